#pragma once

#include <QImage>

class QPainter;
class QRect;
class QRegion;
class QWidget;

namespace ravnoves {

/// The pixels that a widget is painted on, as a picture of the widget's size that shares them: what
/// is painted into it need not be copied there.
class ScreenPixels {
  public:
    /// While the widget is painted.
    /// @param painter  on the widget
    /// @param part  of the widget, which alone is painted into the picture
    /// @param seen  of it what Qt asks for, without what lies over it
    /// @return null where there are no such pixels, as in a file; where the widget begins between
    ///         two of them, or is painted in another size; or where not all of the part is seen
    QImage* of(const QPainter& painter, const QWidget& widget, const QRect& part,
               const QRegion& seen);

  private:
    QImage view_;  ///< with what Qt keeps for painting on it
};

/// Makes a picture one of the widget's size, in its pixels. @return true where nothing is on it yet
bool fitPicture(QImage& picture, const QWidget& widget);

/// Draws the picture of a widget where the screen's pixels cannot be had. A widget that begins or
/// ends between two pixels has one more than its picture, which else nobody would paint.
void drawPicture(QPainter& painter, const QImage& picture, const QRect& widget);

}  // namespace ravnoves

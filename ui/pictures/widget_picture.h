#pragma once

#include <QImage>

class QPainter;
class QWidget;

namespace ravnoves {

/// Gives a picture the size of a widget, in its pixels; opaque. @return true where that is another
/// one, and nothing in it
bool fitPicture(QImage& picture, const QWidget& widget);

/// Draws such a picture where the widget is.
void drawPicture(QPainter& painter, const QImage& picture, const QRect& widget);

}  // namespace ravnoves

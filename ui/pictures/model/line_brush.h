#pragma once

#include <QColor>
#include <QImage>
#include <QList>
#include <QPoint>
#include <QPolygonF>
#include <QRect>
#include <cstdint>
#include <utility>
#include <vector>

namespace ravnoves {

/// Draws lines wider than a pixel into a picture, antialiased, by the distance of each pixel from
/// the line. Qt makes the outline of such a line and fills it: ten times the work, for the same
/// picture but for the last shades of its edges. Ends are flat, bends round; where a line crosses
/// itself it is no darker. All in pixels of the picture.
class LineBrush {
  public:
    /// @param picture  RGB32 or premultiplied ARGB32, written to until the brush is destroyed
    /// @param clip  pixels of the picture that may change
    LineBrush(QImage& picture, const QRect& clip);

    /// @param width  at least 1
    /// @param dashes  dash, gap, …; none: a solid line
    void draw(const std::vector<QPolygonF>& lines, const QColor& colour, double width,
              const QList<qreal>& dashes = {});

  private:
    void markDashes(const QPolygonF& line, const QList<qreal>& pattern);
    void mark(const QPolygonF& line);
    /// @param before, after  points that the line comes from and continues to; null at its ends
    void markSegment(const QPointF& from, const QPointF& to, const QPointF* before,
                     const QPointF* after);
    void ink(const QColor& colour);

    QImage& picture_;
    QRect clip_;
    double half_ = 0.5;                 ///< of the width
    std::vector<std::uint8_t>& cover_;  ///< of each pixel of the clip, 255 is all; and eight more
    /// Of each row of the clip, the pixels touched: from, to beyond the last.
    std::vector<std::pair<int, int>> touched_;
};

}  // namespace ravnoves

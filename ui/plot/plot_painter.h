#pragma once

#include <QColor>
#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <array>
#include <cmath>
#include <optional>

#include "pictures/model/shape.h"
#include "plot/model/plot_data.h"
#include "text/text_width.h"
#include "theme/theme.h"

namespace ravnoves {

class LabelPlaces;

/// Curves and dots get wider with the text, half as fast.
double strokeScale();

/// How a title is in a row of this width: in smaller type before it takes several lines.
struct PlotTitle {
    PlotTitle(const QString& title, double width);

    QFont font;
    int flags = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap;
    double height = 0.0;
    double width = 0.0;  ///< in one line
};

/// Paints a plot onto any device: the static layer (axes), the moving one (curves) and the top one
/// apart.
class PlotPainter {
  public:
    explicit PlotPainter(PlotData& data);

    /// What the y axis and the last number of x need beside the chart, pixels.
    struct Margins {
        double left = 0.0;
        double right = 0.0;

        bool operator==(const Margins&) const = default;
    };

    /// What the axes need in a picture of this size.
    Margins margins(const QSizeF& size);
    /// Places everything in a picture of this size below the header: scales, margins, ticks, lines.
    /// @param minimum  the chart leaves as much room
    /// @param axesStale  the axes have changed; set where this moves them
    void layout(const QSizeF& size, const Margins& minimum, bool& axesStale);
    /// Title, image, bands, grid, axes, the reference's curves.
    void paintAxes(QPainter& painter);
    void paintCurves(QPainter& painter) const;
    /// Lines, present value, marks, readout.
    void paintOverlay(QPainter& painter) const;

  private:
    struct Row {
        QString text;
        QColor colour;
    };

    void layoutArea(const QSizeF& size, const Margins& minimum);
    double heightOfArea() const;
    /// The step of x in that many pixels.
    void chooseColumns(PlotScale& x, double pixels) const;
    /// Grid, lines of the axes, and ticks of scales that are not own.
    void paintGrid(QPainter& painter) const;
    /// Where there is room for them.
    void paintBandWords(QPainter& painter, const plot::Band& band, LabelPlaces& places) const;
    QRectF shadeOf(const plot::Band& band) const;
    /// Numbers and title.
    void paintAxis(QPainter& painter, const PlotScale& scale, bool flat) const;
    void paintGhosts(QPainter& painter) const;
    void paintShades(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;
    /// The place of a line that is no longer than a point.
    static std::optional<QPointF> shrunkTo(const PlotCurve& curve);
    void paintBars(QPainter& painter, const PlotCurve& curve, const QPen& pen,
                   const QBrush& brush) const;
    /// Points and bars have their spread as bars with caps.
    void paintSpreads(QPainter& painter, const PlotCurve& curve) const;
    void paintLines(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    /// Labels of marks, lines and bands, over all else, where they cover the minimum.
    void paintLabels(QPainter& painter) const;
    LabelPlaces drawnPlaces() const;
    /// The place of its label, and its leader drawn; nothing where it has none.
    QRectF placeMark(QPainter& painter, const plot::Mark& mark, LabelPlaces& places) const;
    /// At the edge where the line is beyond it, with its value and an arrow.
    void labelLine(QPainter& painter, const plot::Line& line, LabelPlaces& places) const;
    bool isSeen(const plot::Mark& mark) const;
    static double radiusOf(const plot::Mark& mark);
    QLineF strokeOf(const plot::Line& line) const;
    void paintReadout(QPainter& painter) const;
    void paintPointReadout(QPainter& painter) const;
    /// The reading of a point of a vector's path.
    std::vector<Row> rowsOfPath(const PlotCurve& curve, std::size_t point) const;
    void paintRows(QPainter& painter, const std::vector<Row>& rows, const QPointF& at,
                   const QPointF& away, float opacity) const;
    QPointF pixel(const PlotCurve& curve, std::size_t point) const {
        return data_.toPixel(curve.x[point], curve.y[point]);
    }
    double across(double x) const { return data_.toPixel(x, data_.left.low).x(); }

    PlotData& data_;
    QSizeF size_;
    std::array<double, 10> placed_{};  ///< sizes and scales of the lines made last
};

}  // namespace ravnoves

/// What several parts of a plot are drawn with; sizes in pixels.
namespace ravnoves::painter_parts {

/// From a label to its subject, for text of the designed size.
inline double labelGap() {
    return Theme::withText(6);
}
/// A tick of an axis with labels of our own: powers are taller.
inline double rowPerTick() {
    return Theme::withText(36);
}

inline void dot(QPainter& painter, const QPointF& at, double radius, const QPen& pen,
                const QBrush& fill) {
    painter.setPen(pen);
    painter.setBrush(fill);
    paintDisc(painter, at, radius);
}

/// A point in the shape that tells its role from others without colours.
void paintMarker(QPainter& painter, Marker marker, const QPointF& at, double radius,
                 const QPen& pen, const QBrush& fill);

/// Bars whose role has no solid line are translucent with an edge.
struct BarFill {
    explicit BarFill(Role role);

    QPen edge = Qt::NoPen;
    QBrush inside;
};

/// Of the markers of points; rings leave room for a dot in them.
inline double pointRadius(plot::Shape shape) {
    return strokeScale() * (shape == plot::Shape::Rings ? 5.4 : 3.6);
}

inline QColor veil(QColor colour, float opacity) {
    colour.setAlphaF(opacity);
    return colour;
}

/// A label on a ground of its own, over whatever is drawn there.
inline void drawLabel(QPainter& painter, const QRectF& box, const QColor& ink, const QString& text,
                      int flags = Qt::AlignCenter) {
    painter.fillRect(box.toAlignedRect(), veil(Theme::instance().panel(), 0.92F));
    painter.setPen(ink);
    painter.drawText(box.adjusted(1, 0, -1, 0), flags | Qt::TextDontClip, text);
}

inline constexpr double besideLabel = 3.0;  ///< of a label's ground left and right of the text

inline QSizeF labelSize(const QFont& font, const QString& text) {
    return {std::ceil(textWidth(font, text)) + 2.0 * besideLabel,
            QFontMetricsF(font).height() + 1.0};
}

}  // namespace ravnoves::painter_parts

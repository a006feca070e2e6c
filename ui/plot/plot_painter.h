#pragma once

#include <QColor>
#include <QFontMetricsF>
#include <QPainter>
#include <cmath>

#include "pictures/model/shape.h"
#include "plot/model/plot_data.h"
#include "text/text_width.h"
#include "theme/theme.h"

namespace ravnoves {

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

/// What the y axis and the last number of x need beside the chart, pixels.
struct PlotMargins {
    double left = 0.0;
    double right = 0.0;
};

// A plot on any device: the static layer (axes), the moving one (curves) and the top one apart.

/// What the axes need in a picture of this size.
PlotMargins plotMargins(PlotData& data, const QSizeF& size);
/// Places everything in a picture of this size below the header: scales, margins, ticks, lines.
/// @param minimum  the chart leaves as much room
/// @param axesStale  the axes have changed; set where this moves them
void layOutPlot(PlotData& data, const QSizeF& size, const PlotMargins& minimum, bool& axesStale);
/// Title, image, bands, grid, axes, the reference's curves.
void paintPlotAxes(QPainter& painter, const PlotData& data);
void paintPlotCurves(QPainter& painter, const PlotData& data);
/// Lines, present value, marks, readout.
void paintPlotOverlay(QPainter& painter, const PlotData& data);

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

/// Of the plot that the band is in.
QRectF shadeOf(const PlotData& data, const plot::Band& band);

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

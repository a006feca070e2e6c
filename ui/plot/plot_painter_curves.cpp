// Curves, points and bars of a plot.

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <optional>

#include "numerics/constants.h"
#include "pictures/model/stroke.h"
#include "plot/plot_painter.h"
#include "theme/theme.h"

namespace ravnoves {

using namespace painter_parts;
using plot::Shape;

namespace {

/// A dashed curve on a wider one: its dashes, as long as the gaps that show the other, clear the
/// ground on both sides. So both are distinguished whatever their colours. In widths of the curve.
constexpr double cleared = 2.3;
constexpr double dashOnAnother = 5.0;

void paintShades(QPainter& painter, const PlotData& data) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(data.area);
    painter.setPen(Qt::NoPen);
    for (const PlotCurve& curve : data.curves) {
        if (data.showsSpread(curve)) {
            painter.setBrush(veil(Theme::instance().colour(curve.style.role), 0.26F));
            for (const QPolygonF& shade : curve.shades) {
                painter.drawPolygon(shade);
            }
        }
    }
    painter.restore();
}

std::optional<QPointF> shrunkTo(const PlotCurve& curve) {
    constexpr double smallest = 2.0;  // pixels
    QRectF whole;
    for (const QPolygonF& stretch : curve.stretches) {
        // What has neither width nor height is nothing to a union.
        whole = whole.united(stretch.boundingRect().adjusted(-0.1, -0.1, 0.1, 0.1));
        if (whole.width() > smallest || whole.height() > smallest) {
            return std::nullopt;
        }
    }
    return whole.isEmpty() ? std::nullopt : std::optional(whole.center());
}

void paintBars(QPainter& painter, const PlotData& data, const PlotCurve& curve, const QPen& pen,
               const QBrush& brush) {
    const QRectF& area = data.area;
    painter.setPen(pen);
    painter.setBrush(brush);
    const auto corner = [&](double x, double y) {
        return QPointF(x, std::clamp(y, area.top(), area.bottom()));
    };
    const double foot = data.left.spec.logarithmic ? area.bottom() : data.toPixel(0.0, 0.0).y();
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const double middle = curve.x[i] + curve.style.barShift;
        const double half = 0.5 * curve.style.barWidth;
        const QPointF left = data.toPixel(middle - half, curve.y[i]);
        const QPointF right = data.toPixel(middle + half, curve.y[i]);
        painter.drawRect(QRectF(corner(left.x(), left.y()), corner(right.x(), foot)).normalized());
    }
}

void paintSpreads(QPainter& painter, const PlotData& data, const PlotCurve& curve) {
    if (!data.showsSpread(curve) || curve.isLine()) {
        return;
    }
    const Theme& theme = Theme::instance();
    const bool onBar = curve.style.shape == Shape::Bars;
    painter.setPen(QPen(onBar ? theme.text() : theme.colour(curve.style.role), 1.2));
    const QPointF cap(3, 0);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const auto [low, high] = data.spreadAt(curve, i);
        const double middle = curve.x[i] + (onBar ? curve.style.barShift : 0.0);
        const QPointF foot = data.toPixel(middle, low);
        const QPointF tip = data.toPixel(middle, high);
        if (foot.y() - tip.y() < 1.0) {
            continue;  // nothing to be seen
        }
        painter.drawLine(foot, tip);
        painter.drawLine(foot - cap, foot + cap);
        painter.drawLine(tip - cap, tip + cap);
    }
}

void paintPoints(QPainter& painter, const PlotData& data) {
    const Theme& theme = Theme::instance();
    const double reach = strokeScale() * 4.0;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(data.area.adjusted(-reach, -reach, reach, reach));
    for (const PlotCurve& curve : data.curves) {
        if (!curve.shown) {
            continue;
        }
        const QColor colour = theme.colour(curve.style.role);
        if (curve.style.shape == Shape::Bars) {
            const BarFill fill(curve.style.role);
            paintBars(painter, data, curve, fill.edge, fill.inside);
            if (const PlotCurve* ghost = data.ghostOf(curve)) {
                const double width = strokeScale() * 1.2;
                paintBars(painter, data, *ghost, QPen(theme.panel(), 2.0 * width), Qt::NoBrush);
                paintBars(painter, data, *ghost, QPen(theme.text(), width, Qt::DashLine),
                          Qt::NoBrush);
            }
            paintSpreads(painter, data, curve);
        } else if (curve.style.shape != Shape::Line) {
            const bool hollow = curve.style.shape == Shape::Rings;
            const QPen pen(hollow ? colour : theme.panel(), strokeScale() * (hollow ? 1.6 : 1.0));
            paintSpreads(painter, data, curve);
            for (std::size_t i = 0; i < curve.x.size(); ++i) {
                paintMarker(painter, lookOf(curve.style.role).marker, data.pixelOf(curve, i),
                            pointRadius(curve.style.shape), pen, hollow ? theme.panel() : colour);
            }
        } else if (const auto at = shrunkTo(curve)) {
            dot(painter, *at, strokeScale() * 3.0, Qt::NoPen, colour);
        }
    }
    painter.restore();
}

}  // namespace

void painter_parts::paintMarker(QPainter& painter, Marker marker, const QPointF& at, double radius,
                                const QPen& pen, const QBrush& fill) {
    if (marker == Marker::Disc) {
        dot(painter, at, radius, pen, fill);
        return;
    }
    const int corners = marker == Marker::Triangle ? 3 : 4;
    const double start = marker == Marker::Square ? pi / 4.0 : 0.0;
    QPolygonF outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = start + two_pi * i / corners;
        outline << at + 1.25 * radius * QPointF(std::sin(angle), -std::cos(angle));
    }
    painter.setPen(pen);
    painter.setBrush(fill);
    painter.drawPolygon(outline);
}

painter_parts::BarFill::BarFill(Role role) : inside(Theme::instance().colour(role)) {
    if (lookOf(role).pen != Qt::SolidLine) {
        edge = QPen(inside.color(), 1.2 * strokeScale());
        inside.setColor(veil(inside.color(), 0.3F));
    }
}

void paintPlotCurves(QPainter& painter, const PlotData& data) {
    paintShades(painter, data);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(data.area);
    std::vector<LinesOfPen> lines;
    for (const PlotCurve& curve : data.curves) {
        if (curve.shown && !curve.stretches.empty()) {
            QPen pen(Theme::instance().colour(curve.style.role), strokeScale() * curve.style.width,
                     curve.pen(), Qt::FlatCap, Qt::BevelJoin);
            if (data.liesOnAnother(curve)) {
                QPen ground(pen);
                ground.setColor(Theme::instance().panel());
                ground.setWidthF(cleared * pen.widthF());
                ground.setDashPattern({dashOnAnother / cleared, dashOnAnother / cleared});
                pen.setDashPattern({dashOnAnother, dashOnAnother});
                lines.push_back({ground, curve.stretches});
            }
            lines.push_back({pen, curve.stretches});
        }
    }
    paintLines(painter, lines);
    painter.restore();
    paintPoints(painter, data);
}

}  // namespace ravnoves

#include "balance-shaft/shaft_map_drawing.h"

#include <QPainter>
#include <QPainterPath>
#include <QTransform>
#include <algorithm>
#include <cmath>
#include <utility>

#include "balance-shaft/change_colours.h"
#include "balance-shaft/solver.h"
#include "numerics/constants.h"
#include "numerics/units.h"
#include "pictures/model/pixel.h"
#include "pictures/model/shape.h"
#include "pictures/model/stroke.h"
#include "plot/plot_painter.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

/// A circle that may be far larger than the map: a disc would measure every pixel inside.
void drawCircle(QPainter& painter, const QPointF& middle, double radius) {
    constexpr int chords = 720;
    QPolygonF circle;
    circle.reserve(chords + 1);
    for (int i = 0; i <= chords; ++i) {
        const double angle = two_pi * i / chords;
        circle << middle + radius * QPointF(std::cos(angle), std::sin(angle));
    }
    paintLine(painter, circle);
}

QPolygonF inPixels(const drawing::Frame& frame, const QPolygonF& metres) {
    const double k = frame.pixelsPerUnit;
    return QTransform(k, 0.0, 0.0, -k, frame.origin.x(), frame.origin.y()).map(metres);
}

}  // namespace

drawing::Frame frameOf(const PlotView& plot) {
    const QPointF origin = plot.toPixel(0.0, 0.0);
    return {origin, (plot.toPixel(1.0, 0.0).x() - origin.x()) / units::mm.to_si};
}

void drawBlocked(QPainter& painter, const std::vector<QPolygonF>& blocked, const PlotView& plot) {
    const Theme& theme = Theme::instance();
    const drawing::Frame frame = frameOf(plot);
    QPainterPath path;
    LinesOfPen edges{QPen(faint(theme.text(), 0.7), 1.0), {}};
    for (const QPolygonF& line : blocked) {
        QPolygonF edge = inPixels(frame, line);
        path.addPolygon(edge);
        path.closeSubpath();
        // Round its corners, the first of them, too.
        edge << edge.value(0) << edge.value(1);
        edges.lines.push_back(std::move(edge));
    }
    if (path.isEmpty()) {
        return;
    }
    constexpr double apart = 7.0;  // lines of the hatch, pixels
    painter.fillPath(path, faint(theme.panel(), 0.38));
    // Lines at 45° need no smoothing, which takes most of a turn of the wheel.
    const bool onPixels = paintsPixels(painter);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, !onPixels);
    painter.setPen(QPen(faint(theme.text(), 0.3), onPixels ? 0.0 : 1.0));
    for (const QPolygonF& line : hatchLines(path, plot.plotArea(), apart, 1.0)) {
        painter.drawPolyline(line);
    }
    painter.restore();
    paintLines(painter, {edges});
}

void drawLimits(QPainter& painter, const balance_shaft::PlaceLimits& limits, const PlotView& plot) {
    const drawing::Frame frame = frameOf(plot);
    const QRectF area = plot.plotArea();
    QPen pen(Theme::instance().error(), 1.4);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen);
    for (const auto& x : {limits.left, limits.right}) {
        if (x) {
            const double at = frame.at(*x, 0.0).x();
            painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
        }
    }
    for (const auto& y : {limits.bottom, limits.top}) {
        if (y) {
            const double at = frame.at(0.0, *y).y();
            painter.drawLine(QPointF(area.left(), at), QPointF(area.right(), at));
        }
    }
    const QPointF crank = frame.at(0.0, 0.0);
    for (const auto& distance : {limits.centre_distance_min, limits.centre_distance_max}) {
        if (distance) {
            drawCircle(painter, crank, frame.length(*distance));
        }
    }
    pen.setStyle(Qt::DashLine);
    painter.setPen(pen);
    const double far = area.width() + area.height();
    for (const auto& angle : {limits.shaft_angle_from, limits.shaft_angle_to}) {
        if (angle) {
            painter.drawLine(crank, crank + far * QPointF(std::sin(*angle), -std::cos(*angle)));
        }
    }
}

void drawReference(QPainter& painter, const ShaftMapModel& other, const PlotView& plot) {
    if (other.map() == nullptr) {
        return;
    }
    // Wide and pale, as ghosts of curves are.
    const Theme& theme = Theme::instance();
    const auto wide = [&](double alpha, double width) {
        return QPen(faint(theme.text(), alpha), strokeScale() * width, Qt::SolidLine, Qt::FlatCap,
                    Qt::BevelJoin);
    };
    painter.setBrush(Qt::NoBrush);
    painter.setPen(wide(0.18, 4.0));
    for (const QPolygonF& line : other.map()->blocked) {
        painter.drawPolygon(inPixels(frameOf(plot), line));
    }
    painter.setPen(wide(0.34, 6.0));
    for (const ChangeContours::Contour& contour : other.field().contours) {
        for (const QPolygonF& line : contour.lines) {
            if (contour.level == 0.0) {
                painter.drawPolyline(inPixels(plot, line));
            }
        }
    }
}

void drawEngine(QPainter& painter, const BalanceShaftModel& model, const PlotView& plot) {
    const Theme& theme = Theme::instance();
    const balance_shaft::FrontView& sizes = model.solver().front_view();
    const auto pose = balance_shaft::mechanism_pose(
        model.solver(), model.crank()->degrees() * degree, model.input().shaft_angle);
    const drawing::Frame frame = frameOf(plot);
    const double k = frame.pixelsPerUnit;
    const QColor line = faint(theme.text(), 0.75);
    const QColor metal = faint(drawing::metal(), 0.72);
    const QPointF crank = frame.at(0, 0);
    const QPointF pin = frame.at(pose.crankpin);
    const QPointF piston = frame.at(pose.piston_pin);

    const double e = sizes.offset;
    const double bore = sizes.cylinder_bore;
    const double wall = std::max(sizes.cylinder_wall, 2.0 / k);
    painter.setPen(QPen(line, 1.1));
    painter.setBrush(metal);
    for (const double side : {-1.0, 1.0}) {
        paintBlock(painter,
                   QRectF(frame.at(e + side * bore / 2, sizes.cylinder_top),
                          frame.at(e + side * (bore / 2 + wall), sizes.cylinder_bottom)),
                   0.0);
    }
    const double height = 0.75 * bore;
    const double top = std::min(pose.piston_pin.y + 0.45 * height, sizes.cylinder_top);
    painter.setBrush(faint(drawing::brightMetal(), 0.72));
    paintBlock(painter, QRectF(frame.at(e - bore / 2, top), frame.at(e + bore / 2, top - height)),
               3.0);
    painter.setPen(QPen(line, 1.0));
    painter.setBrush(Qt::NoBrush);
    drawCircle(painter, crank, frame.length(sizes.crank_swing_radius));
    const double thick = std::clamp(0.3 * sizes.crank_radius * k, 4.0, 14.0);
    drawing::drawRod(painter, pin, piston, 0.6 * thick, metal, line);
    drawing::drawRod(painter, crank, pin, thick, metal, line);
    painter.setPen(QPen(line, 1.1));
    painter.setBrush(theme.panel());
    for (const QPointF& joint : {crank, pin, piston}) {
        paintDisc(painter, joint, 0.24 * thick + 1.5);
    }
}

void drawShaft(QPainter& painter, const BalanceShaftModel& model, const ShaftMapModel& map,
               const ShaftMapModel* other, const PlotView& plot) {
    const Theme& theme = Theme::instance();
    const balance_shaft::FrontView& sizes = model.solver().front_view();
    const auto present = map.present();
    const drawing::Frame frame = frameOf(plot);
    const QPointF crank = frame.at(0.0, 0.0);
    const QPointF axis = frame.at(present);
    const bool canBeBuilt =
        map.map() != nullptr ? map.isBuildable(present) : model.result().is_buildable;
    const QColor colour = canBeBuilt ? theme.accent() : theme.error();
    painter.setBrush(Qt::NoBrush);
    if (other != nullptr) {
        const auto was = other->present();
        painter.setPen(QPen(faint(theme.text(), 0.55), 1.2));
        drawCircle(painter, crank, frame.length(was.centre_distance()));
        paintDisc(painter, frame.at(was), shaftHandleRadius);
    }
    painter.setPen(QPen(theme.accent(), 1.4));
    drawCircle(painter, crank, frame.length(present.centre_distance()));
    painter.setPen(QPen(faint(theme.text(), 0.6), 1.0, Qt::DashDotLine));
    painter.drawLine(crank, axis);
    const double swing = frame.length(sizes.shaft_swing_radius);
    painter.setPen(QPen(colour, 1.2));
    painter.setBrush(faint(colour, 0.1));
    paintDisc(painter, axis, swing);
    painter.setPen(QPen(theme.panel(), 1.6));
    painter.setBrush(colour);
    paintDisc(painter, axis, shaftHandleRadius);
}

}  // namespace ravnoves

#include "balance-shaft/shaft_map_engine.h"

#include <QPainter>
#include <algorithm>

#include "balance-shaft/mechanism.h"
#include "balance-shaft/model/shaft_map_model.h"
#include "balance-shaft/place_scale.h"
#include "balance-shaft/shaft_map_signs.h"
#include "numerics/constants.h"
#include "pictures/model/shape.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

void drawEngine(QPainter& painter, const BalanceShaftModel& model, const PlaceScale& scale) {
    const Theme& theme = Theme::instance();
    const balance_shaft::FrontView& sizes = model.solver().front_view();
    const auto pose = balance_shaft::mechanism_pose(
        model.solver(), model.crank()->degrees() * degree, model.input().shaft_angle);
    const double k = scale.perMetre();
    const auto at = [&](double x, double y) { return scale.at(x, y); };
    const QColor line = faint(theme.text(), 0.75);
    const QColor metal = faint(drawing::metal(), 0.72);
    const QPointF crank = at(0, 0);
    const QPointF pin = at(pose.crankpin.x, pose.crankpin.y);
    const QPointF piston = at(pose.piston_pin.x, pose.piston_pin.y);

    const double e = sizes.offset;
    const double bore = sizes.cylinder_bore;
    const double wall = std::max(sizes.cylinder_wall, 2.0 / k);
    painter.setPen(QPen(line, 1.1));
    painter.setBrush(metal);
    for (const double side : {-1.0, 1.0}) {
        painter.drawRect(QRectF(at(e + side * bore / 2, sizes.cylinder_top),
                                at(e + side * (bore / 2 + wall), sizes.cylinder_bottom))
                             .normalized());
    }
    const double height = 0.75 * bore;
    const double top = std::min(pose.piston_pin.y + 0.45 * height, sizes.cylinder_top);
    painter.setBrush(faint(drawing::brightMetal(), 0.72));
    painter.drawRoundedRect(QRectF(at(e - bore / 2, top), at(e + bore / 2, top - height)), 3, 3);
    painter.setPen(QPen(line, 1.0));
    painter.setBrush(Qt::NoBrush);
    drawDashedCircle(painter, crank, sizes.crank_swing_radius * k, 2.0, 4.0);
    const double thick = std::clamp(0.3 * sizes.crank_radius * k, 4.0, 14.0);
    drawing::drawBar(painter, pin, piston, 0.6 * thick, metal, line);
    drawing::drawBar(painter, crank, pin, thick, metal, line);
    painter.setPen(QPen(line, 1.1));
    painter.setBrush(theme.panel());
    for (const QPointF& joint : {crank, pin, piston}) {
        paintDisc(painter, joint, 0.24 * thick + 1.5);
    }
}

void drawShaft(QPainter& painter, const BalanceShaftModel& model, const ShaftMapModel& map,
               const ShaftMapModel* other, const PlaceScale& scale) {
    const Theme& theme = Theme::instance();
    const balance_shaft::FrontView& sizes = model.solver().front_view();
    const auto present = map.present();
    const double k = scale.perMetre();
    const QPointF crank = scale.at(0.0, 0.0);
    const QPointF axis = scale.at(present);
    const bool canBeBuilt =
        map.map() != nullptr ? map.isBuildable(present) : model.result().is_buildable;
    const QColor colour = canBeBuilt ? theme.accent() : theme.error();
    painter.setBrush(Qt::NoBrush);
    if (other != nullptr) {
        const auto was = other->present();
        painter.setPen(QPen(faint(theme.text(), 0.55), 1.2));
        drawDashedCircle(painter, crank, was.centre_distance() * k);
        paintDisc(painter, scale.at(was), shaftHandleRadius);
    }
    painter.setPen(QPen(theme.accent(), 1.4));
    drawDashedCircle(painter, crank, present.centre_distance() * k);
    painter.setPen(QPen(faint(theme.text(), 0.6), 1.0, Qt::DashDotLine));
    painter.drawLine(crank, axis);
    const double swing = sizes.shaft_swing_radius * k;
    painter.setPen(QPen(colour, 1.2));
    painter.setBrush(faint(colour, 0.1));
    paintDisc(painter, axis, swing);
    painter.setPen(QPen(theme.panel(), 1.6));
    painter.setBrush(colour);
    paintDisc(painter, axis, shaftHandleRadius);
}

}  // namespace ravnoves

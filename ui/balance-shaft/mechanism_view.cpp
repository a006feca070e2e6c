#include <QCoreApplication>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QtMath>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "balance-shaft/balance_shaft_page.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/position_study.h"
#include "balance-shaft/solver.h"
#include "numerics/constants.h"
#include "page/mechanism_picture.h"
#include "pictures/model/shape.h"
#include "pictures/model/stroke.h"
#include "text/shown_units.h"
#include "text/text_width.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

using balance_shaft::Envelope;
using balance_shaft::FrontView;
using balance_shaft::MechanismPose;
using balance_shaft::ShaftPosition;
using balance_shaft::Vector2;

namespace {

constexpr double arrowMargin = 5.0;  // to the picture's edge

/// A counterweight about an axis, centred on the direction of its mass.
QPainterPath weight(const QPointF& axis, const QPointF& mass, double radius, double hub) {
    const double angle = std::atan2(axis.y() - mass.y(), mass.x() - axis.x());
    return drawing::weightPath(axis, angle, radius, hub, 58.0);
}

QFont namesFont() {
    return Theme::font(Theme::smallSize);
}

struct ArrowName {
    QString text;
    Role role;
    QPoint at;
};

/// Front view of the mechanism to scale: cylinder, piston, rod, crank, both counterweights, the
/// shaft at α, gear circles, force arrows, the envelope. Space plays and pauses; dragging the shaft
/// turns α, dragging elsewhere turns the crank.
class MechanismView final : public MechanismPicture {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::MechanismView)

  public:
    explicit MechanismView(BalanceShaftModel* model)
        : MechanismPicture(
              model->crank(), tr("Front view of the mechanism"),
              tr("Front view to scale; the crank turns clockwise. Drag the shaft to change α, "
                 "drag elsewhere to turn the crank, Space plays and pauses.")),
          model_(model) {
        for (const auto signal : {&SceneModel::changed, &SceneModel::shownChanged}) {
            connect(model_, signal, this, qOverload<>(&QWidget::update));
        }
    }

    /// The results below it come first: in a low window it is as low as it can be.
    QSize sizeHint() const override { return minimumSizeHint(); }
    QSize minimumSizeHint() const override { return {Theme::withText(180), Theme::withText(180)}; }

  protected:
    void paintPicture(QPainter& painter) override {
        const Theme& theme = Theme::instance();
        const FrontView& sizes = model_->solver().front_view();
        const double phi = model_->crank()->degrees() * degree;
        const MechanismPose pose =
            balance_shaft::mechanism_pose(model_->solver(), phi, model_->input().shaft_angle);
        const Envelope& envelope = model_->result().envelope;
        const drawing::Frame map = frame();
        const double k = map.pixelsPerUnit;

        const QPointF crank = map.at(0, 0);
        const QPointF shaft = map.at(pose.shaft_axis);
        const QPointF pin = map.at(pose.crankpin);
        const QPointF piston = map.at(pose.piston_pin);
        const QColor line = theme.text();
        const QColor metal = drawing::metal();

        // Envelope and axes.
        painter.setPen(QPen(theme.mutedText(), 1.0, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        paintLine(painter, QPolygonF(QRectF(map.at(envelope.left, envelope.top),
                                            map.at(envelope.right, envelope.bottom))));
        painter.setPen(QPen(theme.border(), 1.0, Qt::DashDotLine));
        paintLine(painter, map.at(0, envelope.top), map.at(0, -sizes.crank_swing_radius));
        const double e = sizes.offset;
        if (e != 0.0) {
            paintLine(painter, map.at(e, envelope.top), map.at(e, sizes.cylinder_bottom));
        }
        paintLine(painter, crank, shaft);

        // Gears: pitch circles, in mesh where they touch.
        painter.setPen(QPen(theme.border(), 1.2));
        paintDisc(painter, crank, sizes.gear_pitch_radius * k);
        paintDisc(painter, shaft, sizes.gear_pitch_radius * k);
        painter.setPen(QPen(theme.border(), 1.0, Qt::DotLine));
        paintDisc(painter, crank, sizes.crank_swing_radius * k);
        const bool buildable = model_->result().is_buildable;
        if (!buildable) {
            painter.setPen(QPen(theme.error(), 1.4, Qt::DashLine));
        }
        paintDisc(painter, shaft, sizes.shaft_swing_radius * k);

        // Cylinder and piston.
        const double bore = sizes.cylinder_bore;
        const double wall = std::max(sizes.cylinder_wall, 2.0 / k);
        const double pistonHeight = 0.75 * bore;
        painter.setPen(QPen(line, 1.4));
        painter.setBrush(metal);
        for (const double side : {-1.0, 1.0}) {
            const double inner = e + side * bore / 2;
            const double outer = e + side * (bore / 2 + wall);
            paintBlock(
                painter,
                QRectF(map.at(inner, sizes.cylinder_top), map.at(outer, sizes.cylinder_bottom)),
                0.0);
        }
        paintBlock(painter,
                   QRectF(map.at(e - bore / 2 - wall, sizes.cylinder_top + wall),
                          map.at(e + bore / 2 + wall, sizes.cylinder_top)),
                   0.0);
        const double pistonTop =
            std::min(pose.piston_pin.y + 0.45 * pistonHeight, sizes.cylinder_top);
        painter.setBrush(drawing::brightMetal());
        paintBlock(
            painter,
            QRectF(map.at(e - bore / 2, pistonTop), map.at(e + bore / 2, pistonTop - pistonHeight)),
            3.0);
        for (int ring = 0; ring < 3; ++ring) {
            const double y = pistonTop - (0.10 + 0.09 * ring) * pistonHeight;
            paintLine(painter, map.at(e - bore / 2, y), map.at(e + bore / 2, y));
        }

        // Counterweights.
        painter.setPen(QPen(line, 1.2));
        painter.setBrush(drawing::weightFill(Role::CrankWeight));
        painter.drawPath(weight(crank, map.at(pose.crank_counterweight),
                                sizes.crank_swing_radius * k, 0.22 * sizes.crank_radius * k));
        painter.setBrush(drawing::weightFill(Role::ShaftWeight));
        painter.drawPath(weight(shaft, map.at(pose.shaft_counterweight),
                                sizes.shaft_swing_radius * k,
                                0.22 * sizes.counterweight_radius * k));

        // Crank and rod.
        const double thick = std::clamp(0.36 * sizes.crank_radius * k, 5.0, 18.0);
        drawing::drawRod(painter, crank, pin, thick, metal, line);
        drawing::drawRod(painter, pin, piston, 0.55 * thick, metal, line);
        painter.setPen(QPen(line, 1.2));
        painter.setBrush(theme.panel());
        for (const QPointF& joint : {crank, pin, piston, shaft}) {
            paintDisc(painter, joint, 0.24 * thick + 1.5);
        }

        // Forces, one scale for all: P_j1 max is 0.36 of the picture's smaller side.
        const double force = std::max(model_->result().inertia_force_1_max, 1e-300);
        const double perNewton = 0.36 * std::min(width(), height()) / force;
        const auto drawForce = [&](const QPointF& from, const Vector2& f, const QColor& colour) {
            const QLineF arrow = drawing::pulledInside(
                {from, from + QPointF(f.x * perNewton, -f.y * perNewton)},
                QRectF(rect()).adjusted(arrowMargin, arrowMargin, -arrowMargin, -arrowMargin));
            drawing::drawArrow(painter, arrow.p1(), arrow.p2(), colour);
        };
        drawForce(piston, pose.inertia_force_1, theme.colour(Role::Reciprocating));
        // A force acts along its line: it is drawn from inside the weight.
        const auto inside = [](const QPointF& axis, const QPointF& mass, double radius,
                               double rho) {
            return rho > 0.8 * radius ? axis + (mass - axis) * (0.8 * radius / rho) : mass;
        };
        const double rho = sizes.counterweight_radius;
        drawForce(inside(crank, map.at(pose.crank_counterweight), sizes.crank_swing_radius, rho),
                  pose.crank_counterweight_force, theme.colour(Role::CrankWeight));
        drawForce(inside(shaft, map.at(pose.shaft_counterweight), sizes.shaft_swing_radius, rho),
                  pose.shaft_counterweight_force, theme.colour(Role::ShaftWeight));

        // α between the cylinder axis and the line of centres, positive clockwise.
        const double alpha = model_->shaftAngleDeg();
        const double arcRadius = std::min(0.55 * sizes.centre_distance * k, 44.0);
        painter.setPen(QPen(theme.accent(), 1.6));
        painter.setBrush(Qt::NoBrush);
        const QRectF arc(crank - QPointF(arcRadius, arcRadius),
                         QSizeF(2 * arcRadius, 2 * arcRadius));
        painter.drawArc(arc, 90 * 16, static_cast<int>(std::lround(-alpha * 16)));
        painter.setFont(Theme::font(Theme::smallSize, true));
        const double middle = 0.5 * alpha * degree;
        painter.setPen(theme.accent());
        drawing::drawCentred(
            painter, crank + QPointF(std::sin(middle), -std::cos(middle)) * (arcRadius + 12),
            QStringLiteral("α"));

        painter.setFont(Theme::font(Theme::smallSize));
        painter.setPen(theme.mutedText());
        drawing::drawWithHalo(
            painter, QRectF(rect()).adjusted(8, 6, -8, -6), Qt::AlignTop | Qt::AlignLeft,
            tr("φ = %1°").arg(QLocale().toString(model_->crank()->degrees(), 'f', 0)));
        drawing::drawWithHalo(painter, QRectF(rect()).adjusted(8, 6, -8, -6),
                              Qt::AlignTop | Qt::AlignRight,
                              shownDigits(envelope.width(), units::mm, 0) + QStringLiteral(" × ") +
                                  shownNumber(envelope.height(), units::mm, 0));
        if (!buildable) {
            painter.setPen(theme.error());
            drawing::drawWithHalo(painter, QRectF(rect()).adjusted(8, 6, -8, -6),
                                  Qt::AlignTop | Qt::AlignHCenter, tr("does not fit"));
        }
        painter.setFont(namesFont());
        for (const ArrowName& name : namesOfArrows()) {
            painter.setPen(theme.readable(theme.colour(name.role)));
            painter.drawText(name.at, name.text);
        }
    }

    void mousePressEvent(QMouseEvent* event) override {
        const drawing::Frame map = frame();
        const FrontView& sizes = model_->solver().front_view();
        const double alpha = model_->input().shaft_angle;
        const QPointF shaft = map.at(ShaftPosition::at(sizes.centre_distance, alpha));
        const QPointF away = event->position() - shaft;
        if (std::hypot(away.x(), away.y()) < sizes.shaft_swing_radius * map.pixelsPerUnit) {
            held_ = map;
        }
        mouseMoveEvent(event);
    }

    void mouseMoveEvent(QMouseEvent* event) override {
        if (!(event->buttons() & Qt::LeftButton)) {
            return;
        }
        const QPointF p = event->position() - frame().origin;
        double angle = std::atan2(p.x(), -p.y()) / degree;  // clockwise from up
        if (angle < 0) {
            angle += 360.0;
        }
        if (held_) {
            model_->pickShaftAngleDeg(angle);
        } else {
            setPlaying(false);
            angle -= model_->result().dead_centre / degree;
            angle += angle < 0.0 ? 360.0 : 0.0;
            turnTo(angle + (model_->crank()->degrees() >= 360.0 ? 360.0 : 0.0));
        }
    }

    void mouseReleaseEvent(QMouseEvent* /*event*/) override {
        if (held_) {
            model_->finishDrag();
            held_.reset();
            update();
        }
    }

  private:
    /// The mapping of metres to pixels: the envelope fills the picture. It rests while the shaft is
    /// dragged.
    drawing::Frame frame() const {
        if (held_) {
            return *held_;
        }
        const Envelope& envelope = model_->result().envelope;
        const FrontView& sizes = model_->solver().front_view();
        const double top = std::max(envelope.top, sizes.cylinder_top + sizes.cylinder_wall);
        // With the cylinder's head, y up.
        const QRectF box(envelope.left, envelope.bottom, envelope.width(), top - envelope.bottom);
        const double margin = 14.0;
        const double row = QFontMetricsF(namesFont()).height();
        const double above = row + 10.0;  // the row of text
        const double below = std::max(above, height() - namesOfArrows().back().at.y() + row);
        drawing::Frame frame;
        frame.pixelsPerUnit = std::max(std::min((width() - 2 * margin) / box.width(),
                                                (height() - above - below) / box.height()),
                                       1e-9);
        frame.origin =
            QPointF(width() / 2.0 - box.center().x() * frame.pixelsPerUnit,
                    (height() + above - below) / 2.0 + box.center().y() * frame.pixelsPerUnit);
        return frame;
    }

    /// The legend of the arrows, in rows from the lower edge up.
    std::vector<ArrowName> namesOfArrows() const {
        constexpr int margin = 8;
        constexpr int apart = 12;
        std::vector<ArrowName> names{{tr("piston (Pⱼ₁)"), Role::Reciprocating, {}},
                                     {tr("crank weight (P₁)"), Role::CrankWeight, {}},
                                     {tr("shaft weight (P₁)"), Role::ShaftWeight, {}}};
        const QFontMetrics metrics(namesFont());
        QPoint at(margin, height() - margin);
        for (ArrowName& name : names) {
            const int wide = qCeil(textWidth(namesFont(), name.text));
            if (at.x() > margin && at.x() + wide > width() - margin) {
                at = QPoint(margin, at.y() - metrics.height());
            }
            name.at = at;
            at.rx() += wide + apart;
        }
        return names;
    }

    BalanceShaftModel* model_;
    std::optional<drawing::Frame> held_;  ///< while the shaft is dragged
};

}  // namespace

PicturePanel* BalanceShaftPage::buildPicture(QWidget* parent) {
    return new PicturePanel(new MechanismView(model_),
                            tr("Crank angle of the picture; 0 is top dead centre"), parent);
}

}  // namespace ravnoves

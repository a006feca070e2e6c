#include "elastic-hinge/hinge_mechanism_view.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "elastic-hinge/model/elastic_hinge_model.h"
#include "numerics/constants.h"
#include "pictures/model/shape.h"
#include "pictures/model/stroke.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

using elastic_hinge::Branch;
using elastic_hinge::Guide;
using elastic_hinge::GuidePoint;
using elastic_hinge::Hinge;
using elastic_hinge::MechanismPose;
using elastic_hinge::Motion;

namespace {

constexpr double shownTurnsPerSecond = 0.4;  ///< at the design speed: slow enough for the eye
/// The spring stands still across the slider line.
constexpr double springAngle = 0.5 * pi;

/// A spring between two points: straight ends, a zigzag between.
QPolygonF springLine(const QPointF& from, const QPointF& to, double width) {
    constexpr int coils = 14;
    const QPointF along = to - from;
    const double length = std::hypot(along.x(), along.y());
    QPolygonF path{from};
    if (length < 1.0) {
        return path;
    }
    const QPointF across(-along.y() / length * width, along.x() / length * width);
    path << from + 0.08 * along;
    for (int i = 0; i < coils; ++i) {
        const double at = 0.08 + 0.84 * (i + 0.5) / coils;
        path << from + at * along + (i % 2 == 0 ? across : -across);
    }
    path << from + 0.92 * along << to;
    return path;
}

/// A roller that can be seen, also where none is given.
double shownRoller(double radius, double startRadius) {
    return std::max(radius, 0.045 * startRadius);
}

/// The crank's: the one shown, or the one beside the rod's.
const Guide& crankGuide(const ElasticHingeModel& model) {
    return model.shownHinge() == Hinge::rod ? model.result().crank_guide_with_rod
                                            : model.shownGuide();
}

/// The guide under one end of the spring, or the other end with `second`; its relief enlarged by
/// `factor`. Empty without one.
std::vector<QPolygonF> track(const ElasticHingeModel& model, const drawing::Frame& map, double phi,
                             double factor, bool second) {
    const Guide& guide = crankGuide(model);
    std::vector<QPolygonF> stretches;
    if (!guide.shape) {
        return stretches;
    }
    const double start = guide.shape->spring().start_radius(guide.branch);
    const double roller = shownRoller(model.input().roller_radius, start);
    const double side = guide.branch == Branch::compressed ? 1.0 : -1.0;
    const auto& radii =
        guide.branch == Branch::compressed ? guide.radius_compressed : guide.radius_stretched;
    std::vector<QPointF> stretch;
    const auto add = [&] {
        if (!stretch.empty()) {
            stretches.push_back(thinPolyline(stretch));
            stretch.clear();
        }
    };
    for (std::size_t i = 0; i < radii.size(); i += 2) {
        const double radius = start + factor * (radii[i] - start) + side * roller;
        if (!std::isfinite(radius)) {
            add();
            continue;
        }
        const double angle = springAngle - guide.polar_angle[i] + phi + (second ? pi : 0.0);
        stretch.push_back(map.at(radius * std::cos(angle), radius * std::sin(angle)));
    }
    add();
    return stretches;
}

}  // namespace

HingeMechanismView::HingeMechanismView(ElasticHingeModel* model, QWidget* parent)
    : MechanismPicture(model->crank(), tr("Picture of the mechanism with its hinges"),
                       tr("The mechanism to scale, with the guide's relief enlarged. Drag to turn "
                          "the crank; Space plays the computed motion."),
                       parent),
      model_(model) {
    for (const auto signal :
         {&SceneModel::changed, &SceneModel::viewChanged, &SceneModel::shownChanged}) {
        connect(model_, signal, this, qOverload<>(&QWidget::update));
    }
}

double HingeMechanismView::slowness() const {
    const double speed = std::abs(model_->input().angular_speed);
    return speed > 0.0 ? shownTurnsPerSecond * two_pi / speed : 1.0;
}

void HingeMechanismView::play(double seconds) {
    const Motion* motion = model_->animatedMotion();
    if (motion == nullptr || motion->time.back() <= 0.0) {
        model_->crank()->turnTo(model_->crank()->degrees() + 360.0 * shownTurnsPerSecond * seconds);
        return;
    }
    double time = model_->motionTime().value_or(0.0) + seconds * slowness();
    if (time > motion->time.back()) {
        time = 0.0;  // from the start again
    }
    model_->setMotionTime(time);
}

void HingeMechanismView::turnTo(double degrees) {
    setPlaying(false);
    MechanismPicture::turnTo(degrees);
}

drawing::Frame HingeMechanismView::frame() const {
    const auto& mechanism = model_->result().design->mechanism();
    const Guide& guide = crankGuide(*model_);
    const double r = mechanism.crank_radius;
    double ring = r;
    if (guide.shape) {
        // Room for the relief as it is drawn.
        const double start = guide.shape->spring().start_radius(guide.branch);
        const double rise = guide.feasible ? reliefFactor() * guide.relief : 0.0;
        ring = std::max(r, start + rise + model_->input().roller_radius);
    }
    const double block = 0.5 * r;
    const double weight = mechanism.counterweight_distance;
    const double left = std::max(ring, r + weight);
    const double right = std::max(ring, r + mechanism.rod_length() + block);
    const double tall = std::max({ring, r + weight * mechanism.lambda + 0.2 * r, block});
    const double margin = 12.0;
    const double header = 16.0;
    drawing::Frame frame;
    frame.pixelsPerUnit = std::max(1e-9, std::min((width() - 2 * margin) / (left + right),
                                                  (height() - 2 * margin - header) / (2 * tall)));
    const double used = (left + right) * frame.pixelsPerUnit;
    frame.origin =
        QPointF(0.5 * (width() - used) + left * frame.pixelsPerUnit, 0.5 * (height() + header));
    return frame;
}

double HingeMechanismView::reliefFactor() const {
    return model_->shownHinge() != Hinge::rod ? model_->exaggeration() : 1.0;
}

void HingeMechanismView::paintPicture(QPainter& painter) {
    const Theme& theme = Theme::instance();
    const auto& result = model_->result();
    const auto& mechanism = result.design->mechanism();
    const Guide& guide = crankGuide(*model_);
    const double phi = model_->crank()->degrees() * degree;
    const MechanismPose pose = elastic_hinge::mechanism_pose(result, phi);
    const drawing::Frame map = frame();
    const double k = map.pixelsPerUnit;
    const double r = mechanism.crank_radius;

    const QColor line = theme.text();
    const QColor metal = drawing::metal();
    const QColor weight = drawing::weightFill(Role::CrankWeight);
    const QColor block = drawing::brightMetal();
    const QPointF axis = map.at(0, 0);
    const QPointF pin = map.at(pose.crankpin);
    const QPointF slider = map.at(pose.slider);

    // Slider line with its ways.
    const double half = 0.26 * r;
    const double farthest = r + mechanism.rod_length() + 0.5 * r;
    const double nearest = std::max(0.0, mechanism.rod_length() - r - 0.5 * r);
    painter.setPen(QPen(theme.border(), 1.0, Qt::DashDotLine));
    paintLine(painter, map.at(-r, 0), map.at(farthest, 0));
    painter.setPen(QPen(line, 1.4));
    for (const double side : {-1.0, 1.0}) {
        paintLine(painter, map.at(nearest, side * half), map.at(farthest, side * half));
    }

    // The guide turns with the crank; at the polar angle b of its own axes it has ρ(a), where a is
    // the crank angle at which the still spring meets that place.
    double rollerRadius = 0.0;
    if (guide.shape) {
        const double factor = reliefFactor();
        const double start = guide.shape->spring().start_radius(guide.branch);
        const double roller = shownRoller(model_->input().roller_radius, start);
        // Each end of the spring has a track of its own, half a turn apart.
        const QColor colour =
            theme.colour(guide.branch == Branch::compressed ? Role::Compressed : Role::Stretched);
        for (const bool second : {true, false}) {
            QColor shade = colour;
            shade.setAlphaF(second ? 0.3F : 1.0F);
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(shade, second || !guide.feasible ? 1.4 : 2.6,
                                guide.feasible ? Qt::SolidLine : Qt::DotLine));
            for (const QPolygonF& stretch : track(*model_, map, phi, factor, second)) {
                paintLine(painter, stretch);
            }
        }

        const GuidePoint here = guide.shape->at(guide.branch, phi);
        const double reach =
            std::isfinite(here.radius) ? start + factor * (here.radius - start) : start;
        const QPointF up = map.at(0, reach);
        const QPointF down = map.at(0, -reach);
        painter.setPen(QPen(theme.mutedText(), 1.3));
        paintLine(painter, springLine(up, down, 0.11 * start * k));
        rollerRadius = std::max(roller * k, 2.5);
        painter.setPen(QPen(line, 1.2));
        painter.setBrush(std::isfinite(here.radius) ? block : theme.error());
        for (const QPointF& p : {up, down}) {
            paintDisc(painter, p, rollerRadius);
        }
    }

    // Slider, rod with its counterweight, crank.
    painter.setPen(QPen(line, 1.4));
    painter.setBrush(block);
    paintBlock(
        painter,
        QRectF(map.at(pose.slider.x - 0.36 * r, half), map.at(pose.slider.x + 0.36 * r, -half)),
        3.0);
    const double thick = std::clamp(0.22 * r * k, 5.0, 16.0);
    const auto rod = [&](const QPointF& from, const QPointF& to, double width) {
        drawing::drawRod(painter, from, to, width, metal, line);
    };
    if (mechanism.has_counterweight()) {
        const QPointF at = map.at(pose.counterweight);
        rod(pin, at, 0.4 * thick);
        // A disc whose area goes with the weight, against that of the crank's circle.
        const double share = mechanism.counterweight_mass /
                             std::max(mechanism.slider_mass + mechanism.rod_mass, 1e-12);
        const double radius = std::clamp(0.22 * r * std::sqrt(share), 0.1 * r, 0.5 * r) * k;
        painter.setPen(QPen(line, 1.2));
        painter.setBrush(weight);
        paintDisc(painter, at, radius);
        painter.setPen(line);
        painter.setFont(Theme::font(Theme::smallSize));
        drawing::drawCentred(painter, at, QStringLiteral("P₄"));
    }
    rod(pin, slider, 0.55 * thick);
    rod(axis, pin, thick);

    // The rod's hinge: a spiral at the crankpin, where there is one to build.
    if (result.rod_guide.feasible) {
        QPolygonF spiral;
        for (int i = 0; i <= 80; ++i) {
            const double turn = 2.25 * two_pi * i / 80.0;
            const double radius = (0.28 + 0.6 * i / 80.0) * thick;
            spiral << pin + radius * QPointF(std::cos(turn + pose.rod_angle),
                                             -std::sin(turn + pose.rod_angle));
        }
        painter.setPen(QPen(theme.colour(Role::Hinge), 1.4));
        paintLine(painter, spiral);
    }
    painter.setPen(QPen(line, 1.2));
    painter.setBrush(theme.panel());
    for (const QPointF& joint : {axis, pin, slider}) {
        paintDisc(painter, joint, 0.2 * thick + 1.2);
    }

    // φ, and what moves.
    const double arc = std::min(0.5 * r * k, 34.0);
    painter.setPen(QPen(theme.accent(), 1.6));
    painter.setBrush(Qt::NoBrush);
    painter.drawArc(QRectF(axis - QPointF(arc, arc), QSizeF(2 * arc, 2 * arc)), 0,
                    static_cast<int>(std::lround(model_->crank()->degrees() * 16)));
    painter.setFont(Theme::font(Theme::smallSize));
    painter.setPen(theme.mutedText());
    const QRectF inside = QRectF(rect()).adjusted(8, 5, -8, -5);
    painter.drawText(inside, Qt::AlignTop | Qt::AlignLeft,
                     tr("φ = %1°").arg(QLocale().toString(model_->crank()->degrees(), 'f', 0)));
    painter.drawText(inside, Qt::AlignTop | Qt::AlignRight,
                     tr("ω = %1").arg(shownNumber(model_->shownSpeed(), units::rad_per_s, 2)));
    const bool isOther = guide.hinge != model_->shownHinge();
    if (guide.feasible && (isOther || reliefFactor() > 1.0)) {
        drawing::drawWithHalo(
            painter, inside, Qt::AlignBottom | Qt::AlignLeft,
            isOther ? tr("crank's guide, to scale")
                    : tr("relief × %1").arg(formNumber(reliefFactor(), QLocale(), 6)));
    }
    if (isPlaying() && model_->animatedMotion() != nullptr) {
        const double times = rounded_to_digits(1.0 / slowness(), 2);
        painter.drawText(inside, Qt::AlignBottom | Qt::AlignRight,
                         tr("%1 times slower").arg(formNumber(times, QLocale())));
    }
}

void HingeMechanismView::mousePressEvent(QMouseEvent* event) {
    mouseMoveEvent(event);
}

void HingeMechanismView::mouseMoveEvent(QMouseEvent* event) {
    if (!(event->buttons() & Qt::LeftButton)) {
        return;
    }
    const QPointF p = event->position() - frame().origin;
    turnTo(std::atan2(-p.y(), p.x()) / degree);
}

}  // namespace ravnoves

#include "inertia-moments/engine_view.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "inertia-moments/engine.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "pictures/model/shape.h"
#include "pictures/model/stroke.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

using inertia_moments::Complex;
using inertia_moments::Cylinder;
using inertia_moments::CylinderPose;
using inertia_moments::Engine;

namespace {

// Sizes of the picture that the input does not give, in crank radii.
constexpr double pistonHalf = 0.72;
constexpr double crownHeight = 0.75;
constexpr double pinShare = 0.26;  // half the length of a crankpin, from the side

/// Number of the bank of each cylinder: cylinders with the same direction and offset are in line.
std::vector<int> banksOf(const std::vector<Cylinder>& cylinders) {
    std::vector<std::pair<double, double>> known;
    std::vector<int> banks;
    for (const Cylinder& cylinder : cylinders) {
        const auto same = std::find_if(known.begin(), known.end(), [&](const auto& bank) {
            return std::abs(bank.first - cylinder.bank_angle) < 1e-6 &&
                   std::abs(bank.second - cylinder.offset) < 1e-9;
        });
        banks.push_back(static_cast<int>(same - known.begin()));
        if (same == known.end()) {
            known.emplace_back(cylinder.bank_angle, cylinder.offset);
        }
    }
    return banks;
}

/// The counterweight on the front (0) or rear web (1); null where there is none.
const inertia_moments::Counterweight* sideWeight(const InertiaMomentsModel& model,
                                                 std::size_t end) {
    const auto& webs = model.input().end_webs;
    const auto& design = model.result().counterweights;
    if (!webs || !webs->enabled || !design) {
        return nullptr;
    }
    const auto& weight = end == 0 ? design->front : design->rear;
    return std::abs(weight.unbalance) > 0.0 ? &weight : nullptr;
}

/// What the front view must hold, m, y up: it does not depend on φ, so the picture rests.
QRectF frontBounds(const InertiaMomentsModel& model) {
    const Engine& engine = model.result().engine;
    const double radius = engine.crank_radius;
    const double around = 1.25 * radius;
    QPolygonF corners{QPointF(-around, -around), QPointF(around, around)};
    for (const CylinderPose& pose : inertia_moments::engine_pose(engine, 0.0)) {
        for (const double side : {-pistonHalf, pistonHalf}) {
            const Complex corner =
                pose.axis_foot +
                pose.axis_direction * Complex(pose.top + crownHeight * radius, side * radius);
            corners << QPointF(corner.real(), corner.imag());
        }
    }
    return corners.boundingRect();
}

/// Where the crank begins and ends along its axis, with what is on it, m.
std::pair<double, double> sideBounds(const InertiaMomentsModel& model) {
    const Engine& engine = model.result().engine;
    const auto& input = model.input();
    std::vector<double> places{input.reference_position};
    for (const Cylinder& cylinder : engine.cylinders) {
        places.push_back(cylinder.axial_position);
    }
    if (input.end_webs && input.end_webs->enabled) {
        places.insert(places.end(),
                      {input.end_webs->front_position, input.end_webs->rear_position});
    }
    const auto [first, last] = std::ranges::minmax(places);
    const double margin = 0.8 * engine.crank_radius;
    return {first - margin, last + margin};
}

QPolygonF pistonOf(const CylinderPose& pose, double radius, const drawing::Frame& frame) {
    const Complex across = pose.axis_direction * Complex(0.0, 0.95 * pistonHalf * radius);
    const Complex crown = pose.piston_pin + pose.axis_direction * 0.6 * radius;
    const Complex skirt = pose.piston_pin - pose.axis_direction * 0.35 * radius;
    return {frame.at(crown + across), frame.at(crown - across), frame.at(skirt - across),
            frame.at(skirt + across)};
}

QRectF weightBlock(const QPointF& centre, double radiusPixels) {
    const QPointF half(0.16 * radiusPixels, 0.3 * radiusPixels);
    return {centre - half, centre + half};
}

double pointerAngle(const QPointF& from, const QPointF& to) {
    return std::atan2(from.y() - to.y(), to.x() - from.x()) / degree;
}

}  // namespace

EngineView::EngineView(InertiaMomentsModel* model, QWidget* parent)
    : MechanismPicture(model->crank(), tr("Engine from the front and the crank from the side"),
                       tr("To scale; the crank turns counter-clockwise. Drag to turn the crank; "
                          "Space plays and pauses, arrow keys step."),
                       parent),
      model_(model) {
    connect(model_, &SceneModel::changed, this, qOverload<>(&QWidget::update));
}

std::pair<QRectF, QRectF> EngineView::areas() const {
    const QRectF bounds = frontBounds(*model_);
    const QRectF whole = QRectF(rect()).adjusted(10, 24, -10, -8);
    const auto scale = [&](const QRectF& area) {
        return std::min(area.width() / bounds.width(), area.height() / bounds.height());
    };
    const QRectF above = whole.adjusted(0, 0, 0, -0.34 * whole.height());
    const QRectF beside = whole.adjusted(0, 0, -0.55 * whole.width(), 0);
    if (scale(beside) > scale(above)) {
        return {beside, whole.adjusted(0.47 * whole.width(), 0, 0, 0)};
    }
    return {above, whole.adjusted(0, 0.68 * whole.height(), 0, 0)};
}

void EngineView::paintPicture(QPainter& painter) {
    const Theme& theme = Theme::instance();
    const auto [front, side] = areas();
    paintFront(painter, front);
    paintSide(painter, side);
    painter.setFont(Theme::font(Theme::smallSize));
    painter.setPen(theme.mutedText());
    painter.drawText(QRectF(rect()).adjusted(8, 6, -8, -6), Qt::AlignTop | Qt::AlignLeft,
                     tr("φ = %1°").arg(fixedNumber(model_->crank()->degrees(), 0, QLocale())));
    painter.drawText(QRectF(rect()).adjusted(8, 6, -8, -6), Qt::AlignTop | Qt::AlignRight,
                     model_->layoutTitle(model_->layoutName()));
}

namespace {

/// Over all rods. Numbers that would cover one another, as of pistons one behind the other, stand
/// together in the middle of their places.
void paintNumbers(QPainter& painter, const std::vector<QPointF>& places) {
    struct Label {
        QPointF sum;
        std::vector<int> numbers;

        QRectF room(QPainter& painter) const {
            constexpr QPointF reach(200.0, 50.0);
            const QPointF middle = sum / static_cast<double>(numbers.size());
            return painter.boundingRect(QRectF(middle - reach, middle + reach), Qt::AlignCenter,
                                        text());
        }
        QString text() const {
            QStringList words;
            for (const int number : numbers) {
                words << QString::number(number);
            }
            return words.join(QStringLiteral(", "));
        }
    };
    std::vector<Label> labels;
    for (std::size_t i = 0; i < places.size(); ++i) {
        labels.push_back({places[i], {static_cast<int>(i) + 1}});
    }
    for (std::size_t i = 0; i < labels.size();) {
        constexpr double apart = 4.0;  // pixels; nearer, 1 and 3 would be 13
        const QRectF room = labels[i].room(painter).adjusted(-apart, 0.0, apart, 0.0);
        const auto covered =
            std::find_if(labels.begin() + static_cast<std::ptrdiff_t>(i) + 1, labels.end(),
                         [&](const Label& other) { return other.room(painter).intersects(room); });
        if (covered == labels.end()) {
            ++i;
            continue;
        }
        labels[i].sum += covered->sum;
        std::vector<int>& numbers = labels[i].numbers;
        numbers.insert(numbers.end(), covered->numbers.begin(), covered->numbers.end());
        std::sort(numbers.begin(), numbers.end());
        labels.erase(covered);
        i = 0;  // what is wider may cover others
    }
    for (const Label& label : labels) {
        drawing::drawWithHalo(painter, label.room(painter), Qt::AlignCenter, label.text());
    }
}

}  // namespace

void EngineView::paintFront(QPainter& painter, const QRectF& area) {
    const Theme& theme = Theme::instance();
    const Engine& engine = model_->result().engine;
    const double radius = engine.crank_radius;
    const double phi = model_->crank()->degrees() * degree;
    const std::vector<CylinderPose> poses = inertia_moments::engine_pose(engine, phi);
    const std::vector<int> banks = banksOf(engine.cylinders);

    const QRectF bounds = frontBounds(*model_);
    const double half = pistonHalf * radius;
    const double crown = crownHeight * radius;
    drawing::Frame frame;
    frame.pixelsPerUnit = std::min(area.width() / bounds.width(), area.height() / bounds.height());
    frame.origin =
        area.center() - QPointF(bounds.center().x(), -bounds.center().y()) * frame.pixelsPerUnit;
    crankPixel_ = frame.at({0.0, 0.0});

    // Axes of the banks, past the crank's centre by their offsets.
    painter.setPen(QPen(theme.border(), 1.0));
    paintLine(painter, QPointF(area.left(), crankPixel_.y()),
              QPointF(area.right(), crankPixel_.y()));
    paintLine(painter, QPointF(crankPixel_.x(), area.top()),
              QPointF(crankPixel_.x(), area.bottom()));
    int drawn = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        if (banks[i] < drawn) {
            continue;  // one behind the other
        }
        ++drawn;
        const CylinderPose& pose = poses[i];
        QColor line = drawing::bankColour(banks[i]);
        line.setAlphaF(0.5F);
        painter.setPen(QPen(line, 1.0));
        paintLine(painter, frame.at(pose.axis_foot - pose.axis_direction * 0.3 * radius),
                  frame.at(pose.axis_foot + pose.axis_direction * (pose.top + crown)));
        // Cylinder walls.
        painter.setPen(QPen(theme.mutedText(), 1.0));
        for (const double side : {-half, half}) {
            const Complex across = pose.axis_direction * Complex(0.0, side);
            paintLine(painter,
                      frame.at(pose.axis_foot + across +
                               pose.axis_direction * std::max(pose.bottom - 0.4 * radius, 0.0)),
                      frame.at(pose.axis_foot + across + pose.axis_direction * (pose.top + crown)));
        }
    }

    painter.setPen(QPen(theme.grid(), 1.2));
    painter.setBrush(Qt::NoBrush);
    paintDisc(painter, crankPixel_, frame.length(radius));

    // From the rear to the front, so that the nearer cylinder covers the farther one.
    std::vector<std::size_t> order(poses.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return engine.cylinders[a].axial_position < engine.cylinders[b].axial_position;
    });
    painter.setFont(Theme::font(Theme::smallSize, true));
    const double thick = std::clamp(frame.length(0.18 * radius), 2.5, 9.0);
    for (const std::size_t i : order) {
        const CylinderPose& pose = poses[i];
        const QColor bank = drawing::bankColour(banks[i]);
        QColor body = drawing::metal();
        body.setAlphaF(0.86F);
        painter.setPen(QPen(bank, 1.0));
        painter.setBrush(body);
        paintPolygon(painter, pistonOf(pose, radius, frame));
        const QPointF pin = frame.at(pose.rod_foot);
        const QPointF piston = frame.at(pose.piston_pin);
        drawing::drawRod(painter, pin, piston, thick, body, theme.text());
        paintDisc(painter, piston, 0.5 * thick);
    }
    // The big ends of master rods reach to the knuckle pins.
    for (const CylinderPose& pose : poses) {
        if (pose.articulated) {
            drawing::drawRod(painter, frame.at(pose.crankpin), frame.at(pose.rod_foot), thick,
                             drawing::metal(), theme.text());
            painter.setPen(QPen(theme.text(), 1.0));
            painter.setBrush(theme.panel());
            paintDisc(painter, frame.at(pose.rod_foot), 0.35 * thick);
        }
    }
    // The crank star over all.
    for (const CylinderPose& pose : poses) {
        drawing::drawRod(painter, crankPixel_, frame.at(pose.crankpin), thick, drawing::metal(),
                         theme.text());
    }
    painter.setPen(QPen(theme.text(), 1.0));
    painter.setBrush(theme.panel());
    paintDisc(painter, crankPixel_, 0.6 * thick + 1.5);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        painter.setPen(QPen(theme.text(), 1.0));
        painter.setBrush(drawing::bankColour(banks[i]));
        paintDisc(painter, frame.at(poses[i].crankpin), 0.5 * thick + 1.0);
    }
    // On the piston; where it is smaller than its number, above it, off the rod.
    const double letters = 0.5 * painter.fontMetrics().height() / frame.pixelsPerUnit;
    const double up = letters < 0.45 * radius ? 0.3 * radius : 0.6 * radius + letters;
    std::vector<QPointF> crowns;
    crowns.reserve(poses.size());
    for (const CylinderPose& pose : poses) {
        crowns.push_back(frame.at(pose.piston_pin + pose.axis_direction * up));
    }
    painter.setPen(theme.text());
    paintNumbers(painter, crowns);
}

double EngineView::Side::height(double angle) const {
    return std::cos(direction + angle);
}

void EngineView::paintSide(QPainter& painter, const QRectF& area) {
    const Theme& theme = Theme::instance();
    const Engine& engine = model_->result().engine;
    const auto& input = model_->input();
    const double radius = engine.crank_radius;
    const double phi = model_->crank()->degrees() * degree;
    const std::vector<int> banks = banksOf(engine.cylinders);

    const auto [low, high] = sideBounds(*model_);
    painter.setFont(Theme::font(Theme::smallSize));
    const double row = painter.fontMetrics().height();  // the numbers are below
    const double scale =
        std::min(area.width() / (high - low), (area.height() - row) / (2.3 * radius));
    const double axisY = area.center().y() - 0.5 * row;
    const Side at{{area.center().x(), axisY},
                  0.5 * (low + high),
                  scale,
                  phi + engine.cylinders.front().bank_angle};
    painter.setPen(QPen(theme.border(), 1.0));
    paintLine(painter, at(high, 0), at(low, 0));
    const std::array colours{drawing::weightFill(Role::CrankWeight),
                             drawing::weightFill(Role::RearWeight)};
    for (std::size_t i = 0; i < colours.size(); ++i) {
        if (const auto* weight = sideWeight(*model_, i)) {
            const double y = weight->radius * at.height(std::arg(weight->unbalance));
            painter.setPen(QPen(theme.text(), 1.0));
            paintLine(painter, at(weight->position, 0), at(weight->position, y));
            painter.setBrush(colours[i]);
            paintBlock(painter, weightBlock(at(weight->position, y), radius * scale), 0.0);
        }
    }

    // Throws: web, pin, web.
    const double pinHalf = pinShare * radius;
    std::map<int, QStringList> labels;
    for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
        const Cylinder& cylinder = engine.cylinders[i];
        const double y = radius * at.height(cylinder.crankpin_angle);
        const double z = cylinder.axial_position;
        painter.setPen(QPen(theme.text(), 2.0, Qt::SolidLine, Qt::FlatCap));
        paintLine(painter, at(z - pinHalf, 0), at(z - pinHalf, y));
        paintLine(painter, at(z + pinHalf, 0), at(z + pinHalf, y));
        painter.setPen(QPen(drawing::bankColour(banks[i]), 4.0, Qt::SolidLine, Qt::FlatCap));
        paintLine(painter, at(z - pinHalf, y), at(z + pinHalf, y));
        labels[static_cast<int>(std::lround(at(z, 0).x()))] << QString::number(i + 1);
    }
    // Numbers below the throws; those that would overlap share a place.
    painter.setPen(theme.text());
    for (auto label = labels.begin(); label != labels.end();) {
        const int first = label->first;
        int last = first;
        QStringList names;
        while (label != labels.end() && label->first - last <= Theme::withText(14)) {
            last = label->first;
            names << label->second;
            ++label;
        }
        drawing::drawCentred(
            painter, QPointF(0.5 * (first + last), axisY + 1.12 * radius * scale + 0.5 * row),
            names.join(QLatin1Char(',')));
    }
    // The point that moments refer to.
    const QPointF reference = at(input.reference_position, 0);
    painter.setPen(QPen(theme.accent(), 1.4));
    painter.setBrush(theme.panel());
    paintDisc(painter, reference, 5.0);
    paintLine(painter, reference - QPointF(8, 0), reference + QPointF(8, 0));
    paintLine(painter, reference - QPointF(0, 8), reference + QPointF(0, 8));
}

void EngineView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        return;
    }
    setPlaying(false);
    // The crank follows the pointer round its axis without a jump.
    dragOffset_ = model_->crank()->degrees() - pointerAngle(crankPixel_, event->position());
}

void EngineView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons().testFlag(Qt::LeftButton)) {
        turnTo(pointerAngle(crankPixel_, event->position()) + dragOffset_);
    }
}

}  // namespace ravnoves

#include "inertia-moments/model/inertia_moments_model.h"

#include <algorithm>
#include <cmath>

#include "case-file/result_json.h"
#include "inertia-moments/fields.h"
#include "model/case_model_json.h"
#include "text/message_text.h"
#include "text/shown_units.h"

namespace ravnoves {

using inertia_moments::Balances;
using inertia_moments::Cylinder;
using inertia_moments::Direction;
using inertia_moments::Input;
using inertia_moments::Layout;
using inertia_moments::Shaft;
namespace field = inertia_moments::field;

namespace {

const QString paperEngine = QStringLiteral("vw-vr5");
const QString radialEngine = QStringLiteral("radial-%1");
const QString ownTable = QStringLiteral("table");

/// Cylinders of a radial by its name; 0 for other layouts.
int radialCount(const QString& name) {
    for (const int count : inertia_moments::radial_counts) {
        if (name == radialEngine.arg(count)) {
            return count;
        }
    }
    return 0;
}

std::pair<double, double> extent(const std::vector<Cylinder>& cylinders, double Cylinder::*member) {
    const auto ends = std::ranges::minmax_element(cylinders, {}, member);
    return {(*ends.min).*member, (*ends.max).*member};
}

}  // namespace

template class CaseModel<InertiaMomentsScene>;

InertiaMomentsModel::InertiaMomentsModel(QObject* parent) : CaseModel({}, parent) {}

Json InertiaMomentsModel::resultJson() const {
    return result_json({}, input(), result());
}

bool InertiaMomentsModel::setViewOption(const QString& key, const QString& value) {
    if (key == QLatin1String("crank_angle_deg")) {
        crank_.turnTo(readNumber(key, value));
    } else if (key == QLatin1String("layout_name")) {
        oneOf(key, value, layoutNames());
        chooseLayout(value);
    } else {
        return false;
    }
    return true;
}

QString InertiaMomentsModel::editField(const std::string& pointer, const FieldValue& value,
                                       const QString& name) {
    return edit(name, [&](Input& input) {
        const Input before = input;
        setField(input, pointer, value);
        inertia_moments::follow_sizes(input, before);
    });
}

// -------------------------------------------------------------------------------------- layout

QStringList InertiaMomentsModel::layoutNames() {
    QStringList names{paperEngine};
    for (const int count : inertia_moments::radial_counts) {
        names << radialEngine.arg(count);
    }
    for (const inertia_moments::LayoutSpec& spec : inertia_moments::layout_library()) {
        names << QString::fromUtf8(spec.name.data(), static_cast<qsizetype>(spec.name.size()));
    }
    return names << ownTable;
}

QString InertiaMomentsModel::layoutTitle(const QString& name) const {
    if (name == paperEngine) {
        return tr("VW VR5 (paper)");
    }
    if (const int count = radialCount(name); count > 0) {
        return tr("Radial %1").arg(count);
    }
    if (name == ownTable) {
        return tr("Own table");
    }
    if (const auto* spec = inertia_moments::find_layout(name.toStdString())) {
        return shownText(spec->title);
    }
    const int cylinders = input().layout ? inertia_moments::cylinder_count(*input().layout) : 0;
    return tr("VR%1").arg(cylinders);
}

QString InertiaMomentsModel::layoutName() const {
    if (!input().layout) {
        for (const int count : inertia_moments::radial_counts) {
            Input radial = input();
            inertia_moments::make_radial(radial, count);
            if (input().cylinders == radial.cylinders) {
                return radialEngine.arg(count);
            }
        }
        return ownTable;
    }
    QString name = QString::fromStdString(input().layout->name);
    if (name != QLatin1String("vr")) {
        return name;
    }
    static const Input paper = inertia_moments::preset_vw_vr5();
    if (input().layout == paper.layout && input().crank_radius == paper.crank_radius &&
        input().ratio() == paper.ratio() &&
        input().reciprocating_mass == paper.reciprocating_mass &&
        input().angular_speed == paper.angular_speed &&
        input().reference_position == paper.reference_position) {
        return paperEngine;
    }
    for (const int cylinders : {5, 6}) {
        if (input().layout->cylinders == cylinders) {
            return QStringLiteral("vr%1").arg(cylinders);
        }
    }
    return QStringLiteral("vr");
}

QString InertiaMomentsModel::layoutText() const {
    return input().layout ? layoutTitle(QString::fromStdString(input().layout->name))
                          : tr("Own table, cylinders: %1").arg(input().cylinders.size());
}

void InertiaMomentsModel::chooseLayout(const QString& name) {
    if (name == layoutName()) {
        return;
    }
    if (name == paperEngine) {
        edit(
            tr("Layout"), [](Input& input) { input = inertia_moments::preset_vw_vr5(); },
            QStringLiteral("Volkswagen VR5"));
        Q_EMIT broughtIn();
        return;
    }
    if (const int count = radialCount(name); count > 0) {
        edit(
            tr("Layout"), [count](Input& input) { inertia_moments::make_radial(input, count); },
            layoutTitle(name));
        return;
    }
    if (name == ownTable) {
        makeTable();
        return;
    }
    const inertia_moments::LayoutSpec* spec = inertia_moments::find_layout(name.toStdString());
    if (spec == nullptr) {
        return;
    }
    const auto choose = [&](Input& input) {
        input.layout = inertia_moments::usual_layout(*spec, input.crank_radius);
        input.cylinders.clear();
        input.firing_order.clear();
        input.reference_position = 0.0;
        const auto cylinders = inertia_moments::make_cylinders(input);
        const bool counted = input.end_webs && input.end_webs->enabled;
        input.end_webs = inertia_moments::usual_end_webs(cylinders, input.crank_radius);
        input.end_webs->enabled = counted;
        input.shafts = inertia_moments::usual_shafts(cylinders, input.crank_radius);
    };
    edit(tr("Layout"), choose, layoutTitle(name));
}

void InertiaMomentsModel::makeTable() {
    edit(tr("Own table"), [this](Input& input) { tableOf(input); });
}

std::vector<Cylinder>& InertiaMomentsModel::tableOf(Input& input) const {
    if (input.layout) {
        input.cylinders = inertia_moments::rounded(result().engine.cylinders);
        input.firing_order = input.layout->firing_order;
        input.layout.reset();
    }
    return input.cylinders;
}

QString InertiaMomentsModel::setEvenFiring() {
    const std::vector<int> order = firingOrder();
    const int count = static_cast<int>(result().engine.cylinders.size());
    if (!inertia_moments::is_firing_order(order, count)) {
        return tr("Enter a firing order for even firing.");
    }
    if (hasArticulatedRods()) {
        return tr("Articulated rods run on their master's crankpin and cannot be separated.");
    }
    return edit(tr("Even firing"), [&](Input& input) {
        inertia_moments::set_even_firing(tableOf(input), order, input);
        input.cylinders = inertia_moments::rounded(std::move(input.cylinders));
    });
}

bool InertiaMomentsModel::hasArticulatedRods() const {
    const auto& cylinders = result().engine.cylinders;
    return std::any_of(cylinders.begin(), cylinders.end(),
                       [](const Cylinder& cylinder) { return cylinder.articulated.has_value(); });
}

QString InertiaMomentsModel::setArticulatedRods(bool on) {
    return edit(tr("Articulated rods"), [&](Input& input) {
        std::vector<Cylinder>& cylinders = tableOf(input);
        if (on) {
            inertia_moments::hang_on_masters(cylinders, input.crank_radius);
        } else {
            for (Cylinder& cylinder : cylinders) {
                cylinder.articulated.reset();
            }
        }
    });
}

const std::vector<int>& InertiaMomentsModel::firingOrder() const {
    return input().layout ? input().layout->firing_order : input().firing_order;
}

QString InertiaMomentsModel::orderText(const std::vector<int>& order) {
    return order.empty() ? QString() : messageText(inertia_moments::firing_order_text(order));
}

QString InertiaMomentsModel::orderTrouble(const std::vector<int>& order) const {
    if (order.empty() && !input().layout) {
        return {};
    }
    const int count = static_cast<int>(result().engine.cylinders.size());
    return messageText(inertia_moments::firing_order_trouble(order, count));
}

QString InertiaMomentsModel::setFiringOrder(const std::vector<int>& order) {
    return edit(fieldName(field::firing_order), [&](Input& input) {
        (input.layout ? input.layout->firing_order : input.firing_order) = order;
    });
}

// -------------------------------------------------------------------------------------- throws

bool InertiaMomentsModel::hasSharedPins() const {
    return result().engine.throws.size() < result().engine.cylinders.size();
}

QString InertiaMomentsModel::setRotatingMassOfThrow(bool ofThrow) {
    const auto count = static_cast<double>(result().engine.throws.front().cylinders.size());
    return edit(fieldName(field::rotating_mass), [&](Input& input) {
        if (input.rotating_mass_of_throw != ofThrow) {
            const double mass = ofThrow ? input.rotating_mass * count : input.rotating_mass / count;
            input.rotating_mass = rounded(mass, field::rotating_mass, 12);
            input.rotating_mass_of_throw = ofThrow;
        }
    });
}

QString InertiaMomentsModel::throwMassText() const {
    QStringList kinds;
    for (const auto& [rods, kind] : inertia_moments::kinds_of_throw(result().engine.throws)) {
        kinds << tr("%1, rods: %2")
                     .arg(shownShort(result().engine.mass_on(*kind), units::kg, 4))
                     .arg(rods);
    }
    return kinds.join(QLatin1Char('\n'));
}

// ------------------------------------------------------------------------------------- sliders

double InertiaMomentsModel::bankAngleDeg() const {
    if (input().layout) {
        return from_si(field::included_angle, input().layout->bank_angle);
    }
    const auto [low, high] = extent(input().cylinders, &Cylinder::bank_angle);
    return (high - low) / degree;
}

bool InertiaMomentsModel::canChangeBankAngle() const {
    return input().layout && inertia_moments::arrangement_of(*input().layout) !=
                                 inertia_moments::Arrangement::in_line;
}

bool InertiaMomentsModel::canBeStaggered() const {
    return input().layout && inertia_moments::has_paired_banks(*input().layout);
}

double InertiaMomentsModel::offsetMm() const {
    if (input().layout) {
        return from_si(field::layout_offset, input().layout->offset);
    }
    double largest = 0.0;
    for (const Cylinder& cylinder : input().cylinders) {
        largest = std::max(largest, std::abs(cylinder.offset));
    }
    return from_si(field::offset, largest);
}

std::pair<double, double> InertiaMomentsModel::offsetLimitsMm() const {
    const double reach = (input().rod_length() - input().crank_radius) / units::mm;
    const double radius = input().crank_radius / units::mm;
    const double maximum = std::floor(std::min(0.98 * reach, radius) * 10.0) / 10.0;
    const double high = std::max(maximum, std::abs(offsetMm()));
    return {-high, high};
}

std::pair<double, double> InertiaMomentsModel::referenceLimitsMm() const {
    const auto [low, high] = extent(result().engine.cylinders, &Cylinder::axial_position);
    const double room = std::max(high - low, 2.0 * input().crank_radius) / 2.0;
    const double reference = input().reference_position;
    return {std::floor(std::min(low - room, reference) / units::mm),
            std::ceil(std::max(high + room, reference) / units::mm)};
}

// -------------------------------------------------------------------------------------- shafts

void InertiaMomentsModel::addShaft() {
    edit(tr("Add shaft"), [](Input& input) {
        if (input.shafts.size() >= static_cast<std::size_t>(inertia_moments::max_shafts)) {
            return;
        }
        Shaft shaft;
        if (!input.shafts.empty()) {
            shaft = input.shafts.back();
            // The counterpart of the last one, or the next order.
            if (shaft.direction == Direction::forward) {
                shaft.direction = Direction::backward;
            } else {
                shaft.direction = Direction::forward;
                shaft.order = std::min(shaft.order + 1, inertia_moments::highest_order);
            }
            shaft.phase_error = 0.0;
        } else {
            shaft.weight_radius = 0.02;
        }
        shaft.enabled = true;
        input.shafts.push_back(shaft);
    });
}

void InertiaMomentsModel::removeShaft(int index) {
    edit(tr("Remove shaft"), [index](Input& input) {
        if (index >= 0 && index < static_cast<int>(input.shafts.size())) {
            input.shafts.erase(input.shafts.begin() + index);
        }
    });
}

void InertiaMomentsModel::setShaftEnabled(int index, bool enabled) {
    edit(enabled ? tr("Shaft on") : tr("Shaft off"),
         [=](Input& input) { input.shafts.at(static_cast<std::size_t>(index)).enabled = enabled; });
}

QString InertiaMomentsModel::shaftTitle(const Shaft& shaft) const {
    const QString sign =
        shaft.direction == Direction::forward ? QStringLiteral("+") : QStringLiteral("\u2212");
    const QString speed =
        shaft.order == 1 ? QStringLiteral("ω") : QString::number(shaft.order) + QStringLiteral("ω");
    return (shaft.balances == Balances::force ? tr("F") : tr("M")) + QStringLiteral("\u00A0") +
           sign + speed;
}

namespace {

/// Of what follows from another input: it is in the case as it is on the page.
constexpr int digitsOnPage = 6;

}  // namespace

QString InertiaMomentsModel::setRodRatio(std::optional<double> ratio) {
    return edit(fieldName(inertia_moments::field::lambda), [ratio](Input& input) {
        input.given_rod_length =
            ratio ? std::nullopt
                  : std::optional(rounded(input.rod_length(), field::rod_length, digitsOnPage));
        input.lambda = ratio.value_or(input.lambda);
    });
}

QString InertiaMomentsModel::setRodLength(std::optional<double> length) {
    return edit(fieldName(inertia_moments::field::rod_length), [length](Input& input) {
        input.lambda = rounded(input.ratio(), field::lambda, digitsOnPage);
        input.given_rod_length = length;
    });
}

// ---------------------------------------------------------------------------------------- view

void InertiaMomentsModel::takeView(const SceneModel& other) {
    const auto* model = qobject_cast<const InertiaMomentsModel*>(&other);
    if (model == nullptr) {
        return;
    }
    const bool before = showsForces();
    forces_ = model->showsForces();
    if (before != *forces_) {
        Q_EMIT viewChanged();
    }
}

}  // namespace ravnoves

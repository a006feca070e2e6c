// The tables of results of the page: what core found, as text and numbers.

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "inertia-moments/model/inertia_moments_model.h"
#include "numerics/angle.h"
#include "plot/model/ticks.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

using inertia_moments::Balances;
using inertia_moments::Complex;
using inertia_moments::Difference;
using inertia_moments::Direction;
using inertia_moments::EngineOrder;
using inertia_moments::RotatingPair;
using inertia_moments::ShaftDesign;

namespace {

const QString dash = QStringLiteral("–");

QString number(double value, int decimals) {
    return fixedNumber(value, decimals, QLocale());
}

/// Four digits, whatever the size, or the two that matter of a trace: forces of a model engine and
/// of a ship's fit the same column.
QString figure(double value) {
    const double size = std::abs(value);
    if (size == 0.0) {
        return number(0.0, 0);
    }
    if (size >= 1e6 || size < 1e-4) {
        return powerText(value, QLocale(), size < 1.0 ? 2 : 4);
    }
    const int decimals = std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
    return number(value, std::min(decimals, 3));
}

/// Of a quantity, in the unit shown.
ResultCell figure(double si, const Unit& unit) {
    const double value = shownValue(si, unit);
    return {value, figure(value)};
}

QString forceAndMoment() {
    return shownUnit(units::newton).name + QStringLiteral("; ") +
           InertiaMomentsModel::tr("%1 about z₀").arg(shownUnit(units::N_m).name);
}

/// The same, and 0 where it is nothing but rounding beside its scale.
ResultCell figure(double si, double scale, const Unit& unit) {
    return std::abs(si) > inertia_moments::zero_share * scale
               ? figure(si, unit)
               : ResultCell(0.0, QStringLiteral("0"));
}

ResultCell degrees(double radians) {
    const double angle = wrap(radians / degree, 360.0);
    // 359.96 would print as 360.0
    const double rounded = std::round(angle * 10.0) / 10.0;
    return {angle, number(rounded >= 360.0 ? 0.0 : rounded, 1), ResultCell::Kind::Direction};
}

/// A direction, or a dash where the vector is nothing beside its scale.
ResultCell directionOf(const Complex& vector, double scale) {
    return std::abs(vector) > inertia_moments::zero_share * scale ? degrees(std::arg(vector))
                                                                  : ResultCell(dash);
}

ResultCell percent(double share) {
    return {100.0 * share, number(100.0 * share, 1)};
}

constexpr QChar wideSpace(0x2002);

/// Of inertia_moments::components().
constexpr const char* componentNames[] = {"Fx", "Fy", "Mx", "My", "Mz"};

constexpr const char* componentTips[] = {
    QT_TRANSLATE_NOOP("ravnoves::InertiaMomentsModel",
                      "Force to the right; the number is its order"),
    QT_TRANSLATE_NOOP("ravnoves::InertiaMomentsModel", "Force upwards; the number is its order"),
    QT_TRANSLATE_NOOP("ravnoves::InertiaMomentsModel",
                      "Moment in the horizontal plane, Σ Fx (z − z₀)"),
    QT_TRANSLATE_NOOP("ravnoves::InertiaMomentsModel",
                      "Moment in the vertical plane, Σ Fy (z − z₀)"),
    QT_TRANSLATE_NOOP(
        "ravnoves::InertiaMomentsModel",
        "Roll moment on the engine, of offsets, rods and the reaction of the torque")};

/// The rows of force and moment of an order.
void addOrder(ResultRows& rows, int order, QVector<ResultCell> force, QVector<ResultCell> moment) {
    const QString k = QString::number(order) + wideSpace;
    force.prepend(k + QStringLiteral("F"));
    moment.prepend(k + QStringLiteral("M"));
    rows << ResultRow(std::move(force),
                      InertiaMomentsModel::tr("Force of the order k = the number"))
         << ResultRow(std::move(moment),
                      InertiaMomentsModel::tr("Moment of the order k = the number"));
}

}  // namespace

Results InertiaMomentsModel::orderResults() const {
    Results results{
        {forceAndMoment(),
         {tr("recipr. exact"),
          tr("Amplitude of the order of the reciprocating masses, exact motion")},
         {tr("phase, °"), tr("kφ of the maximum of the exact component")},
         {tr("recipr. two-term"), tr("Amplitude by the paper's cos θ + K λ sin θ + λ cos 2θ")},
         {tr("δ, %"), tr("Error of the two-term form, relative to exact")}}};
    ResultRows& rows = results.rows;
    rows.reserve(static_cast<qsizetype>(result().differences.size()));
    const ResultCell zero(0.0, QStringLiteral("0"));
    for (const Difference& d : result().differences) {
        const auto h = inertia_moments::components(result().exact.order(d.order))[d.component];
        const Unit& unit = d.component < 2 ? units::newton : units::N_m;
        ResultRow row(
            {QString::number(d.order) + wideSpace + QLatin1String(componentNames[d.component])},
            tr(componentTips[d.component]));
        row << (d.relative
                    ? ResultRow{figure(d.exact, unit), degrees(inertia_moments::phase(h)),
                                figure(d.two_term, std::abs(d.exact), unit), percent(*d.relative)}
                    : ResultRow{zero, dash, zero, dash});
        rows << row;
    }
    return results;
}

Results InertiaMomentsModel::rotatingResults() const {
    const ResultColumn at(
        tr("at, °"), tr("Direction of the part to the left at φ = 0, counter-clockwise from x"));
    Results results{
        {forceAndMoment(),
         {tr("+kω"), tr("Part A that turns with the crank: x + iy = A exp(ikφ) + B exp(−ikφ)")},
         at,
         {tr("−kω"), tr("Part B that turns against the crank")},
         at}};
    ResultRows& rows = results.rows;
    const auto cells = [](const RotatingPair& pair, double scale, const Unit& unit) {
        return QVector<ResultCell>{
            figure(std::abs(pair.forward), scale, unit), directionOf(pair.forward, scale),
            figure(std::abs(pair.backward), scale, unit), directionOf(pair.backward, scale)};
    };
    for (const EngineOrder& order : result().exact.orders) {
        addOrder(rows, order.order, cells(order.force, order.force_scale, units::newton),
                 cells(order.moment, order.moment_scale, units::N_m));
    }
    return results;
}

Results InertiaMomentsModel::shaftResults() const {
    Results results{
        {{forceAndMoment(), tr("Order, task and direction; a full dot is switched on")},
         {tr("cancels"), tr("The part of the order that the shaft cancels")},
         {shownTitle(tr("mρ, g·mm")).text,
          tr("Weight times radius: m ρ (kω)² is the force, m ρ L (kω)² the moment cancelled")},
         {tr("at, °"),
          tr("Direction of its weight (towards cylinder 1) at φ = 0, counter-clockwise from x")},
         {tr("recip. left"),
          tr("Maximum of the reciprocating masses' order with this shaft alone; the rotating "
             "masses are not in it")}}};
    ResultRows& rows = results.rows;
    for (const ShaftDesign& design : result().shafts) {
        const QString mark =
            design.shaft.enabled ? QStringLiteral("\u25CF ") : QStringLiteral("\u25CB ");
        const Unit& unit = design.shaft.balances == Balances::force ? units::newton : units::N_m;
        rows.push_back(
            {mark + shaftTitle(design.shaft), figure(std::abs(design.target), design.scale, unit),
             design.phase ? figure(design.unbalance, units::gram_mm)
                          : ResultCell(0.0, QStringLiteral("0")),
             design.phase ? degrees(*design.phase) : ResultCell(dash),
             design.phase ? figure(design.remaining, design.scale, unit) : ResultCell(dash)});
    }
    return results;
}

Results InertiaMomentsModel::weightResults() const {
    const inertia_moments::RotatingMasses& rotating = result().rotating;
    const auto row = [](const QString& name, const ResultCell& value, const Complex& vector,
                        double scale, const QString& tip) {
        return ResultRow({shownTitle(name).text, value, directionOf(vector, scale),
                          directionOf(std::conj(vector), scale)},
                         tip);
    };
    ResultRows rows{
        row(tr("Force, N"),
            figure(std::abs(rotating.force()), rotating.force_scale * rotating.mass_force,
                   units::newton),
            rotating.force_factor, rotating.force_scale,
            tr("Force of the rotating masses, m R ω² |Σ exp(iκ)|")),
        row(tr("Moment about zₘ, N·m"),
            figure(std::abs(rotating.moment()), rotating.moment_scale * rotating.mass_force,
                   units::N_m),
            rotating.moment_factor, rotating.moment_scale,
            tr("Moment of the rotating masses, m R ω² |Σ (z − zₘ) exp(iκ)|, about zₘ, the mean "
               "axial position of the crankpins. Other moments are about z₀.")),
        row(tr("against the force"), dash, -rotating.force_factor, rotating.force_scale,
            tr("Place of a counterweight against the force")),
        row(tr("against the moment"), dash, -rotating.moment_factor, rotating.moment_scale,
            tr("Place of the front one of two opposite counterweights against the moment"))};
    for (const auto& [rods, kind] : inertia_moments::kinds_of_throw(result().engine.throws)) {
        rows << ResultRow(
            {shownTitle(tr("On a throw, rods: %1, g").arg(rods)).text,
             figure(result().engine.mass_on(*kind), units::gram)},
            tr("Rotating mass on one crankpin with this number of rods, at the crank radius"));
    }
    if (result().counterweights) {
        const inertia_moments::CounterweightDesign& design = *result().counterweights;
        const auto weight = [&](const QString& name, const inertia_moments::Counterweight& w,
                                const QString& unbalanceTip, const QString& massTip) {
            rows << row(name + tr(", g·mm"),
                        figure(std::abs(w.unbalance), design.scale, units::gram_mm), w.unbalance,
                        design.scale, unbalanceTip)
                 << ResultRow({shownTitle(name + tr(", g")).text,
                               figure(w.mass(), design.scale / w.radius, units::gram)},
                              massTip);
        };
        weight(tr("Front web"), design.front, tr("Mass times radius of the front counterweight"),
               tr("Mass of the front counterweight at its radius"));
        weight(tr("Rear web"), design.rear, tr("Mass times radius of the rear counterweight"),
               tr("Mass of the rear counterweight at its radius"));
    }
    return {{tr("Rotating masses"),
             tr("value"),
             {tr("angle, °"), tr("From crankpin 1, counter-clockwise")},
             {tr("lag, °"), tr("From crankpin 1 against the rotation")}},
            rows};
}

Results InertiaMomentsModel::remainingResults() const {
    Results results{
        {forceAndMoment(),
         {tr("before"), tr("Maximum over a turn, with the rotating masses, without balancing")},
         {tr("residual"), tr("Maximum with the counterweights and shafts that are on")},
         {tr("residual, %"), tr("Residual relative to the value before balancing")}}};
    ResultRows& rows = results.rows;
    const auto cells = [](double was, double is, double scale, const Unit& unit) {
        const bool isZero = !(was > inertia_moments::zero_share * scale);
        ResultCell left = figure(is, scale, unit);
        left.isSmallerBetter = true;
        return QVector<ResultCell>{figure(was, scale, unit), left,
                                   isZero ? ResultCell(dash) : percent(is / was)};
    };
    for (std::size_t i = 0; i < result().unbalanced.orders.size(); ++i) {
        const EngineOrder& before = result().unbalanced.orders[i];
        const EngineOrder& after = result().remaining.orders[i];
        addOrder(rows, before.order,
                 cells(before.force.max(), after.force.max(), before.force_scale, units::newton),
                 cells(before.moment.max(), after.moment.max(), before.moment_scale, units::N_m));
    }
    return results;
}

}  // namespace ravnoves

// Of what the torque is made, its orders, and what it does to the speed; the forces on the engine
// without and with a shaft, what a gear fitted some teeth out and its play do, and the shaft with a
// relieved middle.

#include <algorithm>
#include <functional>

#include "balance-shaft/crank_balance.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/result_fields.h"
#include "numerics/constants.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves::shaft_parts {

using balance_shaft::CrankBalance;
using balance_shaft::ForceLocus;
using balance_shaft::GearError;

Figure torque(const BalanceShaftModel& model) {
    const balance_shaft::MomentCurves& curves = model.result().curves;
    Figure figure =
        overCycle(model, ShaftParts::tr("Engine torque and its parts"), ShaftParts::tr("N·m"));
    if (curves.M_gas.empty()) {
        return figure;  // the torque is a table
    }
    const std::vector<double>& phi = curves.crank_angle_deg;
    figure.add("gas",
               {.name = ShaftParts::tr("gas"),
                .role = Role::Gas,
                .toolTip = ShaftParts::tr("−(p − p₀) A s′")},
               phi, curves.M_gas);
    figure.add("inertia",
               {.name = ShaftParts::tr("inertia"),
                .role = Role::Reciprocating,
                .toolTip = ShaftParts::tr("−mⱼ ω² s′ s″")},
               phi, curves.M_inertia);
    if (model.input().cylinder.offset != 0.0) {
        figure.add(
            "offset",
            {.name = ShaftParts::tr("offset"),
             .role = Role::Offset,
             .toolTip = ShaftParts::tr("e mⱼ ω² s″: part of Mᵤₚ due to the offset cylinder")},
            phi, curves.M_offset);
    }
    std::vector<double> total(curves.M_up.size());
    std::transform(curves.M_offset.begin(), curves.M_offset.end(), curves.M_up.begin(),
                   total.begin(), std::minus<>());
    figure.add("total",
               {.name = ShaftParts::tr("engine torque"),
                .role = Role::Engine,
                .width = 2.0,
                .toolTip = ShaftParts::tr("Gas plus inertia")},
               phi, std::move(total));
    return figure;
}

namespace {

auto pressureStyle() {
    return plot::CurveStyle{
        .name = ShaftParts::tr("p"), .role = Role::Gas, .width = 1.8, .inLegend = false};
}

}  // namespace

Figure pressure(const BalanceShaftModel& model) {
    const balance_shaft::MomentCurves& curves = model.result().curves;
    Figure figure = overCycle(model, ShaftParts::tr("Cylinder pressure"), ShaftParts::tr("bar"));
    if (!curves.pressure.empty()) {
        figure.add("pressure", pressureStyle(), curves.crank_angle_deg,
                   inUnit(curves.pressure, units::bar));
    }
    return figure;
}

Figure indicator(const BalanceShaftModel& model) {
    const balance_shaft::Result& result = model.result();
    Figure figure;
    figure.title = ShaftParts::tr("Indicator diagram, p–V");
    figure.left = {.title = ShaftParts::tr("bar")};
    if (!result.indicated || result.curves.volume.empty()) {
        return figure;
    }
    std::vector<double> volume = inUnit(result.curves.volume, units::cm3);
    // A trace has no clearance volume: without it all cycles can be compared.
    for (double& each : volume) {
        each -= result.indicated->clearance.value_or(0.0) / units::cm3;
    }
    figure.x = {.title = ShaftParts::tr("V without clearance, cm³"),
                .min = 0.0,
                .max = 1.03 * *std::max_element(volume.begin(), volume.end())};
    figure.add("loop", pressureStyle(), std::move(volume),
               inUnit(result.curves.pressure, units::bar));
    return figure;
}

Figure orders(const BalanceShaftModel& model) {
    const balance_shaft::Result& result = model.result();
    Figure figure;
    figure.title = ShaftParts::tr("Order spectrum of the moment");
    figure.x = {.title = ShaftParts::tr("order (per turn of the crank)"), .min = 0.0, .max = 12.5};
    figure.left = {.title = ShaftParts::tr("N·m")};
    const auto add = [&](const char* id, const QString& name, Role role, const QString& tip,
                         double shift, const auto& spectrum) {
        Figure::Curve& curve = figure.add(id,
                                          {.name = name,
                                           .role = role,
                                           .shape = plot::Shape::Bars,
                                           .toolTip = tip,
                                           .barWidth = 0.18,
                                           .barShift = shift},
                                          {}, {});
        for (const auto& order : spectrum) {
            curve.x.push_back(order.order);
            curve.y.push_back(order.amplitude);
        }
    };
    add("M_up", ShaftParts::tr("without shaft (Mᵤₚ)"), Role::Engine,
        ShaftParts::tr("Without a shaft"), -0.1, result.spectrum_M_up);
    add("M_ups", ShaftParts::tr("with shaft (Mᵤₚₛ)"), Role::Sum,
        ShaftParts::tr("With the shaft at the present α"), 0.1, result.spectrum_M_ups);
    return figure;
}

Results orderTable(const BalanceShaftModel& model) {
    const balance_shaft::Result& result = model.result();
    const ResultColumn phase(
        ShaftParts::tr("phase, °"),
        ShaftParts::tr("Phase of the moment to the left: amplitude × sin(kφ + phase)"));
    Results results{{{ShaftParts::tr("Order"), ShaftParts::tr("Multiple of the crank speed")},
                     {shownTitle(ShaftParts::tr("Mᵤₚ, N·m")).text,
                      ShaftParts::tr("Fourier amplitude of the moment without a shaft")},
                     phase,
                     {shownTitle(ShaftParts::tr("Mᵤₚₛ, N·m")).text,
                      ShaftParts::tr("Fourier amplitude with the shaft at the present α")},
                     phase}};
    const auto moment = [](double value) { return shownCell(value, units::N_m, 2); };
    const auto direction = [](double value) {
        return ResultCell(value / degree, shownDigits(value, units::degree, 1),
                          ResultCell::Kind::Direction);
    };
    for (std::size_t i = 0; i < result.spectrum_M_up.size(); ++i) {
        const auto& without = result.spectrum_M_up[i];
        const auto& with = result.spectrum_M_ups[i];
        results.rows.push_back({formNumber(without.order, QLocale()), moment(without.amplitude),
                                direction(without.phase), moment(with.amplitude),
                                direction(with.phase)});
    }
    return results;
}

Figure energy(const BalanceShaftModel& model) {
    const balance_shaft::Flywheel& wheel = model.result().flywheel;
    Figure figure =
        overCycle(model, ShaftParts::tr("Excess energy over the cycle"), ShaftParts::tr("J"));
    figure.add("energy",
               {.name = ShaftParts::tr("E"),
                .role = Role::Value,
                .width = 1.8,
                .inLegend = false,
                .toolTip = ShaftParts::tr("Work of the engine torque minus work of its mean")},
               model.result().curves.crank_angle_deg, wheel.energy);
    auto& marks = figure.marks.emplace();
    const auto mark = [&](double angle, double joules, const QString& text) {
        marks.push_back({.x = angle / degree,
                         .y = joules,
                         .text = text.arg(fixedNumber(joules, 0, QLocale())),
                         .role = Role::Value});
    };
    mark(wheel.max_angle, wheel.max_energy, ShaftParts::tr("fastest, %1 J"));
    mark(wheel.min_angle, wheel.min_energy, ShaftParts::tr("slowest, %1 J"));
    return figure;
}

Figure forceLocus(const BalanceShaftModel& model) {
    const CrankBalance balance = balance_shaft::crank_balance(model.solver());
    const auto room = [](double force) { return 1.15 * force / units::kN; };
    const double along = std::max(balance.along, balance.with_shaft);
    Figure figure;
    figure.title = ShaftParts::tr("Force on the engine");
    figure.x = {.title = ShaftParts::tr("across, kN"),
                .min = -room(balance.across),
                .max = room(balance.across)};
    figure.left = {.title = ShaftParts::tr("along, kN")};
    figure.leftRange =
        std::pair(-room(std::max(along, balance.second_order)), room(along + balance.second_order));
    figure.equalScale = true;
    const auto add = [&](const char* id, plot::CurveStyle style, ForceLocus locus) {
        style.turn = 360.0;
        figure.add(id, std::move(style), inUnit(std::move(locus.x), units::kN),
                   inUnit(std::move(locus.y), units::kN));
    };
    add("both",
        {.name = ShaftParts::tr("without shaft, 1st + 2nd order"),
         .role = Role::AllOrders,
         .toolTip = ShaftParts::tr("First and second order without a shaft")},
        force_locus(balance, balance.across, balance.along, balance.second_order));
    add("first",
        {.name = ShaftParts::tr("without shaft, 1st order"),
         .role = Role::Engine,
         .width = 2.0,
         .toolTip = ShaftParts::tr("First order without a shaft: an ellipse")},
        force_locus(balance, balance.across, balance.along, 0.0));
    add("shaft",
        {.name = ShaftParts::tr("with shaft"),
         .role = Role::Sum,
         .width = 2.0,
         .toolTip = ShaftParts::tr("With the shaft the first order is a point; the second order "
                                   "along the cylinder remains")},
        force_locus(balance, 0.0, balance.with_shaft, balance.second_order));
    return figure;
}

Results forces(const BalanceShaftModel& model) {
    namespace key = balance_shaft::result_field;
    const CrankBalance balance = balance_shaft::crank_balance(model.solver());
    Results results{{ShaftParts::tr("Force"), ShaftParts::tr("Value"), ShaftParts::tr("Unit")}};
    results.rows = {
        shownRow(key::first_order, balance.first_order),
        shownRow(key::along_cylinder, balance.along),
        shownRow(key::across_cylinder, balance.across),
        shownRow(key::with_shaft, balance.with_shaft),
        shownRow(key::second_order, balance.second_order),
        shownRow(ShaftParts::tr("on crank, κ mⱼ r"), balance.counterweight_moment, units::gram_mm,
                 0, ShaftParts::tr("Static moment of the counterweight on the crank")),
    };
    return results;
}

Figure gearMoment(const BalanceShaftModel& model) {
    const GearError& error = model.gearError();
    const balance_shaft::Result& result = model.result();
    Figure figure = overCycle(model, ShaftParts::tr("Mᵤₚₛ with gear error"), ShaftParts::tr("N·m"));
    figure.leftRange = std::pair(result.M_up.min - result.moment_amplitude,
                                 result.M_up.max + result.moment_amplitude);
    plot::CurveStyle play{.name = ShaftParts::tr("play, low"), .role = Role::Limit, .width = 1.0};
    if (error.play > 0.0) {
        play.inLegend = false;
        figure.add("low", play, error.crank_angle_deg, error.M_ups_low);
        play.inLegend = true;
        play.name = ShaftParts::tr("play");
        play.toolTip = ShaftParts::tr("Band due to the play of the gears");
        figure.add("high", play, error.crank_angle_deg, error.M_ups_high);
    }
    figure.add("right",
               {.name = ShaftParts::tr("correct"),
                .role = Role::Sum,
                .width = 2.4,
                .toolTip = ShaftParts::tr("Correct timing")},
               result.curves.crank_angle_deg, result.curves.M_ups);
    figure.add("wrong",
               {.name = ShaftParts::tr("k teeth out"),
                .role = Role::Comparison,
                .width = 1.6,
                .toolTip = ShaftParts::tr("Shaft k teeth out")},
               error.crank_angle_deg, error.M_ups);
    return figure;
}

Results gears(const BalanceShaftModel& model) {
    namespace key = balance_shaft::result_field;
    const GearError& error = model.gearError();
    const auto& right = model.result().M_ups;
    const auto angle = [](double radians, int digits) {
        return ResultCell(radians / degree, fixedNumber(radians / degree, digits, QLocale()));
    };
    const auto moments = [](double one, const QString& pattern, double other, int digits) {
        return ResultCell::two(pattern, shownCell(one, units::N_m, digits),
                               shownCell(other, units::N_m, digits));
    };
    // What the gears have not is a dash; a report leaves such rows out.
    const auto when = [](bool is, const ResultCell& cell) {
        return is ? cell : ResultCell(QStringLiteral("–"));
    };
    const bool isOut = error.phase_error != 0.0;
    const bool hasPlay = error.play > 0.0;
    const QString to = QStringLiteral("%1 → %2");
    const QString momentUnit = shownUnit(units::N_m).name;
    const QString degrees = QStringLiteral("°");
    Results results{{ShaftParts::tr("Gears"), ShaftParts::tr("Value"), ShaftParts::tr("Unit")}};
    results.rows = {
        {{ShaftParts::tr("phase error"), when(isOut, angle(error.phase_error, 2)), degrees},
         ShaftParts::tr("360° k / z")},
        shownRow(key::residual_force, isOut ? std::optional(error.residual_force) : std::nullopt),
        {{ShaftParts::tr("range"), when(isOut, moments(right.range, to, error.range, 0)),
          momentUnit},
         ShaftParts::tr("ΔMᵤₚₛ, correct timing → k teeth out")},
        {{ShaftParts::tr("RMS"), when(isOut, moments(right.rms, to, error.rms, 1)), momentUnit},
         ShaftParts::tr("RMS of Mᵤₚₛ, correct timing → k teeth out")},
        {{ShaftParts::tr("play, ±"), when(hasPlay, angle(error.play, 3)), degrees},
         ShaftParts::tr("Angle of the shaft within the play, to either side: play / l")},
        {{ShaftParts::tr("range in play"),
          when(hasPlay,
               moments(error.play_range_low, QStringLiteral("%1…%2"), error.play_range_high, 0)),
          momentUnit},
         ShaftParts::tr("Minimum and maximum ΔMᵤₚₛ within the play")}};
    return results;
}

Results relief(const BalanceShaftModel& model) {
    namespace key = balance_shaft::result_field;
    const balance_shaft::RelievedShaft& found = model.result().relieved_shaft;
    const auto row = [](const ResultField& field, double si) {
        return shownRow(field, si > 0.0 ? std::optional(si) : std::nullopt);
    };
    Results results{{ShaftParts::tr("Shaft"), ShaftParts::tr("Value"), ShaftParts::tr("Unit")}};
    results.rows = {
        row(key::required_unbalance, found.required),
        row(key::unbalance, found.unbalance),
        row(key::flat_width, 2.0 * found.half_width),
        row(key::relieved_part_mass, found.mass),
        row(key::removed_mass, found.removed_mass),
        row(key::centre_of_mass_radius, found.centre_of_mass_radius),
        row(key::critical_radius, found.critical_radius),
        row(key::critical_length, found.critical_length),
    };
    return results;
}

Notes reliefVerdict(const BalanceShaftModel& model) {
    const balance_shaft::RelievedShaft& shaft = model.result().relieved_shaft;
    return shaft.feasible ? Notes::of(Severity::note, (ShaftParts::tr("Feasible.") +
                                                       QLatin1Char(' ') + messageText(shaft.note))
                                                          .trimmed())
                          : Notes::of(Severity::warning, messageText(shaft.reason));
}

}  // namespace ravnoves::shaft_parts

// The moments on the engine over φ and over α, how large it is over α, and what that costs.

#include <algorithm>
#include <limits>

#include "balance-shaft/model/balance_shaft_model.h"
#include "numerics/constants.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves::shaft_parts {

using balance_shaft::MomentMetrics;
using balance_shaft::Result;
using Criterion = BalanceShaftModel::Criterion;

Figure moments(const BalanceShaftModel& model) {
    const Result& result = model.result();
    Figure figure =
        overCycle(model, ShaftParts::tr("Moments over the cycle"), ShaftParts::tr("N·m"));
    // Room for every α, so that the axis rests while the shaft moves.
    figure.leftRange = std::pair(result.M_up.min - result.moment_amplitude,
                                 result.M_up.max + result.moment_amplitude);
    const auto add = [&](const char* id, const QString& name, Role role, double width,
                         const QString& tip, const std::vector<double>& moment) {
        figure.add(id, {.name = name, .role = role, .width = width, .toolTip = tip},
                   result.curves.crank_angle_deg, moment);
    };
    add("M_up", ShaftParts::tr("without shaft (Mᵤₚ)"), Role::Engine, 1.4,
        ShaftParts::tr("Tipping moment: the reaction to the engine torque"), result.curves.M_up);
    add("M_s", ShaftParts::tr("shaft (Mₛ)"), Role::Shaft, 1.4,
        ShaftParts::tr("Moment of the balance shaft, P₁ l sin(α + φ), (4)"), result.curves.M_s);
    add("M_ups", ShaftParts::tr("with shaft (Mᵤₚₛ)"), Role::Sum, 2.0,
        ShaftParts::tr("Moment on the mounts, Mᵤₚ + Mₛ, (5)"), result.curves.M_ups);
    auto& marks = figure.marks.emplace();
    const auto mark = [&](const char* curve, const MomentMetrics& metrics, Role role) {
        for (const auto& [angle, moment] : {std::pair(metrics.max_angle, metrics.max),
                                            std::pair(metrics.min_angle, metrics.min)}) {
            marks.push_back({.x = angle / degree,
                             .y = moment,
                             .text = shownDigits(moment, units::N_m, 0),
                             .role = role,
                             .curve = curve});
        }
    };
    mark("M_ups", result.M_ups, Role::Sum);
    mark("M_up", result.M_up, Role::Engine);
    mark("M_s", result.M_s, Role::Shaft);
    return figure;
}

Figure range(const BalanceShaftModel& model) {
    const balance_shaft::AngleSweep& sweep = model.result().sweep;
    const std::vector<double>& alpha = sweep.shaft_angle_deg;
    Figure figure = overAngle(model, ShaftParts::tr("Range and RMS over α"), ShaftParts::tr("N·m"));
    figure.add("range",
               {.name = ShaftParts::tr("range (ΔMᵤₚₛ)"),
                .role = Role::Range,
                .width = 1.8,
                .toolTip = ShaftParts::tr("Range of Mᵤₚₛ, max − min")},
               alpha, sweep.range);
    figure.add("RMS",
               {.name = ShaftParts::tr("RMS"),
                .role = Role::Rms,
                .toolTip = ShaftParts::tr("RMS of Mᵤₚₛ about its mean")},
               alpha, sweep.rms);
    auto& marks = figure.marks.emplace();
    const auto add = [&](const balance_shaft::Optimum& best, Role role) {
        if (best.shaft_angle) {
            const double at = *best.shaft_angle / degree;
            marks.push_back({.x = at,
                             .y = best.value,
                             .text = fixedNumber(at, 2, QLocale()) + QStringLiteral("°"),
                             .role = role,
                             .ring = true});
        }
    };
    add(model.best(Criterion::range), Role::Range);
    add(model.best(Criterion::rms), Role::Rms);
    return figure;
}

Figure means(const BalanceShaftModel& model) {
    const balance_shaft::AngleSweep& sweep = model.result().sweep;
    Figure figure = overAngle(model, ShaftParts::tr("Means over α"), ShaftParts::tr("N·m"));
    if (!model.isPapersCase()) {
        return figure;
    }
    const auto add = [&](const char* id, const QString& name, Role role, double width,
                         const QString& tip, const std::vector<double>& values) {
        figure.add(id, {.name = name, .role = role, .width = width, .toolTip = tip},
                   sweep.shaft_angle_deg, values);
    };
    add("M_s", ShaftParts::tr("shaft (Mₛₘ)"), Role::Shaft, 1.8, ShaftParts::tr("Cycle mean of Mₛ"),
        sweep.mean_M_s);
    add("M_ups", ShaftParts::tr("with shaft (Mᵤₚₛₘ)"), Role::Sum, 1.8,
        ShaftParts::tr("Cycle mean of Mᵤₚₛ"), sweep.mean_M_ups);
    add("printed-M_s", ShaftParts::tr("shaft, paper (Mₛₘ)"), Role::Printed, 1.6,
        ShaftParts::tr("Mean of 25 nodes, the end counted twice"), sweep.printed_mean_M_s);
    add("printed-M_ups", ShaftParts::tr("with shaft, paper (Mᵤₚₛₘ)"), Role::PrintedSum, 1.6,
        ShaftParts::tr("Node mean of Mᵤₚ plus node mean of Mₛ"), sweep.printed_mean_M_ups);
    return figure;
}

namespace {

/// Over a whole turn: the first comes again at its end.
std::vector<double> closedTurn(const std::vector<double>& values, const Unit& unit) {
    std::vector<double> closed = inUnit(values, unit);
    closed.push_back(closed.front());
    return closed;
}

}  // namespace

Figure sizes(const BalanceShaftModel& model) {
    const balance_shaft::EnvelopeStudy& study = model.envelopeStudy();
    std::vector<double> angle = study.shaft_angle_deg;
    angle.push_back(360.0);
    Figure figure = overAngle(model, ShaftParts::tr("Overall size over α"), ShaftParts::tr("mm"));
    figure.add("width", {.name = ShaftParts::tr("width"), .role = Role::Horizontal, .width = 1.8},
               angle, closedTurn(study.width, units::mm));
    figure.add("height", {.name = ShaftParts::tr("height"), .role = Role::Vertical, .width = 1.8},
               angle, closedTurn(study.height, units::mm));
    return figure;
}

Figure rangeOverSize(const BalanceShaftModel& model) {
    const balance_shaft::EnvelopeStudy& study = model.envelopeStudy();
    const std::vector<double> area = closedTurn(study.area, units::cm2);
    const auto [minimum, maximum] = std::minmax_element(area.begin(), area.end());
    const double pad = std::max(0.04 * (*maximum - *minimum), 1e-6);
    Figure figure;
    figure.title = ShaftParts::tr("Range and overall size, α along the curve");
    figure.x = {.title = ShaftParts::tr("width × height, cm²"),
                .min = *minimum - pad,
                .max = *maximum + pad};
    figure.left = {.title = ShaftParts::tr("ΔMᵤₚₛ, N·m")};

    std::vector<double> built = study.range;
    Figure::Curve efficient;
    auto& marks = figure.marks.emplace();
    double marked = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < built.size(); ++i) {
        if (!study.buildable[i]) {
            built[i] = std::numeric_limits<double>::quiet_NaN();
        }
        if (!study.efficient[i]) {
            continue;
        }
        efficient.x.push_back(area[i]);
        efficient.y.push_back(study.range[i]);
        constexpr double apart = 15.0;  // degrees
        if (const double angle = study.shaft_angle_deg[i]; angle - marked >= apart) {
            marked = angle;
            // A ring: the present α is seen in it.
            marks.push_back({.x = area[i],
                             .y = study.range[i],
                             .text = fixedNumber(angle, 0, QLocale()) + QStringLiteral("°"),
                             .role = Role::Best,
                             .ring = true});
        }
    }
    figure.add("all", {.name = ShaftParts::tr("all α"), .role = Role::Limit, .width = 1.0}, area,
               closedTurn(study.range, units::none));
    figure.add("built",
               {.name = ShaftParts::tr("feasible"),
                .role = Role::Neutral,
                .width = 1.8,
                .toolTip = ShaftParts::tr("The shaft clears cylinder, crank and rod"),
                .gaps = true},
               area, closedTurn(built, units::none));
    figure.add("efficient",
               {.name = ShaftParts::tr("Pareto-optimal"),
                .role = Role::Best,
                .shape = plot::Shape::Points,
                .toolTip = ShaftParts::tr("Feasible and Pareto-optimal in size and range")},
               std::move(efficient.x), std::move(efficient.y));
    const balance_shaft::Envelope& box = model.result().envelope;
    figure.add(
        "present",
        {.name = ShaftParts::tr("present α"), .role = Role::Present, .shape = plot::Shape::Points},
        {box.width() * box.height() / units::cm2}, {model.result().M_ups.range});
    return figure;
}

}  // namespace ravnoves::shaft_parts

// The moments on the engine, over φ and over α, and the answer beside the tabs.

#include <array>

#include "balance-shaft/model/balance_shaft_model.h"
#include "numerics/constants.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

namespace shaft_parts {

namespace {

using balance_shaft::MomentMetrics;
using balance_shaft::Result;

using Criterion = BalanceShaftModel::Criterion;

template <Criterion criterion>
Notes bestAngle(const BalanceShaftModel& model) {
    return Notes::of(Severity::note, model.bestText(criterion));
}

Notes notes(const BalanceShaftModel& model) {
    return Notes::of(Severity::note, model.notesText());
}

Figure moments(const BalanceShaftModel& model) {
    const Result& result = model.result();
    Figure figure =
        overCycle(model, MomentWords::tr("Moments over the cycle"), MomentWords::tr("N·m"));
    // Room for every α, so that the axis rests while the shaft moves.
    figure.leftRange = std::pair(result.M_up.min - result.moment_amplitude,
                                 result.M_up.max + result.moment_amplitude);
    const auto add = [&](const char* id, const QString& name, Role role, double width,
                         const QString& tip, const std::vector<double>& moment) {
        figure.add(id, {.name = name, .role = role, .width = width, .toolTip = tip},
                   result.curves.crank_angle_deg, moment);
    };
    add("M_up", MomentWords::tr("without shaft (Mᵤₚ)"), Role::Engine, 1.4,
        MomentWords::tr("Tipping moment: the reaction to the engine torque"), result.curves.M_up);
    add("M_s", MomentWords::tr("shaft (Mₛ)"), Role::Shaft, 1.4,
        MomentWords::tr("Moment of the balance shaft, P₁ l sin(α + φ), (4)"), result.curves.M_s);
    add("M_ups", MomentWords::tr("with shaft (Mᵤₚₛ)"), Role::Sum, 2.0,
        MomentWords::tr("Moment on the mounts, Mᵤₚ + Mₛ, (5)"), result.curves.M_ups);
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
    Figure figure =
        overAngle(model, MomentWords::tr("Range and RMS over α"), MomentWords::tr("N·m"));
    figure.add("range",
               {.name = MomentWords::tr("range (ΔMᵤₚₛ)"),
                .role = Role::Range,
                .width = 1.8,
                .toolTip = MomentWords::tr("Range of Mᵤₚₛ, max − min")},
               alpha, sweep.range);
    figure.add("RMS",
               {.name = MomentWords::tr("RMS"),
                .role = Role::Rms,
                .toolTip = MomentWords::tr("RMS of Mᵤₚₛ about its mean")},
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
    Figure figure = overAngle(model, MomentWords::tr("Means over α"), MomentWords::tr("N·m"));
    if (!model.isPapersCase()) {
        return figure;
    }
    const auto add = [&](const char* id, const QString& name, Role role, double width,
                         const QString& tip, const std::vector<double>& values) {
        figure.add(id, {.name = name, .role = role, .width = width, .toolTip = tip},
                   sweep.shaft_angle_deg, values);
    };
    add("M_s", MomentWords::tr("shaft (Mₛₘ)"), Role::Shaft, 1.8,
        MomentWords::tr("Cycle mean of Mₛ"), sweep.mean_M_s);
    add("M_ups", MomentWords::tr("with shaft (Mᵤₚₛₘ)"), Role::Sum, 1.8,
        MomentWords::tr("Cycle mean of Mᵤₚₛ"), sweep.mean_M_ups);
    add("printed-M_s", MomentWords::tr("shaft, paper (Mₛₘ)"), Role::Printed, 1.6,
        MomentWords::tr("Mean of 25 nodes, the end counted twice"), sweep.printed_mean_M_s);
    add("printed-M_ups", MomentWords::tr("with shaft, paper (Mᵤₚₛₘ)"), Role::PrintedSum, 1.6,
        MomentWords::tr("Node mean of Mᵤₚ plus node mean of Mₛ"), sweep.printed_mean_M_ups);
    return figure;
}

constexpr std::array momentMakers{
    PartMaker<BalanceShaftModel>{{.id = "criteria", .isAnswer = true},
                                 made<&BalanceShaftModel::criteria>},
    PartMaker<BalanceShaftModel>{{.id = "best-range", .isAnswer = true},
                                 made<bestAngle<Criterion::range>>},
    PartMaker<BalanceShaftModel>{{.id = "best-rms", .isAnswer = true},
                                 made<bestAngle<Criterion::rms>>},
    PartMaker<BalanceShaftModel>{{.id = "quantities", .isAnswer = true},
                                 made<&BalanceShaftModel::quantities>},
    PartMaker<BalanceShaftModel>{{.id = "notes"}, made<notes>},
    PartMaker<BalanceShaftModel>{{.id = "moments", .tab = "moments"}, made<moments>},
    PartMaker<BalanceShaftModel>{{.id = "range", .tab = "moments"}, made<range>},
    PartMaker<BalanceShaftModel>{{.id = "means", .tab = "moments"}, made<means>},
};

}  // namespace

}  // namespace shaft_parts

ShaftPartMakers momentParts() {
    return shaft_parts::momentMakers;
}

}  // namespace ravnoves

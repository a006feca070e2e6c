// The forces on the engine without and with a shaft, what a gear fitted some teeth out and its play
// do, and the shaft with a relieved middle.

#include <algorithm>
#include <array>

#include "balance-shaft/crank_balance.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/result_fields.h"
#include "numerics/constants.h"
#include "text/field_row.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

namespace shaft_parts {

namespace {

using balance_shaft::CrankBalance;
using balance_shaft::ForceLocus;
using balance_shaft::GearError;

/// The words of the rows.
struct RowWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ForcesModel)
};

Figure forceLocus(const BalanceShaftModel& model) {
    const CrankBalance balance = balance_shaft::crank_balance(model.solver());
    const auto room = [](double force) { return 1.15 * force / units::kN; };
    const double along = std::max(balance.along, balance.with_shaft);
    Figure figure;
    figure.title = ForceWords::tr("Force on the engine");
    figure.x = {.title = ForceWords::tr("across, kN"),
                .min = -room(balance.across),
                .max = room(balance.across)};
    figure.left = {.title = ForceWords::tr("along, kN")};
    figure.leftRange =
        std::pair(-room(std::max(along, balance.second_order)), room(along + balance.second_order));
    figure.equalScale = true;
    const auto add = [&](const char* id, plot::CurveStyle style, ForceLocus locus) {
        for (std::vector<double>* newtons : {&locus.x, &locus.y}) {
            for (double& value : *newtons) {
                value = value / units::kN;
            }
        }
        style.turn = 360.0;
        figure.add(id, std::move(style), std::move(locus.x), std::move(locus.y));
    };
    add("both",
        {.name = ForceWords::tr("without shaft, 1st + 2nd order"),
         .role = Role::AllOrders,
         .toolTip = ForceWords::tr("First and second order without a shaft")},
        force_locus(balance, balance.across, balance.along, balance.second_order));
    add("first",
        {.name = ForceWords::tr("without shaft, 1st order"),
         .role = Role::Engine,
         .width = 2.0,
         .toolTip = ForceWords::tr("First order without a shaft: an ellipse")},
        force_locus(balance, balance.across, balance.along, 0.0));
    add("shaft",
        {.name = ForceWords::tr("with shaft"),
         .role = Role::Sum,
         .width = 2.0,
         .toolTip = ForceWords::tr("With the shaft the first order is a point; the second order "
                                   "along the cylinder remains")},
        force_locus(balance, 0.0, balance.with_shaft, balance.second_order));
    return figure;
}

Results forces(const BalanceShaftModel& model) {
    namespace key = balance_shaft::result_field;
    const CrankBalance balance = balance_shaft::crank_balance(model.solver());
    Results results{{ForceWords::tr("Force"), ForceWords::tr("Value"), ForceWords::tr("Unit")}};
    results.rows = {
        shownRow(key::first_order, balance.first_order),
        shownRow(key::along_cylinder, balance.along),
        shownRow(key::across_cylinder, balance.across),
        shownRow(key::with_shaft, balance.with_shaft),
        shownRow(key::second_order, balance.second_order),
        shownRow(RowWords::tr("on crank, κ mⱼ r"), balance.counterweight_moment, units::gram_mm, 0,
                 RowWords::tr("Static moment of the counterweight on the crank")),
    };
    return results;
}

Figure gearMoment(const BalanceShaftModel& model) {
    const GearError& error = model.gearError();
    const balance_shaft::Result& result = model.result();
    Figure figure = overCycle(model, ForceWords::tr("Mᵤₚₛ with gear error"), ForceWords::tr("N·m"));
    figure.leftRange = std::pair(result.M_up.min - result.moment_amplitude,
                                 result.M_up.max + result.moment_amplitude);
    plot::CurveStyle play{.name = ForceWords::tr("play, low"), .role = Role::Limit, .width = 1.0};
    if (error.play > 0.0) {
        play.inLegend = false;
        figure.add("low", play, error.crank_angle_deg, error.M_ups_low);
        play.inLegend = true;
        play.name = ForceWords::tr("play");
        play.toolTip = ForceWords::tr("Band due to the play of the gears");
        figure.add("high", play, error.crank_angle_deg, error.M_ups_high);
    }
    figure.add("right",
               {.name = ForceWords::tr("correct"),
                .role = Role::Sum,
                .width = 2.4,
                .toolTip = ForceWords::tr("Correct timing")},
               result.curves.crank_angle_deg, result.curves.M_ups);
    figure.add("wrong",
               {.name = ForceWords::tr("k teeth out"),
                .role = Role::Comparison,
                .width = 1.6,
                .toolTip = ForceWords::tr("Shaft k teeth out")},
               error.crank_angle_deg, error.M_ups);
    return figure;
}

Results gears(const BalanceShaftModel& model) {
    namespace key = balance_shaft::result_field;
    const GearError& error = model.gearError();
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
    Results results{{ForceWords::tr("Gears"), ForceWords::tr("Value"), ForceWords::tr("Unit")}};
    results.rows = {
        {{RowWords::tr("phase error"), when(isOut, angle(error.phase_error, 2)), degrees},
         RowWords::tr("360° k / z")},
        shownRow(key::residual_force, isOut ? std::optional(error.residual_force) : std::nullopt),
        {{RowWords::tr("range"), when(isOut, moments(error.right_range, to, error.range, 0)),
          momentUnit},
         RowWords::tr("ΔMᵤₚₛ, correct timing → k teeth out")},
        {{RowWords::tr("RMS"), when(isOut, moments(error.right_rms, to, error.rms, 1)), momentUnit},
         RowWords::tr("RMS of Mᵤₚₛ, correct timing → k teeth out")},
        {{RowWords::tr("play, ±"), when(hasPlay, angle(error.play, 3)), degrees},
         RowWords::tr("Angle of the shaft within the play, to either side: play / l")},
        {{RowWords::tr("range in play"),
          when(hasPlay,
               moments(error.play_range_low, QStringLiteral("%1…%2"), error.play_range_high, 0)),
          momentUnit},
         RowWords::tr("Minimum and maximum ΔMᵤₚₛ within the play")}};
    return results;
}

/// The words of the relieved shaft.
struct ReliefWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::RelievedShaftView)
};

Results relief(const BalanceShaftModel& model) {
    namespace key = balance_shaft::result_field;
    const balance_shaft::RelievedShaft& found = model.result().relieved_shaft;
    const auto row = [](const ResultField& field, double si) {
        return shownRow(field, si > 0.0 ? std::optional(si) : std::nullopt);
    };
    Results results{{ReliefWords::tr("Shaft"), ReliefWords::tr("Value"), ReliefWords::tr("Unit")}};
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
    return shaft.feasible ? Notes::of(Severity::note, (ReliefWords::tr("Feasible.") +
                                                       QLatin1Char(' ') + messageText(shaft.note))
                                                          .trimmed())
                          : Notes::of(Severity::warning, messageText(shaft.reason));
}

constexpr std::array forceMakers{
    PartMaker<BalanceShaftModel>{{.id = "force-locus", .tab = "forces"}, made<forceLocus>},
    PartMaker<BalanceShaftModel>{{.id = "gear-moment", .tab = "forces"}, made<gearMoment>},
    PartMaker<BalanceShaftModel>{{.id = "forces", .tab = "forces"}, made<forces>},
    PartMaker<BalanceShaftModel>{{.id = "gears", .tab = "forces"}, made<gears>},
    PartMaker<BalanceShaftModel>{{.id = "relief", .tab = "relieved"}, made<relief>},
    PartMaker<BalanceShaftModel>{{.id = "relief-verdict", .tab = "relieved"}, made<reliefVerdict>},
};

}  // namespace

}  // namespace shaft_parts

ShaftPartMakers forceParts() {
    return shaft_parts::forceMakers;
}

}  // namespace ravnoves

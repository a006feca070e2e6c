#include "balance-shaft/model/forces_model.h"

#include <QLocale>
#include <algorithm>

#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

using balance_shaft::ForceLocus;

namespace {

ForceLocus inKilonewtons(ForceLocus locus) {
    for (std::vector<double>* newtons : {&locus.x, &locus.y}) {
        for (double& value : *newtons) {
            value = value / units::kN;
        }
    }
    return locus;
}

}  // namespace

ForcesModel::Loci ForcesModel::loci() const {
    const balance_shaft::CrankBalance balance = balance_shaft::crank_balance(model_->solver());
    const auto room = [](double force) { return 1.15 * force / units::kN; };
    const double along = std::max(balance.along, balance.with_shaft);
    return {room(balance.across),
            -room(std::max(along, balance.second_order)),
            room(along + balance.second_order),
            inKilonewtons(balance_shaft::crank_only_locus(balance)),
            inKilonewtons(balance_shaft::crank_only_locus_with_second_order(balance)),
            inKilonewtons(balance_shaft::shaft_locus(balance))};
}

ResultRows ForcesModel::forceRows() const {
    const balance_shaft::CrankBalance balance = balance_shaft::crank_balance(model_->solver());
    const auto row = [](const QString& name, double value, const QString& tip,
                        const Unit& unit = units::newton) {
        return shownRow(name, value, unit, 0, tip);
    };
    return {
        row(tr("1st order, P"), balance.first_order, tr("First-order inertia force, mⱼ r ω²")),
        row(tr("along, (1 − κ) P"), balance.along,
            tr("Half-axis of the ellipse along the cylinder")),
        row(tr("across, κ P"), balance.across, tr("Half-axis of the ellipse across the cylinder")),
        row(tr("1st with shaft"), balance.with_shaft,
            tr("First order that the shaft's two counterweights leave")),
        row(tr("2nd order, λ mⱼ r ω²"), balance.second_order,
            tr("Second order along the cylinder; stays with and without a shaft")),
        row(tr("on crank, κ mⱼ r"), balance.counterweight_moment,
            tr("Static moment of the counterweight on the crank"), units::gram_mm)};
}

balance_shaft::GearError ForcesModel::gearError() const {
    return balance_shaft::gear_error(model_->solver(), model_->input().shaft_angle);
}

ResultRows ForcesModel::gearRows(const balance_shaft::GearError& error) {
    const auto angle = [](double radians, int digits) {
        return ResultCell(radians / degree, fixedNumber(radians / degree, digits, QLocale()));
    };
    const auto moments = [](double one, const QString& pattern, double other, int digits) {
        return ResultCell::two(pattern, shownCell(one, units::N_m, digits),
                               shownCell(other, units::N_m, digits));
    };
    const QString to = QStringLiteral("%1 → %2");
    const QString momentUnit = shownUnit(units::N_m).name;
    const QString degrees = QStringLiteral("°");
    return {{{tr("phase error"), angle(error.phase_error, 2), degrees}, tr("360° k / z")},
            shownRow(tr("force left"), error.residual_force, units::newton, 0,
                     tr("Constant force that turns against the crank, 2 P₁ |sin(δ/2)|")),
            {{tr("range"), moments(error.right_range, to, error.range, 0), momentUnit},
             tr("ΔMᵤₚₛ, shaft in its right place → k teeth out")},
            {{tr("RMS"), moments(error.right_rms, to, error.rms, 1), momentUnit},
             tr("RMS of Mᵤₚₛ, shaft in its right place → k teeth out")},
            {{tr("play, ±"), angle(error.play, 3), degrees},
             tr("The shaft wanders this far to either side: play / l")},
            {{tr("range in play"),
              moments(error.play_range_low, QStringLiteral("%1…%2"), error.play_range_high, 0),
              momentUnit},
             tr("Least and largest ΔMᵤₚₛ while the shaft wanders")}};
}

}  // namespace ravnoves

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

QVector<QStringList> ForcesModel::forceRows() const {
    const balance_shaft::CrankBalance balance = balance_shaft::crank_balance(model_->solver());
    const auto row = [](const QString& name, double value, const Unit& unit = units::newton) {
        return shownRow(name, value, unit, 0);
    };
    return {row(tr("1st order, P"), balance.first_order),
            row(tr("along, (1 − κ) P"), balance.along),
            row(tr("across, κ P"), balance.across),
            row(tr("1st with shaft"), balance.with_shaft),
            row(tr("2nd order, λ mⱼ r ω²"), balance.second_order),
            row(tr("on crank, κ mⱼ r"), balance.counterweight_moment, units::gram_mm)};
}

QStringList ForcesModel::forceHints() {
    return {tr("First-order inertia force, mⱼ r ω²"),
            tr("Half-axis of the ellipse along the cylinder"),
            tr("Half-axis of the ellipse across the cylinder"),
            tr("First order that the shaft's two counterweights leave"),
            tr("Second order along the cylinder; stays with and without a shaft"),
            tr("Static moment of the counterweight on the crank")};
}

balance_shaft::GearError ForcesModel::gearError() const {
    return balance_shaft::gear_error(model_->solver(), model_->input().shaft_angle);
}

QVector<QStringList> ForcesModel::gearRows(const balance_shaft::GearError& error) {
    const auto fixed = [](double value, int digits) {
        return fixedNumber(value, digits, QLocale());
    };
    const auto moment = [](double value, int digits) {
        return shownDigits(value, units::N_m, digits);
    };
    const auto change = [&](double right, double wrong, int digits) {
        return moment(right, digits) + QStringLiteral(" → ") + moment(wrong, digits);
    };
    const QString momentUnit = shownUnit(units::N_m).name;
    return {
        {tr("phase error"), fixed(error.phase_error / degree, 2), QStringLiteral("°")},
        shownRow(tr("force left"), error.residual_force, units::newton, 0),
        {tr("range"), change(error.right_range, error.range, 0), momentUnit},
        {tr("RMS"), change(error.right_rms, error.rms, 1), momentUnit},
        {tr("play, ±"), fixed(error.play / degree, 3), QStringLiteral("°")},
        {tr("range in play"),
         moment(error.play_range_low, 0) + QStringLiteral("…") + moment(error.play_range_high, 0),
         momentUnit}};
}

QStringList ForcesModel::gearHints() {
    return {tr("360° k / z"),
            tr("Constant force that turns against the crank, 2 P₁ |sin(δ/2)|"),
            tr("ΔMᵤₚₛ, shaft in its right place → k teeth out"),
            tr("RMS of Mᵤₚₛ, shaft in its right place → k teeth out"),
            tr("The shaft wanders this far to either side: play / l"),
            tr("Least and largest ΔMᵤₚₛ while the shaft wanders")};
}

}  // namespace ravnoves

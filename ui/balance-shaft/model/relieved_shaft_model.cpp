#include "balance-shaft/model/relieved_shaft_model.h"

#include <QLocale>

#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "text/write_file.h"

namespace ravnoves {

using balance_shaft::Input;
using balance_shaft::RelievedShaft;
using balance_shaft::RelievedShaftSizes;

RelievedShaftModel::RelievedShaftModel(BalanceShaftModel* model, QObject* parent)
    : QObject(parent), model_(model) {}

RelievedShaftSizes RelievedShaftModel::sizes() const {
    return model_->input().relieved_shaft.value_or(RelievedShaftSizes{});
}

RelievedShaftModel::Sized RelievedShaftModel::sized() const {
    const RelievedShaftSizes given = sizes();
    return !given.depth      ? Sized::Depth
           : !given.length   ? Sized::Length
           : !given.diameter ? Sized::Diameter
                             : Sized::None;
}

std::optional<double> RelievedShaftModel::sizeOf(Size size) const {
    const RelievedShaft& found = shaft();
    const double metres = (sizes().*size)
                              .value_or(size == &RelievedShaftSizes::diameter ? found.diameter
                                        : size == &RelievedShaftSizes::depth  ? found.depth
                                                                              : found.length);
    return metres > 0.0 ? std::optional(metres) : std::nullopt;
}

void RelievedShaftModel::choose(Sized sized) {
    const RelievedShaft& found = shaft();
    RelievedShaftSizes next = sizes();
    const auto keep = [](std::optional<double>& size, double metres) {
        if (!size && metres > 0.0) {
            size = metres;
        }
    };
    keep(next.diameter, found.diameter);
    keep(next.depth, found.depth > 0.0 ? found.depth : found.diameter / 4.0);
    keep(next.length, found.length);
    if (sized == Sized::Depth) {
        next.depth.reset();
    } else if (sized == Sized::Length) {
        next.length.reset();
    } else if (sized == Sized::Diameter) {
        next.diameter.reset();
    }
    model_->edit(tr("Size to find"), [&](Input& input) { input.relieved_shaft = next; });
}

ResultRows RelievedShaftModel::rows() const {
    const RelievedShaft& found = shaft();
    const balance_shaft::ShaftBending& bending = found.bending;
    const auto row = [](const QString& name, double si, int decimals, const Unit& unit,
                        const QString& tip) {
        ResultRow made = shownRow(name, si, unit, decimals, tip);
        if (!(si > 0.0)) {
            made[1] = QStringLiteral("–");
        }
        return made;
    };
    using units::mm;
    return {
        row(tr("unbalance needed, m₁ ρ₁"), found.required, 0, units::gram_mm,
            tr("What both counterweights have by equation (1)")),
        row(tr("unbalance of the shaft"), found.unbalance, 0, units::gram_mm,
            tr("U = 2/3 ρ b a³, a² = h (D − h)")),
        row(tr("width of the flat"), 2.0 * found.half_width, 2, mm, tr("2 a = 2 √(h (D − h))")),
        row(tr("mass of the relieved part"), found.mass, 3, units::kg,
            tr("ρ b A of the section that is left")),
        row(tr("mass milled away"), found.removed_mass, 3, units::kg,
            tr("ρ b times the area of the segment")),
        row(tr("radius of its centre of mass"), found.centre_of_mass_radius, 2, mm,
            tr("U over the mass of the relieved part, on the side away from the flat")),
        row(tr("critical bar radius"), found.critical_radius, 2, mm,
            tr("The smallest bar radius that can have the unbalance at this length: with half of "
               "the bar milled away, ∛(3 U / (2 ρ b)). It has nothing to do with vibration.")),
        row(tr("critical length"), found.critical_length, 1, mm,
            tr("The shortest relief that can have the unbalance with this bar: with half of it "
               "milled away, 3 U / (2 ρ R³). It has nothing to do with vibration.")),
        row(tr("bearing span L"), found.bearing_span, 1, mm,
            tr("As entered, or b + D; the relief stands in the middle")),
        row(tr("whirling speed"), bending.critical_speed, 0, units::rpm,
            tr("First bending critical speed between two simple supports, towards the flat; "
               "finite elements of the beam with its steps")),
        row(tr("over the speed"), bending.critical_speed / model_->input().angular_speed, 2,
            {"×", 1.0},
            tr("Whirling speed over the speed entered; must reach the margin asked for")),
        row(tr("load of a bearing"), bending.bearing_load, 0, units::newton,
            tr("Half of the centrifugal load U ω², grown by the deflection, and of the weight")),
        row(tr("sag at speed"), bending.deflection, 3, mm,
            tr("Largest deflection under the centrifugal load, which grows with it, and the "
               "weight")),
        row(tr("permitted sag"), found.permitted_sag, 3, mm, tr("As entered, or L / 1200")),
        row(tr("sag at rest"), bending.weight_sag, 4, mm,
            tr("Largest deflection under the weight alone, flat up")),
        row(tr("tilt of the journals"), bending.journal_slope, 2,
            {QT_TRANSLATE_NOOP("core", "mrad"), 1e-3},
            tr("Slope in the bearings at speed. Ball bearings take 1 to 3 mrad, plain ones less.")),
        row(tr("bending stress"), bending.bending_stress, 1, units::MPa,
            tr("Largest bending moment over the section modulus, σ = M / W")),
        row(tr("stress with shear"), bending.combined_stress, 1, units::MPa,
            tr("Largest √(σ² + 3 τ²), τ = 4/3 V / A; must not be above the allowable stress")),
    };
}

QString RelievedShaftModel::verdict() const {
    return shaft().feasible
               ? (tr("Feasible.") + QLatin1Char(' ') + messageText(shaft().note)).trimmed()
               : messageText(shaft().reason);
}

QString RelievedShaftModel::exportDxf(const QString& path) const {
    return writeFile(path, [this] { return balance_shaft::relieved_shaft_dxf(shaft(), {}); });
}

}  // namespace ravnoves

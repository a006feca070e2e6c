#include "balance-shaft/model/relieved_shaft_model.h"

#include <QCoreApplication>
#include <QLocale>

#include "balance-shaft/fields.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "text/write_file.h"

namespace ravnoves {

using balance_shaft::Input;
using balance_shaft::RelievedShaft;
using balance_shaft::RelievedShaftSizes;

namespace {

struct ReliefWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::RelievedShaftView)
};

}  // namespace

RelievedShaftModel::RelievedShaftModel(BalanceShaftModel* model, QObject* parent)
    : QObject(parent), model_(model) {}

RelievedShaftSizes RelievedShaftModel::sizes() const {
    return balance_shaft::relieved_shaft_sizes(model_->input());
}

RelievedShaftModel::Sized RelievedShaftModel::sized() const {
    const RelievedShaftSizes given = sizes();
    return !given.depth      ? Sized::Depth
           : !given.length   ? Sized::Length
           : !given.diameter ? Sized::Diameter
                             : Sized::None;
}

std::optional<double> RelievedShaftModel::sizeOf(Size size) const {
    const RelievedShaft found = shaft();
    const double metres = (sizes().*size)
                              .value_or(size == &RelievedShaftSizes::diameter ? found.diameter
                                        : size == &RelievedShaftSizes::depth  ? found.depth
                                                                              : found.length);
    return metres > 0.0 ? std::optional(metres) : std::nullopt;
}

void RelievedShaftModel::choose(Sized sized) {
    const RelievedShaft found = shaft();
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

void RelievedShaftModel::setSize(const Field& field, Size size, double metres) {
    model_->edit(fieldName(field), [&](Input& input) {
        input.relieved_shaft = balance_shaft::relieved_shaft_sizes(input);
        (*input.relieved_shaft).*size = metres;
    });
}

void RelievedShaftModel::setDensity(double density) {
    model_->edit(fieldName(balance_shaft::field::density), [&](Input& input) {
        input.relieved_shaft = balance_shaft::relieved_shaft_sizes(input);
        input.relieved_shaft->density = density;
    });
}

Results RelievedShaftModel::results(const RelievedShaft& found) {
    const auto row = [](const QString& name, double si, int decimals, const Unit& unit,
                        const QString& tip) {
        ResultRow made = shownRow(name, si, unit, decimals, tip);
        if (!(si > 0.0)) {
            made[1] = QStringLiteral("–");
        }
        return made;
    };
    using units::mm;
    Results results{{ReliefWords::tr("Shaft"), ReliefWords::tr("Value"), ReliefWords::tr("Unit")}};
    results.rows = {
        row(tr("required unbalance, m₁ ρ₁"), found.required, 0, units::gram_mm,
            tr("Unbalance of both counterweights by equation (1)")),
        row(tr("unbalance of the shaft"), found.unbalance, 0, units::gram_mm,
            tr("U = 2/3 ρ b a³, a² = h (D − h)")),
        row(tr("width of the flat"), 2.0 * found.half_width, 2, mm, tr("2 a = 2 √(h (D − h))")),
        row(tr("mass of the relieved part"), found.mass, 3, units::kg,
            tr("ρ b A of the remaining section")),
        row(tr("mass milled away"), found.removed_mass, 3, units::kg,
            tr("ρ b times the area of the segment")),
        row(tr("radius of its centre of mass"), found.centre_of_mass_radius, 2, mm,
            tr("U over the mass of the relieved part, on the side away from the flat")),
        row(tr("critical bar radius"), found.critical_radius, 2, mm,
            tr("Minimum bar radius for the unbalance at this length, ∛(3 U / (2 ρ b)); not a "
               "vibration limit.")),
        row(tr("critical length"), found.critical_length, 1, mm,
            tr("Minimum length of the relief for the unbalance with this bar, 3 U / (2 ρ R³); not "
               "a vibration limit.")),
    };
    return results;
}

QString RelievedShaftModel::verdict(const RelievedShaft& found) {
    return found.feasible ? (tr("Feasible.") + QLatin1Char(' ') + messageText(found.note)).trimmed()
                          : messageText(found.reason);
}

QString RelievedShaftModel::exportDxf(const QString& path) const {
    return writeFile(path, [this] { return balance_shaft::relieved_shaft_dxf(shaft(), {}); });
}

}  // namespace ravnoves

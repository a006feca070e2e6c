#include "balance-shaft/model/relieved_shaft_model.h"

#include <QLocale>

#include "case-file/text_file.h"
#include "text/error_text.h"
#include "text/file_path.h"
#include "text/message_text.h"
#include "text/number_text.h"

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

std::optional<double> RelievedShaftModel::sizeMm(Size size) const {
    const RelievedShaft& found = shaft();
    const double metres = (sizes().*size)
                              .value_or(size == &RelievedShaftSizes::diameter ? found.diameter
                                        : size == &RelievedShaftSizes::depth  ? found.depth
                                                                              : found.length);
    return metres > 0.0 ? std::optional(metres / units::mm) : std::nullopt;
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

QVector<QStringList> RelievedShaftModel::rows() const {
    const RelievedShaft& found = shaft();
    const auto row = [](const QString& name, double value, int digits, const QString& unit) {
        return QStringList{
            name, value > 0.0 ? fixedNumber(value, digits, QLocale()) : QStringLiteral("–"), unit};
    };
    const QString mm = tr("mm");
    return {
        row(tr("unbalance needed, m₁ ρ₁"), found.required / units::gram_mm, 0, tr("g·mm")),
        row(tr("unbalance of the shaft"), found.unbalance / units::gram_mm, 0, tr("g·mm")),
        row(tr("width of the flat"), 2.0 * found.half_width / units::mm, 2, mm),
        row(tr("mass of the relieved part"), found.mass, 3, tr("kg")),
        row(tr("mass milled away"), found.removed_mass, 3, tr("kg")),
        row(tr("radius of its centre of mass"), found.centre_of_mass_radius / units::mm, 2, mm),
        row(tr("critical bar radius"), found.critical_radius / units::mm, 2, mm),
        row(tr("critical length"), found.critical_length / units::mm, 1, mm),
        row(tr("sag at speed"), found.sag / units::mm, 3, mm),
        row(tr("bending stress"), found.bending_stress / units::MPa, 1, tr("MPa")),
    };
}

QStringList RelievedShaftModel::hints() {
    QStringList hints(6);
    hints << tr("The smallest bar that can have the unbalance at this length")
          << tr("The shortest relief that can have it with this bar")
          << tr("Of the relieved part on two supports under its own centrifugal load");
    return hints;
}

QString RelievedShaftModel::verdict() const {
    return shaft().feasible
               ? (tr("Feasible.") + QLatin1Char(' ') + messageText(shaft().note)).trimmed()
               : messageText(shaft().reason);
}

QString RelievedShaftModel::exportDxf(const QString& path) const {
    try {
        write_text_file(fsPath(path), balance_shaft::relieved_shaft_dxf(shaft(), {}));
    } catch (const std::exception& error) {
        return path + QStringLiteral(": ") + errorText(error);
    }
    return {};
}

}  // namespace ravnoves

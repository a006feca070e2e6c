#include "balance-shaft/model/relieved_shaft_model.h"

#include <QCoreApplication>

#include "balance-shaft/fields.h"
#include "balance-shaft/result_fields.h"
#include "text/field_row.h"
#include "text/message_text.h"
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
    namespace key = balance_shaft::result_field;
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

QString RelievedShaftModel::verdict(const RelievedShaft& found) {
    return found.feasible ? (tr("Feasible.") + QLatin1Char(' ') + messageText(found.note)).trimmed()
                          : messageText(found.reason);
}

QString RelievedShaftModel::exportDxf(const QString& path) const {
    return writeFile(path, [this] { return balance_shaft::relieved_shaft_dxf(shaft(), {}); });
}

}  // namespace ravnoves

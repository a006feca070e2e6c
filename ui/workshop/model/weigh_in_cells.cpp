// The weigh-in sheet as cells.

#include "bob-weights/fields.h"
#include "model/editable_table.h"
#include "text/shown_units.h"
#include "text/typed_number.h"
#include "workshop/model/workshop_model.h"

namespace ravnoves {

namespace {

auto& cellOf(auto& sheet, int row, int column) {
    auto& part = sheet.columns[static_cast<std::size_t>(column)];
    constexpr int first = WorkshopModel::firstCylinder;
    return row >= first ? part.mass[static_cast<std::size_t>(row - first)]
           : row == 0   ? part.nominal
                        : part.permitted_spread;
}

}  // namespace

const Field& WorkshopModel::weightField(int row) {
    return row >= firstCylinder ? shop::field::part_mass
           : row == 0           ? shop::field::nominal
                                : shop::field::permitted_spread;
}

std::optional<double> WorkshopModel::weight(int row, int column) const {
    const auto& sheet = solved().sheet;
    return sheet && row < weightRows() ? cellOf(*sheet, row, column) : std::nullopt;
}

void WorkshopModel::setWeight(const QString& name, int row, int column,
                              std::optional<double> mass) {
    editWeights(name, [&](shop::WeighIn& sheet) { cellOf(sheet, row, column) = mass; });
}

QString WorkshopModel::pasteWeights(int row, int column, const std::vector<QStringList>& cells) {
    if (QString mixed = mixedDecimalSigns(cells); !mixed.isEmpty()) {
        return mixed;
    }
    struct Pasted {
        int row;
        int column;
        double mass;
    };
    std::vector<Pasted> pasted;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (qsizetype j = 0; j < cells[i].size(); ++j) {
            const QString& typed = cells[i].at(j);
            if (typed.isEmpty()) {
                continue;
            }
            const int toRow = row + static_cast<int>(i);
            const int toColumn = column + static_cast<int>(j);
            if (toRow >= weightRows() || toColumn >= std::ssize(shop::all_parts)) {
                return tr("Not pasted: from here the block does not fit on the sheet of %1 "
                          "cylinders.")
                    .arg(input().engine.cylinders);
            }
            // In the unit that the cells show.
            const Field& field = weightField(toRow);
            const ShownUnit unit = shownUnit(field.unit);
            const auto [value, trouble] = readTypedNumber(typed, unit.name);
            if (!trouble.isEmpty()) {
                return tr("Not pasted: %1").arg(trouble);
            }
            if (!value || field.left_by(*value / unit.factor) != nullptr) {
                return tr("Not pasted: “%1” is not a mass in %2.").arg(typed, unit.name);
            }
            pasted.push_back({toRow, toColumn, *value / unit.factor * field.unit});
        }
    }
    return editWeights(tr("Paste weights"), [&](shop::WeighIn& sheet) {
        for (const Pasted& each : pasted) {
            cellOf(sheet, each.row, each.column) = each.mass;
        }
    });
}

}  // namespace ravnoves

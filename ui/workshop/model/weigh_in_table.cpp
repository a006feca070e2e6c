#include "workshop/model/weigh_in_table.h"

#include <algorithm>

#include "bob-weights/fields.h"
#include "model/editable_table.h"
#include "text/message_text.h"
#include "text/shown_units.h"
#include "text/typed_number.h"
#include "workshop/model/workshop_model.h"

namespace ravnoves {

namespace {

auto& cellOf(auto& sheet, int row, int column) {
    auto& part = sheet.columns[static_cast<std::size_t>(column)];
    constexpr int first = WeighInTable::firstCylinder;
    return row >= first ? part.mass[static_cast<std::size_t>(row - first)]
           : row == 0   ? part.nominal
                        : part.permitted_spread;
}

/// A text with %1 for the part and %2 for the cylinder; the first two are of nominal and spread.
QString ofCell(int row, int column, const QString& nominal, const QString& spread,
               const QString& cylinder) {
    const QString part = WeighInTable::partOf(column);
    return row == 0   ? nominal.arg(part)
           : row == 1 ? spread.arg(part)
                      : cylinder.arg(part).arg(row - WeighInTable::firstCylinder + 1);
}

}  // namespace

int WeighInTable::rows() const {
    return firstCylinder + model_->input().engine.cylinders;
}

const Field& WeighInTable::fieldOf(int row) {
    return row >= firstCylinder ? bob_weights::field::part_mass
           : row == 0           ? shop::field::nominal
                                : shop::field::permitted_spread;
}

QString WeighInTable::titleOf(int row) {
    return row >= firstCylinder ? QString::number(row - firstCylinder + 1)
           : row == 0           ? shownTitle(tr("nominal, g")).text
                                : shownTitle(tr("permitted range, g")).text;
}

QString WeighInTable::partOf(int column) {
    return shownText(shop::part_word(shop::all_parts[static_cast<std::size_t>(column)]).label);
}

QString WeighInTable::headingOf(int column) {
    const auto parts = bob_weights::part_fields();
    return fieldName(std::ranges::find(parts, shop::all_parts[static_cast<std::size_t>(column)],
                                       &bob_weights::PartField::column)
                         ->field);
}

QString WeighInTable::keyOf(int row, int column) {
    const auto word = shop::part_word(shop::all_parts[static_cast<std::size_t>(column)]).word;
    const QString part = QString::fromStdString(std::string(word));
    return row == 0   ? QStringLiteral("nominal_") + part
           : row == 1 ? QStringLiteral("spread_") + part
                      : QStringLiteral("mass_%1_%2").arg(part).arg(row - firstCylinder + 1);
}

QString WeighInTable::nameOf(int row, int column) {
    return shownTitle(ofCell(row, column, tr("%1, nominal mass, g"), tr("%1, permitted range, g"),
                             tr("%1 of cylinder %2, g")))
        .text;
}

QString WeighInTable::hintOf(int row, int column) {
    return ofCell(row, column, tr("%1: mass by the drawing."),
                  tr("%1: permitted heaviest minus lightest, by the works manual. Blank means no "
                     "limit."),
                  tr("%1 of cylinder %2 by the scale."));
}

std::optional<double> WeighInTable::mass(int row, int column) const {
    const auto& sheet = model_->input().weigh_in;
    const bool isThere =
        sheet && row < firstCylinder + static_cast<int>(sheet->columns[0].mass.size());
    return isThere ? cellOf(*sheet, row, column) : std::nullopt;
}

void WeighInTable::setMass(int row, int column, std::optional<double> mass) {
    model_->editWeights(ofCell(row, column, tr("%1, nominal"), tr("%1, range"), tr("%1 %2")),
                        [&](shop::WeighIn& sheet) { cellOf(sheet, row, column) = mass; });
}

QString WeighInTable::paste(int row, int column, const std::vector<QStringList>& cells) {
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
            if (toRow >= rows() || toColumn >= columns) {
                return tr("Not pasted: from here the block does not fit on the sheet of %1 "
                          "cylinders.")
                    .arg(rows() - firstCylinder);
            }
            // In the unit that the cells show.
            const Field& field = fieldOf(toRow);
            const ShownUnit unit = shownUnit(field.unit);
            const auto value = readTypedNumber(typed, unit.name).value;
            if (!value || field.left_by(*value / unit.factor) != nullptr) {
                return tr("Not pasted: “%1” is not a mass in %2.").arg(typed, unit.name);
            }
            pasted.push_back({toRow, toColumn, *value / unit.factor * field.unit});
        }
    }
    return model_->editWeights(tr("Paste weights"), [&](shop::WeighIn& sheet) {
        for (const Pasted& each : pasted) {
            cellOf(sheet, each.row, each.column) = each.mass;
        }
    });
}

}  // namespace ravnoves

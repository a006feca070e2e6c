#include "workshop/model/weigh_in_table.h"

#include "bob-weights/fields.h"
#include "text/message_text.h"
#include "text/shown_units.h"
#include "text/typed_number.h"
#include "workshop/model/workshop_model.h"

namespace ravnoves {

namespace {

QString partOf(int column) {
    return shownText(shop::part_word(shop::all_parts[static_cast<std::size_t>(column)]).label);
}

auto& cellOf(auto& sheet, int row, int column) {
    auto& part = sheet.columns[static_cast<std::size_t>(column)];
    constexpr int first = WeighInTable::firstCylinder;
    return row >= first ? part.mass[static_cast<std::size_t>(row - first)]
           : row == 0   ? part.nominal
                        : part.permitted_spread;
}

}  // namespace

WeighInTable::WeighInTable(WorkshopModel* model, QObject* parent)
    : EditableTable(parent), model_(model) {}

int WeighInTable::cylinders() const {
    return model_->input().engine.cylinders;
}

const Field& WeighInTable::fieldOf(int row) {
    return row >= firstCylinder ? bob_weights::field::part_mass
           : row == 0           ? shop::field::nominal
                                : shop::field::permitted_spread;
}

int WeighInTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : firstCylinder + cylinders();
}

int WeighInTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(shop::all_parts.size());
}

QVariant WeighInTable::data(const QModelIndex& cell, int role) const {
    const int row = cell.row();
    const QString part = partOf(cell.column());
    const int cylinder = row - firstCylinder + 1;
    const bool isNominal = cylinder < 1 && row == 0;
    const bool isSpread = cylinder < 1 && row == 1;
    switch (role) {
        case Qt::EditRole: {
            const auto& sheet = model_->input().weigh_in;
            const bool isThere =
                sheet && row < firstCylinder + static_cast<int>(sheet->columns[0].mass.size());
            const shop::Weighed mass =
                isThere ? cellOf(*sheet, row, cell.column()) : shop::Weighed();
            return mass ? QVariant(from_si(fieldOf(row), *mass)) : QVariant();
        }
        case Qt::AccessibleTextRole:
            return shownTitle(isNominal  ? tr("%1, nominal mass, g").arg(part)
                              : isSpread ? tr("%1, permitted range, g").arg(part)
                                         : tr("%1 of cylinder %2, g").arg(part).arg(cylinder))
                .text;
        case Qt::ToolTipRole:
            return isNominal  ? tr("%1: mass by the drawing.").arg(part)
                   : isSpread ? tr("%1: permitted heaviest minus lightest, by the works manual. "
                                   "Blank means no limit.")
                                    .arg(part)
                              : tr("%1 of cylinder %2 by the scale.").arg(part).arg(cylinder);
        case KeyRole: {
            const std::string_view word =
                shop::part_word(shop::all_parts[static_cast<std::size_t>(cell.column())]).word;
            const auto key = QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()));
            return isNominal  ? QStringLiteral("nominal_") + key
                   : isSpread ? QStringLiteral("spread_") + key
                              : QStringLiteral("mass_%1_%2").arg(key).arg(cylinder);
        }
        default:
            return {};
    }
}

QVariant WeighInTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole) {
        return {};
    }
    if (orientation == Qt::Horizontal) {
        return partOf(section);
    }
    return section >= firstCylinder ? QString::number(section - firstCylinder + 1)
           : section == 0           ? shownTitle(tr("nominal, g")).text
                                    : shownTitle(tr("permitted range, g")).text;
}

bool WeighInTable::setData(const QModelIndex& cell, const QVariant& value, int role) {
    if (role != Qt::EditRole || !cell.isValid()) {
        return false;
    }
    const int row = cell.row();
    const QString part = partOf(cell.column());
    const QString step = row >= firstCylinder ? tr("%1 %2").arg(part).arg(row - firstCylinder + 1)
                         : row == 0           ? tr("%1, nominal").arg(part)
                                              : tr("%1, range").arg(part);
    return model_
        ->editWeights(step,
                      [&](shop::WeighIn& sheet) {
                          cellOf(sheet, row, cell.column()) =
                              value.isValid() ? shop::Weighed(value.toDouble() * fieldOf(row).unit)
                                              : std::nullopt;
                      })
        .isEmpty();
}

QString WeighInTable::pasteBlock(int row, int column, const std::vector<QStringList>& cells) {
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
            if (!index(toRow, toColumn).isValid()) {
                return tr("Not pasted: from here the block does not fit on the sheet of %1 "
                          "cylinders.")
                    .arg(cylinders());
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

#include "v8-plugs/model/weigh_in_table.h"

#include "text/shown_units.h"
#include "text/typed_number.h"
#include "v8-plugs/fields.h"
#include "v8-plugs/model/v8_names.h"
#include "v8-plugs/model/v8_plugs_model.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

template <typename Sheet>
auto& cellOf(Sheet& sheet, int row, int column) {
    auto& part = sheet.columns[static_cast<std::size_t>(column)];
    return row == 0   ? part.nominal
           : row == 1 ? part.permitted_spread
                      : part.mass[static_cast<std::size_t>(row - WeighInTable::firstCylinder)];
}

}  // namespace

WeighInTable::WeighInTable(V8PlugsModel* model, QObject* parent)
    : EditableTable(parent), model_(model) {
    connect(model_, &SceneModel::changed, this,
            [this] { Q_EMIT dataChanged(index(0, 0), index(rows - 1, columnCount() - 1)); });
}

const Field& WeighInTable::fieldOf(int row) {
    return row == 0 ? field::nominal : row == 1 ? field::permitted_spread : field::part_mass;
}

int WeighInTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : rows;
}

int WeighInTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(all_parts.size());
}

QString WeighInTable::partOf(int column) const {
    return v8_text::partName(Words(), all_parts[static_cast<std::size_t>(column)]);
}

QVariant WeighInTable::data(const QModelIndex& cell, int role) const {
    const int row = cell.row();
    const QString part = partOf(cell.column());
    const int cylinder = row - firstCylinder + 1;
    switch (role) {
        case Qt::EditRole:
            if (const auto& sheet = model_->input().weigh_in) {
                const auto& mass = cellOf(*sheet, row, cell.column());
                return mass ? QVariant(from_si(fieldOf(row), *mass)) : QVariant();
            }
            return {};
        case Qt::AccessibleTextRole:
            return shownTitle(row == 0   ? tr("%1, nominal mass, g").arg(part)
                              : row == 1 ? tr("%1, permitted spread, g").arg(part)
                                         : tr("%1 of cylinder %2, g").arg(part).arg(cylinder))
                .text;
        case Qt::ToolTipRole:
            return row == 0   ? tr("%1: mass by the drawing.").arg(part)
                   : row == 1 ? tr("%1: heaviest less lightest that the works manual permits. "
                                   "Empty: no limit.")
                                    .arg(part)
                              : tr("%1 of cylinder %2 as the scale says.").arg(part).arg(cylinder);
        case KeyRole: {
            const std::string_view word =
                part_word(all_parts[static_cast<std::size_t>(cell.column())]).word;
            const auto key = QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()));
            return row == 0   ? QStringLiteral("nominal_") + key
                   : row == 1 ? QStringLiteral("spread_") + key
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
    return section == 0   ? shownTitle(tr("nominal, g")).text
           : section == 1 ? shownTitle(tr("permitted spread, g")).text
                          : QString::number(section - firstCylinder + 1);
}

bool WeighInTable::setData(const QModelIndex& cell, const QVariant& value, int role) {
    if (role != Qt::EditRole || !cell.isValid()) {
        return false;
    }
    const int row = cell.row();
    const QString part = partOf(cell.column());
    const QString step = row == 0   ? tr("%1, nominal").arg(part)
                         : row == 1 ? tr("%1, spread").arg(part)
                                    : tr("%1 %2").arg(part).arg(row - firstCylinder + 1);
    return model_
        ->editWeights(step,
                      [&](WeighIn& sheet) {
                          cellOf(sheet, row, cell.column()) =
                              value.isValid() ? std::optional(value.toDouble() * fieldOf(row).unit)
                                              : std::nullopt;
                      })
        .isEmpty();
}

QString WeighInTable::pasteBlock(int row, int column, const std::vector<QStringList>& cells) {
    WeighIn sheet = model_->input().weigh_in.value_or(WeighIn{});
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (qsizetype j = 0; j < cells[i].size(); ++j) {
            const QString& typed = cells[i].at(j);
            if (typed.isEmpty()) {
                continue;
            }
            const int toRow = row + static_cast<int>(i);
            const int toColumn = column + static_cast<int>(j);
            if (!index(toRow, toColumn).isValid()) {
                return tr("Nothing is pasted: the block does not fit on the sheet from here.");
            }
            // In the unit that the cells show.
            const Field& field = fieldOf(toRow);
            const ShownUnit unit = shownUnit(field.unit);
            const auto value = readTypedNumber(typed, unit.name).value;
            if (!value || !field.range.contains(*value / unit.factor)) {
                return tr("Nothing is pasted: “%1” is no mass in %2.").arg(typed, unit.name);
            }
            cellOf(sheet, toRow, toColumn) = *value / unit.factor * field.unit;
        }
    }
    return model_->editWeights(tr("Paste weights"), [&](WeighIn& now) { now = sheet; });
}

}  // namespace ravnoves

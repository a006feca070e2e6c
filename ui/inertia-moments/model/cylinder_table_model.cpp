#include "inertia-moments/model/cylinder_table_model.h"

#include <QLocale>
#include <algorithm>
#include <array>

#include "inertia-moments/fields.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "text/message_text.h"
#include "text/number_text.h"

namespace ravnoves {

using inertia_moments::Cylinder;
using inertia_moments::Input;
namespace field = inertia_moments::field;

namespace {

struct ColumnInfo {
    const Field* field;
    double Cylinder::*member;
};

const std::array<ColumnInfo, CylinderTableModel::Columns>& columns() {
    static const std::array<ColumnInfo, CylinderTableModel::Columns> list{
        {{&field::axial_position, &Cylinder::axial_position},
         {&field::bank_angle, &Cylinder::bank_angle},
         {&field::offset, &Cylinder::offset},
         {&field::crankpin_angle, &Cylinder::crankpin_angle}}};
    return list;
}

const ColumnInfo& infoOf(int index) {
    return columns().at(static_cast<std::size_t>(index));
}

}  // namespace

CylinderTableModel::CylinderTableModel(InertiaMomentsModel* model, QObject* parent)
    : EditableTable(parent), model_(model) {
    rows_ = rowCount();
    connect(model_, &SceneModel::changed, this, &CylinderTableModel::refresh);
}

double CylinderTableModel::valueAt(int row, int column) const {
    return model_->result().engine.cylinders[static_cast<std::size_t>(row)].*infoOf(column).member;
}

void CylinderTableModel::refresh() {
    const int now = static_cast<int>(model_->result().engine.cylinders.size());
    std::erase_if(refused_, [&](const auto& cell) {
        const auto [row, column] = cell.first;
        return row >= now || valueAt(row, column) != cell.second.below;
    });
    if (now != rows_) {
        beginResetModel();
        rows_ = now;
        endResetModel();
        return;
    }
    Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, Columns - 1));
}

int CylinderTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(model_->result().engine.cylinders.size());
}

int CylinderTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : Columns;
}

QVariant CylinderTableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const ColumnInfo& info = infoOf(index.column());
    const double value = valueAt(index.row(), index.column());
    const auto refused = refused_.find({index.row(), index.column()});
    if (refused != refused_.end()) {
        if (role == Qt::DisplayRole || role == Qt::EditRole) {
            return refused->second.text;
        }
        if (role == TroubleRole) {
            return true;
        }
    }
    switch (role) {
        case Qt::DisplayRole:
            return formNumber(from_si(*info.field, value), QLocale(), 6);
        case Qt::EditRole:
            return formNumber(from_si(*info.field, value), QLocale(), 15);
        case Qt::TextAlignmentRole:
            return QVariant(Qt::AlignRight | Qt::AlignVCenter);
        default:
            return {};
    }
}

bool CylinderTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid()) {
        return false;
    }
    const ColumnInfo& info = infoOf(index.column());
    const QString text = value.toString().trimmed();
    const auto number = readFormNumber(text);
    const std::pair cell(index.row(), index.column());
    const bool wasRefused = refused_.erase(cell) > 0;
    QString why;
    if (!number || !info.field->range.contains(*number)) {
        why = tr("Cylinder %1: %2")
                  .arg(QString::number(index.row() + 1),
                       rangeText(info.field->range, unitText(info.field->unit.name), QLocale()));
    } else {
        why = model_->edit(tr("Cylinder %1").arg(index.row() + 1), [&](Input& input) {
            model_->tableOf(input).at(static_cast<std::size_t>(index.row())).*info.member =
                *number * info.field->unit;
        });
        model_->finishDrag();
    }
    if (!why.isEmpty()) {
        refused_[cell] = {text, valueAt(index.row(), index.column())};
    }
    if (wasRefused || !why.isEmpty()) {
        Q_EMIT dataChanged(index, index);
    }
    Q_EMIT troubleChanged(why);
    return why.isEmpty();
}

QVariant CylinderTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) {
        return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
    }
    const Field& field = *infoOf(section).field;
    switch (role) {
        case Qt::DisplayRole:
            return QString::fromUtf8(field.symbol.data(),
                                     static_cast<qsizetype>(field.symbol.size())) +
                   QStringLiteral(", ") + unitText(field.unit.name);
        case Qt::ToolTipRole:
            return shownText(field.hint);
        default:
            return {};
    }
}

void CylinderTableModel::insertRowBelow(int row) {
    const QString why = model_->edit(tr("Add cylinder"), [&](Input& input) {
        auto& cylinders = model_->tableOf(input);
        const int at = row < 0 ? static_cast<int>(cylinders.size()) - 1 : row;
        Cylinder copy = cylinders.at(static_cast<std::size_t>(at));
        copy.axial_position -= 2.0 * input.crank_radius;
        cylinders.insert(cylinders.begin() + at + 1, copy);
        input.firing_order.clear();  // it no longer names every cylinder
    });
    model_->finishDrag();
    Q_EMIT troubleChanged(why);
}

void CylinderTableModel::removeRowRange(int first, int count) {
    if (first < 0 || count <= 0) {
        return;
    }
    if (count >= rowCount()) {
        Q_EMIT troubleChanged(tr("An engine has at least one cylinder."));
        return;
    }
    const QString why = model_->edit(tr("Remove cylinder"), [&](Input& input) {
        auto& cylinders = model_->tableOf(input);
        const auto from = cylinders.begin() + first;
        cylinders.erase(from, from + std::min(count, static_cast<int>(cylinders.size()) - first));
        input.firing_order.clear();
    });
    model_->finishDrag();
    Q_EMIT troubleChanged(why);
}

QString CylinderTableModel::pasteBlock(int row, int column, const std::vector<QStringList>& cells) {
    const std::size_t first = static_cast<std::size_t>(row);
    if (first + cells.size() > static_cast<std::size_t>(inertia_moments::most_cylinders)) {
        return tr("At most %1 cylinders.").arg(inertia_moments::most_cylinders);
    }
    std::vector<Cylinder> cylinders = model_->result().engine.cylinders;
    cylinders.resize(std::max(cylinders.size(), first + cells.size()));
    for (std::size_t line = 0; line < cells.size(); ++line) {
        for (int cell = 0; cell < cells[line].size() && column + cell < Columns; ++cell) {
            const ColumnInfo& info = infoOf(column + cell);
            const auto number = readFormNumber(cells[line][cell]);
            if (!number || !info.field->range.contains(*number)) {
                return tr("Line %1, column %2: %3 is no number that fits here.")
                    .arg(QString::number(line + 1), QString::number(cell + 1),
                         cells[line][cell].left(20));
            }
            cylinders[first + line].*info.member = *number * info.field->unit;
        }
    }
    QString why = model_->edit(tr("Paste cylinders"), [&](Input& input) {
        model_->tableOf(input) = cylinders;
        if (input.firing_order.size() != cylinders.size()) {
            input.firing_order.clear();
        }
    });
    model_->finishDrag();
    Q_EMIT troubleChanged(why);
    return why;
}

}  // namespace ravnoves

#include "model/rejecting_table.h"

namespace ravnoves {

void RejectingTable::takeBackRejected(const QModelIndex& at) {
    setRejected(at.row(), at.column(), {}, {});
    Q_EMIT troubleChanged(trouble());
    Q_EMIT dataChanged(at, at);
}

void RejectingTable::forgetRejected() {
    if (!rejected_.empty()) {
        rejected_.clear();
        Q_EMIT troubleChanged({});
        Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, columns_ - 1));
    }
}

void RejectingTable::setRejected(int row, int column, const QString& text, const QString& why) {
    const Cell cell(rowName(row), column);
    if (why.isEmpty()) {
        rejected_.erase(cell);
    } else {
        rejected_[cell] = {text, why, held(row, column)};
    }
}

void RejectingTable::setTaken(int row, int column, const std::vector<QStringList>& cells) {
    if (rejected_.empty()) {
        return;
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (int j = 0; j < cells[i].size(); ++j) {
            rejected_.erase({rowName(row + static_cast<int>(i)), column + j});
        }
    }
    Q_EMIT troubleChanged(trouble());
    Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, columns_ - 1));
}

std::vector<RejectingTable::Cell> RejectingTable::rejectedCells() const {
    std::vector<Cell> cells;
    for (int row = 0; row < rowCount() && !rejected_.empty(); ++row) {
        for (int column = 0; column < columnCount(); ++column) {
            if (Cell cell(rowName(row), column); rejected_.contains(cell)) {
                cells.push_back(std::move(cell));
            }
        }
    }
    return cells;
}

QString RejectingTable::trouble() const {
    SaidTroubles troubles;
    for (const Cell& cell : rejectedCells()) {
        troubles.add(rejectedText(cell, rejected_.at(cell)));
    }
    return troubles.text(tr("Also not accepted: %1"));
}

QVariant RejectingTable::rejectedData(const QModelIndex& at, int role) const {
    const auto there =
        rejected_.empty() ? rejected_.end() : rejected_.find({rowName(at.row()), at.column()});
    switch (role) {
        case TroubleRole:
            return there != rejected_.end();
        case Qt::DisplayRole:
        case Qt::EditRole:
            return there != rejected_.end() ? there->second.text : QVariant();
        case Qt::ToolTipRole:
            return there != rejected_.end() ? there->second.why : QVariant();
        default:
            return {};
    }
}

void RejectingTable::follow() {
    std::map<std::string, int> rows;
    for (int row = 0; row < rowCount() && !rejected_.empty(); ++row) {
        rows[rowName(row)] = row;
    }
    const auto corrected = std::erase_if(rejected_, [&](const auto& each) {
        const auto& [cell, rejected] = each;
        const auto row = rows.find(cell.first);
        return row == rows.end() || cell.second >= columnCount() ||
               held(row->second, cell.second) != rejected.below;
    });
    if (corrected > 0) {
        Q_EMIT troubleChanged(trouble());
    }
    if (rowCount() != rows_ || columnCount() != columns_) {
        beginResetModel();
        rows_ = rowCount();
        columns_ = columnCount();
        endResetModel();
    } else if (rows_ > 0) {
        Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, columns_ - 1));
    }
}

}  // namespace ravnoves

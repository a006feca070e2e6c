#include "model/refusing_table.h"

namespace ravnoves {

void RefusingTable::takeBackRefused(const QModelIndex& at) {
    setRefused(at.row(), at.column(), {}, {});
    Q_EMIT troubleChanged(trouble());
    Q_EMIT dataChanged(at, at);
}

void RefusingTable::forgetRefused() {
    if (!refused_.empty()) {
        refused_.clear();
        Q_EMIT troubleChanged({});
        Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, columns_ - 1));
    }
}

void RefusingTable::setRefused(int row, int column, const QString& text, const QString& why) {
    const Cell cell(rowName(row), column);
    if (why.isEmpty()) {
        refused_.erase(cell);
    } else {
        refused_[cell] = {text, why, held(row, column)};
    }
}

void RefusingTable::setTaken(int row, int column, const std::vector<QStringList>& cells) {
    if (refused_.empty()) {
        return;
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (int j = 0; j < cells[i].size(); ++j) {
            refused_.erase({rowName(row + static_cast<int>(i)), column + j});
        }
    }
    Q_EMIT troubleChanged(trouble());
    Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, columns_ - 1));
}

std::vector<RefusingTable::Cell> RefusingTable::refusedCells() const {
    std::vector<Cell> cells;
    for (int row = 0; row < rowCount() && !refused_.empty(); ++row) {
        for (int column = 0; column < columnCount(); ++column) {
            if (Cell cell(rowName(row), column); refused_.contains(cell)) {
                cells.push_back(std::move(cell));
            }
        }
    }
    return cells;
}

QString RefusingTable::trouble() const {
    SaidTroubles troubles;
    for (const Cell& cell : refusedCells()) {
        troubles.add(refusedText(cell, refused_.at(cell)));
    }
    return troubles.text(tr("Also not accepted: %1"));
}

QVariant RefusingTable::refusedData(const QModelIndex& at, int role) const {
    const auto there =
        refused_.empty() ? refused_.end() : refused_.find({rowName(at.row()), at.column()});
    switch (role) {
        case TroubleRole:
            return there != refused_.end();
        case Qt::DisplayRole:
        case Qt::EditRole:
            return there != refused_.end() ? there->second.text : QVariant();
        case Qt::ToolTipRole:
            return there != refused_.end() ? there->second.why : QVariant();
        default:
            return {};
    }
}

void RefusingTable::follow() {
    std::map<std::string, int> rows;
    for (int row = 0; row < rowCount() && !refused_.empty(); ++row) {
        rows[rowName(row)] = row;
    }
    const auto mended = std::erase_if(refused_, [&](const auto& each) {
        const auto& [cell, refused] = each;
        const auto row = rows.find(cell.first);
        return row == rows.end() || cell.second >= columnCount() ||
               held(row->second, cell.second) != refused.below;
    });
    if (mended > 0) {
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

#include "model/editable_table.h"

#include <QCoreApplication>
#include <algorithm>

#include "case-file/decimal.h"
#include "text/typed_number.h"

namespace ravnoves {

namespace {

/// A number, or one with a slip in it: "56O,1" is no heading, which would be passed over.
bool mayBeNumber(const QString& cell) {
    const bool isWord = cell.size() > 1 && cell[0].isLetter() && cell[1].isLetter();
    return !isWord && std::any_of(cell.begin(), cell.end(), [](QChar c) { return c.isDigit(); });
}

}  // namespace

std::vector<QStringList> readTextTable(const QString& text, EmptyLine empty) {
    std::vector<QStringList> rows;
    for (const QString& line : text.split(QLatin1Char('\n'))) {
        if (empty == EmptyLine::nothing && line.trimmed().isEmpty()) {
            continue;
        }
        QStringList cells =
            line.split(line.contains(QLatin1Char('\t')) ? QLatin1Char('\t') : QLatin1Char(';'));
        for (QString& cell : cells) {
            constexpr qsizetype longest = 1000;  // letters; no number has more, no label takes it
            cell = cell.trimmed();
            if (cell.size() > longest) {
                cell = cell.left(longest) + QChar(0x2026);
            }
        }
        rows.push_back(std::move(cells));
    }
    while (!rows.empty() && rows.back().join(QString()).isEmpty()) {
        rows.pop_back();
    }
    const bool beginsWithGap =
        empty == EmptyLine::gap && !rows.empty() && rows[0].join(QString()).isEmpty();
    if (rows.size() > 1 && !beginsWithGap &&
        std::none_of(rows[0].begin(), rows[0].end(), mayBeNumber)) {
        rows.erase(rows.begin());
    }
    return rows;
}

QString mixedDecimalSigns(const std::vector<QStringList>& cells) {
    QString comma;
    QString point;
    for (const QStringList& row : cells) {
        for (const QString& cell : row) {
            if (isTypedNumber(cell)) {
                comma = comma.isEmpty() && may_have_thousands(cell.toStdString()) ? cell : comma;
                point = point.isEmpty() && cell.contains(QLatin1Char('.')) ? cell : point;
            }
        }
    }
    return comma.isEmpty() || point.isEmpty()
               ? QString()
               : QCoreApplication::translate("ravnoves::TableEditor",
                                             "Not pasted: “%1” has a comma, “%2” a point. Use one "
                                             "decimal sign and no thousands separators.")
                     .arg(comma, point);
}

QString saidTroubles(const QStringList& lines) {
    constexpr qsizetype maximum = 3;
    QStringList all = lines.mid(0, maximum);
    if (lines.size() > maximum) {
        all << EditableTable::tr("Also not accepted: %1").arg(lines.size() - maximum);
    }
    return all.join(QLatin1Char('\n'));
}

int EditableTable::widthOf(const std::vector<QStringList>& cells) {
    qsizetype wide = 0;
    for (const QStringList& line : cells) {
        qsizetype filled = line.size();
        while (filled > 0 && line[filled - 1].isEmpty()) {
            --filled;
        }
        wide = std::max(wide, filled);
    }
    return static_cast<int>(wide);
}

QString EditableTable::noRoomText(const std::vector<QStringList>& cells, int rows, int columns) {
    rows = std::max(rows, 0);  // the place may lie behind the last row
    const int wide = widthOf(cells);
    if (wide > columns) {
        return tr("Not pasted: the block has %1 columns, but only %2 fit here.")
            .arg(wide)
            .arg(columns);
    }
    if (cells.size() > static_cast<std::size_t>(rows)) {
        return tr("Not pasted: the block has %1 rows, but only %2 fit here.")
            .arg(cells.size())
            .arg(rows);
    }
    return {};
}

QString EditableTable::paste(int row, int column, const std::vector<QStringList>& cells) {
    const QString mixed = mixedDecimalSigns(cells);
    return mixed.isEmpty() ? pasteBlock(row, column, cells) : mixed;
}

Qt::ItemFlags EditableTable::flags(const QModelIndex& index) const {
    return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable
                           : Qt::NoItemFlags;
}

void EditableTable::takeBackRejected(const QModelIndex& at) {
    setRejected(at.row(), at.column(), {}, {});
    Q_EMIT troubleChanged(trouble());
    Q_EMIT dataChanged(at, at);
}

void EditableTable::forgetRejected() {
    if (!rejected_.empty()) {
        rejected_.clear();
        Q_EMIT troubleChanged({});
        Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, columns_ - 1));
    }
}

void EditableTable::setRejected(int row, int column, const QString& text, const QString& why) {
    const Cell cell(rowName(row), column);
    if (why.isEmpty()) {
        rejected_.erase(cell);
    } else {
        rejected_[cell] = {text, why, held(row, column)};
    }
}

void EditableTable::setTaken(int row, int column, const std::vector<QStringList>& cells) {
    if (rejected_.empty()) {
        return;
    }
    // Rows may have gone by what was taken.
    for (std::size_t i = 0; i < cells.size() && row + static_cast<int>(i) < rowCount(); ++i) {
        for (int j = 0; j < cells[i].size(); ++j) {
            rejected_.erase({rowName(row + static_cast<int>(i)), column + j});
        }
    }
    Q_EMIT troubleChanged(trouble());
    Q_EMIT dataChanged(index(0, 0), index(rows_ - 1, columns_ - 1));
}

std::vector<EditableTable::Cell> EditableTable::rejectedCells() const {
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

QString EditableTable::trouble() const {
    QStringList troubles;
    for (const Cell& cell : rejectedCells()) {
        troubles << rejectedText(cell, rejected_.at(cell));
    }
    return saidTroubles(troubles);
}

QVariant EditableTable::rejectedData(const QModelIndex& at, int role) const {
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

void EditableTable::follow() {
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

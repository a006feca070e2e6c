#include "model/editable_table.h"

#include <QCoreApplication>
#include <algorithm>

#include "case-file/decimal.h"
#include "text/typed_number.h"

namespace ravnoves {

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
        std::none_of(rows[0].begin(), rows[0].end(), isTypedNumber)) {
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

void SaidTroubles::add(const QString& line) {
    constexpr int maximum = 3;
    if (lines_.size() < maximum) {
        lines_ << line;
    } else {
        ++more_;
    }
}

QString SaidTroubles::text(const QString& others) const {
    QStringList all = lines_;
    if (more_ > 0) {
        all << others.arg(more_);
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

}  // namespace ravnoves

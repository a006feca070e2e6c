#include "widgets/whole_rows.h"

#include <QTimer>
#include <QtMath>
#include <algorithm>

#include "text/text_width.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

constexpr int cellPadding = 8;

}  // namespace

QRegion wholeRows(const QTableView& table) {
    QRect room = table.viewport()->rect();
    if (table.verticalScrollBar()->maximum() == 0) {
        return room;
    }
    const int row = table.rowAt(room.bottom());
    const int top = row < 0 ? 0 : table.rowViewportPosition(row);
    if (top > 0 && top + table.rowHeight(row) > room.height()) {
        room.setHeight(top);
    }
    return room;
}

void fitRowsToWords(QTableView& table, const QList<int>& columns) {
    const QAbstractItemModel& model = *table.model();
    QHeaderView* rows = table.verticalHeader();
    bool changed = false;
    for (int row = 0; row < model.rowCount(); ++row) {
        int height = rows->defaultSectionSize();
        for (const int column : columns) {
            if (table.isColumnHidden(column)) {
                continue;
            }
            const QModelIndex index = model.index(row, column);
            const QVariant own = index.data(Qt::FontRole);
            const QFont font = own.isValid() ? own.value<QFont>() : table.font();
            const QString text = index.data().toString();
            const int room = table.columnWidth(column) - cellPadding;
            if (textWidth(font, text) > room) {
                const QRect lines = QFontMetrics(font).boundingRect(
                    QRect(0, 0, room, QWIDGETSIZE_MAX), Qt::TextWordWrap, text);
                height = std::max(height, lines.height() + Theme::gap);
            }
        }
        if (rows->sectionSize(row) != height) {
            rows->resizeSection(row, height);
            changed = true;
        }
    }
    if (changed && table.currentIndex().isValid()) {
        table.scrollTo(table.currentIndex());
    }
}

void keepRowsToWords(QTableView& table, const QList<int>& columns) {
    table.setWordWrap(true);
    // After the header has shared out the room: rows that grow bring a bar, which takes of it.
    auto* later = new QTimer(&table);
    later->setSingleShot(true);
    QObject::connect(later, &QTimer::timeout, &table,
                     [&table, columns] { fitRowsToWords(table, columns); });
    const auto fit = [later] { later->start(0); };
    QObject::connect(table.horizontalHeader(), &QHeaderView::sectionResized, later, fit);
    const QAbstractItemModel* model = table.model();
    QObject::connect(model, &QAbstractItemModel::dataChanged, later, fit);
    QObject::connect(model, &QAbstractItemModel::rowsInserted, later, fit);
    QObject::connect(model, &QAbstractItemModel::modelReset, later, fit);
    fit();
}

int longestWord(const QTableView& table, int column) {
    const QAbstractItemModel& model = *table.model();
    int widest = 0;
    for (int row = 0; row < model.rowCount(); ++row) {
        const QString text = model.index(row, column).data().toString();
        for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            widest = std::max(widest, qCeil(textWidth(table.font(), word)));
        }
    }
    return widest + cellPadding + 2;
}

}  // namespace ravnoves

#include "widgets/result_table.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>

#include "text/csv_format.h"
#include "theme/theme.h"

namespace ravnoves {

ResultTable::ResultTable(QWidget* parent) : QTableWidget(parent) {
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::ContiguousSelection);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setFont(Theme::font(Theme::baseSize - 1));
    setTabKeyNavigation(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(Theme::withText(20));
    verticalHeader()->setMinimumSectionSize(Theme::withText(18));
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setFont(Theme::font(Theme::smallSize + 1, true));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // until it is needed
    setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
}

void ResultTable::setColumns(const QStringList& headings) {
    setColumnCount(static_cast<int>(headings.size()));
    isOver_ = false;
    setHorizontalHeaderLabels(headings);
    for (int column = 0; column < headings.size(); ++column) {
        horizontalHeaderItem(column)->setTextAlignment(
            (column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    }
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    showTips();
    fitColumns();
}

void ResultTable::fitColumns() {
    // Columns only ever grow, so that they rest while a slider moves.
    constexpr int padding = 9;
    const QFontMetrics cells(font());
    const QFontMetrics headings(horizontalHeader()->font());
    for (int column = 1; column < columnCount(); ++column) {
        if (stretched_.contains(column)) {
            continue;
        }
        int width = columnWidth(column) * (fitted_ ? 1 : 0);
        width = std::max(
            width, headings.horizontalAdvance(horizontalHeaderItem(column)->text()) + padding);
        for (int row = 0; row < rowCount(); ++row) {
            if (const QTableWidgetItem* cell = item(row, column)) {
                width = std::max(width, cells.horizontalAdvance(cell->text()) + padding);
            }
        }
        if (width != columnWidth(column)) {
            setColumnWidth(column, width);
        }
    }
    fitted_ = true;
    fitStretched();
}

void ResultTable::stretchColumn(int column) {
    stretched_ << column;
    horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
}

void ResultTable::fitStretched() {
    constexpr int most = 110;  // designed pixels that words insist on
    constexpr int padding = 12;
    const QFontMetrics cells(font());
    int wanted = 0;
    QList<int> least;
    for (int column = 0; column < columnCount(); ++column) {
        if (!stretched_.contains(column)) {
            wanted += columnWidth(column);
            continue;
        }
        int widest = 0;
        for (int row = 0; row < rowCount() && widest < Theme::withText(most); ++row) {
            if (const QTableWidgetItem* cell = item(row, column)) {
                widest = std::max(widest, cells.horizontalAdvance(cell->text()) + padding);
            }
        }
        least << std::clamp(widest, Theme::withText(30), Theme::withText(most));
        wanted += least.last();
    }
    const bool over = wanted > viewport()->width();
    if (over != isOver_) {
        isOver_ = over;
        setHorizontalScrollBarPolicy(over ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
        for (const int column : stretched_) {
            horizontalHeader()->setSectionResizeMode(
                column, over ? QHeaderView::Fixed : QHeaderView::Stretch);
        }
        updateGeometry();
    }
    for (int i = 0; over && i < stretched_.size(); ++i) {
        if (columnWidth(stretched_[i]) != least[i]) {
            setColumnWidth(stretched_[i], least[i]);
        }
    }
}

void ResultTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    fitStretched();
}

void ResultTable::setRows(const QVector<QStringList>& rows) {
    if (rowCount() != rows.size()) {
        setRowCount(static_cast<int>(rows.size()));
        updateGeometry();
    }
    for (int row = 0; row < rows.size(); ++row) {
        for (int column = 0; column < columnCount(); ++column) {
            const QString text = rows[row].value(column);
            QTableWidgetItem* cell = item(row, column);
            if (cell == nullptr) {
                cell = new QTableWidgetItem(text);
                cell->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) |
                                       Qt::AlignVCenter);
                setItem(row, column, cell);
            } else if (cell->text() != text) {
                cell->setText(text);
            }
        }
    }
    showTips();
    fitColumns();
}

void ResultTable::setTips(const ResultTips& tips) {
    tips_.clear();
    for (const auto& [name, tip] : tips) {
        tips_.insert(name, tip);
    }
    showTips();
}

QString ResultTable::tipOf(const QString& name) const {
    const auto exact = tips_.constFind(name);
    if (exact != tips_.constEnd()) {
        return *exact;
    }
    for (auto tip = tips_.constBegin(); tip != tips_.constEnd(); ++tip) {
        const qsizetype place = tip.key().indexOf(QLatin1String("%1"));
        if (place >= 0 && name.startsWith(tip.key().left(place)) &&
            name.endsWith(tip.key().mid(place + 2))) {
            return *tip;
        }
    }
    return {};
}

void ResultTable::showTips() {
    if (tips_.isEmpty()) {
        return;
    }
    for (int column = 0; column < columnCount(); ++column) {
        QTableWidgetItem* heading = horizontalHeaderItem(column);
        QString ofColumn;
        if (heading != nullptr) {
            ofColumn = tipOf(heading->text());
            heading->setToolTip(ofColumn);
        }
        for (int row = 0; row < rowCount(); ++row) {
            QTableWidgetItem* cell = item(row, column);
            const QTableWidgetItem* name = item(row, 0);
            if (cell == nullptr || name == nullptr) {
                continue;
            }
            QStringList lines{tipOf(name->text())};
            if (column > 0 || lines.first().isEmpty()) {
                lines << ofColumn;
            }
            lines.removeAll(QString());
            cell->setToolTip(lines.join(QLatin1Char('\n')));
        }
    }
}

void ResultTable::setCellToolTip(int row, int column, const QString& text) {
    if (QTableWidgetItem* cell = item(row, column)) {
        cell->setToolTip(text);
    }
}

QString ResultTable::joined(QChar separator, bool selectionOnly) const {
    const CsvFormat csv;
    const auto written = [&](const QString& text) {
        return separator == QLatin1Char('\t') ? text : csv.field(text);
    };
    QString text;
    QStringList line;
    for (int column = 0; column < columnCount() && !selectionOnly; ++column) {
        line << written(horizontalHeaderItem(column)->text());
    }
    if (!line.isEmpty()) {
        text += line.join(separator) + QLatin1Char('\n');
    }
    for (int row = 0; row < rowCount(); ++row) {
        line.clear();
        for (int column = 0; column < columnCount(); ++column) {
            const QTableWidgetItem* cell = item(row, column);
            if (cell != nullptr && (!selectionOnly || cell->isSelected())) {
                line << written(cell->text());
            }
        }
        if (!line.isEmpty()) {
            text += line.join(separator) + QLatin1Char('\n');
        }
    }
    return text;
}

QString ResultTable::asText() const {
    return joined(QLatin1Char('\t'), false);
}
QString ResultTable::asCsv() const {
    return joined(CsvFormat().separator, false);
}

void ResultTable::copySelection() {
    const bool some = !selectedItems().isEmpty();
    QApplication::clipboard()->setText(joined(QLatin1Char('\t'), some));
}

void ResultTable::paintEvent(QPaintEvent* event) {
    QTableWidget::paintEvent(event);
    if (hasFocus()) {
        QPainter painter(viewport());
        painter.setPen(Theme::instance().accent());
        painter.drawRect(viewport()->rect().adjusted(0, 0, -1, -1));
    }
}

void ResultTable::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy)) {
        copySelection();
        return;
    }
    QTableWidget::keyPressEvent(event);
}

void ResultTable::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    menu.addAction(tr("Copy selection"), this, &ResultTable::copySelection);
    menu.addAction(tr("Copy table as text"), this,
                   [this] { QApplication::clipboard()->setText(asText()); });
    menu.addAction(tr("Copy table as CSV"), this,
                   [this] { QApplication::clipboard()->setText(asCsv()); });
    menu.exec(event->globalPos());
}

void ResultTable::setShownRows(int rows) {
    shownRows_ = rows;
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    updateGeometry();
}

QSize ResultTable::sizeHint() const {
    const int heading =
        horizontalHeader()->isHidden() ? 0 : horizontalHeader()->sizeHint().height();
    const int rows = shownRows_ > 0 ? shownRows_ : rowCount();
    const int bar = isOver_ ? horizontalScrollBar()->sizeHint().height() : 0;
    const int height = heading + rows * verticalHeader()->defaultSectionSize() + bar + 2;
    return {240, height};
}

QSize ResultTable::minimumSizeHint() const {
    return {120, sizeHint().height()};
}

}  // namespace ravnoves

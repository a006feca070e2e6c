#pragma once

#include <QHeaderView>
#include <QPaintEvent>
#include <QScrollBar>
#include <QTableView>

namespace ravnoves {

/// Where a table shows whole rows: all of it but rows that its edges would cut.
QRegion wholeRows(const QTableView& table);

/// Makes rows as high as their words need in these columns, where they wrap; the current row stays
/// in sight.
void fitRowsToWords(QTableView& table, const QList<int>& columns);

/// The same from now on, whatever becomes of its cells and columns.
void keepRowsToWords(QTableView& table, const QList<int>& columns);

/// The width that its longest word needs, as the table writes it.
int longestWord(const QTableView& table, int column);

/// A table that scrolls by whole rows, begins at one, and paints none that its edge cuts.
template <typename Table>
class WithWholeRows : public Table {
  public:
    explicit WithWholeRows(QWidget* parent) : Table(parent) {
        // What was left blank must not be moved as if it were a row.
        QObject::connect(this->verticalScrollBar(), &QScrollBar::valueChanged, this->viewport(),
                         qOverload<>(&QWidget::update));
    }

  protected:
    void paintEvent(QPaintEvent* event) override {
        QPaintEvent whole(event->region() & wholeRows(*this));
        Table::paintEvent(&whole);
    }
    void scrollContentsBy(int dx, int dy) override {
        Table::scrollContentsBy(dx, dy);
        beginAtARow();
    }
    void updateGeometries() override {
        Table::updateGeometries();
        beginAtARow();
    }

  private:
    /// At its end Qt puts the last row to the bottom, and cuts the first.
    void beginAtARow() {
        const QScrollBar* bar = this->verticalScrollBar();
        if (bar->maximum() > 0 && bar->value() == bar->maximum() &&
            this->verticalScrollMode() == QAbstractItemView::ScrollPerItem) {
            this->verticalHeader()->setOffsetToSectionPosition(bar->value());
            this->viewport()->update();
        }
    }
};

}  // namespace ravnoves

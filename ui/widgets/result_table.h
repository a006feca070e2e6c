#pragma once

#include <QStringList>
#include <QTableWidget>
#include <QVector>
#include <utility>
#include <vector>

#include "text/result_row.h"

class QDialogButtonBox;

namespace ravnoves {

class WrappedHeader;

/// A read-only table of results whose selection, or whole, is copied as text (tabs, for a
/// spreadsheet) or CSV. Where it has too little room its headings wrap, then it scrolls sideways.
class ResultTable : public QTableWidget {
    Q_OBJECT

  public:
    explicit ResultTable(QWidget* parent = nullptr);
    /// @param name  of the content, for screen readers
    ResultTable(const QString& name, QWidget* parent) : ResultTable(parent) {
        setAccessibleName(name);
    }

    /// Sets headings once; rows follow with setRows().
    void setColumns(const ResultColumns& columns);
    /// Replaces the cells, with their own differences below them; only what differs is touched, so
    /// it may be called at every step of a slider. Every cell says what its row and its column
    /// mean.
    void setRows(const ResultRows& rows);
    /// Both.
    void setResults(const Results& results);
    /// Shows below its numbers how they differ from those that another input gives, row by row's
    /// key: absolute and in percent. Null removes them.
    void showReference(const Results* results, const QString& name);
    /// Absolute and percent of a cell, as shown; empty without a comparison.
    QStringList differenceAt(int row, int column) const;
    /// Shows them below the numbers, after differences. None removes them.
    /// @param how  they were found, which the cells say too
    void setSpreads(std::vector<CellSpread> spreads, const QString& how = {});
    /// The numbers are others now: "± …" is in their places until they are set again.
    void awaitSpreads();
    /// "± 0.2" of a cell, "+ 0.1 − 0.3" where its sides differ, as shown; empty where it has
    /// none.
    QString spreadAt(int row, int column) const;

    /// Beside the first, this column fills the room.
    void stretchColumn(int column);
    /// Its maximum height is that many rows; further ones scroll.
    void setShownRows(int rows);

    QString asText() const;  ///< the whole table, tab-separated
    QString asCsv() const;   ///< the whole table, comma-separated, quoted where needed
    /// A line above tables as text or CSV; nothing without a text.
    static QString lineAbove(const QString& text, bool asCsv);
    /// Buttons of a dialog that copy the whole table, as text and as CSV.
    void addCopyButtons(QDialogButtonBox* buttons) const;

    /// The page around a table that is higher follows its current row.
    void scrollTo(const QModelIndex& index, ScrollHint hint = EnsureVisible) override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    static int plainRowHeight();  ///< without the lines below the numbers

  protected:
    /// Above what a user copies of the table; may be empty.
    virtual QString warning() const { return {}; }
    void paintEvent(QPaintEvent* event) override;
    /// The frame of the focus does not scroll.
    void scrollContentsBy(int across, int down) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    /// How little room the columns have: differences in one line under one-line headings, the same
    /// under headings that wrap, or absolute and percent below one another.
    enum class Room { Plenty, Headings, Little };

    QString joined(QChar separator, bool selectionOnly) const;
    void copy(bool selectionOnly) const;
    void fitColumns();
    int wantedWidth(int column) const;
    /// Those given, with differences and ±.
    void showRows();
    /// The texts below a cell, line by line.
    QStringList below(int row, int column) const;
    void fitRows();
    QString tipOf(int row, int column) const;

    friend class ResultDelegate;
    friend class ResultItem;

    WrappedHeader* header_;
    Room room_ = Room::Plenty;
    int fittedTo_ = -1;  ///< width that the columns were fitted to; there they only ever grow
    QList<int> stretched_{0};
    int shownRows_ = 0;  ///< 0: all
    ResultColumns headings_;
    ResultRows given_;
    ResultRows rows_;                      ///< as shown
    std::optional<ResultRows> reference_;  ///< of results, not of a table
    QString referenceName_;
    std::vector<CellSpread> spreads_;
    QString spreadTip_;
    bool areSpreadsAwaited_ = false;
    bool hasDifferences_ = false;  ///< in its cells
};

}  // namespace ravnoves

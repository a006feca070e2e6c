#pragma once

#include <QStringList>
#include <QTableWidget>
#include <QVector>
#include <optional>
#include <utility>
#include <vector>

#include "text/result_row.h"
#include "widgets/whole_rows.h"

class QDialogButtonBox;

namespace ravnoves {

class WrappedHeader;

/// A read-only table of results whose selection, or whole, is copied as text (tabs, for a
/// spreadsheet) or CSV. Where it has too little room its headings go on a second line, then it
/// scrolls from one whole column to the next; no row is
/// shown in part.
class ResultTable : public WithWholeRows<QTableWidget> {
    Q_OBJECT

  public:
    explicit ResultTable(QWidget* parent = nullptr);
    /// @param name  what it shows, for screen readers
    ResultTable(const QString& name, QWidget* parent) : ResultTable(parent) {
        setAccessibleName(name);
    }
    ~ResultTable() override;

    /// Sets headings once; rows follow with setRows().
    void setColumns(const ResultColumns& columns);
    /// Replaces the cells; only what differs is touched, so it may be called at every step of a
    /// slider. Every cell says what its row and its column mean.
    void setRows(const ResultRows& rows);
    /// Both.
    void setResults(const Results& results);
    /// The same; there is no table where there are no rows.
    void setOrHide(const Results& results);
    /// Null where the cell holds no number, or two.
    const ResultNumber* numberAt(int row, int column) const;
    void setCellToolTip(int row, int column, const QString& text);
    /// Shows beside its numbers how they differ from those that the same table of a page with
    /// another input has, row by row's name: absolute and in percent, in columns of their own where
    /// it has one column of numbers and the room, else below each number. It follows that table.
    /// Null removes them.
    void setReference(ResultTable* table, const QString& name);
    const ResultTable* reference() const { return reference_; }
    /// Absolute and percent of a cell, as shown; empty where there is nothing to compare.
    QStringList differenceAt(int row, int column) const;
    /// What scatter of the inputs makes of a cell.
    struct Spread {
        int row = 0;
        int column = 0;
        QString name;        ///< of the row, which is elsewhere where that is another
        double below = 0.0;  ///< from 5 % to the number, in the unit of the cell
        double above = 0.0;  ///< from the number to 95 %
    };
    /// Shows them beside the numbers, where differences stand. None removes them.
    /// @param how  they were found: the tip of their heading
    void setSpreads(std::vector<Spread> spreads, const QString& how = {});
    /// The numbers are others now: "± …" stands in their places until they are set again.
    void awaitSpreads();
    /// "± 0.2" of a cell, "+ 0.1 − 0.3" where its sides differ, as shown; empty where it has
    /// none.
    QString spreadAt(int row, int column) const;
    /// Differences and ± have columns of their own.
    bool hasColumnsBeside() const { return columnCount() > columns_; }
    /// Tables made later have a greater number.
    int number() const { return number_; }

    /// Besides the first, this column takes what room there is.
    void stretchColumn(int column);
    /// It asks for no more height than so many rows need; further ones scroll.
    void setShownRows(int rows);

    QString asText() const;  ///< the whole table, tab-separated
    QString asCsv() const;   ///< the whole table, comma-separated, quoted where needed
    /// Buttons of a dialog that copy the whole table, as text and as CSV.
    void addCopyButtons(QDialogButtonBox* buttons) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    static int plainRowHeight();  ///< without what stands below the numbers

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    /// Where differences and ± stand: in columns, or below the numbers in one line, in one for each
    /// of the two, or in three, which words beside them have too.
    enum class Place { Columns, Line, Pair, Lines, Words };
    /// So many parts are in the first line below a number.
    static int joinedIn(Place place);

    QString joined(QChar separator, bool selectionOnly) const;
    bool hasSelection() const;
    void copySelection();
    void fitColumns();
    /// What the columns of numbers need: column, width.
    QList<std::pair<int, int>> neededWidths() const;
    /// Wraps the headings where they do not fit beside the names.
    void wrapHeadings();
    /// Whether the columns of words are as wide as they want to be.
    bool hasRoomForWords() const;
    /// Where it scrolled sideways else.
    void setSmall(bool isSmall);
    int headingWidth(int column) const;
    int padding() const;
    /// Words never give way to numbers altogether: the table scrolls sideways instead.
    void fitStretched();
    void showDifferences();
    void showSpreads();
    /// Differences and ±.
    void placeBeside();
    /// What stands beside a cell.
    QStringList besideAt(int row, int column) const;
    int rowInReference(int row) const;
    /// Of a cell with its difference where that stands so.
    int widthOf(int row, int column, Place place) const;
    int roomFor(Place place) const;
    int heightOf(int rowHeight) const;

    void showTips();

    bool tipsRest_ = false;  ///< every cell has that of its row and heading
    WrappedHeader* header_;
    bool small_ = false;  ///< its text, at the width `wrapsAt_`
    bool wraps_ = false;  ///< headings, at the width `wrapsAt_`
    int wrapsAt_ = -1;
    QList<int> stretched_{0};
    bool isOver_ = false;  ///< wider than its room
    int shownRows_ = 0;    ///< 0: all
    bool fitted_ = false;
    /// What a fit of the columns looks at, beside the texts.
    struct Layout {
        QSize room;
        QSize whole;
        int height = 0;
        int hidden = 0;
        bool hasNoHeadings = false;
        bool wraps = false;
        bool isSmall = false;
        bool isOver = false;
        QList<int> widths;

        bool operator==(const Layout&) const = default;
    };
    Layout laidOut() const;
    std::optional<Layout> rests_;  ///< at which the last fit changed nothing
    ResultColumns headings_;
    ResultRows rows_;
    int columns_ = 0;  ///< without those of the differences
    ResultTable* reference_ = nullptr;
    ResultTable* referenceOf_ = nullptr;  ///< the table that compares itself with this one
    QString referenceName_;
    std::vector<Spread> spreads_;
    QString spreadTip_;
    bool areSpreadsAwaited_ = false;
    QList<int> compared_;  ///< columns with differences
    QList<int> spread_;    ///< columns with ±
    Place place_ = Place::Columns;
    Place leastPlace_ = Place::Columns;  ///< at the width `placedAt_`
    int placedAt_ = -1;
    int number_;
};

}  // namespace ravnoves

#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <QStringList>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "case-file/json_fwd.h"

namespace ravnoves {

class SceneModel;

/// What an empty line in the middle of a block is.
enum class EmptyLine {
    nothing,  ///< it is passed over
    gap       ///< an empty row
};

/// Rows of cells as a spreadsheet puts them on the clipboard: tabs or semicolons between the cells.
/// Empty lines are passed over, those at the end always, and a first line without any number where
/// more lines follow: it is a header.
std::vector<QStringList> readTextTable(const QString& text, EmptyLine empty = EmptyLine::nothing);

/// Why a block of cells is not taken where some have a decimal point and others what may be a comma
/// between thousands: "1,893" beside 60.30 is 1893 to who wrote it. Else empty.
QString mixedDecimalSigns(const std::vector<QStringList>& cells);

/// The faults in the cells of a table, as text: the first few, and the number of the others.
QString saidTroubles(const QStringList& lines);

/// A table of numbers that is edited in place. A rejected text remains in its cell, in red, until
/// it is corrected or the case changes there; the case keeps its previous value.
class EditableTable : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    /// True for a cell with a rejected text; the editor colours it.
    static constexpr int TroubleRole = Qt::UserRole + 1;

    /// A new row below a row; below the last one for −1. Tables of fixed length have none.
    /// @return the new row; −1: none
    virtual int insertRowBelow(int /*row*/) { return -1; }
    virtual void removeRowRange(int /*first*/, int /*count*/) {}
    /// The columns of a block that have something in them, from its first.
    static int widthOf(const std::vector<QStringList>& cells);
    /// Why a block does not fit into these rows or columns; empty where it does.
    static QString noRoomText(const std::vector<QStringList>& cells, int rows, int columns);
    /// pasteBlock(), unless mixedDecimalSigns().
    QString paste(int row, int column, const std::vector<QStringList>& cells);
    /// Writes a block of cells at a cell, as a spreadsheet does.
    /// @return an empty string, or the fault
    virtual QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) = 0;
    /// Takes back the rejected text of a cell; where the table is rejected as a whole, the latest.
    virtual void takeBackRejected(const QModelIndex& at);
    /// The model has another state as a whole: nothing is rejected any more.
    void forgetRejected();
    /// The model of the cells' case.
    virtual SceneModel* scene() const = 0;

    Qt::ItemFlags flags(const QModelIndex& index) const override;

  Q_SIGNALS:
    /// Why a change was rejected, as text; empty after one was taken.
    void troubleChanged(const QString& trouble);

  protected:
    using Cell = std::pair<std::string, int>;  ///< name of the row, and column
    struct Rejected {
        QString text;
        QString why;
        QString below;
    };

    /// What a row is called while others come and go.
    virtual std::string rowName(int row) const = 0;
    /// The case's value of a cell: a change of this value clears the rejected text.
    virtual QString held(int /*row*/, int /*column*/) const { return {}; }
    /// The rejected text of a cell, with the cell's name.
    virtual QString rejectedText(const Cell& /*cell*/, const Rejected& rejected) const {
        return rejected.why;
    }
    /// The same of the first cells, row by row, a line for each.
    QString trouble() const;

    const std::map<Cell, Rejected>& rejected() const { return rejected_; }
    /// Those cells, row by row.
    std::vector<Cell> rejectedCells() const;
    /// A text that was typed into a cell. @param why  it is rejected; empty where it is taken
    void setRejected(int row, int column, const QString& text, const QString& why);
    /// A block of cells was taken: nothing in it is rejected any more.
    void setTaken(int row, int column, const std::vector<QStringList>& cells);
    /// What a rejected cell shows, and whether it is one; invalid for all else.
    QVariant rejectedData(const QModelIndex& at, int role) const;
    /// Shows the present case.
    void follow();

  private:
    std::map<Cell, Rejected> rejected_;
    int rows_ = 0;
    int columns_ = 0;
};

}  // namespace ravnoves

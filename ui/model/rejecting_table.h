#pragma once

#include <map>
#include <string>
#include <utility>

#include "model/editable_table.h"

namespace ravnoves {

/// A table in which a rejected text remains in its cell, in red, until it is corrected or the case
/// changes there; the case keeps its previous value.
class RejectingTable : public EditableTable {
    Q_OBJECT

  public:
    using EditableTable::EditableTable;

    void takeBackRejected(const QModelIndex& at) override;
    void forgetRejected() override;

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

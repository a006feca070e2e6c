#pragma once

#include <QString>
#include <set>

#include "balance-shaft/torque_table.h"
#include "model/editable_table.h"

namespace ravnoves {

/// The torque table while it is being edited.
///
/// Cells hold what was typed, valid or not, so nothing is lost; checkedTable() is the table where
/// it is a cycle, trouble() says why where it is not. The first and the last row are one instant of
/// the cycle: a torque typed in one goes to the other.
class TorqueTableModel : public EditableTable {
    Q_OBJECT

  public:
    enum Column { CrankAngle = 0, Torque = 1 };

    using EditableTable::EditableTable;

    /// Takes over a valid table; nothing is emitted but the reset.
    void setTable(const balance_shaft::TorqueTable& table);
    const balance_shaft::TorqueTable& checkedTable() const { return valid_; }
    /// Why the cells are not a cycle; empty where they are.
    QString trouble() const { return trouble_; }

    void insertRowBelow(int row) override;
    void removeRowRange(int first, int count) override;
    /// Replaces the whole table by text from a CSV file, in N·m, or from a spreadsheet, in the unit
    /// that the column shows where the text names none.
    /// @return what was read, as a sentence; throws InputError and changes nothing
    QString replaceByText(const QString& text, bool isShown = false);
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  Q_SIGNALS:
    /// The cells are a cycle that differs from the one before.
    void tableEdited();

  private:
    struct Row {
        QString angle;
        QString torque;
        QString ownText = {};  ///< what stands for `own`, until something else is typed
        double own = 0.0;      ///< N·m
    };

    void check();

    std::vector<Row> rows_;
    balance_shaft::TorqueTable valid_;
    QString trouble_;
    int badRow_ = -1;
};

}  // namespace ravnoves

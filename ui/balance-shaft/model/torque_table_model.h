#pragma once

#include <QString>
#include <map>
#include <string>
#include <utility>

#include "balance-shaft/torque_table.h"
#include "model/editable_table.h"

namespace ravnoves {

class BalanceShaftModel;

/// The torque table of a case. A text that makes it no cycle remains rejected in its cell, and is
/// tried again with each other one. The first and the last row are one instant of the cycle: a
/// torque typed in one is put into the other.
class TorqueTableModel final : public EditableTable {
    Q_OBJECT

  public:
    enum Column { CrankAngle = 0, Torque = 1 };

    explicit TorqueTableModel(BalanceShaftModel* model, QObject* parent = nullptr);

    using EditableTable::trouble;
    int insertRowBelow(int row) override;
    void removeRowRange(int first, int count) override;
    /// Replaces the whole table by text from a spreadsheet, in the column's unit unless the text
    /// names another.
    /// @return a sentence on the rows read; throws InputError and changes nothing
    QString replaceByText(const std::string& text);
    /// That the table last put in made the engine another; empty where it did not.
    const QString& strokesNote() const { return strokesNote_; }
    /// Replaces the whole table by another.
    void replaceBy(const balance_shaft::TorqueTable& table);
    SceneModel* scene() const override;
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  protected:
    std::string rowName(int row) const override;
    QString held(int row, int column) const override;
    QString rejectedText(const Cell& cell, const Rejected& rejected) const override;

  private:
    using Place = std::pair<int, int>;  ///< row and column
    using Texts = std::map<Place, QString>;

    const balance_shaft::TorqueTable& table() const;
    int rowOf(const Cell& cell) const;
    /// The case's value, with all digits.
    QString ownText(const Place& place) const;
    /// Accepts the typed texts as long as the table is a cycle; the rest is rejected in its cells.
    void put(Texts texts);
    QString take(const balance_shaft::TorqueTable& table);

    BalanceShaftModel* model_;
    QString strokesNote_;
};

}  // namespace ravnoves

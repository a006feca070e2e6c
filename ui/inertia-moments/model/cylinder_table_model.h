#pragma once

#include <map>
#include <utility>

#include "model/editable_table.h"

namespace ravnoves {

class InertiaMomentsModel;

/// The cylinders as a table to edit: axial position, bank angle, offset, crankpin angle. Editing a
/// cell of a layout turns it into a table of its own.
class CylinderTableModel final : public EditableTable {
    Q_OBJECT

  public:
    enum Column { Position, BankAngle, Offset, CrankpinAngle, Columns };

    explicit CylinderTableModel(InertiaMomentsModel* model, QObject* parent = nullptr);

    /// A copy of the row below it.
    void insertRowBelow(int row) override;
    void removeRowRange(int first, int count) override;
    /// Rows that are missing are added.
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    /// A text that is no value for its cell: it stays, in red, while the value below it holds.
    struct Refused {
        QString text;
        double below;
    };

    void refresh();
    double valueAt(int row, int column) const;

    InertiaMomentsModel* model_;
    int rows_ = 0;
    std::map<std::pair<int, int>, Refused> refused_;  ///< by row and column
};

}  // namespace ravnoves

#pragma once

#include "case-file/field.h"
#include "model/editable_table.h"

namespace ravnoves {

class WorkshopModel;

/// The weigh-in sheet as a table: a column for each kind of part, a row for each cylinder; above
/// them rows for the nominal mass and for the permitted spread. A cell is a number in the unit of
/// its field, or nothing.
class WeighInTable final : public EditableTable {
    Q_OBJECT

  public:
    /// Name of a cell among the page's fields: "nominal_pin", "mass_piston_3".
    static constexpr int KeyRole = TroubleRole + 1;
    /// The row of the first cylinder.
    static constexpr int firstCylinder = 2;

    explicit WeighInTable(WorkshopModel* model, QObject* parent = nullptr);

    /// What is described once for all cells of a row.
    static const Field& fieldOf(int row);

    /// The cell of a row that may not be there yet, for its names.
    QModelIndex createdIndex(int row, int column) const { return createIndex(row, column); }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& cell, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// An invalid value empties the cell.
    bool setData(const QModelIndex& cell, const QVariant& value, int role = Qt::EditRole) override;
    /// One step; a cell without text leaves what is there, and where one is rejected nothing is
    /// written.
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;

  private:
    int cylinders() const;

    WorkshopModel* model_;
};

}  // namespace ravnoves

#pragma once

#include "case-file/field.h"
#include "model/editable_table.h"
#include "v8-plugs/weigh_in.h"

namespace ravnoves {

class V8PlugsModel;

/// The weigh-in sheet as a table: a column for each kind of part; rows for its nominal mass, for
/// the permitted spread and for each cylinder. A cell is a number in the unit of its field, or
/// nothing.
class WeighInTable final : public EditableTable {
    Q_OBJECT

  public:
    static constexpr int firstCylinder = 2;
    static constexpr int rows = firstCylinder + v8_plugs::cylinder_count;
    /// Name of a cell among the page's fields: "nominal_pin", "mass_piston_3".
    static constexpr int KeyRole = TroubleRole + 1;

    explicit WeighInTable(V8PlugsModel* model, QObject* parent = nullptr);

    /// What is described once for all cells of a row.
    static const Field& fieldOf(int row);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& cell, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// An invalid value empties the cell.
    bool setData(const QModelIndex& cell, const QVariant& value, int role = Qt::EditRole) override;
    /// One step; a cell without text leaves what is there, and where one is refused nothing is
    /// written.
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;

  private:
    QString partOf(int column) const;

    V8PlugsModel* model_;
};

}  // namespace ravnoves

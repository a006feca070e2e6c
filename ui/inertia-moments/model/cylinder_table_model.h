#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "model/editable_table.h"

namespace ravnoves {

class InertiaMomentsModel;

/// The cylinders as a table to edit: axial position, bank angle, offset, crankpin angle, and where
/// rods are articulated their knuckle pins, lengths and masters. Editing a cell of a layout turns
/// it into a table of its own. A knuckle radius makes a rod articulated, an empty one puts it back
/// on the crankpin; what else is empty follows from the other values and is shown in italics. So
/// are, where rods are articulated, top dead centres and strokes.
class CylinderTableModel final : public EditableTable {
    Q_OBJECT

  public:
    enum Column {
        Position,
        BankAngle,
        Offset,
        CrankpinAngle,
        KnuckleRadius,  ///< this and the next only where rods are articulated
        KnuckleAngle,
        RodLength,
        Master,
        KnuckleMass,
        TopDeadCentre,  ///< this and the next only to read
        Stroke,
        Columns
    };

    explicit CylinderTableModel(InertiaMomentsModel* model, QObject* parent = nullptr);

    /// Shows the fault of the last change, beside the rejected texts of cells.
    void say(const QString& why);

    /// A copy of the row below it.
    int insertRowBelow(int row) override;
    void removeRowRange(int first, int count) override;
    /// Rows that are missing are added.
    void takeBackRejected(const QModelIndex& at) override;
    SceneModel* scene() const override;
    QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) override;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// Only the knuckle radius makes a rod articulated.
    Qt::ItemFlags flags(const QModelIndex& index) const override;

  private:
    /// Where rows come or go, none has its old name.
    std::string rowName(int row) const override;
    QString held(int row, int column) const override;
    /// In the unit; empty where the cell has none.
    std::optional<double> valueAt(int row, int column) const;
    /// True where the value is not given but follows from others.
    bool isUsual(int row, int column) const;

    InertiaMomentsModel* model_;
    mutable std::vector<std::pair<double, double>> strokes_;  ///< dead centre, ° and stroke, mm
};

}  // namespace ravnoves

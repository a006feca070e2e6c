#pragma once

#include <QAbstractTableModel>

namespace ravnoves {

class InertiaMomentsModel;

/// The cylinders as a table to edit: axial position, bank angle, offset, crankpin angle. Editing a
/// cell of a layout turns it into a table of its own.
class CylinderTableModel final : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column { Position, BankAngle, Offset, CrankpinAngle, Columns };

    explicit CylinderTableModel(InertiaMomentsModel* model, QObject* parent = nullptr);

    /// A copy of a row below it (a new last cylinder for an empty selection).
    void insertBelow(int row);
    void removeRowRange(int first, int count);
    /// Writes a block of cells (tabs or semicolons between columns, one line a row) at a cell, as a
    /// spreadsheet does; rows that are missing are added.
    /// @return an empty string, or what is wrong
    QString pasteBlock(int row, int column, const QString& text);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

  Q_SIGNALS:
    /// Why a cell was refused; empty after one was taken.
    void troubleChanged(const QString& trouble);

  private:
    void refresh();

    InertiaMomentsModel* model_;
    int rows_ = 0;
};

}  // namespace ravnoves

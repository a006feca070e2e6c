#pragma once

#include <QCoreApplication>
#include <QStringList>
#include <optional>
#include <vector>

#include "case-file/field.h"
#include "shop/weigh_in.h"

namespace ravnoves {

class WorkshopModel;

/// The weigh-in sheet as cells: a column for each kind of part, a row for each cylinder; above them
/// rows for the nominal mass and for the permitted spread. A cell is a mass in kg, or nothing.
class WeighInTable {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::WeighInTable)

  public:
    static constexpr int firstCylinder = 2;  ///< its row
    static constexpr int columns = static_cast<int>(shop::all_parts.size());

    explicit WeighInTable(WorkshopModel* model) : model_(model) {}

    int rows() const;
    /// The description common to all cells of a row.
    static const Field& fieldOf(int row);
    static QString titleOf(int row);
    static QString partOf(int column);
    /// The same with whose it is, as sheet 2 has it.
    static QString headingOf(int column);
    /// Of a cell among the page's fields: "nominal_pin", "mass_piston_3".
    static QString keyOf(int row, int column);
    /// Of a cell for screen readers.
    static QString nameOf(int row, int column);
    static QString hintOf(int row, int column);

    std::optional<double> mass(int row, int column) const;
    void setMass(int row, int column, std::optional<double> mass);
    /// Writes a block of cells, as a spreadsheet does, in one step; a cell without text keeps its
    /// value, and one rejected cell rejects the block.
    /// @return an empty string, or the fault
    QString paste(int row, int column, const std::vector<QStringList>& cells);

  private:
    WorkshopModel* model_;
};

}  // namespace ravnoves

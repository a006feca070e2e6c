#pragma once

#include <vector>

#include "v8-plugs/model/weigh_in_table.h"
#include "workshop/matching_sheet.h"

namespace ravnoves {

class ResultTable;

/// Sheet 3, the weigh-in: a column for each kind of part, a row for each cylinder, nominal mass and
/// permitted spread above, mean and spread below; then what may move, what the parts make of the
/// crankpins, and the best placing. The order of the fields goes down the columns, as one weighs; a
/// block of a spreadsheet is pasted from the cell that has the focus.
class WeighInSheet : public MatchingSheet {
    Q_OBJECT

  public:
    explicit WeighInSheet(V8PlugsModel* model, QWidget* parent = nullptr);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void buildGrid();
    void addColumn(QGridLayout* grid, int column);
    NumberField* addCell(int row, int column);
    void buildFindings();
    /// The keys of a cell: a block is pasted, the arrows go up and down. @return true for such a
    /// key
    bool useKey(const QKeyEvent& key, const QModelIndex& cell);
    Findings findings() const;

    V8PlugsModel* model_;
    WeighInTable* table_;
    std::vector<NumberField*> cells_;  ///< column by column
    TroubleLine* trouble_;
    ResultTable* crankpins_;
};

}  // namespace ravnoves

#pragma once

#include <vector>

#include "v8-plugs/model/weigh_in_table.h"
#include "v8-plugs/v8_sheet.h"

class QGridLayout;
class QPushButton;

namespace ravnoves {

class ResultTable;

/// Sheet 3, the weigh-in: a column for each kind of part, a row for each cylinder, nominal mass and
/// permitted spread above, mean and spread below; then what the parts make of the crankpins and the
/// best assignment. The order of the fields goes down the columns, as one weighs; a block of a
/// spreadsheet is pasted from the cell that has the focus.
class WeighInSheet : public V8Sheet {
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
    void showFindings();

    WeighInTable* table_;
    std::vector<NumberField*> cells_;  ///< column by column
    TroubleLine* trouble_;
    QLabel* summary_;
    QPushButton* move_;
    ResultTable* assignment_;
    ResultTable* crankpins_;
};

}  // namespace ravnoves

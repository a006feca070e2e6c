#pragma once

#include <array>
#include <vector>

#include "v8-plugs/sheet_form.h"
#include "v8-plugs/weigh_in.h"

class QCheckBox;
class QPushButton;

namespace ravnoves {

class ResultTable;

/// Sheet 3, the weigh-in: a column for each kind of part, a row for each cylinder, nominal mass and
/// permitted spread above, mean and spread below; then what the parts make of the crankpins and the
/// best assignment. The order of the fields goes down the columns, as one weighs; a block of a
/// spreadsheet is pasted from the cell that has the focus.
class WeighInSheet : public SheetForm {
    Q_OBJECT

  public:
    explicit WeighInSheet(V8PlugsModel* model, QWidget* parent = nullptr);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// Rows of a column that are typed: nominal mass, permitted spread, the cylinders.
    static constexpr int firstCylinder = 2;
    static constexpr int rowCount = firstCylinder + v8_plugs::cylinder_count;
    struct Column {
        std::array<NumberField*, rowCount> cells;
        QLabel* mean;
        QLabel* deviation;  ///< of the mean from nominal
        QLabel* spread;
    };

    void buildGrid();
    NumberField* addCell(v8_plugs::Part part, int row);
    void buildFindings();
    /// Writes a block of text into the cells from one on; a row of headings above it is passed
    /// over. All of it is one step, and nothing is written where part of it is refused.
    void pasteBlock(const QString& text, int column, int row);
    /// The keys of a cell: a block is pasted, the arrows go up and down. @return true for such a
    /// key
    bool useKey(const QKeyEvent& key, std::size_t column, std::size_t row);
    void showInput();

    std::vector<Column> columns_;
    QCheckBox* use_;
    TroubleLine* trouble_;
    QLabel* summary_;
    QPushButton* move_;
    ResultTable* assignment_;
    ResultTable* crankpins_;
};

}  // namespace ravnoves

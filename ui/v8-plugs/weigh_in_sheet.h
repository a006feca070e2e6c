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
/// best assignment. The order of the fields goes down the columns, as one weighs.
class WeighInSheet : public SheetForm {
    Q_OBJECT

  public:
    explicit WeighInSheet(V8PlugsModel* model, QWidget* parent = nullptr);

  private:
    struct Column {
        NumberField* nominal;
        NumberField* permitted;
        std::array<NumberField*, v8_plugs::cylinder_count> mass;
        QLabel* mean;
        QLabel* deviation;  ///< of the mean from nominal
        QLabel* spread;
    };

    NumberField* addField(const QString& name, const QString& accessible, const FieldSpec& spec,
                          const QString& hint);
    void showInput();

    std::vector<Column> columns_;
    QCheckBox* use_;
    QComboBox* numbering_;
    QLabel* trouble_;
    QLabel* summary_;
    QPushButton* move_;
    ResultTable* assignment_;
    ResultTable* crankpins_;
};

}  // namespace ravnoves

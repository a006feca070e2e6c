#pragma once

#include <QWidget>
#include <vector>

class QVBoxLayout;

namespace ravnoves {

class Form;
class InertiaMomentsModel;

/// One balance shaft of the list: switch, order, direction, task, sizes, error of phase.
class ShaftRow;

/// The list of balance shafts.
class ShaftEditor : public QWidget {
    Q_OBJECT

  public:
    /// @param form  its rows are bound to the input there
    ShaftEditor(InertiaMomentsModel* model, Form* form);

    int rowCount() const { return static_cast<int>(rows_.size()); }

  private:
    void refresh();

    InertiaMomentsModel* model_;
    Form* form_;
    QVBoxLayout* list_;
    std::vector<ShaftRow*> rows_;
};

}  // namespace ravnoves

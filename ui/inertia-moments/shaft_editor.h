#pragma once

#include <QWidget>
#include <vector>

class QVBoxLayout;

namespace ravnoves {

class InertiaMomentsModel;

/// One balance shaft of the list: switch, order, direction, task, sizes, error of phase.
class ShaftRow;

/// The list of balance shafts.
class ShaftEditor : public QWidget {
    Q_OBJECT

  public:
    explicit ShaftEditor(InertiaMomentsModel* model, QWidget* parent = nullptr);

    int rowCount() const { return static_cast<int>(rows_.size()); }

  private:
    void refresh();

    InertiaMomentsModel* model_;
    QVBoxLayout* list_;
    std::vector<ShaftRow*> rows_;
};

}  // namespace ravnoves

#pragma once

#include "widgets/table_editor.h"

class QPushButton;

namespace ravnoves {

class CylinderTableModel;
class InertiaMomentsViewModel;

/// The cylinder table with its tools: edit, add, remove, copy, paste, even firing.
class CylinderEditor : public TableEditor {
    Q_OBJECT

  public:
    explicit CylinderEditor(InertiaMomentsViewModel* model, QWidget* parent = nullptr)
        : CylinderEditor(model, newTable(model), parent) {}

    CylinderTableModel* tableModel() const { return table_; }

  private:
    CylinderEditor(InertiaMomentsViewModel* model, CylinderTableModel* table, QWidget* parent);
    static CylinderTableModel* newTable(InertiaMomentsViewModel* model);
    void showState();

    InertiaMomentsViewModel* model_;
    CylinderTableModel* table_;
    QPushButton* evenFiring_;
};

}  // namespace ravnoves

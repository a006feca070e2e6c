#pragma once

#include "widgets/table_editor.h"

class QCheckBox;
class QPushButton;

namespace ravnoves {

class CylinderTableModel;
class InertiaMomentsModel;

/// The cylinder table, with even firing and articulated rods beside its tools.
class CylinderEditor : public TableEditor {
    Q_OBJECT

  public:
    explicit CylinderEditor(InertiaMomentsModel* model, QWidget* parent = nullptr);

  private:
    void showState();

    InertiaMomentsModel* model_;
    CylinderTableModel* table_;
    QPushButton* evenFiring_;
    QCheckBox* articulated_;
};

}  // namespace ravnoves

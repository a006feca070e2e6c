#pragma once

#include "widgets/table_editor.h"

namespace ravnoves {

class BalanceShaftModel;
class TorqueTableModel;

/// The torque table with its tools: edit, insert, delete, paste, import and export.
class TorqueTableEditor : public TableEditor {
    Q_OBJECT

  public:
    explicit TorqueTableEditor(BalanceShaftModel* model, QWidget* parent = nullptr);

    /// Opens the import window for a file, which replaces the whole table.
    void importFile(const QString& path);
    void importWithDialog();
    /// A whole cycle replaces the table; anything smaller is put into the cells from the current
    /// one.
    void paste() override;

  private:
    BalanceShaftModel* model_;
    TorqueTableModel* table_;
};

}  // namespace ravnoves

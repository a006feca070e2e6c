#pragma once

#include <optional>

#include "widgets/table_editor.h"

class QComboBox;
class QPushButton;
class QStackedWidget;

namespace ravnoves {

class BalanceShaftModel;
class Form;
class TorqueTableModel;
class TroubleLine;

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

/// The source of the engine torque: a table, a measured pressure trace, or a computed cycle, each
/// with its own form. Switching keeps the other sources.
class TorqueSourceEditor : public QWidget {
    Q_OBJECT

  public:
    explicit TorqueSourceEditor(BalanceShaftModel* model, QWidget* parent = nullptr);

    /// Opens the import window for a file with a pressure trace.
    void importTrace(const QString& path);
    /// Puts the inertia torque of masses and speed in the place of the table's.
    static QPushButton* rebuildButton(BalanceShaftModel* model, const QString& name,
                                      QWidget* parent);

  private:
    QWidget* buildPressure();
    QWidget* buildCycle();
    void showInput();
    QWidget* buildCheck();
    QWidget* buildNoTable();
    void showForm(int page);
    /// Whether a source has nothing to give yet.
    bool isEmpty(int page) const;

    BalanceShaftModel* model_;
    /// A source that was chosen and is empty: it is shown until another gives the torque.
    std::optional<int> awaited_;
    int given_ = -1;  ///< the page of the one that gives it
    QComboBox* choice_ = nullptr;
    QStackedWidget* forms_ = nullptr;
    TorqueTableEditor* table_ = nullptr;
    QLabel* trace_ = nullptr;  ///< the file that the trace is of
    TroubleLine* trouble_ = nullptr;
    QWidget* noTable_ = nullptr;
    TroubleLine* noTrace_ = nullptr;  ///< whose results they are, until there is a trace
};

}  // namespace ravnoves

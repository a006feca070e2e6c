#pragma once

#include <QWidget>
#include <functional>

#include "model/editable_table.h"

class QHBoxLayout;
class QLabel;
class QTableView;
class QToolButton;

namespace ravnoves {

class TroubleLine;

/// A table with its tools: edit, copy, paste, add and remove rows; above it a caption, below it the
/// faults.
class TableEditor : public QWidget {
    Q_OBJECT

  public:
    /// @param name  of the table for screen readers
    /// @param addTip, removeTip  what the tools for rows do
    TableEditor(EditableTable* table, const QString& name, const QString& addTip,
                const QString& removeTip, QWidget* parent = nullptr);

    QTableView* view() const { return view_; }
    /// Copies the selected cells, or all where none are.
    void copy() const;
    /// Writes the clipboard at the current cell.
    virtual void paste();
    /// Below the table.
    void say(const QString& text, bool isTrouble);
    EditableTable* table() const { return table_; }
    /// The rejected texts, as text; empty without any.
    QString trouble() const { return trouble_; }
    /// Undo and Escape are the table's while its present cell is rejected, else the document's.
    bool takeBackRejected();
    /// Makes the first rejected cell the current one.
    void showRejected();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

    /// A tool after the others.
    QToolButton* addTool(const QString& icon, const QString& tip, std::function<void()> use);
    /// The row of tools; its end is at the right.
    QHBoxLayout* tools() const { return tools_; }
    QLabel* caption() const { return caption_; }
    /// Pastes; says where memory does not suffice.
    void tryPaste();

  private:
    void removeSelected();

    EditableTable* table_;
    QString trouble_;
    QHBoxLayout* tools_;
    QTableView* view_;
    QLabel* caption_;
    TroubleLine* message_;
    int toolCount_ = 0;
};

}  // namespace ravnoves

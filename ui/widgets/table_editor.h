#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QTableView;
class QToolButton;

namespace ravnoves {

/// Rows of cells as a spreadsheet puts them on the clipboard: tabs or semicolons between the cells.
/// Empty lines are passed over, and a first line without any number where more lines follow: it is
/// a header.
std::vector<QStringList> readTextTable(const QString& text);

/// A table of numbers that is edited in place.
class EditableTable : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    /// A new row below a row; below the last one for −1.
    virtual void insertRowBelow(int row) = 0;
    virtual void removeRowRange(int first, int count) = 0;
    /// Writes a block of cells at a cell, as a spreadsheet does.
    /// @return an empty string, or what is wrong
    virtual QString pasteBlock(int row, int column, const std::vector<QStringList>& cells) = 0;

    Qt::ItemFlags flags(const QModelIndex& index) const override;

  Q_SIGNALS:
    /// Why a change was refused, in words; empty after one was taken.
    void troubleChanged(const QString& trouble);
};

/// A table with its tools: edit, copy, paste, add and remove rows; above it a caption, below it
/// what is wrong.
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

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

    /// A tool after the others.
    QToolButton* addTool(const QString& icon, const QString& tip, std::function<void()> use);
    /// The row of tools; its end is at the right.
    QHBoxLayout* tools() const { return tools_; }
    QLabel* caption() const { return caption_; }
    void say(const QString& text, bool isTrouble);

  private:
    void removeSelected();

    EditableTable* table_;
    QHBoxLayout* tools_;
    QTableView* view_;
    QLabel* caption_;
    QLabel* message_;
    int toolCount_ = 0;
};

}  // namespace ravnoves

#pragma once

#include <QWidget>

class QLabel;
class QTableView;

namespace ravnoves {

class BalanceShaftModel;
class TorqueTableModel;

/// The torque table with its tools: edit, insert, delete, paste, import and export.
class TorqueTableEditor : public QWidget {
    Q_OBJECT

  public:
    explicit TorqueTableEditor(BalanceShaftModel* model, QWidget* parent = nullptr);

    QTableView* view() const { return view_; }
    TorqueTableModel* tableModel() const { return table_; }
    /// Reads a CSV file over the whole table.
    /// @return an empty string, or what is wrong, with the file's name
    QString importFile(const QString& path);
    void paste();
    void copy();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void say(const QString& text, bool isTrouble);

    BalanceShaftModel* model_;
    TorqueTableModel* table_;
    QTableView* view_;
    QLabel* message_;
};

}  // namespace ravnoves

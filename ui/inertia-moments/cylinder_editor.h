#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QTableView;

namespace ravnoves {

class CylinderTableModel;
class InertiaMomentsModel;

/// The cylinder table with its tools: edit, add, remove, copy, paste, even firing.
class CylinderEditor : public QWidget {
    Q_OBJECT

  public:
    explicit CylinderEditor(InertiaMomentsModel* model, QWidget* parent = nullptr);

    QTableView* view() const { return view_; }
    CylinderTableModel* tableModel() const { return table_; }
    void copy();
    void paste();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void say(const QString& trouble);
    void showState();

    InertiaMomentsModel* model_;
    CylinderTableModel* table_;
    QTableView* view_;
    QLabel* state_;
    QLabel* message_;
    QPushButton* evenFiring_;
};

}  // namespace ravnoves

#pragma once

#include <QDialog>

class QLabel;

namespace ravnoves {

class ResultTable;
class ScenePage;
class SceneModel;

/// The inputs in which a page's present input and its reference differ, in a window of its own that
/// follows both.
class InputComparison : public QDialog {
    Q_OBJECT

  public:
    InputComparison(ScenePage* page, QWidget* parent);

    const ResultTable* table() const { return table_; }

  private:
    void showDifferences();

    SceneModel* model_;
    QLabel* title_;
    ResultTable* table_;
};

}  // namespace ravnoves

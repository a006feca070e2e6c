#pragma once

#include "methods/model/methods_model.h"
#include "page/scene_page.h"

class QComboBox;
class QLabel;
class QTabWidget;
class QToolButton;
class QVBoxLayout;

namespace ravnoves {

class CaseBudgetModel;
struct OpenCase;
class MethodPlots;
class ResultTable;
class ValidationView;
class ValueSlider;
class VerdictLine;

/// The page "Methods": how sure the open case is; of each kernel the charts of its methods, their
/// table and why the scene uses the one it uses; and the validation report.
class MethodsPage : public ScenePage {
    Q_OBJECT

  public:
    explicit MethodsPage(QWidget* parent = nullptr, SceneModel* kept = nullptr);

    SceneModel* model() override { return model_; }
    MethodsModel* viewModel() { return model_; }
    QList<QAction*> sceneActions() override { return {againAction_}; }
    QString resultsAsText() const override;
    QString resultsAsCsv() const override;
    void setActive(bool active) override;

    // For tests and for the frame benchmark.
    ResultTable* table() const { return table_; }
    CaseBudgetModel* budget() const { return budget_; }

  private:
    QWidget* buildChoice();
    QWidget* buildMeasuring();
    QWidget* buildWords();
    QWidget* buildResults();
    QWidget* buildCase();
    void updateActive();
    bool isInFront(const QWidget* view) const;
    /// Of all pages; nothing where no case is open.
    std::optional<OpenCase> caseLastInFront() const;
    void showBudget();
    void showKernel();
    void showSweep();
    void showValue();
    void showWords();
    void showTable();
    void showVerdict();
    void showRunning();
    void chooseRow();

    MethodsModel* model_;
    bool active_ = false;  ///< the page is in front
    QComboBox* kernels_ = nullptr;
    QComboBox* sweeps_ = nullptr;
    ValueSlider* value_ = nullptr;  ///< of the hard parameter that is chosen
    QVBoxLayout* valuePlace_ = nullptr;
    QLabel* words_ = nullptr;
    QTabWidget* tabs_ = nullptr;
    CaseBudgetModel* budget_ = nullptr;
    QWidget* case_ = nullptr;
    ResultTable* budgetTable_ = nullptr;
    QLabel* caseTitle_ = nullptr;
    QLabel* leftOut_ = nullptr;
    QWidget* charts_ = nullptr;
    QToolButton* details_ = nullptr;
    MethodPlots* plots_ = nullptr;
    ResultTable* table_ = nullptr;
    const methods::Kernel* tableOf_ = nullptr;  ///< the kernel in the table
    QLabel* limits_ = nullptr;
    ValidationView* validation_ = nullptr;
    VerdictLine* verdict_ = nullptr;
    QAction* againAction_ = nullptr;
};

}  // namespace ravnoves

#pragma once

#include "plot/plot_view.h"
#include "page/scene_page.h"
#include "widgets/field_slider.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTabWidget;

namespace ravnoves {

class BalanceShaftModel;
class MechanismView;
class Form;
class ResultTable;
class VerdictLine;
class CycleView;
class TorqueSourceEditor;
class TorqueTableEditor;

/// The balance-shaft page: inputs, α slider, plots over φ and over α, picture, results.
class BalanceShaftPage : public ScenePage {
    Q_OBJECT

  public:
    explicit BalanceShaftPage(QWidget* parent = nullptr, SceneModel* kept = nullptr);

    SceneModel* model() override;
    BalanceShaftModel* viewModel() { return model_; }
    QList<QAction*> sceneActions() override;
    QString resultsAsText() const override;
    QString resultsAsCsv() const override;

    // For tests and for the frame benchmark.
    FieldSlider* angleSlider() const { return angle_; }
    PlotView* momentPlot() const { return moments_; }
    PlotView* rangePlot() const { return range_; }
    PlotView* meanPlot() const { return means_; }
    MechanismView* picture() const { return picture_; }
    TorqueTableEditor* torqueEditor() const;
    TorqueSourceEditor* torqueSource() const { return source_; }
    QTabWidget* views() const { return views_; }

  private:
    QTabWidget* buildInputs();
    QWidget* buildPlots();
    QWidget* buildMoments();
    QWidget* buildAnswer();
    void addEngine(Form* form);
    void addMasses(Form* form);
    void showSweep();
    void showVerdict();
    void doVerdictAct();
    void showShaft();
    void showMeans();

    BalanceShaftModel* model_;
    TorqueSourceEditor* source_ = nullptr;
    QTabWidget* views_ = nullptr;
    CycleView* cycle_ = nullptr;
    FieldSlider* angle_ = nullptr;
    QComboBox* meansChoice_ = nullptr;
    PlotView* moments_ = nullptr;
    PlotView* range_ = nullptr;
    PlotView* means_ = nullptr;
    MechanismView* picture_ = nullptr;
    ResultTable* criteria_ = nullptr;
    ResultTable* quantities_ = nullptr;
    QLabel* bestRange_ = nullptr;
    QLabel* bestRms_ = nullptr;
    QPushButton* goRange_ = nullptr;
    QPushButton* goRms_ = nullptr;
    VerdictLine* verdict_ = nullptr;
    QLabel* notes_ = nullptr;
    QAction* playAction_ = nullptr;
    QAction* bestRangeAction_ = nullptr;
    QAction* bestRmsAction_ = nullptr;

    // Curves, by plot.
    int up_ = 0, s_ = 0, ups_ = 0;
    int rangeCurve_ = 0, rmsCurve_ = 0, meanSTrue_ = 0, meanSPrinted_ = 0;
    int mSTrue_ = 0, mSPrinted_ = 0, mUpsTrue_ = 0, mUpsPrinted_ = 0;
};

}  // namespace ravnoves

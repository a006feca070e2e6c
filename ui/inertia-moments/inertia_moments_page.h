#pragma once

#include <QVector>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "plot/plot_view.h"
#include "shell/scene_page.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTabWidget;
class QVBoxLayout;

namespace ravnoves {

class CounterweightView;
class CylinderEditor;
class EngineView;
class FiringWheel;
class FormSection;
class InertiaMomentsModel;
class NumberField;
class OrderBars;
class ResultTable;
class ShaftEditor;
class ShaftView;
class ValueSlider;

/// The inertia-moments page: layout library and table, sliders, plots over φ and by order, picture,
/// shafts, counterweights, answer.
class InertiaMomentsPage : public ScenePage {
    Q_OBJECT

  public:
    explicit InertiaMomentsPage(QWidget* parent = nullptr);

    SceneModel* model() override;
    InertiaMomentsModel* viewModel() { return model_; }
    QList<QAction*> sceneActions() override;
    QString resultsAsText() const override;
    QString resultsAsCsv() const override;

    // For tests and for the frame benchmark.
    ValueSlider* bankSlider() const { return bank_; }
    ValueSlider* offsetSlider() const { return offset_; }
    ValueSlider* speedSlider() const { return speed_; }
    ValueSlider* referenceSlider() const { return reference_; }
    ValueSlider* crankSlider() const { return crank_; }
    QComboBox* layoutChoice() const { return layout_; }
    PlotView* momentPlot(int order) const {
        return moments_.at(static_cast<std::size_t>(order - 1));
    }
    PlotView* forceHodograph() const { return hodographs_[0].plot; }
    PlotView* momentHodograph() const { return hodographs_[1].plot; }
    PlotView* rollPlot() const { return roll_; }
    OrderBars* orderBars() const { return bars_; }
    ShaftView* shaftView() const { return shaftView_; }
    EngineView* picture() const { return picture_; }
    CylinderEditor* cylinderEditor() const { return cylinders_; }
    QTabWidget* chartTabs() const { return charts_; }

  private:
    /// A field bound to one number of the input.
    struct Binding {
        NumberField* field;
        std::function<std::optional<double>()> read;
    };
    /// One hodograph with the reach of its axes.
    struct Hodograph {
        PlotView* plot = nullptr;
        int order1 = 0, order2 = 0, whole = 0, left = 0;
        double reach = 0.0;
    };

    QWidget* buildInputs();
    QWidget* buildEngineForm();
    QWidget* buildBalancingForm();
    QWidget* buildSliders();
    QWidget* buildPlots();
    QWidget* buildCharts();
    QWidget* buildAnswer();
    ResultTable* addAnswerTable(const QString& title, const QString& name,
                                const QStringList& columns);
    void bind(NumberField* field, std::function<std::optional<double>()> read,
              std::function<void(std::optional<double>)> write);

    void showInput();
    void showSliders();
    void showResult();
    void showCharts();
    void showHodograph(Hodograph& hodograph, bool force);
    void showAnswer();
    void showCursor(double crankAngle);

    InertiaMomentsModel* model_;
    std::vector<Binding> bindings_;
    QTabWidget* inputs_ = nullptr;
    QComboBox* layout_ = nullptr;
    FormSection* sizes_ = nullptr;
    QLineEdit* firingOrder_ = nullptr;
    QLabel* firingTrouble_ = nullptr;
    QLabel* rodLength_ = nullptr;
    QLabel* deadCentre_ = nullptr;
    QCheckBox* rigidRod_ = nullptr;
    FormSection* rod_ = nullptr;
    CylinderEditor* cylinders_ = nullptr;
    QComboBox* basis_ = nullptr;
    ShaftEditor* shafts_ = nullptr;
    QCheckBox* counterweights_ = nullptr;
    FormSection* webs_ = nullptr;

    ValueSlider* bank_ = nullptr;
    ValueSlider* offset_ = nullptr;
    ValueSlider* speed_ = nullptr;
    ValueSlider* reference_ = nullptr;

    std::array<PlotView*, 2> moments_{};
    QTabWidget* charts_ = nullptr;
    std::array<Hodograph, 2> hodographs_;
    OrderBars* bars_ = nullptr;
    PlotView* roll_ = nullptr;
    ShaftView* shaftView_ = nullptr;
    CounterweightView* weightView_ = nullptr;
    FiringWheel* firing_ = nullptr;

    EngineView* picture_ = nullptr;
    ValueSlider* crank_ = nullptr;
    QTabWidget* answer_ = nullptr;
    std::vector<ResultTable*> tables_;
    QLabel* warning_ = nullptr;
    QAction* playAction_ = nullptr;
    QAction* shaftsAction_ = nullptr;
};

}  // namespace ravnoves

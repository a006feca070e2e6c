#pragma once

#include "elastic-hinge/model/elastic_hinge_model.h"
#include "page/scene_page.h"

class QComboBox;
class QTabWidget;

namespace ravnoves {

class HingeMechanismView;
class HingeTabs;
class VerdictLine;

/// The elastic-hinge page: sliders, inputs, search and export, plots, picture, answer.
class ElasticHingePage : public ScenePage {
    Q_OBJECT

  public:
    explicit ElasticHingePage(QWidget* parent = nullptr, SceneModel* kept = nullptr);

    SceneModel* model() override;
    ElasticHingeModel* viewModel() { return model_; }
    QList<QAction*> sceneActions() override;

    // For tests and for the frame benchmark.
    HingeTabs* plots() const { return plots_; }
    HingeMechanismView* picture() const { return picture_; }
    QTabWidget* forms() const { return forms_; }

  private:
    QWidget* buildInputs();
    QWidget* buildSliders();
    QWidget* buildAnswer();
    void showAnswer();
    void showAnimated();

    ElasticHingeModel* model_;
    QTabWidget* forms_ = nullptr;
    HingeTabs* plots_ = nullptr;
    HingeMechanismView* picture_ = nullptr;
    QComboBox* animated_ = nullptr;
    VerdictLine* verdict_ = nullptr;
    QAction* playAction_ = nullptr;
};

}  // namespace ravnoves

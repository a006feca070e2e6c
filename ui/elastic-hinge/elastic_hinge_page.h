#pragma once

#include "elastic-hinge/model/elastic_hinge_model.h"
#include "page/scene_page.h"

class QComboBox;
class QTabWidget;

namespace ravnoves {

/// The elastic-hinge page: sliders, inputs, search and export, plots, picture, answer.
class ElasticHingePage : public ScenePage {
    Q_OBJECT

  public:
    explicit ElasticHingePage(QWidget* parent = nullptr, SceneModel* kept = nullptr);

    SceneModel* model() override { return model_; }
    ElasticHingeModel* viewModel() { return model_; }
    QList<QAction*> sceneActions() override { return {playAction_}; }

  private:
    QWidget* buildInputs();
    QWidget* buildSliders();
    QWidget* buildAnswer();
    void showAnimated();

    ElasticHingeModel* model_;
    QTabWidget* forms_ = nullptr;
    QComboBox* animated_ = nullptr;
    QAction* playAction_ = nullptr;
};

}  // namespace ravnoves

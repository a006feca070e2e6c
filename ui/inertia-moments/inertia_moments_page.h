#pragma once

#include "inertia-moments/model/inertia_moments_model.h"
#include "page/scene_page.h"

class QTabWidget;

namespace ravnoves {

/// The inertia-moments page: layout library and table, sliders, plots over φ and by order, picture,
/// shafts, counterweights, answer.
class InertiaMomentsPage : public ScenePage {
    Q_OBJECT

  public:
    explicit InertiaMomentsPage(QWidget* parent = nullptr, SceneModel* kept = nullptr);

    SceneModel* model() override { return model_; }
    InertiaMomentsModel* viewModel() { return model_; }
    QList<QAction*> sceneActions() override { return {playAction_, shaftsAction_}; }

  private:
    QTabWidget* makeInputs();
    /// The picture of the engine and the tables of the answer.
    QWidget* buildAnswer();
    void addShaftsAction();

    InertiaMomentsModel* model_;
    QAction* playAction_ = nullptr;
    QAction* shaftsAction_ = nullptr;
};

}  // namespace ravnoves

#pragma once

#include "inertia-moments/inertia_moments_answer.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "page/mechanism_picture.h"
#include "page/scene_page.h"

class QTabWidget;

namespace ravnoves {

class VerdictLine;

/// The inertia-moments page: layout library and table, sliders, plots over φ and by order, picture,
/// shafts, counterweights, answer.
class InertiaMomentsPage : public ScenePage {
    Q_OBJECT

  public:
    explicit InertiaMomentsPage(QWidget* parent = nullptr, SceneModel* kept = nullptr);

    SceneModel* model() override { return model_; }
    InertiaMomentsModel* viewModel() { return model_; }
    QList<QAction*> sceneActions() override {
        return {answer_->picturePanel()->action(), shaftsAction_};
    }

  private:
    QTabWidget* makeInputs();
    void addShaftsAction();

    InertiaMomentsModel* model_;
    InertiaMomentsAnswer* answer_;
    VerdictLine* verdict_;
    QAction* shaftsAction_ = nullptr;
};

}  // namespace ravnoves

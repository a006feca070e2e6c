#pragma once

#include "balance-shaft/model/balance_shaft_model.h"
#include "page/scene_page.h"

class QGridLayout;
class QTabWidget;

namespace ravnoves {

class Form;
class PicturePanel;

/// The balance-shaft page: inputs, α slider, tabs, picture, results.
class BalanceShaftPage : public ScenePage {
    Q_OBJECT

  public:
    explicit BalanceShaftPage(QWidget* parent = nullptr, SceneModel* kept = nullptr);

    SceneModel* model() override { return model_; }
    BalanceShaftModel* viewModel() { return model_; }
    QList<QAction*> sceneActions() override { return actions_; }

  private:
    QTabWidget* buildInputs();
    QWidget* buildPlots();
    QWidget* buildAnswer();
    PicturePanel* buildPicture(QWidget* parent);
    QGridLayout* buildBest(QWidget* parent);
    void addEngine(Form* form);
    void addMasses(Form* form);
    /// A size in mm that the front view assumes where it is not given.
    void addAssumed(Form* form, const char* place, double balance_shaft::FrontView::*size);
    void doVerdictAct();

    BalanceShaftModel* model_;
    QList<QAction*> actions_;
};

}  // namespace ravnoves

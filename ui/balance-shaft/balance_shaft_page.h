#pragma once

#include <array>

#include "balance-shaft/model/balance_shaft_model.h"
#include "page/scene_page.h"

class QGridLayout;
class QPushButton;
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
    QList<QAction*> sceneActions() override {
        return {playAction_, best_[0].action, best_[1].action};
    }

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
    void showBest();
    void doVerdictAct();

    BalanceShaftModel* model_;
    /// The two ways to the best α of a criterion.
    struct Best {
        BalanceShaftModel::Criterion criterion;
        QPushButton* button;
        QAction* action;
    };
    std::array<Best, 2> best_{};
    QAction* playAction_ = nullptr;
};

}  // namespace ravnoves

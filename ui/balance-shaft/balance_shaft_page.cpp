#include "balance-shaft/balance_shaft_page.h"

#include <QTabWidget>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/torque_source_editor.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"

namespace ravnoves {

BalanceShaftPage::BalanceShaftPage(QWidget* parent, SceneModel* kept)
    : ScenePage(parent), model_(takeOver<BalanceShaftModel>(kept)) {
    QTabWidget* inputs = buildInputs();
    columnIn(this)->addWidget(new PageColumns(
        {.inputs = inputs, .tabs = inputs, .plots = buildPlots(), .results = buildAnswer()}, this));

    bestRangeAction_ = new QAction(themedIcon(QStringLiteral("best")),
                                   tr("Go to the α of the least &range"), this);
    connect(bestRangeAction_, &QAction::triggered, model_, &BalanceShaftModel::goToBestRange);
    bestRmsAction_ = new QAction(tr("Go to the α of the least R&MS"), this);
    connect(bestRmsAction_, &QAction::triggered, model_, &BalanceShaftModel::goToBestRms);
    connect(model_, &SceneModel::changed, this, &BalanceShaftPage::showSweep);
    connect(&Theme::instance(), &Theme::changed, this, &BalanceShaftPage::showSweep);
    connect(model_, &BalanceShaftModel::shaftMoved, this, &BalanceShaftPage::showShaft);
    connect(model_, &BalanceShaftModel::meansChanged, this, &BalanceShaftPage::showMeans);
    connect(model_, &BalanceShaftModel::refused, this, &ScenePage::status);

    showSweep();
    showShaft();
    showMeans();
}

TorqueTableEditor* BalanceShaftPage::torqueEditor() const {
    return source_->tableEditor();
}

SceneModel* BalanceShaftPage::model() {
    return model_;
}

QList<QAction*> BalanceShaftPage::sceneActions() {
    return {playAction_, bestRangeAction_, bestRmsAction_};
}

}  // namespace ravnoves

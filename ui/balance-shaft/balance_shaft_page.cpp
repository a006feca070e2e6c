#include "balance-shaft/balance_shaft_page.h"

#include <QTabWidget>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/torque_source_editor.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/verdict_line.h"

namespace ravnoves {

BalanceShaftPage::BalanceShaftPage(QWidget* parent, SceneModel* kept)
    : ScenePage(parent), model_(takeOver<BalanceShaftModel>(kept)) {
    QTabWidget* inputs = buildInputs();
    verdict_ = new VerdictLine(this);
    connect(verdict_, &VerdictLine::acted, this, &BalanceShaftPage::doVerdictAct);
    QVBoxLayout* column = columnIn(this);
    column->addWidget(verdict_);
    column->addWidget(
        new PageColumns(
            {.inputs = inputs, .tabs = inputs, .plots = buildPlots(), .results = buildAnswer()},
            this),
        1);

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

void BalanceShaftPage::showVerdict() {
    const Verdict verdict = model_->verdict();
    verdict_->show(verdict,
                   verdict.act == balance_shaft::move_trace_act   ? tr("Move the trace by &360°")
                   : verdict.act == balance_shaft::best_range_act ? tr("&Use the best feasible α")
                                                                  : QString());
}

void BalanceShaftPage::doVerdictAct() {
    if (model_->verdict().act == balance_shaft::move_trace_act) {
        model_->moveTraceByTurn();
    } else {
        model_->goToBestRange();
    }
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

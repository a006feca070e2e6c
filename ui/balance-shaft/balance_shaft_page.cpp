#include "balance-shaft/balance_shaft_page.h"

#include <QHBoxLayout>

#include "balance-shaft/balance_shaft_view_model.h"
#include "balance-shaft/torque_source_editor.h"
#include "theme/icons.h"
#include "theme/theme.h"

namespace ravnoves {

BalanceShaftPage::BalanceShaftPage(QWidget* parent)
    : ScenePage(parent), model_(new BalanceShaftViewModel(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    row->setSpacing(Theme::space);
    row->addWidget(buildInputs());
    row->addWidget(buildPlots(), 5);
    row->addWidget(buildAnswer(), 2);

    bestRangeAction_ = new QAction(themedIcon(QStringLiteral("best")),
                                   tr("Go to the α of the least &range"), this);
    connect(bestRangeAction_, &QAction::triggered, model_, &BalanceShaftViewModel::goToBestRange);
    bestRmsAction_ = new QAction(tr("Go to the α of the least R&MS"), this);
    connect(bestRmsAction_, &QAction::triggered, model_, &BalanceShaftViewModel::goToBestRms);
    connect(model_, &SceneViewModel::changed, this, &BalanceShaftPage::showInput);
    connect(model_, &SceneViewModel::changed, this, &BalanceShaftPage::showSweep);
    connect(model_, &BalanceShaftViewModel::shaftMoved, this, &BalanceShaftPage::showShaft);
    connect(model_, &BalanceShaftViewModel::meansChanged, this, &BalanceShaftPage::showMeans);
    connect(model_, &BalanceShaftViewModel::crankAngleChanged, this, &BalanceShaftPage::showCursor);
    connect(model_, &BalanceShaftViewModel::refused, this, &ScenePage::status);

    showInput();
    showSweep();
    showShaft();
    showMeans();
    showCursor(model_->crankAngleDeg());
}

TorqueTableEditor* BalanceShaftPage::torqueEditor() const {
    return source_->tableEditor();
}

SceneViewModel* BalanceShaftPage::model() {
    return model_;
}

QList<QAction*> BalanceShaftPage::sceneActions() {
    return {playAction_, bestRangeAction_, bestRmsAction_};
}

}  // namespace ravnoves

#include "inertia-moments/inertia_moments_page.h"

#include <QHBoxLayout>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "inertia-moments/model/inertia_moments_model.h"
#include "theme/icons.h"
#include "theme/theme.h"

namespace ravnoves {

using inertia_moments::Input;

namespace {

using Tabs = InertiaMomentsModel::Tabs;

}  // namespace

InertiaMomentsPage::InertiaMomentsPage(QWidget* parent)
    : ScenePage(parent), model_(new InertiaMomentsModel(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    row->setSpacing(Theme::space);
    row->addWidget(buildInputs());
    // The sliders over plots and picture: they need length.
    auto* right = new QVBoxLayout;
    right->setSpacing(Theme::space);
    right->addWidget(buildSliders());
    auto* lower = new QHBoxLayout;
    lower->setSpacing(Theme::space);
    lower->addWidget(buildPlots(), 5);
    lower->addWidget(buildAnswer(), 3);
    right->addLayout(lower, 1);
    row->addLayout(right, 1);

    shaftsAction_ = new QAction(themedIcon(QStringLiteral("best")), tr("&Shafts on or off"), this);
    shaftsAction_->setToolTip(tr("Switch all balance shafts on, or off when all are on"));
    connect(shaftsAction_, &QAction::triggered, this, [this] {
        const auto& shafts = model_->input().shafts;
        const bool all = std::all_of(shafts.begin(), shafts.end(),
                                     [](const auto& shaft) { return shaft.enabled; });
        model_->edit(all ? tr("All shafts off") : tr("All shafts on"), [all](Input& input) {
            for (auto& shaft : input.shafts) {
                shaft.enabled = !all;
            }
        });
        model_->finishDrag();
    });
    connect(model_, &SceneModel::changed, this, &InertiaMomentsPage::showInput);
    connect(model_, &SceneModel::changed, this, &InertiaMomentsPage::showResult);
    connect(model_, &InertiaMomentsModel::crankAngleChanged, this,
            &InertiaMomentsPage::showCursor);
    connect(model_, &InertiaMomentsModel::refused, this, [this](const QString& why) {
        Q_EMIT status(why);
        showSliders();  // a slider that went too far comes back
    });
    connect(model_, &InertiaMomentsModel::tabChanged, this, [this](Tabs group, int index) {
        QTabWidget* tabs = group == Tabs::Inputs   ? inputs_
                           : group == Tabs::Charts ? charts_
                                                   : answer_;
        tabs->setCurrentIndex(index);
        showCharts();
        showAnswer();
    });

    showInput();
    showResult();
    showCursor(model_->crankAngleDeg());
}

SceneModel* InertiaMomentsPage::model() {
    return model_;
}

QList<QAction*> InertiaMomentsPage::sceneActions() {
    return {playAction_, shaftsAction_};
}

}  // namespace ravnoves

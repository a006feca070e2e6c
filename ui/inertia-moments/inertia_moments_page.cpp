#include "inertia-moments/inertia_moments_page.h"

#include <QTabWidget>
#include <algorithm>

#include "inertia-moments/cylinder_editor.h"
#include "inertia-moments/engine_forms.h"
#include "inertia-moments/inertia_moments_charts.h"
#include "page/rejected_verdict.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/verdict_line.h"

namespace ravnoves {

InertiaMomentsPage::InertiaMomentsPage(QWidget* parent, SceneModel* kept)
    : ScenePage(parent), model_(adopt<InertiaMomentsModel>(kept)) {
    QTabWidget* inputs = makeInputs();
    answer_ = new InertiaMomentsAnswer(model_, this);
    verdict_ = new VerdictLine(this);
    const auto showVerdict = [this] { verdict_->show(withRejected(model_->verdict(), *model_)); };
    connect(model_, &SceneModel::changed, verdict_, showVerdict);
    connect(model_, &SceneModel::rejectedInChanged, verdict_, showVerdict);
    showVerdict();
    QVBoxLayout* column = columnIn(this);
    column->addWidget(verdict_);
    // The sliders over plots and picture: they need length.
    column->addWidget(
        new PageColumns({.inputs = inputs,
                         .tabs = inputs,
                         .plots = scrolled(new InertiaMomentsCharts(model_, this), this),
                         .results = answer_,
                         .resultShare = 3,
                         .top = new EngineSliders(model_, this)},
                        this),
        1);

    connect(model_, &SceneModel::rejected, this, &ScenePage::status);
    addShaftsAction();
}

QTabWidget* InertiaMomentsPage::makeInputs() {
    auto* inputs = new QTabWidget(this);
    inputs->setDocumentMode(true);
    inputs->setFixedWidth(PageColumns::inputsWidth());
    const auto add = [inputs](QWidget* view, const char* name, const QString& title) {
        view->setObjectName(QLatin1String(name));
        inputs->addTab(view, title);
    };
    add(scrolled(new EngineForm(model_), inputs), "engine", tr("Engine"));
    add(new CylinderEditor(model_, inputs), "cylinders", tr("Cylinders"));
    add(scrolled(new BalancingForm(model_), inputs), "balancing", tr("Balancing"));
    return inputs;
}

void InertiaMomentsPage::addShaftsAction() {
    shaftsAction_ = new QAction(themedIcon(QStringLiteral("best")), tr("&Shafts on or off"), this);
    shaftsAction_->setToolTip(tr("Switch all balance shafts on, or off when all are on"));
    connect(shaftsAction_, &QAction::triggered, this, [this] {
        const auto& shafts = model_->input().shafts;
        const bool all = std::all_of(shafts.begin(), shafts.end(),
                                     [](const auto& shaft) { return shaft.enabled; });
        model_->edit(all ? tr("All shafts off") : tr("All shafts on"),
                     [all](inertia_moments::Input& input) {
                         for (auto& shaft : input.shafts) {
                             shaft.enabled = !all;
                         }
                     });
        model_->finishDrag();
    });
}

}  // namespace ravnoves

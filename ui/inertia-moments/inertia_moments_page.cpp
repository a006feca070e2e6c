#include "inertia-moments/inertia_moments_page.h"

#include <QTabWidget>
#include <algorithm>

#include "inertia-moments/crank_views.h"
#include "inertia-moments/cylinder_editor.h"
#include "inertia-moments/engine_forms.h"
#include "inertia-moments/engine_view.h"
#include "inertia-moments/inertia_moments_charts.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "page/rejected_verdict.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"

namespace ravnoves {

InertiaMomentsPage::InertiaMomentsPage(QWidget* parent, SceneModel* kept)
    : ScenePage(parent), model_(adopt<InertiaMomentsModel>(kept)) {
    QTabWidget* inputs = makeInputs();
    auto* verdict = new VerdictLine(this);
    showVerdict(verdict, model_);
    QVBoxLayout* column = columnIn(this);
    column->addWidget(verdict);
    // The sliders over plots and picture: they need length.
    column->addWidget(
        new PageColumns({.inputs = inputs,
                         .tabs = inputs,
                         .plots = scrolled(new InertiaMomentsCharts(model_, this), this),
                         .results = buildAnswer(),
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
    addScrolledTab(inputs, new EngineForm(model_), QStringLiteral("engine"), tr("Engine"));
    auto* cylinders = new CylinderEditor(model_, inputs);
    cylinders->setObjectName(QStringLiteral("cylinders"));
    inputs->addTab(cylinders, tr("Cylinders"));
    addScrolledTab(inputs, new BalancingForm(model_), QStringLiteral("balancing"), tr("Balancing"));
    return inputs;
}

QWidget* InertiaMomentsPage::buildAnswer() {
    auto* holder = new QWidget(this);
    holder->setMinimumWidth(Theme::withText(332));
    holder->setMaximumWidth(Theme::withText(480));
    QVBoxLayout* column = columnIn(holder);
    auto* picturePanel = new PicturePanel(
        new EngineView(model_), tr("Crank angle of the picture, from cylinder 1's axis"), holder);
    playAction_ = picturePanel->action();
    column->addWidget(picturePanel, 5);

    auto* panel = new Panel(holder);
    QVBoxLayout* answerColumn =
        columnIn(panel, Theme::gap, {Theme::gap, Theme::gap, Theme::gap, Theme::space});
    auto* tabs = new QTabWidget(panel);
    tabs->setDocumentMode(true);
    const auto add = [&](const char* part, const QString& title, const QString& name) {
        auto* table = new PartTable(model_, part, name, tabs);
        table->setObjectName(QStringLiteral("table-") + QLatin1String(part));
        table->setShownRows(4);  // the picture has the same share of the height
        tabs->setTabToolTip(tabs->addTab(table, title), name);
    };
    add("orders", tr("Orders"), tr("Amplitudes and phases by order and plane"));
    add("rotating", tr("±kω"), tr("Forward and backward rotating parts by order"));
    add("shafts", tr("Shafts"), tr("Balance shafts"));
    add("weights", tr("Weights"), CounterweightView::name());
    add("left", tr("Residual"), tr("Residual by order"));
    answerColumn->addWidget(tabs, 1);
    column->addWidget(panel, 5);
    return holder;
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
    });
}

}  // namespace ravnoves

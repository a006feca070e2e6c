#include "balance-shaft/balance_shaft_page.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTabWidget>

#include "balance-shaft/mechanism_view.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/shaft_tabs.h"
#include "balance-shaft/torque_source_editor.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "page/rejected_verdict.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/answer_label.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using Criterion = BalanceShaftModel::Criterion;

BalanceShaftPage::BalanceShaftPage(QWidget* parent, SceneModel* kept)
    : ScenePage(parent), model_(adopt<BalanceShaftModel>(kept)) {
    QTabWidget* inputs = buildInputs();
    auto* verdict = new VerdictLine(this);
    connect(verdict, &VerdictLine::acted, this, &BalanceShaftPage::doVerdictAct);
    showVerdict(verdict, model_, [](const Verdict& of) {
        return of.act == balance_shaft::move_trace_act   ? tr("Shift the trace by &360°")
               : of.act == balance_shaft::best_range_act ? tr("&Use the best feasible α")
               : of.act == balance_shaft::best_place_act ? tr("Best place on the &map")
                                                         : QString();
    });
    QVBoxLayout* column = columnIn(this);
    column->addWidget(verdict);
    column->addWidget(
        new PageColumns(
            {.inputs = inputs, .tabs = inputs, .plots = buildPlots(), .results = buildAnswer()},
            this),
        1);

    connect(model_, &SceneModel::changed, this, &BalanceShaftPage::showBest);
    connect(model_, &BalanceShaftModel::rejected, this, &ScenePage::status);
    showBest();
}

QWidget* BalanceShaftPage::buildPlots() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder);

    auto* bar = new Panel(holder);
    QHBoxLayout* barRow = rowIn(bar, Theme::margin, barMargins);
    auto* angle =
        new FieldSlider(model_, "/shaft_angle_deg", {0.0, 360.0, 0.1, 10.0, 2}, bar,
                        {.label = tr("Shaft angle &α"),
                         .hint = tr("Angle from the cylinder axis to the line of centres, in the "
                                    "direction of rotation; at 90° the shaft is beside the crank."),
                         .read = [this] { return model_->shaftAngleDeg(); },
                         .write = [this](double angle) { model_->setShaftAngleDeg(angle); }});
    connect(model_, &SceneModel::shownChanged, angle, &FieldSlider::follow);
    barRow->addWidget(angle, 1);
    column->addWidget(bar);

    column->addWidget(new ShaftTabs(model_, holder), 1);
    return holder;
}

QWidget* BalanceShaftPage::buildAnswer() {
    auto* holder = new QWidget(this);
    holder->setMinimumWidth(Theme::withText(338));
    holder->setMaximumWidth(Theme::withText(440));
    QVBoxLayout* column = columnIn(holder);

    auto* picturePanel = new PicturePanel(
        new MechanismView(model_), tr("Crank angle of the picture; 0 is top dead centre"), holder);
    playAction_ = picturePanel->action();
    column->addWidget(picturePanel, 1);

    auto* answer = new Panel(holder);
    QVBoxLayout* answerColumn = columnIn(answer, Theme::gap, tableMargins);
    answerColumn->addWidget(
        new PartTable(model_, "criteria", tr("Criteria of the three moments"), answer));
    answerColumn->addLayout(buildBest(answer));
    auto* quantities = new PartTable(model_, "quantities", tr("Forces, masses and sizes"), answer);
    quantities->horizontalHeader()->hide();
    answerColumn->addWidget(quantities);
    auto* notes = new PartText(model_, "notes", answer);
    answerColumn->addWidget(new Apart(notes, answer), 1);
    column->addWidget(answer);
    return holder;
}

QGridLayout* BalanceShaftPage::buildBest(QWidget* parent) {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(Theme::space);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 1);
    const auto add = [&](Best& best, int row, const char* part, const char* name,
                         const QString& act, Criterion criterion) {
        const auto go = [this, criterion] { model_->goToBest(criterion); };
        best.criterion = criterion;
        best.action = new QAction(act, this);
        connect(best.action, &QAction::triggered, model_, go);
        auto* label = new PartText(model_, part, parent);
        label->setFont(Theme::font());
        colourText(label, &Theme::text);
        label->setToolTip(tr("Over all feasible α, exact for the continuous cycle"));
        best.button = new QPushButton(tr("Apply"), parent);
        best.button->setObjectName(QLatin1String(name));
        best.button->setAccessibleName(QString(act).remove(QLatin1Char('&')));
        connect(best.button, &QPushButton::clicked, model_, go);
        grid->addWidget(new Apart(label, parent), row, 0);
        grid->addWidget(best.button, row, 1);
    };
    add(best_[0], 0, "best-range", "go_best_range", tr("Apply the α of the minimum &range"),
        Criterion::range);
    add(best_[1], 1, "best-rms", "go_best_rms", tr("Apply the α of the minimum R&MS"),
        Criterion::rms);
    best_[0].action->setIcon(themedIcon(QStringLiteral("best")));
    return grid;
}

void BalanceShaftPage::showBest() {
    for (const Best& best : best_) {
        enableWhereFeasible(*best.button, model_->result().buildable);
        if (!model_->best(best.criterion).shaft_angle) {
            best.button->setEnabled(false);
        }
        best.action->setEnabled(best.button->isEnabled());
    }
}

void BalanceShaftPage::doVerdictAct() {
    if (model_->verdict().act == balance_shaft::move_trace_act) {
        model_->moveTraceByTurn();
    } else if (model_->verdict().act == balance_shaft::best_place_act) {
        showTabs({QStringLiteral("map")});
    } else {
        model_->goToBest(Criterion::range);
    }
}

}  // namespace ravnoves

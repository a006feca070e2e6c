#include "balance-shaft/balance_shaft_page.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTabWidget>

#include "balance-shaft/fields.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/shaft_tabs.h"
#include "balance-shaft/torque_source_editor.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "page/rejected_verdict.h"
#include "text/message_text.h"
#include "text/shown_units.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/answer_label.h"
#include "widgets/form.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using balance_shaft::FrontView;
using Criterion = BalanceShaftModel::Criterion;
namespace field = balance_shaft::field;

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

    connect(model_, &BalanceShaftModel::rejected, this, &ScenePage::status);
}

void BalanceShaftPage::addEngine(Form* form) {
    FormSection* engine = form->section(tr("Engine"));
    NumberField* speed = form->number(
        field::speed, [this] { return model_->input().angular_speed; },
        [this](std::optional<double> value) { model_->setSpeed(*value); });
    speed->setDigits(8);
    QLabel* angularSpeed = engine->addResult(tr("ω"), tr("Angular speed, n π / 30"));
    form->follow([this, angularSpeed] {
        angularSpeed->setText(shownNumber(model_->input().angular_speed, units::rad_per_s, 2));
    });
    form->choice("/strokes");
    form->number("/crank_radius_mm");
    form->number(
        field::stroke, [this] { return std::optional(2.0 * model_->input().crank_radius); },
        [this](std::optional<double> value) {
            model_->editField("/crank_radius_mm", from_si(field::crank_radius, *value / 2.0),
                              fieldName(field::stroke));
        });
    addAssumed(form, "/cylinder/bore_mm", &FrontView::cylinder_bore);
    addAssumed(form, "/cylinder/rod_length_mm", &FrontView::rod_length);
    form->number("/cylinder/offset_mm");
}

void BalanceShaftPage::addAssumed(Form* form, const char* place, double FrontView::*size) {
    showAssumed(form, form->number(place), [this, size] {
        return std::optional(model_->solver().front_view().*size / units::mm);
    });
}

void BalanceShaftPage::addMasses(Form* form) {
    FormSection* masses = form->section(tr("Reciprocating masses"));
    for (const Field& part : field::mass_parts) {
        const std::string name(part.key);
        NumberField* mass = form->number(
            part, [this, name] { return model_->mass(name); },
            [this, name, &part](std::optional<double> value) {
                model_->editField("/reciprocating_masses_kg/" + name, *value, fieldName(part));
            });
        mass->setObjectName(QString::fromStdString("mass_" + name));
    }
    form->number("/rod_mass_kg");
    QLabel* sum = masses->addResult(tr("Sum mⱼ"), tr("Reciprocating mass: the sum of the parts."));
    QLabel* note = captionLabel({}, masses);
    masses->addWide(note);
    form->follow([this, sum, note] {
        sum->setText(shownNumber(model_->input().reciprocating_mass(), units::kg, 3));
        const double other = model_->otherMasses();
        note->setText(tr("Not listed above: %1.").arg(shownShort(other, units::kg, 6)));
        note->setVisible(other > 0.0);
    });
}

QTabWidget* BalanceShaftPage::buildInputs() {
    auto* form = new Form(model_);
    addEngine(form);
    addMasses(form);
    form->section(tr("Counterweights and shaft"));
    form->number("/counterweight_radius_mm");
    showAssumed(form, form->number("/counterweight_mass_kg"),
                [this] { return std::optional(model_->input().counterweight()); });
    form->number("/centre_distance_mm");
    form->section(tr("Sizes for clearance"));
    for (const auto& [place, size] :
         {std::pair("/envelope/cylinder_wall_mm", &FrontView::cylinder_wall),
          std::pair("/envelope/cylinder_bottom_mm", &FrontView::cylinder_bottom),
          std::pair("/envelope/cylinder_top_mm", &FrontView::cylinder_top),
          std::pair("/envelope/rod_width_mm", &FrontView::rod_width),
          std::pair("/envelope/crank_swing_radius_mm", &FrontView::crank_swing_radius),
          std::pair("/envelope/shaft_swing_radius_mm", &FrontView::shaft_swing_radius),
          std::pair("/envelope/gear_tip_radius_mm", &FrontView::gear_tip_radius)}) {
        addAssumed(form, place, size);
    }
    form->number("/envelope/clearance_mm");
    form->number("/envelope/wall_mm");
    FormSection* rows = form->section(tr("Torque between the rows of its table"));
    form->choice("/interpolation");
    form->follow([this, rows] { rows->setVisible(model_->replacedInputs().empty()); });
    form->column()->addStretch();

    auto* tabs = new QTabWidget(this);
    tabs->setDocumentMode(true);
    tabs->setFixedWidth(PageColumns::inputsWidth());
    auto* scroll = scrolled(form, tabs);
    tabs->addTab(scroll, tr("Inputs"));
    auto* source = new TorqueSourceEditor(model_, tabs);
    source->setObjectName(QStringLiteral("torque"));
    tabs->addTab(source, tr("Torque"));
    return tabs;
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

    PicturePanel* picturePanel = buildPicture(holder);
    actions_ << picturePanel->action();
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
    const auto add = [&](int row, const char* part, const char* name, const QString& act,
                         Criterion criterion) {
        const auto go = [this, criterion] { model_->goToBest(criterion); };
        auto* action = new QAction(act, this);
        connect(action, &QAction::triggered, model_, go);
        actions_ << action;
        auto* label = new PartText(model_, part, parent);
        label->setFont(Theme::font());
        colourText(label, &Theme::text);
        label->setToolTip(tr("Over all feasible α, exact for the continuous cycle"));
        auto* button = new QPushButton(tr("Apply"), parent);
        button->setObjectName(QLatin1String(name));
        button->setAccessibleName(QString(act).remove(QLatin1Char('&')));
        connect(button, &QPushButton::clicked, model_, go);
        const auto show = [=, this] {
            enableWhereFeasible(*button, model_->result().buildable);
            button->setEnabled(button->isEnabled() && model_->best(criterion).shaft_angle);
            action->setEnabled(button->isEnabled());
        };
        connect(model_, &SceneModel::changed, button, show);
        show();
        grid->addWidget(new Apart(label, parent), row, 0);
        grid->addWidget(button, row, 1);
        return action;
    };
    add(0, "best-range", "go_best_range", tr("Apply the α of the minimum &range"), Criterion::range)
        ->setIcon(themedIcon(QStringLiteral("best")));
    add(1, "best-rms", "go_best_rms", tr("Apply the α of the minimum R&MS"), Criterion::rms);
    return grid;
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

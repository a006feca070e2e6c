#include "elastic-hinge/elastic_hinge_page.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QTabWidget>

#include "elastic-hinge/hinge_inputs.h"
#include "elastic-hinge/hinge_mechanism_view.h"
#include "elastic-hinge/hinge_tabs.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "page/rejected_verdict.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using elastic_hinge::Kinematics;
using elastic_hinge::Spring;

ElasticHingePage::ElasticHingePage(QWidget* parent, SceneModel* kept)
    : ScenePage(parent), model_(adopt<ElasticHingeModel>(kept)) {
    QWidget* inputs = buildInputs();
    auto* verdict = new VerdictLine(this);
    connect(verdict, &VerdictLine::acted, model_, &ElasticHingeModel::takeMinimumPreload);
    showVerdict(verdict, model_, [](const Verdict& of) {
        return of.act.empty() ? QString() : tr("Use this pre&load");
    });
    QVBoxLayout* column = columnIn(this);
    column->addWidget(verdict);
    column->addWidget(new PageColumns({.inputs = inputs,
                                       .tabs = forms_,
                                       .plots = new HingeTabs(model_, this),
                                       .results = buildAnswer()},
                                      this),
                      1);

    connect(model_, &ElasticHingeModel::viewChanged, this, &ElasticHingePage::showAnimated);
    connect(model_, &ElasticHingeModel::rejected, this, &ScenePage::status);
    showAnimated();
}

QWidget* ElasticHingePage::buildSliders() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, Theme::gap, panelMargins);
    const auto lambdaEnds = [this] {
        return std::pair(0.05, model_->input().kinematics == Kinematics::series ? 1.0 : 0.99);
    };
    const auto radiusEnds = [this] {
        const double maximum = model_->input().spring.value_or(Spring()).free_length / units::mm;
        return std::pair(std::min(1.0, 0.005 * maximum), maximum);
    };
    const auto hasSpring = [this] { return model_->input().spring.has_value(); };
    const auto hasCounterweight = [this] { return model_->input().rod_counterweight.has_value(); };
    const QList<ValueSlider*> sliders{
        new FieldSlider(model_, "/angular_speed_rad_s", {0.0, 600.0, 1.0, 20.0, 1}, panel,
                        {.label = tr("&ω")}),
        new FieldSlider(model_, "/lambda", {0.05, 0.99, 0.01, 0.1, 3}, panel,
                        {.label = tr("&λ"), .ends = lambdaEnds}),
        new FieldSlider(model_, "/spring/stiffness_N_m", {1.0, 1e6, 0.1, 1.0, 1, 50, 3}, panel,
                        {.label = tr("&c"),
                         .name = QStringLiteral("stiffness_kN_m"),
                         .unit = units::kN_per_m,
                         .isGiven = hasSpring}),
        new FieldSlider(model_, "/spring/guide_radius_at_zero_mm", {1.0, 199.0, 0.01, 1.0, 3},
                        panel, {.label = tr("&ρ₀"), .ends = radiusEnds, .isGiven = hasSpring}),
        new FieldSlider(model_, "/rod_counterweight/distance_mm", {10.0, 300.0, 1.0, 10.0, 1},
                        panel,
                        {.label = tr("ℓ&₂"),
                         .name = QStringLiteral("counterweight_distance_mm"),
                         .isMovable = hasCounterweight}),
        new FieldSlider(model_, "/profile_error_um", {0.0, 100.0, 0.5, 5.0, 1}, panel,
                        {.label = tr("&error")}),
    };
    ValueSlider::align(sliders);
    for (ValueSlider* slider : sliders) {
        column->addWidget(slider);
    }
    return panel;
}

QWidget* ElasticHingePage::buildInputs() {
    auto* holder = new QWidget(this);
    holder->setFixedWidth(PageColumns::inputsWidth());
    QVBoxLayout* column = columnIn(holder);
    column->addWidget(buildSliders());

    forms_ = new QTabWidget(holder);
    forms_->setDocumentMode(true);
    addScrolledTab(forms_, new HingeInputs(model_), QStringLiteral("inputs"), tr("Inputs"));
    addScrolledTab(forms_, new GuideSearchForm(model_), QStringLiteral("search"), tr("Search"));
    auto* exports = new GuideExportForm(model_);
    connect(exports, &GuideExportForm::status, this, &ScenePage::status);
    addScrolledTab(forms_, exports, QStringLiteral("export"), tr("Export"));
    column->addWidget(forms_, 1);
    return holder;
}

QWidget* ElasticHingePage::buildAnswer() {
    auto* holder = new QWidget(this);
    holder->setMinimumWidth(Theme::withText(300));
    holder->setMaximumWidth(Theme::withText(460));
    QVBoxLayout* column = columnIn(holder);

    auto* picturePanel = new PicturePanel(
        new HingeMechanismView(model_),
        tr("Crank angle of the picture, counter-clockwise from the slider line"), holder);
    playAction_ = picturePanel->action();
    playAction_->setToolTip(tr("Play the computed motion in slow motion"));
    animated_ = new QComboBox(picturePanel);
    animated_->setObjectName(QStringLiteral("animate"));
    animated_->addItems(
        {tr("without hinge"), tr("crank hinge"), tr("both hinges"), tr("off design")});
    animated_->setAccessibleName(tr("Motion shown"));
    animated_->setToolTip(tr("Computed motion that the picture shows"));
    connect(animated_, &QComboBox::activated, this, [this](int index) {
        model_->setAnimated(static_cast<ElasticHingeModel::Animated>(index));
    });
    auto* label = new QLabel(tr("&Motion"), picturePanel);
    label->setBuddy(animated_);
    picturePanel->addControls({label, animated_});
    column->addWidget(picturePanel, 1);

    auto* answer = new Panel(holder);
    QVBoxLayout* answerColumn = columnIn(answer, Theme::gap, tableMargins);
    auto* quantities = new PartTable(model_, "quantities", tr("Results of the design"), answer);
    quantities->horizontalHeader()->hide();
    answerColumn->addWidget(quantities);
    column->addWidget(answer);
    return holder;
}

void ElasticHingePage::showAnimated() {
    animated_->setCurrentIndex(static_cast<int>(model_->animated()));
}

}  // namespace ravnoves

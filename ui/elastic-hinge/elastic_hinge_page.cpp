#include "elastic-hinge/elastic_hinge_page.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTabWidget>
#include <QVBoxLayout>
#include <cmath>

#include "elastic-hinge/guide_export_form.h"
#include "elastic-hinge/guide_search_form.h"
#include "elastic-hinge/hinge_inputs.h"
#include "elastic-hinge/hinge_mechanism_view.h"
#include "elastic-hinge/hinge_plots.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/mechanism_picture.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using elastic_hinge::Input;
using elastic_hinge::Kinematics;
using elastic_hinge::Spring;
namespace field = elastic_hinge::field;

namespace {

constexpr double kilonewtonPerMetre = 1e3;
constexpr int boxWidth = 118;          ///< pixels, for "20000.0 kN/m"
constexpr double usualDistance = 0.1;  ///< ℓ₂ that a new counterweight gets, m

Spring& springOf(Input& input) {
    if (!input.spring) {
        input.spring = elastic_hinge::preset_zotov().spring;
    }
    return *input.spring;
}

/// Shows a value, and widens the slider where the case lies beyond it.
void showValue(ValueSlider* slider, double value, double min, double max) {
    const double low = std::min(min, value);
    const double high = std::max(max, value);
    if (low != slider->box()->minimum() || high != slider->box()->maximum()) {
        slider->setRange(low, high);
    }
    slider->setValue(value);
}

}  // namespace

ElasticHingePage::ElasticHingePage(QWidget* parent)
    : ScenePage(parent), model_(new ElasticHingeModel(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    row->setSpacing(Theme::space);
    row->addWidget(buildInputs());
    plots_ = new HingePlots(model_, this);
    row->addWidget(plots_, 5);
    row->addWidget(buildAnswer(), 2);

    connect(model_, &SceneModel::changed, this, &ElasticHingePage::showInput);
    connect(model_, &SceneModel::changed, this, &ElasticHingePage::showAnswer);
    connect(model_, &ElasticHingeModel::motionsChanged, this, &ElasticHingePage::showAnswer);
    connect(model_, &ElasticHingeModel::viewChanged, this, &ElasticHingePage::showCrank);
    connect(model_, &ElasticHingeModel::crankAngleChanged, this, &ElasticHingePage::showCrank);
    connect(model_, &ElasticHingeModel::refused, this, &ScenePage::status);
    showInput();
    showAnswer();
    showCrank();
}

SceneModel* ElasticHingePage::model() {
    return model_;
}

QList<QAction*> ElasticHingePage::sceneActions() {
    return {playAction_};
}

ValueSlider* ElasticHingePage::addSlider(QWidget* parent, const QString& name, const QString& label,
                                         double min, double max, double step, double page,
                                         int decimals, const QString& unit, const QString& stepName,
                                         const QString& hint,
                                         std::function<void(Input&, double)> write) {
    auto* slider = new ValueSlider(label, min, max, step, page, decimals, unit, parent);
    slider->slider()->setObjectName(name + QStringLiteral("_slider"));
    slider->box()->setObjectName(name);
    slider->setHint(hint);
    connect(slider, &ValueSlider::valueEdited, this, [this, stepName, write](double value) {
        if (!model_->edit(stepName, [&](Input& input) { write(input, value); }).isEmpty()) {
            showInput();  // refused: the slider goes back
        }
    });
    connect(slider, &ValueSlider::released, model_, &ElasticHingeModel::finishDrag);
    parent->layout()->addWidget(slider);
    return slider;
}

QWidget* ElasticHingePage::buildSliders() {
    auto* panel = new Panel(this);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(Theme::margin, Theme::space, Theme::margin, Theme::space);
    column->setSpacing(Theme::gap);
    omega_ = addSlider(panel, QStringLiteral("angular_speed_rad_s"), tr("&ω"), 0.0, 600.0, 1.0,
                       20.0, 1, tr("rad/s"), tr("Crank speed"),
                       tr("Crank speed that the hinges are designed for. Paper: 100, 300 and "
                          "500 rad/s."),
                       [](Input& input, double value) { input.angular_speed = value; });
    lambda_ = addSlider(panel, QStringLiteral("lambda"), tr("&λ"), 0.05, 0.99, 0.01, 0.1, 3, {},
                        tr("Ratio λ"),
                        tr("Crank radius to rod length. Paper: 0.3. Below 1; λ = 1 can be drawn "
                           "with the series only."),
                        [](Input& input, double value) { input.lambda = value; });
    stiffness_ = addSlider(
        panel, QStringLiteral("stiffness_kN_m"), tr("&c"), 1.0, 1e6, 0.1, 1.0, 1, tr("kN/m"),
        tr("Stiffness"),
        tr("Stiffness of the spring of the crank's hinge. Paper: 20 000 kN/m. "
           "A softer spring gives more relief."),
        [](Input& input, double value) { springOf(input).stiffness = value * kilonewtonPerMetre; });
    stiffness_->setLogarithmic(50, 3);
    radius_ = addSlider(panel, QStringLiteral("guide_radius_at_zero_mm"), tr("&ρ₀"), 1.0, 199.0,
                        0.01, 1.0, 3, tr("mm"), tr("Guide radius ρ₀"),
                        tr("Radius of the guide at φ = 0. Below ℓ₀/2 the spring is compressed, "
                           "above it is stretched. Paper: 90 mm."),
                        [](Input& input, double value) {
                            springOf(input).guide_radius_at_zero = value * field::millimetre;
                        });
    distance_ = addSlider(panel, QStringLiteral("counterweight_distance_mm"), tr("ℓ&₂"), 10.0,
                          300.0, 1.0, 10.0, 1, tr("mm"), tr("Counterweight's distance"),
                          tr("From the crankpin to the counterweight on the rod. Paper: 50, 100 "
                             "and 150 mm."),
                          [](Input& input, double value) {
                              if (input.rod_counterweight) {
                                  input.rod_counterweight->distance = value * field::millimetre;
                              }
                          });
    error_ = addSlider(
        panel, QStringLiteral("profile_error_um"), tr("&error"), 0.0, 100.0, 0.5, 5.0, 1, tr("µm"),
        tr("Profile error"),
        tr("Amplitude of the waves on the guide's profile as it is made. Good "
           "grinding leaves a few micrometres."),
        [](Input& input, double value) { input.profile_error = value * field::micrometre; });
    // One width for labels and boxes, so that the sliders stand in line.
    int labels = 0;
    const QList<ValueSlider*> all{omega_, lambda_, stiffness_, radius_, distance_, error_};
    for (ValueSlider* slider : all) {
        labels = std::max(labels, slider->findChild<QLabel*>()->sizeHint().width());
    }
    for (ValueSlider* slider : all) {
        slider->findChild<QLabel*>()->setFixedWidth(labels);
        slider->box()->setFixedWidth(boxWidth);
    }
    return panel;
}

QWidget* ElasticHingePage::buildInputs() {
    auto* holder = new QWidget(this);
    holder->setFixedWidth(300);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(Theme::space);
    column->addWidget(buildSliders());

    forms_ = new QTabWidget(holder);
    forms_->setDocumentMode(true);
    const auto addForm = [this](QWidget* form, const QString& name, const QString& title) {
        auto* scroll = scrolled(form, forms_);
        scroll->setObjectName(name);
        forms_->addTab(scroll, title);
    };
    addForm(new HingeInputs(model_), QStringLiteral("inputs"), tr("Inputs"));
    addForm(new GuideSearchForm(model_), QStringLiteral("search"), tr("Search"));
    export_ = new GuideExportForm(model_);
    connect(export_, &GuideExportForm::status, this, &ScenePage::status);
    addForm(export_, QStringLiteral("export"), tr("Export"));
    column->addWidget(forms_, 1);
    return holder;
}

QWidget* ElasticHingePage::buildAnswer() {
    auto* holder = new QWidget(this);
    holder->setMinimumWidth(312);
    holder->setMaximumWidth(460);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(Theme::space);

    picture_ = new HingeMechanismView(model_);
    auto* picturePanel = new PicturePanel(
        picture_, 360.0, tr("Crank angle of the picture, counter-clockwise from the slider line"),
        holder);
    playAction_ = picturePanel->action();
    playAction_->setToolTip(tr("Play the computed motion in slow motion"));
    animated_ = new QComboBox(picturePanel);
    animated_->setObjectName(QStringLiteral("animate"));
    animated_->addItems(
        {tr("without hinge"), tr("crank hinge"), tr("both hinges"), tr("off design")});
    animated_->setAccessibleName(tr("Which motion is played"));
    animated_->setToolTip(tr("Which of the computed motions the picture plays"));
    connect(animated_, &QComboBox::activated, this, [this](int index) {
        model_->setAnimated(static_cast<ElasticHingeModel::Animated>(index));
    });
    picturePanel->addControl(animated_);
    crank_ = picturePanel->slider();
    connect(crank_, &ValueSlider::valueEdited, picture_, &HingeMechanismView::turnTo);
    column->addWidget(picturePanel, 1);

    auto* answer = new Panel(holder);
    auto* answerColumn = new QVBoxLayout(answer);
    answerColumn->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    answerColumn->setSpacing(Theme::gap);
    verdict_ = new QLabel(answer);
    verdict_->setWordWrap(true);
    verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    verdict_->setObjectName(QStringLiteral("verdict"));
    answerColumn->addWidget(verdict_);
    auto* mend = new QHBoxLayout;
    takePreload_ = new QPushButton(tr("Take this pre&load"), answer);
    takePreload_->setObjectName(QStringLiteral("take_preload"));
    takeStiffness_ = new QPushButton(tr("Take this sti&ffness"), answer);
    takeStiffness_->setObjectName(QStringLiteral("take_stiffness"));
    connect(takePreload_, &QPushButton::clicked, model_,
            &ElasticHingeModel::takeMinimumPreload);
    connect(takeStiffness_, &QPushButton::clicked, model_,
            &ElasticHingeModel::takeMinimumStiffness);
    mend->addWidget(takePreload_);
    mend->addWidget(takeStiffness_);
    answerColumn->addLayout(mend);
    quantities_ = new ResultTable(answer);
    quantities_->setAccessibleName(tr("What the design gives"));
    quantities_->setColumns(model_->quantityColumns());
    quantities_->horizontalHeader()->hide();
    answerColumn->addWidget(quantities_);
    notes_ = captionLabel({}, answer);
    answerColumn->addWidget(notes_);
    column->addWidget(answer);
    return holder;
}

void ElasticHingePage::showInput() {
    const Input& input = model_->input();
    const bool series = input.kinematics == Kinematics::series;
    showValue(omega_, input.angular_speed, 0.0, 600.0);
    showValue(lambda_, input.lambda, 0.05, series ? 1.0 : 0.99);
    Input known = input;
    const Spring& spring = springOf(known);
    showValue(stiffness_, spring.stiffness / kilonewtonPerMetre, 1.0, 1e6);
    showValue(radius_, spring.guide_radius_at_zero / field::millimetre,
              std::min(1.0, 0.005 * spring.free_length / field::millimetre),
              spring.free_length / field::millimetre);
    distance_->setEnabled(input.rod_counterweight.has_value());
    const double distance =
        input.rod_counterweight ? input.rod_counterweight->distance : usualDistance;
    showValue(distance_, distance / field::millimetre, 10.0, 300.0);
    showValue(error_, input.profile_error / field::micrometre, 0.0, 100.0);
}

void ElasticHingePage::showAnswer() {
    using Level = ElasticHingeModel::Verdict::Level;
    const auto verdict = model_->verdict();
    const Theme& theme = Theme::instance();
    colourText(verdict_, verdict.level == Level::Good      ? theme.good()
                         : verdict.level == Level::Warning ? theme.warning()
                                                           : theme.error());
    verdict_->setText(verdict.text);
    const auto& guide = model_->result().crank_guide;
    const bool mendable = guide.problem == elastic_hinge::GuideProblem::preload_too_small;
    takePreload_->setVisible(mendable);
    takeStiffness_->setVisible(mendable && guide.minimum_stiffness &&
                               field::stiffness.range.contains(*guide.minimum_stiffness));
    quantities_->setRows(model_->quantityRows());
    notes_->setText(model_->notesText());
    notes_->setVisible(!notes_->text().isEmpty());
}

void ElasticHingePage::showCrank() {
    crank_->setValue(std::round(model_->crankAngleDeg()));
    animated_->setCurrentIndex(static_cast<int>(model_->animated()));
}

QString ElasticHingePage::resultsAsText() const {
    return quantities_->asText() + QLatin1Char('\n') + verdict_->text() + QLatin1Char('\n') +
           model_->motionsText() + QLatin1Char('\n');
}

QString ElasticHingePage::resultsAsCsv() const {
    return quantities_->asCsv();
}

}  // namespace ravnoves

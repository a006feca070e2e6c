#include "elastic-hinge/elastic_hinge_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <cmath>

#include "elastic-hinge/hinge_inputs.h"
#include "elastic-hinge/hinge_mechanism_view.h"
#include "elastic-hinge/model/guide_picture.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "page/rejected_verdict.h"
#include "theme/theme.h"
#include "widgets/job_progress.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using elastic_hinge::Branch;
using elastic_hinge::Hinge;
using elastic_hinge::Kinematics;
using elastic_hinge::Motion;
using elastic_hinge::Spring;

namespace {

/// The plots of the elastic-hinge page, by tabs.
class HingeTabs final : public QTabWidget {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::HingeTabs)

  public:
    HingeTabs(ElasticHingeModel* model, QWidget* parent);

  private:
    QVBoxLayout* addTab(const char* name, const QString& title);
    QHBoxLayout* addBar(QVBoxLayout* column);
    PartPlot* addPlot(QVBoxLayout* column, std::string_view part, int share = 1);
    /// Two over φ, whose cursor turns the crank.
    void addAnglePlots(QVBoxLayout* column, std::initializer_list<std::string_view> parts);
    PartPlot* addAnglePlot(QVBoxLayout* column, std::string_view part, int share = 1);
    void addGuides();
    void buildGuideBar(QHBoxLayout* bar);
    void addMotion();
    void addProgress(QHBoxLayout* bar);
    void showView();
    void showAngle();

    ElasticHingeModel* model_;
    PartPlot* guides_ = nullptr;
    PartPlot* speed_ = nullptr;
    QComboBox* hingeChoice_ = nullptr;
    QCheckBox* automatic_ = nullptr;
    ValueSlider* exaggeration_ = nullptr;
};

HingeTabs::HingeTabs(ElasticHingeModel* model, QWidget* parent)
    : QTabWidget(parent), model_(model) {
    constexpr int minimum = 300;  // designed pixels in which titles and texts can be read
    setMinimumWidth(Theme::withText(minimum));
    setDocumentMode(true);
    addGuides();
    addAnglePlots(addTab("rod-hinge", tr("R&od hinge")), {"rod-moment", "rod-moment-speeds"});
    addAnglePlots(addTab("side-force", tr("Sid&e force")),
                  {"side-force-lambdas", "side-force-speeds"});
    addAnglePlots(addTab("crank-moment", tr("Crank &moment")),
                  {"crank-moment", "crank-moment-speeds"});
    addMotion();
    for (const auto signal : {&SceneModel::changed, &SceneModel::viewChanged}) {
        connect(model, signal, this, &HingeTabs::showView);
    }
    connect(model->crank(), &CrankAngle::changed, this, &HingeTabs::showAngle);
    showView();
}

QVBoxLayout* HingeTabs::addTab(const char* name, const QString& title) {
    auto* tab = new QWidget(this);
    QVBoxLayout* column = columnIn(tab, Theme::space, {0, Theme::gap, 0, 0});
    addScrolledTab(this, tab, QString::fromLatin1(name), title);
    return column;
}

QHBoxLayout* HingeTabs::addBar(QVBoxLayout* column) {
    auto* bar = new Panel(column->parentWidget());
    column->addWidget(bar);
    return rowIn(bar, Theme::space, barMargins);
}

PartPlot* HingeTabs::addPlot(QVBoxLayout* column, std::string_view part, int share) {
    auto* plot = new PartPlot(model_, part, column->parentWidget());
    column->addWidget(plot, share);
    return plot;
}

PartPlot* HingeTabs::addAnglePlot(QVBoxLayout* column, std::string_view part, int share) {
    PartPlot* plot = addPlot(column, part, share);
    showCrankAngle(plot, model_->crank());
    return plot;
}

void HingeTabs::addAnglePlots(QVBoxLayout* column, std::initializer_list<std::string_view> parts) {
    QList<PlotView*> plots;
    for (const std::string_view part : parts) {
        plots << addAnglePlot(column, part);
    }
    PlotView::stack(plots);
}

void HingeTabs::addGuides() {
    QVBoxLayout* column = addTab("guides", tr("&Guides"));
    buildGuideBar(addBar(column));
    guides_ = addPlot(column, "guides", 5);
    addAnglePlot(column, "relief", 3);
}

void HingeTabs::buildGuideBar(QHBoxLayout* bar) {
    auto* folding = new FoldingRow(0, bar->parentWidget());
    bar->addWidget(folding);
    const auto addPart = [folding](int share) {
        auto* part = new QWidget(folding);
        QHBoxLayout* row = rowIn(part);
        folding->add(part, share);
        return row;
    };
    QHBoxLayout* row = addPart(0);
    hingeChoice_ = new QComboBox(this);
    hingeChoice_->setObjectName(QStringLiteral("guide_shown"));
    hingeChoice_->addItems(ElasticHingeModel::hingeNames());
    hingeChoice_->setAccessibleName(tr("Guide shown"));
    hingeChoice_->setToolTip(
        tr("Hinge between frame and crank alone (M), or with the rod's hinge (M₁), or "
           "hinge between crank and rod, over θ = φ + ψ"));
    connect(hingeChoice_, &QComboBox::activated, this,
            [this](int index) { model_->setShownHinge(static_cast<Hinge>(index)); });
    auto* label = new QLabel(tr("&Guide"), this);
    label->setBuddy(hingeChoice_);
    row->addWidget(label);
    row->addWidget(hingeChoice_, 1);
    row = addPart(1);
    constexpr Range factors = ElasticHingeModel::exaggerationField.range;
    exaggeration_ =
        new ValueSlider(tr("&Relief ×"), {factors.min, factors.max, 1.0, 10.0, 0, 12, 2}, {}, this);
    exaggeration_->slider()->setObjectName(QStringLiteral("exaggeration_slider"));
    exaggeration_->setHint(tr("Enlargement of the guide's relief; 1 is to scale"));
    connect(exaggeration_, &ValueSlider::valueEdited, this,
            [this](double factor) { model_->setExaggeration(factor); });
    row->addWidget(exaggeration_, 1);
    automatic_ = new QCheckBox(tr("a&uto"), this);
    automatic_->setObjectName(QStringLiteral("exaggeration_auto"));
    automatic_->setToolTip(tr("Choose the factor by the relief"));
    connect(automatic_, &QCheckBox::clicked, this, [this](bool on) {
        model_->setExaggeration(on ? std::nullopt : std::optional(model_->exaggeration()));
    });
    row->addWidget(automatic_);
}

void HingeTabs::addMotion() {
    QVBoxLayout* column = addTab("motion", tr("Mo&tion"));
    QHBoxLayout* bar = addBar(column);
    bar->addWidget(new PartText(model_, "motions", bar->parentWidget()), 1);
    addProgress(bar);
    speed_ = addPlot(column, "crank-speed");
}

void HingeTabs::addProgress(QHBoxLayout* bar) {
    auto* progress =
        new JobProgress(model_->runner(), tr("Progress of the motion"), bar->parentWidget());
    progress->setFixedWidth(Theme::withText(110));
    bar->addWidget(progress);
    QPushButton* cancel = progress->cancelButton(tr("Cancel"), tr("Stop computing the motion"));
    cancel->setObjectName(QStringLiteral("cancel_motion"));
    bar->addWidget(cancel);
}

void HingeTabs::showView() {
    hingeChoice_->setCurrentIndex(static_cast<int>(model_->shownHinge()));
    exaggeration_->setValue(model_->exaggeration());
    automatic_->setChecked(model_->hasAutomaticExaggeration());
    showAngle();
}

void HingeTabs::showAngle() {
    const GuidePicture picture(model_->shownGuide(), model_->exaggeration());
    std::vector<plot::Mark> marks;
    for (const auto& [branch, role] : {std::pair(Branch::compressed, Role::Compressed),
                                       std::pair(Branch::stretched, Role::Stretched)}) {
        if (const auto at = picture.centre(branch, model_->crank()->degrees() * degree)) {
            marks.push_back({at->x, at->y, {}, role});
        }
    }
    guides_->setMarks(std::move(marks));
    const Motion* motion = model_->animatedMotion();
    const auto time = model_->motionTime();
    speed_->setPresentX(
        motion != nullptr && time
            ? std::optional(std::abs(motion->angle_at(*time) - motion->crank_angle.front()) /
                            two_pi)
            : std::nullopt);
}

}  // namespace

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

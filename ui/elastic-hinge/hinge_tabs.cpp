#include "elastic-hinge/hinge_tabs.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "elastic-hinge/model/guide_picture.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "theme/theme.h"
#include "widgets/job_progress.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using elastic_hinge::Branch;
using elastic_hinge::Hinge;
using elastic_hinge::Motion;

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

}  // namespace ravnoves

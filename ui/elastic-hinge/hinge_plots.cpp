#include "elastic-hinge/hinge_plots.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

<<<<<<< HEAD
#include "elastic-hinge/rod_hinge_moment.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
=======
#include "theme/theme.h"
>>>>>>> 0cb8d862814a6ac41f3e36148e35d17870491622
#include "widgets/panel.h"

namespace ravnoves {

HingePlotTab::HingePlotTab(ElasticHingeViewModel* model, QWidget* parent)
    : QWidget(parent), model_(model), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(0, Theme::gap, 0, 0);
    column_->setSpacing(Theme::space);
}

QHBoxLayout* HingePlotTab::addBar() {
    auto* bar = new Panel(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    row->setSpacing(Theme::space);
    column_->addWidget(bar);
    return row;
}

<<<<<<< HEAD
HingePlots::HingePlots(ElasticHingeModel* model, QWidget* parent)
    : QTabWidget(parent), model_(model) {
    setDocumentMode(true);
    addTab(buildGuides(), tr("&Guides"));
    addTab(buildRodHinge(), tr("R&od hinge"));
    addTab(buildSideForce(), tr("Sid&e force"));
    addTab(buildCrankMoment(), tr("Crank &moment"));
    addTab(buildMotion(), tr("Mo&tion"));
    for (PlotView* plot : plots()) {
        if (plot != guide_ && plot != speed_) {
            connect(plot, &PlotView::cursorMoved, model_, [this](double phi) {
                model_->setMotionTime(std::nullopt);
                model_->setCrankAngleDeg(phi);
            });
        }
    }
    connect(this, &QTabWidget::currentChanged, this, &HingePlots::refresh);
    connect(model_, &SceneModel::changed, this, &HingePlots::refresh);
    connect(model_, &ElasticHingeModel::viewChanged, this, &HingePlots::refresh);
    connect(model_, &ElasticHingeModel::motionsChanged, this, [this] {
        if (currentWidget()->objectName() == QLatin1String("motion")) {
            showMotion();
        }
    });
    connect(model_, &ElasticHingeModel::crankAngleChanged, this, &HingePlots::showPresent);
    refresh();
}

QList<PlotView*> HingePlots::plots() const {
    return {guide_,      relief_,      rodMoment_,   rodSpeeds_, sideLambdas_,
            sideSpeeds_, crankMoment_, crankSpeeds_, speed_};
}

QList<PlotView*> HingePlots::frontPlots() const {
    return currentWidget()->findChildren<PlotView*>();
}

void HingePlots::resetZoom() {
    for (PlotView* plot : plots()) {
        plot->resetZoom();
    }
}

PlotView* HingePlots::makePlot(const QString& title, QWidget* parent) {
    auto* plot = new PlotView(title, parent);
    plot->setXAxis({tr("φ, °"), 0.0, 360.0, true});
=======
PlotView* HingePlotTab::addPlot(const QString& title, const PlotView::Axis& x, const QString& y,
                                int share) {
    auto* plot = new PlotView(title, this);
    plot->setXAxis(x);
    plot->setYAxis(PlotView::Side::Left, {y});
    column_->addWidget(plot, share);
    plots_ << plot;
>>>>>>> 0cb8d862814a6ac41f3e36148e35d17870491622
    return plot;
}

PlotView* HingePlotTab::addAnglePlot(const QString& title, const QString& y, int share) {
    PlotView* plot = addPlot(title, {HingePlots::tr("φ, °"), 0.0, 360.0, true}, y, share);
    connect(plot, &PlotView::cursorMoved, model_, [this](double phi) {
        model_->setMotionTime(std::nullopt);
        model_->setCrankAngleDeg(phi);
    });
    anglePlots_ << plot;
    return plot;
}

void HingePlotTab::showAll() {
    refresh();
    showAngle();
}

void HingePlotTab::showAngle() {
    for (PlotView* plot : anglePlots_) {
        plot->setPresentX(model_->crankAngleDeg());
    }
    showPresent();
}

HingePlots::HingePlots(ElasticHingeViewModel* model, QWidget* parent) : QTabWidget(parent) {
    setDocumentMode(true);
    append(makeGuideTab(model, this), QStringLiteral("guides"), tr("&Guides"));
    append(makeRodHingeTab(model, this), QStringLiteral("rod-hinge"), tr("R&od hinge"));
    append(makeSideForceTab(model, this), QStringLiteral("side-force"), tr("Sid&e force"));
    append(makeCrankMomentTab(model, this), QStringLiteral("crank-moment"), tr("Crank &moment"));
    append(makeMotionTab(model, this), QStringLiteral("motion"), tr("Mo&tion"));
    connect(this, &QTabWidget::currentChanged, this, &HingePlots::refresh);
    connect(model, &SceneViewModel::changed, this, &HingePlots::refresh);
    connect(model, &ElasticHingeViewModel::viewChanged, this, &HingePlots::refresh);
    connect(model, &ElasticHingeViewModel::motionsChanged, this, [this] {
        if (currentWidget() == tabs_.back()) {
            tabs_.back()->refresh();
        }
    });
    connect(model, &ElasticHingeViewModel::crankAngleChanged, this,
            [this] { tabs_[currentIndex()]->showAngle(); });
    refresh();
}

void HingePlots::append(HingePlotTab* tab, const QString& name, const QString& title) {
    tab->setObjectName(name);
    tabs_ << tab;
    addTab(tab, title);
}

void HingePlots::refresh() {
    tabs_[currentIndex()]->showAll();
}

QPushButton* HingePlots::cancelButton() const {
    return tabs_.back()->findChild<QPushButton*>();
}

}  // namespace ravnoves

#include "elastic-hinge/hinge_plots.h"

#include <QPushButton>
#include <QVBoxLayout>

#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"

namespace ravnoves {

HingePlotTab::HingePlotTab(ElasticHingeModel* model, QWidget* parent)
    : QWidget(parent), model_(model), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(0, Theme::gap, 0, 0);
    column_->setSpacing(Theme::space);
}

QHBoxLayout* HingePlotTab::addBar() {
    auto* bar = new Panel(this);
    QHBoxLayout* row = rowIn(bar, Theme::space, barMargins);
    column_->addWidget(bar);
    return row;
}

PlotView* HingePlotTab::addPlot(const QString& title, const PlotView::Axis& x, const QString& y,
                                int share) {
    auto* plot = new PlotView(title, this);
    plot->setXAxis(x);
    plot->setYAxis(PlotView::Side::Left, {y});
    column_->addWidget(plot, share);
    plots_ << plot;
    return plot;
}

PlotView* HingePlotTab::addAnglePlot(const QString& title, const QString& y, int share) {
    PlotView* plot = addPlot(title, {HingePlots::tr("φ, °"), 0.0, 360.0, true}, y, share);
    connect(plot, &PlotView::cursorMoved, model_, [this](double phi) {
        model_->setMotionTime(std::nullopt);
        model_->crank()->turnTo(phi);
    });
    anglePlots_ << plot;
    PlotView::stack(anglePlots_);
    return plot;
}

void HingePlotTab::showAll() {
    refresh();
    showAngle();
}

void HingePlotTab::showAngle() {
    for (PlotView* plot : anglePlots_) {
        plot->setPresentX(model_->crank()->degrees());
    }
    showPresent();
}

HingePlots::HingePlots(ElasticHingeModel* model, QWidget* parent) : QTabWidget(parent) {
    constexpr int least = 300;  // designed pixels in which titles and texts can be read
    setMinimumWidth(Theme::withText(least));
    setDocumentMode(true);
    append(makeGuideTab(model, this), QStringLiteral("guides"), tr("&Guides"));
    append(makeRodHingeTab(model, this), QStringLiteral("rod-hinge"), tr("R&od hinge"));
    append(makeSideForceTab(model, this), QStringLiteral("side-force"), tr("Sid&e force"));
    append(makeCrankMomentTab(model, this), QStringLiteral("crank-moment"), tr("Crank &moment"));
    append(makeMotionTab(model, this), QStringLiteral("motion"), tr("Mo&tion"));
    connect(this, &QTabWidget::currentChanged, this, &HingePlots::refresh);
    connect(model, &SceneModel::changed, this, &HingePlots::refresh);
    connect(model, &ElasticHingeModel::viewChanged, this, &HingePlots::refresh);
    // In front or not: on the page of a reference nobody changes the tab again.
    connect(model, &ElasticHingeModel::motionsChanged, this, [this] { tabs_.back()->refresh(); });
    connect(model->crank(), &CrankAngle::changed, this,
            [this] { tabs_[currentIndex()]->showAngle(); });
    refresh();
}

void HingePlots::append(HingePlotTab* tab, const QString& name, const QString& title) {
    tabs_ << tab;
    addScrolledTab(this, tab, name, title);
}

void HingePlots::refresh() {
    tabs_[currentIndex()]->showAll();
}

QPushButton* HingePlots::cancelButton() const {
    return tabs_.back()->findChild<QPushButton*>();
}

}  // namespace ravnoves

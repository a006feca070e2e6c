#pragma once

#include <QWidget>

#include "elastic-hinge/elastic_hinge_view_model.h"
#include "plot/plot_view.h"

class QHBoxLayout;
class QVBoxLayout;

namespace ravnoves {

/// One tab of HingePlots: plots over one another, below a bar where there is one.
class HingePlotTab : public QWidget {
  public:
    HingePlotTab(ElasticHingeViewModel* model, QWidget* parent);

    /// Shows what the model has computed.
    std::function<void()> refresh;
    /// Shows the present crank angle beside the line that each plot over φ has.
    std::function<void()> showPresent = [] {};

    const QList<PlotView*>& plots() const { return plots_; }
    void showAll();
    void showAngle();
    QHBoxLayout* addBar();
    PlotView* addPlot(const QString& title, const PlotView::Axis& x, const QString& y,
                      int share = 1);
    /// A plot over φ, whose cursor turns the crank.
    PlotView* addAnglePlot(const QString& title, const QString& y, int share = 1);

  private:
    ElasticHingeViewModel* model_;
    QVBoxLayout* column_;
    QList<PlotView*> plots_;
    QList<PlotView*> anglePlots_;
};

HingePlotTab* makeGuideTab(ElasticHingeViewModel* model, QWidget* parent);
HingePlotTab* makeRodHingeTab(ElasticHingeViewModel* model, QWidget* parent);
HingePlotTab* makeSideForceTab(ElasticHingeViewModel* model, QWidget* parent);
HingePlotTab* makeCrankMomentTab(ElasticHingeViewModel* model, QWidget* parent);
HingePlotTab* makeMotionTab(ElasticHingeViewModel* model, QWidget* parent);

}  // namespace ravnoves

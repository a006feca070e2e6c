#pragma once

#include <QWidget>

#include "elastic-hinge/model/elastic_hinge_model.h"
#include "plot/plot_view.h"

class QHBoxLayout;
class QVBoxLayout;

namespace ravnoves {

/// One tab of HingePlots: plots over one another, below a bar where there is one.
class HingePlotTab : public QWidget {
  public:
    HingePlotTab(ElasticHingeModel* model, QWidget* parent);

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
    ElasticHingeModel* model_;
    QVBoxLayout* column_;
    QList<PlotView*> plots_;
    QList<PlotView*> anglePlots_;
};

HingePlotTab* makeGuideTab(ElasticHingeModel* model, QWidget* parent);
HingePlotTab* makeRodHingeTab(ElasticHingeModel* model, QWidget* parent);
HingePlotTab* makeSideForceTab(ElasticHingeModel* model, QWidget* parent);
HingePlotTab* makeCrankMomentTab(ElasticHingeModel* model, QWidget* parent);
HingePlotTab* makeMotionTab(ElasticHingeModel* model, QWidget* parent);

}  // namespace ravnoves

#pragma once

#include <QTabWidget>

#include "elastic-hinge/hinge_plot_tab.h"

class QPushButton;

namespace ravnoves {

/// The plots of the elastic-hinge page, two to a tab: guides, rod hinge, side force, crank moment,
/// motion. Only the tab in front is kept up to date; another is filled when it comes to the front.
class HingePlots : public QTabWidget {
    Q_OBJECT

  public:
    explicit HingePlots(ElasticHingeModel* model, QWidget* parent = nullptr);

    // For tests.
    PlotView* guidePlot() const { return tabs_[0]->plots()[0]; }
    PlotView* reliefPlot() const { return tabs_[0]->plots()[1]; }
    PlotView* rodMomentPlot() const { return tabs_[1]->plots()[0]; }
    PlotView* rodSpeedsPlot() const { return tabs_[1]->plots()[1]; }
    PlotView* sideLambdasPlot() const { return tabs_[2]->plots()[0]; }
    PlotView* sideSpeedsPlot() const { return tabs_[2]->plots()[1]; }
    PlotView* crankMomentPlot() const { return tabs_[3]->plots()[0]; }
    PlotView* speedPlot() const { return tabs_[4]->plots()[0]; }
    QPushButton* cancelButton() const;

  private:
    void append(HingePlotTab* tab, const QString& name, const QString& title);
    void refresh();

    QList<HingePlotTab*> tabs_;
};

}  // namespace ravnoves

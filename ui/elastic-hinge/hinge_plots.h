#pragma once

#include <QTabWidget>

<<<<<<< HEAD
#include "elastic-hinge/model/elastic_hinge_model.h"
#include "plot/plot_view.h"
=======
#include "elastic-hinge/hinge_plot_tab.h"
>>>>>>> 0cb8d862814a6ac41f3e36148e35d17870491622

class QPushButton;

namespace ravnoves {

/// The plots of the elastic-hinge page, two to a tab: guides, rod hinge, side force, crank moment,
/// motion. Only the tab in front is kept up to date; another is filled when it comes to the front.
class HingePlots : public QTabWidget {
    Q_OBJECT

  public:
    explicit HingePlots(ElasticHingeModel* model, QWidget* parent = nullptr);

    void resetZoom() { resetAllZoom(this); }

    // For tests.
    PlotView* guidePlot() const { return tabs_[0]->plots()[0]; }
    PlotView* reliefPlot() const { return tabs_[0]->plots()[1]; }
    PlotView* rodMomentPlot() const { return tabs_[1]->plots()[0]; }
    PlotView* rodSpeedsPlot() const { return tabs_[1]->plots()[1]; }
    PlotView* sideLambdasPlot() const { return tabs_[2]->plots()[0]; }
    PlotView* sideSpeedsPlot() const { return tabs_[2]->plots()[1]; }
    PlotView* crankMomentPlot() const { return tabs_[3]->plots()[0]; }
    PlotView* crankSpeedsPlot() const { return tabs_[3]->plots()[1]; }
    PlotView* speedPlot() const { return tabs_[4]->plots()[0]; }
    QPushButton* cancelButton() const;

  private:
    void append(HingePlotTab* tab, const QString& name, const QString& title);
    void refresh();

<<<<<<< HEAD
    ElasticHingeModel* model_;
    PlotView* guide_ = nullptr;
    PlotView* relief_ = nullptr;
    PlotView* rodMoment_ = nullptr;
    PlotView* rodSpeeds_ = nullptr;
    PlotView* sideLambdas_ = nullptr;
    PlotView* sideSpeeds_ = nullptr;
    PlotView* crankMoment_ = nullptr;
    PlotView* crankSpeeds_ = nullptr;
    PlotView* speed_ = nullptr;
    QComboBox* hingeChoice_ = nullptr;
    QCheckBox* automatic_ = nullptr;
    ValueSlider* exaggeration_ = nullptr;
    QLabel* motionText_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QPushButton* cancel_ = nullptr;

    Pieces guideCompressed_, guideStretched_, profile_;
    int circleCompressed_ = 0, circleStretched_ = 0;
    Pieces reliefCompressed_, reliefStretched_;
    int m12_ = 0, m12Potential_ = 0, m12Other_ = 0;
    Family m12Speeds_, withLambdas_, withoutSpeeds_, m1Speeds_;
    int tenfold_ = 0;
    int m_ = 0, m1_ = 0;
    int without_ = 0, crank_ = 0, both_ = 0, off_ = 0;
    double guideReach_ = 0.0;
    double shownTurns_ = 0.0;
    bool narrow_ = false;  ///< the relief plot counts in µm
=======
    QList<HingePlotTab*> tabs_;
>>>>>>> 0cb8d862814a6ac41f3e36148e35d17870491622
};

}  // namespace ravnoves

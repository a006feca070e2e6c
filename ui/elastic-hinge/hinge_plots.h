#pragma once

#include <QTabWidget>
#include <array>
#include <vector>

#include "elastic-hinge/model/elastic_hinge_model.h"
#include "plot/plot_view.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QCheckBox;

namespace ravnoves {

class ValueSlider;

/// The plots of the elastic-hinge page, two to a tab: guides, rod hinge, side force, crank moment,
/// motion. Only the tab in front is kept up to date; another is filled when it comes to the front.
class HingePlots : public QTabWidget {
    Q_OBJECT

  public:
    explicit HingePlots(ElasticHingeModel* model, QWidget* parent = nullptr);

    QList<PlotView*> plots() const;
    /// The plots of the tab in front.
    QList<PlotView*> frontPlots() const;
    void resetZoom();

    // For tests.
    PlotView* guidePlot() const { return guide_; }
    PlotView* reliefPlot() const { return relief_; }
    PlotView* rodMomentPlot() const { return rodMoment_; }
    PlotView* rodSpeedsPlot() const { return rodSpeeds_; }
    PlotView* sideLambdasPlot() const { return sideLambdas_; }
    PlotView* sideSpeedsPlot() const { return sideSpeeds_; }
    PlotView* crankMomentPlot() const { return crankMoment_; }
    PlotView* crankSpeedsPlot() const { return crankSpeeds_; }
    PlotView* speedPlot() const { return speed_; }
    QPushButton* cancelButton() const { return cancel_; }

  private:
    /// A curve that may have gaps: one curve of the plot for each piece, the first in the legend.
    struct Pieces {
        static constexpr std::size_t most = 3;
        std::array<int, most> curves{};
    };
    /// A curve for each member of a family.
    struct Family {
        static constexpr std::size_t most = 6;
        std::array<int, most> curves{};
    };

    /// The profile's curve; without a name it has no legend entry.
    static PlotView::CurveStyle profileStyle(const QString& name);
    PlotView* makePlot(const QString& title, QWidget* parent);
    Pieces addPieces(PlotView* plot, const PlotView::CurveStyle& style);
    void setPieces(PlotView* plot, const Pieces& pieces, const std::vector<double>& x,
                   const std::vector<double>& y, bool closed);
    Family addFamily(PlotView* plot);

    QWidget* buildGuides();
    QWidget* buildRodHinge();
    QWidget* buildSideForce();
    QWidget* buildCrankMoment();
    QWidget* buildMotion();
    QWidget* makeTab(const QString& name, QWidget* bar, PlotView* upper, int upperShare,
                     PlotView* lower, int lowerShare);

    void refresh();
    void showGuides();
    void showRodHinge();
    void showSideForce();
    void showCrankMoment();
    void showMotion();
    void showPresent();

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
};

}  // namespace ravnoves

#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "balance-shaft/solver.h"
#include "balance-shaft/speed_study.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ravnoves {

class BackgroundJob;
class BalanceShaftModel;
class NumberField;
class PlotView;
class ValueSlider;

/// The shaft over a band of speeds: best α over speed, a map of range or RMS over (α, speed), the α
/// that is least bad over the band, and sliders for speed and load. Solved off the GUI thread.
class SpeedView : public QWidget {
    Q_OBJECT

  public:
    explicit SpeedView(BalanceShaftModel* model, QWidget* parent = nullptr);

    BackgroundJob* job() const { return job_; }
    PlotView* anglePlot() const { return angles_; }
    PlotView* mapPlot() const { return map_; }
    QString answer() const;

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    struct Study {
        std::shared_ptr<const balance_shaft::SpeedStudy> study;
        std::optional<balance_shaft::SpeedStudy::Map> map;
        // Of the angles that can be built, or of all where none can.
        balance_shaft::SpeedStudy::LeastBad range;
        balance_shaft::SpeedStudy::LeastBad rms;
        balance_shaft::SpeedStudy::LeastBad rangeOfAll;
        balance_shaft::SpeedStudy::LeastBad rmsOfAll;
    };

    balance_shaft::SpeedBand band() const;
    void solveAgain();
    void showInput();
    void showStudy();
    void showMap();

    BalanceShaftModel* model_;
    BackgroundJob* job_;
    ValueSlider* speed_;
    ValueSlider* load_;
    NumberField* from_;
    NumberField* to_;
    QComboBox* criterion_;
    QProgressBar* progress_;
    QPushButton* cancel_;
    QPushButton* goLeastBad_;
    QLabel* answer_;
    PlotView* angles_;
    PlotView* map_;
    int rangeAngle_ = 0;
    int rmsAngle_ = 0;
    int bestLine_ = 0;
    Study study_;
    bool stale_ = true;
    std::optional<balance_shaft::Input> solvedInput_;
};

}  // namespace ravnoves

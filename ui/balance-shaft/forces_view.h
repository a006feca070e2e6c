#pragma once

#include <QWidget>

class QSpinBox;

namespace ravnoves {

class BalanceShaftModel;
class NumberField;
class PlotView;
class ResultTable;
class ValueSlider;

/// Forces on the engine without a shaft (share κ balanced on the crank alone) beside the shaft's,
/// and what a shaft fitted some teeth out, and the play of its gears, do.
class ForcesView : public QWidget {
    Q_OBJECT

  public:
    explicit ForcesView(BalanceShaftModel* model, QWidget* parent = nullptr);

    ValueSlider* shareSlider() const { return share_; }
    QSpinBox* shiftedTeeth() const { return shifted_; }
    PlotView* locusPlot() const { return locus_; }
    PlotView* gearPlot() const { return gears_; }

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void showInput();
    void showLocus();
    void showGears();

    BalanceShaftModel* model_;
    ValueSlider* share_;
    QSpinBox* teeth_;
    QSpinBox* shifted_;
    NumberField* backlash_;
    PlotView* locus_;
    PlotView* gears_;
    ResultTable* forceTable_;
    ResultTable* gearTable_;
    int first_ = 0;
    int both_ = 0;
    int shaft_ = 0;
    int right_ = 0;
    int wrong_ = 0;
    int low_ = 0;
    int high_ = 0;
};

}  // namespace ravnoves

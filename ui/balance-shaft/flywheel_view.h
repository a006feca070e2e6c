#pragma once

#include <QWidget>

namespace ravnoves {

class BalanceShaftModel;
class PlotView;
class ResultTable;

/// What the engine torque does to the speed: the excess energy over φ with its extremes, the
/// coefficient of fluctuation of a moment of inertia or the inertia for a coefficient.
class FlywheelView : public QWidget {
    Q_OBJECT

  public:
    explicit FlywheelView(BalanceShaftModel* model, QWidget* parent = nullptr);

    PlotView* plot() const { return plot_; }
    ResultTable* table() const { return table_; }

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    QWidget* buildForm();
    void showResult();

    BalanceShaftModel* model_;
    PlotView* plot_;
    ResultTable* table_;
    int energy_ = 0;
};

}  // namespace ravnoves

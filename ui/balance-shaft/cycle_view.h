#pragma once

#include <QWidget>

class QLabel;
class QStackedLayout;

namespace ravnoves {

class BalanceShaftModel;
class PlotView;
class ResultTable;

/// What a computed torque is made of: gas and inertia torque over φ, pressure over φ and over the
/// volume, work and power. For a table it says where to choose another source.
class CycleView : public QWidget {
    Q_OBJECT

  public:
    explicit CycleView(BalanceShaftModel* model, QWidget* parent = nullptr);

    PlotView* torquePlot() const { return torque_; }

  private:
    void showResult();

    BalanceShaftModel* model_;
    QStackedLayout* stack_;
    PlotView* torque_;
    PlotView* pressure_;
    PlotView* indicator_;
    ResultTable* table_;
    int total_ = 0;
    int gas_ = 0;
    int inertia_ = 0;
    int offset_ = 0;
    int pressureCurve_ = 0;
    int loop_ = 0;
};

}  // namespace ravnoves

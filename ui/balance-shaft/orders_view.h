#pragma once

#include <QWidget>

namespace ravnoves {

class BalanceShaftModel;
class PlotView;
class ResultTable;

/// Order spectrum of M_up and M_ups with half orders, as bars and as a table.
class OrdersView : public QWidget {
    Q_OBJECT

  public:
    explicit OrdersView(BalanceShaftModel* model, QWidget* parent = nullptr);

    PlotView* plot() const { return plot_; }

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void showResult();

    BalanceShaftModel* model_;
    PlotView* plot_;
    ResultTable* table_;
    int up_ = 0;
    int ups_ = 0;
};

}  // namespace ravnoves

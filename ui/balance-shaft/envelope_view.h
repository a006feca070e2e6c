#pragma once

#include <QWidget>

#include "balance-shaft/model/shown_curves.h"

namespace ravnoves {

class BalanceShaftModel;
class PlotView;

/// Overall size over α, and range of the moment against overall size with α along the curve.
class EnvelopeView : public QWidget {
    Q_OBJECT

  public:
    explicit EnvelopeView(BalanceShaftModel* model, QWidget* parent = nullptr);

    PlotView* sizePlot() const { return sizes_; }
    PlotView* paretoPlot() const { return pareto_; }

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void solve();
    void showPresent();

    BalanceShaftModel* model_;
    PlotView* sizes_;
    PlotView* pareto_;
    ShownSizes shown_;
    int width_ = 0;
    int height_ = 0;
    int all_ = 0;
    int built_ = 0;
    int efficient_ = 0;
    int present_ = 0;
    bool stale_ = true;
};

}  // namespace ravnoves

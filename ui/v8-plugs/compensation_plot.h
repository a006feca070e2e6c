#pragma once

#include <vector>

#include "plot/plot_view.h"
#include "v8-plugs/solver.h"

namespace ravnoves {

/// The excess that each option compensates over the lightening of one plug: the paper's lines
/// (15)–(18) up to their limits, today's excess, and the point of the option chosen.
class CompensationPlot : public PlotView {
    Q_OBJECT

  public:
    explicit CompensationPlot(QWidget* parent = nullptr);
    /// As low as it can be read, so that the page needs no scroll bar for it.
    QSize sizeHint() const override { return {420, minimumSizeHint().height()}; }

    void showSolution(const v8_plugs::Result& solution);

  private:
    std::vector<int> curves_;
    double shownReach_ = 0.0;  // right end of the x axis, g
};

}  // namespace ravnoves

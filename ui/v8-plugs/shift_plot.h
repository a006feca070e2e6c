#pragma once

#include <optional>

#include "plot/plot_view.h"

namespace ravnoves {

/// What a shift Δr of the plug's centre of mass does to the coefficient, Δk = Δr / r, for the five
/// crank radii of the paper's Fig. 2 and for this engine's.
class ShiftPlot : public PlotView {
    Q_OBJECT

  public:
    explicit ShiftPlot(QWidget* parent = nullptr);
    /// As low as it can be read, so that the page needs no scroll bar for it.
    QSize sizeHint() const override { return {420, minimumSizeHint().height()}; }

    /// @param crankRadius  of this engine, m
    void showRadius(const std::optional<double>& crankRadius);

  private:
    int own_ = 0;
};

}  // namespace ravnoves

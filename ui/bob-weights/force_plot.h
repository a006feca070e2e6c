#pragma once

#include "plot/plot_view.h"

namespace ravnoves {

class BobWeightsModel;

/// The first-order force of the cylinders that a bob weight stands for, over a turn of the crank:
/// without counterweights, and what is left of it with them. As masses at the crank radius.
class ForcePlot : public PlotView {
    Q_OBJECT

  public:
    explicit ForcePlot(BobWeightsModel* model, QWidget* parent = nullptr);
    QSize sizeHint() const override { return {260, 240}; }

  private:
    void showForce();

    BobWeightsModel* model_;
    double reach_ = 0.0;  // of both axes, g
};

}  // namespace ravnoves

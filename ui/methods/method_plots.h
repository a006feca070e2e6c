#pragma once

#include "methods/model/methods_model.h"
#include "plot/plot_view.h"
#include "widgets/page_columns.h"

namespace ravnoves {

/// The two charts of a kernel over one scale of errors: time against error (work and precision),
/// and error along the hard parameter (stability).
///
/// Both follow the newest measurement and are dimmed while a newer one is measured. An error of 0,
/// which has no logarithm, is drawn at the bottom; where a method rejects, its curve has a gap.
class MethodPlots : public FoldingRow {
    Q_OBJECT

  public:
    explicit MethodPlots(MethodsModel* model, QWidget* parent = nullptr);

  private:
    void follow();

    MethodsModel* model_;
    PlotView* work_;
    PlotView* stability_;
};

}  // namespace ravnoves

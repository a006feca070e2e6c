#include "bob-weights/force_plot.h"

#include <algorithm>
#include <utility>

#include "bob-weights/model/bob_weights_model.h"
#include "text/number_text.h"

namespace ravnoves {

using namespace bob_weights;

namespace {

enum ForceCurve { withoutWeights, leftOver };

std::vector<double> inGrams(std::vector<double> masses) {
    for (double& mass : masses) {
        mass = mass / units::gram;
    }
    return masses;
}

}  // namespace

ForcePlot::ForcePlot(BobWeightsModel* model, QWidget* parent)
    : PlotView(tr("First-order force"), parent), model_(model) {
    setAccessibleName(tr("First-order force of the cylinders on a bob weight, over a turn"));
    setEqualScale(true);
    const QString gram = unitText(units::gram.name);
    setYAxis(Side::Left, {tr("upright, %1").arg(gram)});
    addCurve({.name = tr("without counterweights"),
              .colour = 1,
              .pen = Qt::DashLine,
              .toolTip = tr("Of the reciprocating parts alone, as a mass at the crank radius"),
              .turn = 360.0});
    addCurve({.name = tr("left"),
              .colour = 0,
              .width = 2.2,
              .toolTip = tr("What is left by counterweights that hold the bob weight"),
              .turn = 360.0});
    connect(model_, &SceneModel::changed, this, &ForcePlot::showForce);
    showForce();
}

void ForcePlot::showForce() {
    const Result& result = model_->solution();
    if (!result.first_order) {
        setCurve(withoutWeights, {}, {});
        setCurve(leftOver, {}, {});
        return;
    }
    for (const auto& [curve, force] : {std::pair{withoutWeights, *result.first_order_bare},
                                       std::pair{leftOver, *result.first_order}}) {
        ForcePath path = force_path(force);
        setCurve(curve, inGrams(std::move(path.across)), inGrams(std::move(path.upright)));
    }
    const double reach =
        1.15 * std::max(result.first_order_bare->greatest(), result.first_order->greatest()) /
        units::gram;
    // The axes stay while the masses change a little.
    if (reach > 0.0 && (reach > reach_ || reach < 0.6 * reach_)) {
        reach_ = 1.1 * reach;
        setXAxis({tr("across, %1").arg(unitText(units::gram.name)), -reach_, reach_});
        setYRange(Side::Left, -reach_, reach_);
    }
}

}  // namespace ravnoves

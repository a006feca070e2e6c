#include "bob-weights/force_plot.h"

#include <cmath>

#include "bob-weights/model/bob_weights_model.h"
#include "text/number_text.h"

namespace ravnoves {

using namespace bob_weights;

namespace {

enum ForceCurve { withoutWeights, leftOver };

/// The ellipse over a turn, g.
std::pair<std::vector<double>, std::vector<double>> ellipse(const FirstOrder& force) {
    constexpr int steps = 180;
    std::vector<double> across;
    std::vector<double> upright;
    for (int i = 0; i <= steps; ++i) {
        const double phi = two_pi * i / steps;
        across.push_back((force.forward - force.backward) * std::sin(phi) / units::gram);
        upright.push_back((force.forward + force.backward) * std::cos(phi) / units::gram);
    }
    return {std::move(across), std::move(upright)};
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
    const FirstOrder bare = first_order(model_->input().engine, 0.0, *result.reciprocating);
    auto [x, y] = ellipse(bare);
    setCurve(withoutWeights, std::move(x), std::move(y));
    auto [leftX, leftY] = ellipse(*result.first_order);
    setCurve(leftOver, std::move(leftX), std::move(leftY));
    const double reach =
        1.15 * std::max(bare.greatest(), result.first_order->greatest()) / units::gram;
    // The axes stay while the masses change a little.
    if (reach > 0.0 && (reach > reach_ || reach < 0.6 * reach_)) {
        reach_ = 1.1 * reach;
        setXAxis({tr("across, %1").arg(unitText(units::gram.name)), -reach_, reach_});
        setYRange(Side::Left, -reach_, reach_);
    }
}

}  // namespace ravnoves

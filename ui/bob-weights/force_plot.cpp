#include "bob-weights/force_plot.h"

#include "bob-weights/model/bob_weights_model.h"
#include "bob-weights/model/shown_force.h"
#include "text/number_text.h"

namespace ravnoves {

namespace {

enum ForceCurve { withoutWeights, leftOver };

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
    const auto shown = shownForce(model_->solution());
    if (!shown) {
        setCurve(withoutWeights, {}, {});
        setCurve(leftOver, {}, {});
        return;
    }
    setCurve(withoutWeights, shown->bare.across, shown->bare.upright);
    setCurve(leftOver, shown->left.across, shown->left.upright);
    if (const double reach = steadyReach(shown->reach, reach_); reach != reach_) {
        reach_ = reach;
        setXAxis({tr("across, %1").arg(unitText(units::gram.name)), -reach_, reach_});
        setYRange(Side::Left, -reach_, reach_);
    }
}

}  // namespace ravnoves

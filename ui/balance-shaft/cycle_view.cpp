#include "balance-shaft/cycle_view.h"

#include <QGridLayout>
#include <QLabel>
#include <QStackedLayout>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/shown_curves.h"
#include "page/mechanism_picture.h"
#include "plot/plot_view.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"

namespace ravnoves {

CycleView::CycleView(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(model), stack_(new QStackedLayout(this)) {
    auto* hint =
        new QLabel(tr("The torque is a table.\nChoose “pressure trace” or “computed cycle” "
                      "on the Torque tab to see gas and inertia torque, pressure and "
                      "indicator diagram."),
                   this);
    hint->setAlignment(Qt::AlignCenter);
    hint->setWordWrap(true);
    hint->setMargin(Theme::margin * 3);
    stack_->addWidget(hint);

    auto* plots = new QWidget(this);
    auto* grid = new QGridLayout(plots);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(Theme::space);
    torque_ = new PlotView(tr("Engine torque and its parts"), plots);
    torque_->setYAxis(PlotView::Side::Left, {tr("N·m")});
    gas_ = torque_->addCurve({.name = tr("gas"), .colour = 1, .toolTip = tr("−(p − p₀) A s′")});
    inertia_ =
        torque_->addCurve({.name = tr("inertia"), .colour = 3, .toolTip = tr("−mⱼ ω² s′ s″")});
    offset_ = torque_->addCurve({.name = tr("offset"),
                                 .colour = 5,
                                 .pen = Qt::DashLine,
                                 .toolTip = tr("e mⱼ ω² s″: what an offset cylinder adds to Mᵤₚ")});
    total_ = torque_->addCurve({.name = tr("engine torque"),
                                .colour = 2,
                                .width = 2.0,
                                .toolTip = tr("Gas plus inertia")});
    showCrankAngle(torque_, model_->crank());
    pressure_ = new PlotView(tr("Cylinder pressure"), plots);
    pressure_->setYAxis(PlotView::Side::Left, {tr("bar")});
    pressureCurve_ =
        pressure_->addCurve({.name = tr("p"), .colour = 7, .width = 1.8, .inLegend = false});
    showCrankAngle(pressure_, model_->crank());
    indicator_ = new PlotView(tr("Indicator diagram, p–V"), plots);
    indicator_->setYAxis(PlotView::Side::Left, {tr("bar")});
    loop_ = indicator_->addCurve({.name = tr("p"), .colour = 7, .width = 1.8, .inLegend = false});
    auto* panel = new Panel(plots);
    QVBoxLayout* column = columnIn(panel, -1, tableMargins);
    table_ = new ResultTable(tr("Work, pressures and power of the cycle"), panel);
    table_->setColumns({tr("Cycle"), tr("Value"), tr("Unit")});
    column->addWidget(table_);
    grid->addWidget(torque_, 0, 0, 1, 2);
    grid->addWidget(pressure_, 1, 0);
    grid->addWidget(indicator_, 1, 1);
    grid->addWidget(panel, 2, 0, 1, 2);
    grid->setRowStretch(0, 3);
    grid->setRowStretch(1, 3);
    stack_->addWidget(plots);

    connect(model_, &SceneModel::changed, this, &CycleView::showResult);
    showResult();
}

void CycleView::showResult() {
    const balance_shaft::Result& result = model_->result();
    const balance_shaft::MomentCurves& curves = result.curves;
    const ShownCycle shown = shownCycle(result);
    stack_->setCurrentIndex(shown.torque.empty() ? 0 : 1);
    if (shown.torque.empty()) {
        return;
    }
    for (PlotView* plot : {torque_, pressure_}) {
        plot->setXAxis({tr("φ, °"), 0.0, model_->cycleDeg(), true});
    }
    torque_->setCurve(gas_, curves.crank_angle_deg, curves.M_gas);
    torque_->setCurve(inertia_, curves.crank_angle_deg, curves.M_inertia);
    const bool isOffset = model_->input().cylinder.offset != 0.0;
    torque_->setCurve(offset_, isOffset ? curves.crank_angle_deg : std::vector<double>(),
                      isOffset ? curves.M_offset : std::vector<double>());
    torque_->setCurve(total_, curves.crank_angle_deg, shown.torque);
    pressure_->setCurve(pressureCurve_, curves.crank_angle_deg, shown.pressure);
    indicator_->setXAxis(
        {result.indicated->clearance ? tr("V, cm³") : tr("V without clearance, cm³"), 0.0,
         1.03 * shown.largestVolume});
    indicator_->setCurve(loop_, shown.volume, shown.pressure);
    table_->setRows(model_->cycleRows());
}

}  // namespace ravnoves

#include "balance-shaft/orders_view.h"

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/shown_curves.h"
#include "plot/plot_view.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"

namespace ravnoves {

OrdersView::OrdersView(BalanceShaftModel* model, QWidget* parent) : QWidget(parent), model_(model) {
    QVBoxLayout* column = columnIn(this, Theme::space, tabMargins);
    plot_ = new PlotView(tr("Order spectrum of the moment"), this);
    plot_->setXAxis({tr("order (per turn of the crank)"), 0.0, 12.5});
    plot_->setYAxis(PlotView::Side::Left, {tr("N·m")});
    up_ = plot_->addCurve({.name = QStringLiteral("Mᵤₚ"),
                           .colour = 0,
                           .shape = PlotView::Shape::Bars,
                           .toolTip = tr("Without a shaft"),
                           .barWidth = 0.18,
                           .barShift = -0.1});
    ups_ = plot_->addCurve({.name = QStringLiteral("Mᵤₚₛ"),
                            .colour = 2,
                            .shape = PlotView::Shape::Bars,
                            .toolTip = tr("With the shaft at the present α"),
                            .barWidth = 0.18,
                            .barShift = 0.1});
    column->addWidget(plot_, 3);

    auto* panel = new Panel(this);
    QVBoxLayout* inside = columnIn(panel, -1, tableMargins);
    inside->addWidget(captionLabel(
        tr("A four-stroke cycle has half orders, a two-stroke one has whole ones. A shaft at crank "
           "speed changes order 1 alone; the best RMS is where it opposes that order."),
        panel));
    table_ = new ResultTable(tr("Order spectrum"), panel);
    const ResultColumn phase(tr("phase, °"),
                             tr("Of the moment to the left: amplitude × sin(kφ + phase)"));
    table_->setColumns(
        {{tr("Order"), tr("Multiple of the crank speed")},
         {shownTitle(tr("Mᵤₚ, N·m")).text, tr("Fourier amplitude of the moment without a shaft")},
         phase,
         {shownTitle(tr("Mᵤₚₛ, N·m")).text,
          tr("Fourier amplitude with the shaft at the present α")},
         phase});
    table_->setShownRows(5);
    inside->addWidget(table_);
    column->addWidget(panel, 2);

    connect(model_, &BalanceShaftModel::shaftMoved, this, [this] {
        if (isVisible()) {
            showResult();
        }
    });
}

void OrdersView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showResult();
}

void OrdersView::showResult() {
    const balance_shaft::Result& result = model_->result();
    const ShownOrders shown = shownOrders(result);
    plot_->setCurve(up_, shown.order, shown.without);
    plot_->setCurve(ups_, shown.order, shown.with);
    const QLocale locale;
    ResultRows rows;
    for (std::size_t i = 0; i < shown.order.size(); ++i) {
        const auto moment = [](double value) { return shownCell(value, units::N_m, 2); };
        const auto phase = [](double value) {
            return ResultCell(value / degree, shownDigits(value, units::degree, 1),
                              ResultCell::Kind::Direction);
        };
        rows.push_back({formNumber(shown.order[i], locale), moment(shown.without[i]),
                        phase(result.spectrum_M_up[i].phase), moment(shown.with[i]),
                        phase(result.spectrum_M_ups[i].phase)});
    }
    table_->setRows(rows);
}

}  // namespace ravnoves

#include "inertia-moments/inertia_moments_charts.h"

#include <QVBoxLayout>

#include "inertia-moments/crank_views.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "inertia-moments/shaft_view.h"
#include "numerics/constants.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "theme/theme.h"
#include "widgets/layouts.h"

namespace ravnoves {

InertiaMomentsCharts::InertiaMomentsCharts(InertiaMomentsModel* model, QWidget* parent)
    : FittedTabs(parent), model_(model) {
    setDocumentMode(true);
    beginGroup(tr("Analysis"));
    addOrders();
    hodographs_ = addPair("hodograph-forces", "hodograph-moments", "hodographs", tr("Hodographs"));
    addPair("forces-by-order", "moments-by-order", "orders", tr("Orders"));
    showCrankAngle(addPair("roll", "roll-by-order", "roll", tr("Roll"))[0], model_->crank());
    for (PartPlot* plot :
         addPair("forces-over-angle", "moments-over-angle", "over-angle", tr("Over φ"))) {
        showCrankAngle(plot, model_->crank());
    }
    setTabToolTip(count() - 1, tr("Forces and moments of all orders over two turns"));
    beginGroup(tr("Design"));
    add(new FiringWheel(model_, this), "firing", tr("Firing"));
    add(new ShaftView(model_, this), "shafts", tr("Shafts"));
    add(new CounterweightView(model_, this), "weights", tr("Weights"));
    for (const auto signal : {&SceneModel::changed, &SceneModel::viewChanged}) {
        connect(model_, signal, this, &InertiaMomentsCharts::showCursor);
    }
    connect(model_->crank(), &CrankAngle::changed, this, &InertiaMomentsCharts::showCursor);
    showCursor();
}

void InertiaMomentsCharts::add(QWidget* view, const char* name, const QString& title) {
    view->setObjectName(QLatin1String(name));
    addTab(view, title);
}

void InertiaMomentsCharts::addOrders() {
    auto* orders = new QWidget(this);
    QVBoxLayout* both = columnIn(orders);
    QList<PlotView*> plots;
    for (const char* part : {"order-1", "order-2"}) {
        plots << new PartPlot(model_, part, orders);
        showCrankAngle(plots.last(), model_->crank());
        both->addWidget(plots.last());
    }
    PlotView::stack(plots);
    add(orders, "first-orders", tr("Orders 1, 2"));
}

std::array<PartPlot*, 2> InertiaMomentsCharts::addPair(const char* left, const char* right,
                                                       const char* name, const QString& title) {
    constexpr int wide = 420;  // designed pixels of both beside each other
    auto* pair = new FoldingRow(wide, this);
    pair->setContentsMargins(0, Theme::gap, 0, 0);
    const std::array plots{new PartPlot(model_, left, pair), new PartPlot(model_, right, pair)};
    for (PartPlot* plot : plots) {
        pair->add(plot);
    }
    add(pair, name, title);
    return plots;
}

void InertiaMomentsCharts::showCursor() {
    const double phi = model_->crank()->degrees() * degree;
    const auto& engine = model_->result().unbalanced;
    for (std::size_t i = 0; i < hodographs_.size(); ++i) {
        const auto first = vectorAt(engine.order(1), i == 0, phi);
        const auto second = vectorAt(engine.order(2), i == 0, 2.0 * phi);
        hodographs_[i]->setMarks({{first.real(), first.imag(), {}, Role::FirstOrder},
                                  {second.real(), second.imag(), {}, Role::SecondOrder}});
    }
}

}  // namespace ravnoves

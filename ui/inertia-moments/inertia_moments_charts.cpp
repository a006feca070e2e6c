#include "inertia-moments/inertia_moments_charts.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>

#include "inertia-moments/crank_views.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "inertia-moments/order_bars.h"
#include "inertia-moments/shaft_view.h"
#include "numerics/constants.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"

namespace ravnoves {

InertiaMomentsCharts::InertiaMomentsCharts(InertiaMomentsModel* model, QWidget* parent)
    : QWidget(parent), model_(model), orders_(new QWidget(this)), tabs_(new FittedTabs(this)) {
    QVBoxLayout* column = columnIn(this);
    addOrders();
    column->addWidget(orders_, 8);
    tabs_->setDocumentMode(true);
    hodographs_ = addPair("hodograph-forces", "hodograph-moments", tr("Hodographs"));
    addBars();
    tabs_->addTab(addAnglePlot("roll", tabs_), tr("Roll"));
    tabs_->addTab(new ShaftView(model_, tabs_), tr("Shafts"));
    tabs_->addTab(new CounterweightView(model_, tabs_), tr("Weights"));
    tabs_->addTab(new FiringWheel(model_, tabs_), tr("Firing"));
    for (PartPlot* plot : addPair("forces-over-angle", "moments-over-angle", tr("Over φ"))) {
        showCrankAngle(plot, model_->crank());
    }
    tabs_->setTabToolTip(tabs_->count() - 1, tr("Forces and moments of all orders over two turns"));
    column->addWidget(tabs_, 6);
    for (const auto signal : {&SceneModel::changed, &SceneModel::viewChanged}) {
        connect(model_, signal, this, [this] {
            if (std::exchange(isForce_, model_->showsForces()) != isForce_) {
                foldings_ = 0;
                tellOrders();
            }
            showCursor();
        });
    }
    connect(model_->crank(), &CrankAngle::changed, this, &InertiaMomentsCharts::showCursor);
    isForce_ = model_->showsForces();
    showCursor();
}

int InertiaMomentsCharts::heightOfBoth() const {
    // Whichever tab is in front: no other one takes the orders away.
    int highest = 0;
    for (int i = 0; i < tabs_->count(); ++i) {
        if (tabs_->widget(i) != orders_) {
            highest = std::max(highest, tabs_->widget(i)->minimumSizeHint().height());
        }
    }
    return orders_->minimumSizeHint().height() + Theme::space +
           tabs_->tabBar()->sizeHint().height() + highest;
}

QSize InertiaMomentsCharts::minimumSizeHint() const {
    const int bar = tabs_->tabBar()->sizeHint().height();
    return {QWidget::minimumSizeHint().width(),
            std::max(orders_->minimumSizeHint().height() + bar, tabs_->minimumSizeHint().height())};
}

void InertiaMomentsCharts::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    foldWhereNeeded();
}

bool InertiaMomentsCharts::event(QEvent* event) {
    const bool done = QWidget::event(event);
    if (event->type() == QEvent::FontChange) {
        foldings_ = 0;
    }
    if (event->type() == QEvent::LayoutRequest) {  // legends get lines
        foldWhereNeeded();
    }
    return done;
}

void InertiaMomentsCharts::foldWhereNeeded() {
    const bool isFolded = tabs_->indexOf(orders_) >= 0;
    const bool isTooLow = height() < heightOfBoth();
    if (size() != foldedAt_) {
        foldings_ = 0;
    }
    if (!isFolded && isTooLow) {
        foldedAt_ = size();
        ++foldings_;
    }
    // Legends out of sight may ask for less than those in sight, and so there is no end to it.
    constexpr int most = 3;
    foldMoments(isTooLow || (isFolded && foldings_ >= most));
}

void InertiaMomentsCharts::foldMoments(bool folded) {
    const int place = tabs_->indexOf(orders_);
    if (folded == (place >= 0)) {
        return;
    }
    auto* column = static_cast<QVBoxLayout*>(layout());
    if (folded) {
        column->removeWidget(orders_);
        tabs_->addTab(orders_, tr("Orders 1, 2"));
        tellOrders();
    } else {
        tabs_->removeTab(place);
        column->insertWidget(0, orders_, 8);
        orders_->show();
    }
}

void InertiaMomentsCharts::tellOrders() {
    const int place = tabs_->indexOf(orders_);
    if (place >= 0) {
        tabs_->setTabToolTip(place, isForce_ ? EnginePlots::tr("Order 1, forces") +
                                                   QStringLiteral("; ") +
                                                   EnginePlots::tr("Order 2, forces")
                                             : tr("Moments of orders 1 and 2 over two turns"));
    }
}

void InertiaMomentsCharts::addOrders() {
    QVBoxLayout* both = columnIn(orders_);
    QList<PlotView*> plots;
    for (const char* part : {"order-1", "order-2"}) {
        plots << addAnglePlot(part, orders_);
        both->addWidget(plots.last());
    }
    PlotView::stack(plots);
}

PartPlot* InertiaMomentsCharts::addAnglePlot(const char* part, QWidget* parent) {
    auto* plot = new PartPlot(model_, part, parent);
    showCrankAngle(plot, model_->crank());
    return plot;
}

std::array<PartPlot*, 2> InertiaMomentsCharts::addPair(const char* left, const char* right,
                                                       const QString& title) {
    constexpr int wide = 420;  // designed pixels of both beside each other
    auto* pair = new FoldingRow(wide, tabs_);
    pair->setContentsMargins(0, Theme::gap, 0, 0);
    const std::array plots{new PartPlot(model_, left, pair), new PartPlot(model_, right, pair)};
    for (PartPlot* plot : plots) {
        pair->add(plot);
    }
    tabs_->addTab(pair, title);
    return plots;
}

void InertiaMomentsCharts::addBars() {
    auto* orders = new QWidget(tabs_);
    auto* ordersColumn = new QVBoxLayout(orders);
    ordersColumn->setContentsMargins(0, Theme::gap, 0, 0);
    ordersColumn->setSpacing(0);
    auto* bars = new OrderBars(model_, orders);
    auto* logarithmic = new QCheckBox(tr("&logarithmic"), bars);
    logarithmic->setObjectName(QStringLiteral("logarithmic"));
    logarithmic->setToolTip(tr("Six decades, for the high orders"));
    connect(logarithmic, &QCheckBox::toggled, bars, &OrderBars::setLogarithmic);
    auto* corner = new QHBoxLayout(bars);
    corner->setContentsMargins(0, 1, Theme::space, 0);
    corner->addStretch();
    corner->addWidget(logarithmic, 0, Qt::AlignTop);
    ordersColumn->addWidget(bars);
    tabs_->addTab(orders, tr("Orders"));
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

#include "inertia-moments/inertia_moments_charts.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "inertia-moments/crank_views.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "inertia-moments/order_bars.h"
#include "inertia-moments/shaft_view.h"
#include "plot/plot_view.h"
#include "theme/theme.h"

namespace ravnoves {

using inertia_moments::EngineOrder;
using inertia_moments::Result;
using inertia_moments::RotatingPair;
using inertia_moments::WrenchCurves;
using inertia_moments::zero_share;

namespace {

constexpr int plotStep = 3;        // degrees between the points of one order
constexpr int cycleDegrees = 720;  // the paper's Fig. 6 shows two turns

// Curves of the moment plots, in the order in which they are added.
enum MomentCurve {
    verticalTwoTerm,  // below the exact ones, so that it shows where it differs
    horizontalTwoTerm,
    vertical,
    horizontal,
    verticalLeft,
    horizontalLeft
};
// Curves of a hodograph, likewise.
enum HodographCurve { firstOrder, secondOrder, allOrders, leftOver };

/// The ellipse that a rotating pair runs round.
void traceOrder(const RotatingPair& pair, std::vector<double>& x, std::vector<double>& y) {
    constexpr int points = 96;
    x.resize(points + 1);
    y.resize(points + 1);
    for (int i = 0; i <= points; ++i) {
        const auto p = pair.at(two_pi * (i % points) / points);
        x[static_cast<std::size_t>(i)] = p.real();
        y[static_cast<std::size_t>(i)] = p.imag();
    }
}

/// Curves of one turn, shown over two.
std::vector<double> twice(const std::vector<double>& turn) {
    std::vector<double> both(turn);
    both.insert(both.end(), turn.begin() + 1, turn.end());
    return both;
}

double reachOf(const std::vector<double>& x, const std::vector<double>& y) {
    double reach = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        reach = std::max({reach, std::abs(x[i]), std::abs(y[i])});
    }
    return reach;
}

/// The next 1, 2, 3, 5 or 6 times a power of ten: reaches that small plots have round ticks for.
double niceReach(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) {
        return 1.0;
    }
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 3.0, 5.0, 6.0}) {
        if (value <= step * power) {
            return step * power;
        }
    }
    return 10.0 * power;
}

}  // namespace

InertiaMomentsCharts::InertiaMomentsCharts(InertiaMomentsModel* model, QWidget* parent)
    : QWidget(parent), model_(model), tabs_(new QTabWidget(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(Theme::space);
    addMoments();
    for (PlotView* plot : moments_) {
        column->addWidget(plot, 4);
    }
    tabs_->setDocumentMode(true);
    addHodographs();
    addBars();
    addRoll();
    shaftView_ = new ShaftView(model_, tabs_);
    tabs_->addTab(shaftView_, tr("Shafts"));
    tabs_->addTab(new CounterweightView(model_, tabs_), tr("Weights"));
    tabs_->addTab(new FiringWheel(model_, tabs_), tr("Firing"));
    column->addWidget(tabs_, 6);
    connect(tabs_, &QTabWidget::currentChanged, this, &InertiaMomentsCharts::showFront);
    connect(model_, &SceneModel::changed, this, &InertiaMomentsCharts::showMoments);
    connect(model_, &InertiaMomentsModel::crankAngleChanged, this,
            &InertiaMomentsCharts::showCursor);
    showMoments();
    showCursor(model_->crankAngleDeg());
}

void InertiaMomentsCharts::addMoments() {
    for (std::size_t i = 0; i < moments_.size(); ++i) {
        auto* plot = new PlotView(i == 0 ? tr("Order 1") : tr("Order 2"), this);
        // One below the other: the lower one's axis title serves both.
        plot->setXAxis({i == 0 ? QString() : tr("φ, °"), 0.0, cycleDegrees, true});
        plot->setYAxis(PlotView::Side::Left, {tr("M, N·m")});
        plot->addCurve({.name = tr("My 2-term"),
                        .colour = 6,
                        .width = 1.0,
                        .toolTip = tr("Vertical plane, the paper's formulas (1) and (2), Fig. 6")});
        plot->addCurve(
            {.name = tr("Mx 2-term"),
             .colour = 5,
             .width = 1.0,
             .toolTip = tr("Horizontal plane, the paper's formulas (3) and (4), Fig. 6")});
        plot->addCurve({.name = tr("My"),
                        .colour = 2,
                        .width = 1.8,
                        .toolTip = tr("In the vertical plane, exact")});
        plot->addCurve({.name = tr("Mx"),
                        .colour = 1,
                        .width = 1.8,
                        .toolTip = tr("In the horizontal plane, exact")});
        plot->addCurve({.name = tr("My left"),
                        .colour = 3,
                        .width = 2.2,
                        .toolTip = tr("Vertical plane, with rotating masses and with the "
                                      "counterweights and shafts that are on")});
        plot->addCurve({.name = tr("Mx left"),
                        .colour = 4,
                        .width = 2.2,
                        .toolTip = tr("Horizontal plane, likewise")});
        connect(plot, &PlotView::cursorMoved, model_, &InertiaMomentsModel::setCrankAngleDeg);
        moments_[i] = plot;
    }
}

void InertiaMomentsCharts::addHodographs() {
    auto* pair = new QWidget(tabs_);
    auto* row = new QHBoxLayout(pair);
    row->setContentsMargins(0, Theme::gap, 0, 0);
    row->setSpacing(Theme::space);
    for (std::size_t i = 0; i < hodographs_.size(); ++i) {
        auto* plot = new PlotView(i == 0 ? tr("Forces") : tr("Moments"), pair);
        plot->setEqualScale(true);
        plot->setXAxis({i == 0 ? tr("Fx, N") : tr("Mx, N·m"), -1.0, 1.0});
        plot->setYAxis(PlotView::Side::Left, {i == 0 ? tr("Fy, N") : tr("My, N·m")});
        hodographs_[i].plot = plot;
        plot->addCurve(
            {.name = tr("1st"), .colour = 2, .toolTip = tr("Exact first order (Fig. 5)")});
        plot->addCurve({.name = tr("2nd"),
                        .colour = 1,
                        .pen = Qt::DashLine,
                        .toolTip = tr("Exact second order (Fig. 5)")});
        plot->addCurve({.name = tr("all"),
                        .colour = 0,
                        .width = 1.2,
                        .toolTip = tr("All orders of the reciprocating parts")});
        plot->addCurve({.name = tr("left"),
                        .colour = 3,
                        .toolTip = tr("All orders with rotating masses, and with the "
                                      "counterweights and shafts that are on")});
        row->addWidget(plot, 1);
    }
    tabs_->addTab(pair, tr("Hodographs"));
}

void InertiaMomentsCharts::addBars() {
    auto* orders = new QWidget(tabs_);
    auto* ordersColumn = new QVBoxLayout(orders);
    ordersColumn->setContentsMargins(0, Theme::gap, 0, 0);
    ordersColumn->setSpacing(0);
    bars_ = new OrderBars(model_, orders);
    auto* logarithmic = new QCheckBox(tr("&logarithmic"), bars_);
    logarithmic->setObjectName(QStringLiteral("logarithmic"));
    logarithmic->setToolTip(tr("Six decades, so that the high orders can be seen"));
    connect(logarithmic, &QCheckBox::toggled, bars_, &OrderBars::setLogarithmic);
    auto* corner = new QHBoxLayout(bars_);
    corner->setContentsMargins(0, 1, Theme::space, 0);
    corner->addStretch();
    corner->addWidget(logarithmic, 0, Qt::AlignTop);
    ordersColumn->addWidget(bars_);
    tabs_->addTab(orders, tr("Orders"));
}

void InertiaMomentsCharts::addRoll() {
    roll_ = new PlotView(tr("Roll moment on the engine"), tabs_);
    roll_->setXAxis({tr("φ, °"), 0.0, cycleDegrees, true});
    roll_->setYAxis(PlotView::Side::Left, {tr("N·m")});
    roll_->addCurve({.name = tr("Mz"),
                     .colour = 2,
                     .width = 2.0,
                     .toolTip = tr("Roll moment on the engine: the sum of the two")});
    roll_->addCurve({.name = tr("of offsets and rods"),
                     .colour = 1,
                     .toolTip = tr("Moment of the inertia forces about the crank axis: −Σ e F and "
                                   "the couples of rigid rods")});
    roll_->addCurve({.name = tr("reaction torque"),
                     .colour = 3,
                     .toolTip = tr("Reaction of the inertia torque on the crank, −Σ F ds/dφ")});
    connect(roll_, &PlotView::cursorMoved, model_, &InertiaMomentsModel::setCrankAngleDeg);
    tabs_->addTab(roll_, tr("Roll"));
}

void InertiaMomentsCharts::showMoments() {
    const Result& result = model_->result();
    constexpr auto points = static_cast<std::size_t>(cycleDegrees / plotStep) + 1;
    std::vector<double> angle(points);
    for (std::size_t i = 0; i < points; ++i) {
        angle[i] = static_cast<double>(i) * plotStep;
    }
    // What is nothing but rounding is drawn as nothing.
    const auto set = [&](PlotView* plot, int curveY, int curveX, const RotatingPair& pair,
                         const EngineOrder& order) {
        std::vector<double> x(points, 0.0);
        std::vector<double> y(points, 0.0);
        const bool something = pair.max() > zero_share * order.moment_scale;
        for (std::size_t i = 0; i < points && something; ++i) {
            const auto vector = pair.at(angle[i] * degree * order.order);
            x[i] = vector.real();
            y[i] = vector.imag();
        }
        plot->setCurve(curveY, angle, std::move(y));
        plot->setCurve(curveX, angle, std::move(x));
        return something;
    };
    for (int k = 1; k <= 2; ++k) {
        PlotView* plot = moment(k);
        const EngineOrder& exact = result.exact.order(k);
        bool something = set(plot, vertical, horizontal, exact.moment, exact);
        set(plot, verticalTwoTerm, horizontalTwoTerm, result.two_term.order(k).moment, exact);
        // Only where something acts on this order.
        const RotatingPair& left = result.remaining.order(k).moment;
        if ((left - exact.moment).max() > zero_share * exact.moment_scale) {
            something = set(plot, verticalLeft, horizontalLeft, left, exact) || something;
        } else {
            plot->setCurve(verticalLeft, {}, {});
            plot->setCurve(horizontalLeft, {}, {});
        }
        if (something) {
            plot->followData(PlotView::Side::Left);
        } else {
            plot->setYRange(PlotView::Side::Left, -1.0, 1.0);
        }
    }
    showFront();
}

void InertiaMomentsCharts::showFront() {
    // Only the tab in front; the others follow when they come to the front.
    QWidget* front = tabs_->currentWidget();
    if (front == roll_) {
        const WrenchCurves& curves = model_->result().curves;
        std::vector<double> angle(2 * curves.crank_angle.size() - 1);
        for (std::size_t i = 0; i < angle.size(); ++i) {
            angle[i] =
                static_cast<double>(i) * cycleDegrees / static_cast<double>(angle.size() - 1);
        }
        roll_->setCurve(0, angle, twice(curves.roll));
        roll_->setCurve(1, angle, twice(curves.inertia_roll));
        roll_->setCurve(2, angle, twice(curves.reaction_torque));
    } else if (tabs_->currentIndex() == 0) {
        showHodograph(hodographs_[0], true);
        showHodograph(hodographs_[1], false);
    }
}

void InertiaMomentsCharts::showHodograph(Hodograph& hodograph, bool force) {
    const Result& result = model_->result();
    const auto member = [&](const EngineOrder& order) -> const RotatingPair& {
        return force ? order.force : order.moment;
    };
    std::vector<double> x;
    std::vector<double> y;
    double reach = 0.0;
    const auto trace = [&](int curve, int k) {
        traceOrder(member(result.exact.order(k)), x, y);
        reach = std::max(reach, reachOf(x, y));
        hodograph.plot->setCurve(curve, x, y);
    };
    trace(firstOrder, 1);
    trace(secondOrder, 2);
    const auto curve = [&](int number, const WrenchCurves& curves) {
        const auto& cx = force ? curves.force_x : curves.moment_x;
        const auto& cy = force ? curves.force_y : curves.moment_y;
        reach = std::max(reach, reachOf(cx, cy));
        hodograph.plot->setCurve(number, cx, cy);
    };
    curve(allOrders, result.curves);
    bool acts = false;
    for (std::size_t i = 0; i < result.exact.orders.size(); ++i) {
        const EngineOrder& before = result.exact.orders[i];
        const double scale = force ? before.force_scale : before.moment_scale;
        acts = acts ||
               (member(result.remaining.orders[i]) - member(before)).max() > zero_share * scale;
    }
    if (acts) {
        curve(leftOver, result.remaining_curves);
    } else {
        hodograph.plot->setCurve(leftOver, {}, {});
    }
    // Rounding of a balanced engine is not a picture.
    const EngineOrder& first = result.exact.order(1);
    const double floor = zero_share * (force ? first.force_scale : first.moment_scale);
    reach = std::max(reach, std::max(floor * 1e3, 1e-12));
    // With hysteresis, so that the axes rest while a slider moves.
    if (reach > hodograph.reach || reach < 0.45 * hodograph.reach) {
        hodograph.reach = niceReach(1.08 * reach);
        hodograph.plot->setXAxis(
            {force ? tr("Fx, N") : tr("Mx, N·m"), -hodograph.reach, hodograph.reach});
        hodograph.plot->setYRange(PlotView::Side::Left, -hodograph.reach, hodograph.reach);
    }
}

void InertiaMomentsCharts::showCursor(double crankAngle) {
    for (PlotView* plot : moments_) {
        plot->setPresentX(crankAngle);
    }
    roll_->setPresentX(crankAngle);
    // Where the vectors stand now, on their hodographs.
    const double phi = crankAngle * degree;
    const Result& result = model_->result();
    for (std::size_t i = 0; i < hodographs_.size(); ++i) {
        const auto member = [&](int k) {
            const EngineOrder& order = result.exact.order(k);
            return (i == 0 ? order.force : order.moment).at(k * phi);
        };
        const auto first = member(1);
        const auto second = member(2);
        hodographs_[i].plot->setMarks(
            {{first.real(), first.imag(), {}, 2}, {second.real(), second.imag(), {}, 1}});
    }
}

}  // namespace ravnoves

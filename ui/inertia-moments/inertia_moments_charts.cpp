#include "inertia-moments/inertia_moments_charts.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "inertia-moments/crank_views.h"
#include "inertia-moments/model/engine_curves.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "inertia-moments/order_bars.h"
#include "inertia-moments/shaft_view.h"
#include "numerics/constants.h"
#include "page/mechanism_picture.h"
#include "plot/plot_view.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"

namespace ravnoves {

using inertia_moments::Result;

namespace {

constexpr int hodographPair = 420;  ///< designed pixels of both beside each other
constexpr int cycleDegrees = 720;   // the paper's Fig. 6 shows two turns

// Curves of the moment plots, in the order in which they are added.
enum MomentCurve {
    vertical,
    horizontal,
    verticalTwoTerm,  // dashes over the exact ones: where both agree each is seen
    horizontalTwoTerm,
    verticalLeft,
    horizontalLeft,
    rolling,  // moments over φ alone
    rollingLeft
};
// Curves of a hodograph, likewise.
enum HodographCurve { firstOrder, secondOrder, allOrders, leftOver };

void showTrace(PlotView* plot, int curve, const engine_curves::Trace& trace) {
    plot->setCurve(curve, trace.x, trace.y);
}

}  // namespace

InertiaMomentsCharts::InertiaMomentsCharts(InertiaMomentsModel* model, QWidget* parent)
    : QWidget(parent), model_(model), orders_(new QWidget(this)), tabs_(new FittedTabs(this)) {
    QVBoxLayout* column = columnIn(this);
    QVBoxLayout* both = columnIn(orders_);
    addMoments();
    for (PlotView* plot : moments_) {
        both->addWidget(plot);
    }
    PlotView::stack({moments_.begin(), moments_.end()});
    column->addWidget(orders_, 8);
    tabs_->setDocumentMode(true);
    addHodographs();
    addBars();
    addRoll();
    shaftView_ = new ShaftView(model_, tabs_);
    tabs_->addTab(shaftView_, tr("Shafts"));
    tabs_->addTab(new CounterweightView(model_, tabs_), tr("Weights"));
    tabs_->addTab(new FiringWheel(model_, tabs_), tr("Firing"));
    addCourses();
    column->addWidget(tabs_, 6);
    connect(tabs_, &QTabWidget::currentChanged, this, &InertiaMomentsCharts::showFront);
    connect(model_, &SceneModel::changed, this, [this] {
        showMoments();
        showCursor(model_->crank()->degrees());
    });
    connect(model_, &SceneModel::rested, this, &InertiaMomentsCharts::showFront);
    connect(model_, &SceneModel::viewChanged, this, &InertiaMomentsCharts::showMoments);
    connect(model_->crank(), &CrankAngle::changed, this, &InertiaMomentsCharts::showCursor);
    showMoments();
    showCursor(model_->crank()->degrees());
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
        tabs_->setTabToolTip(
            place, isForce_ ? moment(1)->title() + QStringLiteral("; ") + moment(2)->title()
                            : tr("Moments of orders 1 and 2 over two turns"));
    }
}

void InertiaMomentsCharts::addMoments() {
    for (std::size_t i = 0; i < moments_.size(); ++i) {
        auto* plot = new PlotView(i == 0 ? tr("Order 1") : tr("Order 2"), this);
        // One below the other: the lower one's axis title serves both.
        plot->setXAxis({i == 0 ? QString() : tr("φ, °"), 0.0, cycleDegrees, true});
        plot->setYAxis(PlotView::Side::Left, {tr("M, N·m")});
        plot->addCurve({.name = tr("My"),
                        .colour = 2,
                        .width = 2.8,
                        .toolTip = tr("In the vertical plane, exact")});
        plot->addCurve({.name = tr("Mx"),
                        .colour = 1,
                        .width = 2.8,
                        .toolTip = tr("In the horizontal plane, exact")});
        plot->addCurve({.name = tr("My 2-term"),
                        .colour = 6,
                        .width = 1.4,
                        .pen = Qt::DashLine,
                        .toolTip = tr("Vertical plane, the paper's formulas (1) and (2), Fig. 6")});
        plot->addCurve(
            {.name = tr("Mx 2-term"),
             .colour = 7,
             .width = 1.4,
             .pen = Qt::DashLine,
             .toolTip = tr("Horizontal plane, the paper's formulas (3) and (4), Fig. 6")});
        plot->addCurve({.name = tr("My left"),
                        .colour = 3,
                        .width = 2.2,
                        .toolTip = tr("Vertical plane, with rotating masses and with the "
                                      "counterweights and shafts that are on")});
        plot->addCurve({.name = tr("Mx left"),
                        .colour = 4,
                        .width = 2.2,
                        .toolTip = tr("Horizontal plane, likewise")});
        showCrankAngle(plot, model_->crank());
        moments_[i] = plot;
    }
}

void InertiaMomentsCharts::addHodographs() {
    auto* pair = new FoldingRow(hodographPair, tabs_);
    pair->setContentsMargins(0, Theme::gap, 0, 0);
    for (std::size_t i = 0; i < hodographs_.size(); ++i) {
        auto* plot = new PlotView(i == 0 ? tr("Forces") : tr("Moments"), pair);
        plot->setEqualScale(true);
        plot->setXAxis({i == 0 ? tr("Fx, N") : tr("Mx, N·m"), -1.0, 1.0});
        plot->setYAxis(PlotView::Side::Left, {i == 0 ? tr("Fy, N") : tr("My, N·m")});
        hodographs_[i].plot = plot;
        plot->addCurve({.name = tr("1st"),
                        .colour = 2,
                        .toolTip = tr("Exact first order (Fig. 5)"),
                        .turn = turn_deg});
        plot->addCurve({.name = tr("2nd"),
                        .colour = 1,
                        .pen = Qt::DashLine,
                        .toolTip = tr("Exact second order (Fig. 5)"),
                        .turn = 0.5 * turn_deg});
        plot->addCurve({.name = tr("all"),
                        .colour = 0,
                        .width = 1.2,
                        .toolTip = tr("All orders of the reciprocating parts"),
                        .turn = turn_deg});
        plot->addCurve({.name = tr("left"),
                        .colour = 3,
                        .toolTip = tr("All orders with rotating masses, and with the "
                                      "counterweights and shafts that are on"),
                        .turn = turn_deg});
        pair->add(plot);
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
    showCrankAngle(roll_, model_->crank());
    tabs_->addTab(roll_, tr("Roll"));
}

void InertiaMomentsCharts::addCourses() {
    auto* pair = new FoldingRow(hodographPair, tabs_);
    pair->setContentsMargins(0, Theme::gap, 0, 0);
    for (const bool force : {true, false}) {
        auto* plot = new PlotView(force ? tr("Forces over φ") : tr("Moments over φ"), pair);
        plot->setXAxis({tr("φ, °"), 0.0, cycleDegrees, true});
        plot->setYAxis(PlotView::Side::Left, {force ? tr("F, N") : tr("M, N·m")});
        const auto add = [plot](const QString& name, int colour, double width,
                                const QString& toolTip, Qt::PenStyle pen = Qt::SolidLine) {
            plot->addCurve(
                {.name = name, .colour = colour, .width = width, .pen = pen, .toolTip = toolTip});
        };
        const QString twoTerm = tr("By the two-term formulas: orders 1 and 2");
        const QString exact =
            tr("Sum of −m a of all reciprocating parts, exact: every order in it");
        const QString left =
            tr("With rotating masses, and with the counterweights and shafts that "
               "are on");
        add(force ? tr("Fy") : tr("My"), 2, 2.8, exact);
        add(force ? tr("Fx") : tr("Mx"), 1, 2.8, exact);
        add(force ? tr("Fy 2-term") : tr("My 2-term"), 6, 1.4, twoTerm, Qt::DashLine);
        add(force ? tr("Fx 2-term") : tr("Mx 2-term"), 7, 1.4, twoTerm, Qt::DashLine);
        add(force ? tr("Fy left") : tr("My left"), 3, 2.2, left);
        add(force ? tr("Fx left") : tr("Mx left"), 4, 2.2, left);
        if (!force) {
            add(tr("Mz"), 0, 1.8, tr("Roll moment on the engine, of the engine alone"));
            add(tr("Mz left"), 5, 2.2, left);
        }
        showCrankAngle(plot, model_->crank());
        pair->add(plot);
        courses_[force ? 0 : 1] = plot;
    }
    tabs_->setTabToolTip(tabs_->addTab(pair, tr("Over φ")),
                         tr("Forces and moments of all orders over two turns"));
}

void InertiaMomentsCharts::showCourse(bool force) {
    const engine_curves::Course shown = engine_curves::course(model_->result(), force);
    PlotView* plot = course(force);
    const auto set = [&](int curveY, int curveX, const engine_curves::Trace& trace) {
        const auto& angle = trace.x.empty() ? trace.x : shown.crankAngleDeg;
        plot->setCurve(curveY, angle, trace.y);
        plot->setCurve(curveX, angle, trace.x);
    };
    set(verticalTwoTerm, horizontalTwoTerm, shown.twoTerm);
    set(vertical, horizontal, shown.exact);
    set(verticalLeft, horizontalLeft, shown.left);
    if (!force) {
        plot->setCurve(rolling, shown.crankAngleDeg, shown.roll);
        const auto& angle = shown.rollLeft.empty() ? shown.rollLeft : shown.crankAngleDeg;
        plot->setCurve(rollingLeft, angle, shown.rollLeft);
    }
    if (shown.isSomething) {
        plot->followData(PlotView::Side::Left);
    } else {
        plot->setYRange(PlotView::Side::Left, -1.0, 1.0);
    }
}

void InertiaMomentsCharts::nameMoments(bool force) {
    foldings_ = 0;
    isForce_ = force;
    for (int k = 1; k <= 2; ++k) {
        PlotView* plot = moment(k);
        plot->setTitle(force ? (k == 1 ? tr("Order 1, forces") : tr("Order 2, forces"))
                             : (k == 1 ? tr("Order 1") : tr("Order 2")));
        plot->setYAxis(PlotView::Side::Left, {force ? tr("F, N") : tr("M, N·m")});
        plot->setCurveName(verticalTwoTerm, force ? tr("Fy 2-term") : tr("My 2-term"));
        plot->setCurveName(horizontalTwoTerm, force ? tr("Fx 2-term") : tr("Mx 2-term"));
        plot->setCurveName(vertical, force ? tr("Fy") : tr("My"));
        plot->setCurveName(horizontal, force ? tr("Fx") : tr("Mx"));
        plot->setCurveName(verticalLeft, force ? tr("Fy left") : tr("My left"));
        plot->setCurveName(horizontalLeft, force ? tr("Fx left") : tr("Mx left"));
    }
    tellOrders();
}

void InertiaMomentsCharts::showMoments() {
    if (const bool force = model_->showsForces(); force != isForce_) {
        nameMoments(force);
    }
    for (int k = 1; k <= 2; ++k) {
        const engine_curves::OrderMoments moments =
            engine_curves::orderMoments(model_->result(), k, isForce_);
        PlotView* plot = moment(k);
        const auto set = [&](int curveY, int curveX, const engine_curves::Trace& trace) {
            const auto& angle = trace.x.empty() ? trace.x : moments.crankAngleDeg;
            plot->setCurve(curveY, angle, trace.y);
            plot->setCurve(curveX, angle, trace.x);
        };
        set(vertical, horizontal, moments.exact);
        set(verticalTwoTerm, horizontalTwoTerm, moments.twoTerm);
        set(verticalLeft, horizontalLeft, moments.left);
        if (moments.isSomething) {
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
        const engine_curves::Roll roll = engine_curves::roll(model_->result());
        roll_->setCurve(0, roll.crankAngleDeg, roll.sum);
        roll_->setCurve(1, roll.crankAngleDeg, roll.inertia);
        roll_->setCurve(2, roll.crankAngleDeg, roll.reactionTorque);
    } else if (front->isAncestorOf(courses_[0])) {
        showCourse(true);
        showCourse(false);
    } else if (tabs_->currentIndex() == 0) {
        showHodograph(hodographs_[0], true);
        showHodograph(hodographs_[1], false);
    }
}

void InertiaMomentsCharts::showHodograph(Hodograph& hodograph, bool force) {
    const engine_curves::Hodograph picture = engine_curves::hodograph(model_->result(), force);
    showTrace(hodograph.plot, firstOrder, picture.first);
    showTrace(hodograph.plot, secondOrder, picture.second);
    showTrace(hodograph.plot, allOrders, picture.all);
    showTrace(hodograph.plot, leftOver, picture.left);
    // With hysteresis, so that the axes rest while a slider moves.
    const auto fills = [](const engine_curves::Interval& axis, const engine_curves::Interval& now) {
        return now.span() > 0.6 * axis.span();
    };
    if (!model_->isMoved() || !hodograph.x.holds(picture.x) || !hodograph.y.holds(picture.y) ||
        (!fills(hodograph.x, picture.x) && !fills(hodograph.y, picture.y))) {
        // As much room on either axis: both have one scale.
        const double room = 0.08 * std::max(picture.x.span(), picture.y.span());
        const auto with = [room](const engine_curves::Interval& of) {
            return engine_curves::Interval{of.low - room, of.high + room};
        };
        const std::pair wanted(with(picture.x), with(picture.y));
        const auto same = [](const engine_curves::Interval& a, const engine_curves::Interval& b) {
            return a.low == b.low && a.high == b.high;
        };
        if (same(wanted.first, hodograph.x) && same(wanted.second, hodograph.y)) {
            return;
        }
        std::tie(hodograph.x, hodograph.y) = wanted;
        hodograph.plot->setXAxis(
            {force ? tr("Fx, N") : tr("Mx, N·m"), hodograph.x.low, hodograph.x.high});
        hodograph.plot->setYRange(PlotView::Side::Left, hodograph.y.low, hodograph.y.high);
    }
}

void InertiaMomentsCharts::showCursor(double crankAngle) {
    // Where the vectors stand now, on their hodographs.
    const double phi = crankAngle * degree;
    const Result& result = model_->result();
    for (std::size_t i = 0; i < hodographs_.size(); ++i) {
        const auto member = [&](int k) {
            return engine_curves::vectorAt(result.unbalanced.order(k), i == 0, k * phi);
        };
        const auto first = member(1);
        const auto second = member(2);
        hodographs_[i].plot->setMarks(
            {{first.real(), first.imag(), {}, 2}, {second.real(), second.imag(), {}, 1}});
    }
}

}  // namespace ravnoves

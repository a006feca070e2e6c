// What the page of inertia forces and moments shows.

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

#include "inertia-moments/model/inertia_moments_model.h"
#include "numerics/constants.h"
#include "text/number_text.h"

namespace ravnoves {

using inertia_moments::EngineOrder;
using inertia_moments::EngineOrders;
using inertia_moments::Result;
using inertia_moments::RotatingPair;
using inertia_moments::WrenchCurves;
using inertia_moments::zero_share;

namespace {

/// The words of the plots.
struct EnginePlots {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::InertiaMomentsCharts)
};

constexpr double cycle_deg = 720.0;  // the paper's Fig. 6 shows two turns

/// A vector in the plane across the crank, point by point.
struct Trace {
    std::vector<double> x;
    std::vector<double> y;
};

const RotatingPair& vectorOf(const EngineOrder& order, bool force) {
    return force ? order.force : order.moment;
}

/// What counts as nothing beside an order.
double roundingOf(const EngineOrder& order, bool force) {
    return zero_share * (force ? order.force_scale : order.moment_scale);
}

/// Of all orders together.
double rounding(const Result& result, bool force) {
    double sum = 0.0;
    for (const EngineOrder& order : result.unbalanced.orders) {
        sum += roundingOf(order, force);
    }
    return sum;
}

bool isSomething(const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(), [](double value) { return value != 0.0; });
}

/// A curve of one turn, shown over two.
std::vector<double> twice(const std::vector<double>& turn) {
    std::vector<double> both(turn);
    if (!turn.empty()) {
        both.insert(both.end(), turn.begin() + 1, turn.end());
    }
    return both;
}

/// So many angles over two turns, degrees.
std::vector<double> anglesOfTwoTurns(std::size_t points) {
    std::vector<double> angles(points);
    for (std::size_t i = 0; i < points; ++i) {
        angles[i] = static_cast<double>(i) * cycle_deg / static_cast<double>(points - 1);
    }
    return angles;
}

/// Over one turn; what is nothing but rounding is drawn as nothing.
Trace turnOf(const WrenchCurves& curves, bool force, double nothing) {
    Trace trace =
        force ? Trace{curves.force_x, curves.force_y} : Trace{curves.moment_x, curves.moment_y};
    for (std::vector<double>* values : {&trace.x, &trace.y}) {
        if (std::all_of(values->begin(), values->end(),
                        [&](double value) { return std::abs(value) <= nothing; })) {
            std::fill(values->begin(), values->end(), 0.0);
        }
    }
    return trace;
}

/// True where counterweights or shafts change something of an order.
bool isChanged(const Result& result, int order, bool force) {
    const EngineOrder& before = result.unbalanced.order(order);
    return (vectorOf(result.remaining.order(order), force) - vectorOf(before, force)).max() >
           roundingOf(before, force);
}

bool isBalanced(const Result& result, bool force) {
    const auto& orders = result.unbalanced.orders;
    return std::ranges::any_of(
        orders, [&](const EngineOrder& each) { return isChanged(result, each.order, force); });
}

Figure overCycle(const QString& title, const QString& left) {
    return {.title = title,
            .x = {.title = EnginePlots::tr("φ, °"), .min = 0.0, .max = cycle_deg, .degrees = true},
            .left = {.title = left}};
}

/// The table of the orders is without them.
QString withRotating(const QString& title) {
    return EnginePlots::tr("%1, with rotating masses").arg(title);
}

QString unitTitle(bool force) {
    return force ? EnginePlots::tr("F, N") : EnginePlots::tr("M about z₀, N·m");
}

/// Both components of a vector over φ, exact and two-term, and what balancing leaves of it; empty
/// where it changes nothing.
/// @param tips  of the upright and the level component of each
void addCourse(Figure& figure, bool force, const Trace& exact, const Trace& twoTerm,
               const Trace& remaining, const std::array<QString, 6>& tips) {
    const auto add = [&](const char* id, const QString& name, QChar axis, Role role, double width,
                         const QString& tip, const std::vector<double>& turn) {
        if (isSomething(turn)) {
            figure.leftRange.reset();
        }
        const QString symbol = QString(QChar(force ? u'F' : u'M')) + axis;
        const std::vector<double> values = twice(turn);
        figure.add(id, {.name = name.arg(symbol), .role = role, .width = width, .toolTip = tip},
                   anglesOfTwoTurns(values.size()), values);
    };
    figure.leftRange = std::pair(-1.0, 1.0);  // a flat chart, not rounding
    const QString shortForm = EnginePlots::tr("2-term (%1)");
    const QString left = EnginePlots::tr("residual (%1)");
    add("vertical", EnginePlots::tr("vertical (%1)"), u'y', Role::Vertical, 2.8, tips[0], exact.y);
    add("horizontal", EnginePlots::tr("horiz. (%1)"), u'x', Role::Horizontal, 2.8, tips[1],
        exact.x);
    add("vertical-two-term", shortForm, u'y', Role::TwoTermVertical, 1.4, tips[2], twoTerm.y);
    add("horizontal-two-term", shortForm, u'x', Role::TwoTermHorizontal, 1.4, tips[3], twoTerm.x);
    add("vertical-left", left, u'y', Role::ResidualVertical, 2.2, tips[4], remaining.y);
    add("horizontal-left", left, u'x', Role::ResidualHorizontal, 2.2, tips[5], remaining.x);
}

/// The moments (or forces) of one order, as the paper's Fig. 6 shows them.
template <int order>
Figure ofOrder(const InertiaMomentsModel& model) {
    const bool force = model.showsForces();
    const Result& result = model.result();
    Figure figure = overCycle(order == 1 ? withRotating(force ? EnginePlots::tr("Order 1, forces")
                                                              : EnginePlots::tr("Order 1"))
                              : force    ? EnginePlots::tr("Order 2, forces")
                                         : EnginePlots::tr("Order 2"),
                              unitTitle(force));
    if (order == 1) {
        figure.x.title.clear();  // the other one is below
    }
    std::vector<double> angles(121);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        angles[i] = two_pi * static_cast<double>(i) / static_cast<double>(angles.size() - 1);
    }
    const double nothing = roundingOf(result.unbalanced.order(order), force);
    const auto trace = [&](const EngineOrders& orders) {
        const EngineOrders alone{{orders.order(order)}};
        return turnOf(inertia_moments::with_orders(WrenchCurves(angles), alone), force, nothing);
    };
    addCourse(figure, force, trace(result.unbalanced), trace(result.two_term_unbalanced),
              isChanged(result, order, force) ? trace(result.remaining) : Trace(),
              {EnginePlots::tr("In the vertical plane, exact"),
               EnginePlots::tr("In the horizontal plane, exact"),
               EnginePlots::tr("Vertical plane, the paper's formulas (1) and (2), Fig. 6"),
               EnginePlots::tr("Horizontal plane, the paper's formulas (3) and (4), Fig. 6"),
               EnginePlots::tr("Vertical plane, with rotating masses and with the "
                               "counterweights and shafts that are on"),
               EnginePlots::tr("Horizontal plane, likewise")});
    return figure;
}

/// Moments about the crank are moments too: a four in line has no others.
void addRoll(Figure& figure, const Result& result) {
    double nothing = 0.0;
    for (const EngineOrder& order : result.unbalanced.orders) {
        nothing += zero_share * order.roll_scale;
    }
    const std::vector<double>& alone = result.curves.roll;
    const std::vector<double>& left = result.remaining_curves.roll;
    const auto isAbove = [nothing](double value) { return std::abs(value) > nothing; };
    const auto add = [&](const char* id, plot::CurveStyle style, const std::vector<double>& turn) {
        Figure::Curve& curve = figure.add(id, std::move(style), {}, {});
        if (turn.empty()) {
            return;
        }
        curve.y = twice(turn);
        curve.x = anglesOfTwoTurns(curve.y.size());
        if (std::any_of(turn.begin(), turn.end(), isAbove)) {
            figure.leftRange.reset();
        } else {
            std::fill(curve.y.begin(), curve.y.end(), 0.0);
        }
    };
    add("roll",
        {.name = EnginePlots::tr("roll (Mz)"),
         .role = Role::Roll,
         .width = 1.4,
         .toolTip = EnginePlots::tr("Roll moment without balancing")},
        alone);
    bool isChanged = false;
    for (std::size_t i = 0; i < std::min(alone.size(), left.size()); ++i) {
        isChanged = isChanged || isAbove(left[i] - alone[i]);
    }
    add("roll-left",
        {.name = EnginePlots::tr("residual (%1)").arg(QStringLiteral("Mz")),
         .role = Role::ResidualRoll,
         .width = 2.8,
         .toolTip = EnginePlots::tr("With rotating masses, and with the counterweights and shafts "
                                    "that are on")},
        isChanged ? left : std::vector<double>());
}

/// Forces or moments of all orders.
template <bool force>
Figure ofAllOrders(const InertiaMomentsModel& model) {
    const Result& result = model.result();
    const double nothing = rounding(result, force);
    Figure figure = overCycle(
        withRotating(force ? EnginePlots::tr("Forces over φ") : EnginePlots::tr("Moments over φ")),
        unitTitle(force));
    const QString exact = EnginePlots::tr("Sum of −m a of all moving parts, exact, all orders");
    const QString twoTerm = EnginePlots::tr("By the two-term formulas: orders 1 and 2");
    const QString left =
        EnginePlots::tr("With rotating masses, and with the counterweights and shafts that are on");
    addCourse(figure, force, turnOf(result.unbalanced_curves, force, nothing),
              turnOf(inertia_moments::with_orders(WrenchCurves(result.curves.crank_angle),
                                                  result.two_term_unbalanced),
                     force, nothing),
              isBalanced(result, force) ? turnOf(result.remaining_curves, force, nothing) : Trace(),
              {exact, exact, twoTerm, twoTerm, left, left});
    if (!force) {
        addRoll(figure, result);
    }
    return figure;
}

/// The ellipse that a rotating pair runs round.
Trace ellipse(const RotatingPair& pair) {
    constexpr int points = 96;
    Trace trace;
    for (int i = 0; i <= points; ++i) {
        const auto p = pair.at(two_pi * (i % points) / points);
        trace.x.push_back(p.real());
        trace.y.push_back(p.imag());
    }
    return trace;
}

/// The ends of the vectors of force (N) or moment (N·m) over a cycle.
template <bool force>
Figure hodograph(const InertiaMomentsModel& model) {
    const Result& result = model.result();
    Figure figure;
    figure.title =
        withRotating(force ? EnginePlots::tr("Forces") : EnginePlots::tr("Moments about z₀"));
    figure.equalScale = true;
    std::pair<double, double> x;
    std::pair<double, double> y;
    const auto include = [](std::pair<double, double>& reach, const std::vector<double>& values) {
        for (const double value : values) {
            reach = {std::min(reach.first, value), std::max(reach.second, value)};
        }
    };
    const auto add = [&](const char* id, plot::CurveStyle style, Trace trace) {
        include(x, trace.x);
        include(y, trace.y);
        figure.add(id, std::move(style), std::move(trace.x), std::move(trace.y));
    };
    const auto ofOrder = [&](int order) {
        const EngineOrder& of = result.unbalanced.order(order);
        const RotatingPair& pair = vectorOf(of, force);
        return ellipse(pair.max() > roundingOf(of, force) ? pair : RotatingPair{});
    };
    const double nothing = rounding(result, force);
    add("first",
        {.name = EnginePlots::tr("1st order"),
         .role = Role::FirstOrder,
         .toolTip = EnginePlots::tr("Exact first order (Fig. 5)"),
         .turn = turn_deg},
        ofOrder(1));
    add("second",
        {.name = EnginePlots::tr("2nd order"),
         .role = Role::SecondOrder,
         .toolTip = EnginePlots::tr("Exact second order (Fig. 5)"),
         .turn = 0.5 * turn_deg},
        ofOrder(2));
    add("all",
        {.name = EnginePlots::tr("all orders"),
         .role = Role::AllOrders,
         .width = 1.2,
         .toolTip = EnginePlots::tr("All orders, exact"),
         .turn = turn_deg},
        turnOf(result.unbalanced_curves, force, nothing));
    add("left",
        {.name = EnginePlots::tr("residual"),
         .role = Role::Residual,
         .toolTip = EnginePlots::tr("All orders with rotating masses, and with the "
                                    "counterweights and shafts that are on"),
         .turn = turn_deg},
        isBalanced(result, force) ? turnOf(result.remaining_curves, force, nothing) : Trace());
    const auto span = [](const std::pair<double, double>& of) { return of.second - of.first; };
    // Rounding of a balanced engine is not a picture.
    const double minimum = std::max(1e3 * roundingOf(result.unbalanced.order(1), force), 1e-9);
    if (std::max(span(x), span(y)) <= minimum) {
        const double reach = std::max(1.0, minimum);
        x = y = {-reach, reach};
    }
    // As much room on either axis: both have one scale.
    const double room = 0.08 * std::max(span(x), span(y));
    figure.x = {.title = force ? EnginePlots::tr("Fx, N") : EnginePlots::tr("Mx, N·m"),
                .min = x.first - room,
                .max = x.second + room};
    figure.left = {.title = force ? EnginePlots::tr("Fy, N") : EnginePlots::tr("My, N·m")};
    figure.leftRange = std::pair(y.first - room, y.second + room);
    return figure;
}

enum class Kind { Force, Moment, Roll };

/// The largest value of an order over the turn, and what of it is rounding.
std::pair<double, double> sizeOf(const EngineOrder& order, Kind kind) {
    if (kind == Kind::Roll) {
        return {inertia_moments::amplitude(order.roll()), zero_share * order.roll_scale};
    }
    const bool force = kind == Kind::Force;
    return {vectorOf(order, force).max(), roundingOf(order, force)};
}

/// The largest values of the orders as bars: exact, two-term and what balancing leaves.
template <Kind kind>
Figure byOrder(const InertiaMomentsModel& model) {
    const Result& result = model.result();
    Figure figure;
    figure.title = kind == Kind::Force    ? withRotating(EnginePlots::tr("Forces by order"))
                   : kind == Kind::Moment ? withRotating(EnginePlots::tr("Moments by order"))
                                          : EnginePlots::tr("Roll moment by order");
    const auto orders = static_cast<double>(result.unbalanced.orders.size());
    figure.x = {.title = EnginePlots::tr("order k"), .min = 0.5, .max = orders + 0.5};
    figure.left = {.title = kind == Kind::Roll ? EnginePlots::tr("M, N·m")
                                               : unitTitle(kind == Kind::Force)};
    constexpr int kinds = 3;
    const auto add = [&](const char* id, const QString& name, Role role, const EngineOrders& of) {
        const double width = 0.9 / kinds;
        const auto place = static_cast<double>(figure.curves.size()) - 0.5 * (kinds - 1);
        Figure::Curve& curve = figure.add(id,
                                          {.name = name,
                                           .role = role,
                                           .shape = plot::Shape::Bars,
                                           .barWidth = width,
                                           .barShift = place * width},
                                          {}, {});
        for (const EngineOrder& order : of.orders) {
            const auto [size, rounding] = sizeOf(order, kind);
            curve.x.push_back(order.order);
            curve.y.push_back(size <= rounding ? 0.0 : size);
        }
    };
    add("exact", EnginePlots::tr("exact"), Role::Exact, result.unbalanced);
    add("two-term", EnginePlots::tr("two-term"), Role::TwoTerm, result.two_term_unbalanced);
    add("left", EnginePlots::tr("residual"), Role::Residual, result.remaining);
    return figure;
}

/// The roll moment and its two parts, N·m.
Figure roll(const InertiaMomentsModel& model) {
    const WrenchCurves& curves = model.result().curves;
    Figure figure = overCycle(EnginePlots::tr("Roll moment on the engine"), EnginePlots::tr("N·m"));
    const auto add = [&](const char* id, plot::CurveStyle style, const std::vector<double>& turn) {
        figure.add(id, std::move(style), anglesOfTwoTurns(2 * turn.size() - 1), twice(turn));
    };
    add("sum",
        {.name = EnginePlots::tr("roll (Mz)"),
         .role = Role::Roll,
         .width = 2.0,
         .toolTip = EnginePlots::tr("Roll moment on the engine: the sum of the two")},
        curves.roll);
    add("inertia",
        {.name = EnginePlots::tr("offsets and rods"),
         .role = Role::Offset,
         .toolTip = EnginePlots::tr("Moment of the inertia forces about the crank axis: −Σ e F and "
                                    "the couples of rigid rods")},
        curves.inertia_roll);
    add("reaction",
        {.name = EnginePlots::tr("reaction torque"),
         .role = Role::Reciprocating,
         .toolTip = EnginePlots::tr("Reaction of the inertia torque on the crank, −Σ F ds/dφ")},
        curves.reaction_torque);
    return figure;
}

Notes deadCentre(const InertiaMomentsModel& model) {
    const double angle = model.result().engine.top_dead_centre(0) / degree;
    return Notes::of(Severity::note,
                     QCoreApplication::translate("ravnoves::EngineForm", "φ at TDC, cylinder 1") +
                         QStringLiteral(": %1°").arg(fixedNumber(angle, 3, QLocale())));
}

using Model = InertiaMomentsModel;
using Maker = PartMaker<Model>;
constexpr std::array makers{
    Maker{{.id = "dead-centre"}, made<deadCentre>},
    Maker{{.id = "order-1", .tab = "first-orders"}, made<ofOrder<1>>},
    Maker{{.id = "order-2", .tab = "first-orders"}, made<ofOrder<2>>},
    Maker{{.id = "left", .isAnswer = true}, made<&Model::remainingResults>},
    Maker{{.id = "orders", .tab = "table-orders", .isAnswer = true}, made<&Model::orderResults>},
    Maker{{.id = "rotating", .tab = "table-rotating", .isAnswer = true},
          made<&Model::rotatingResults>},
    Maker{{.id = "shafts", .tab = "table-shafts", .isAnswer = true}, made<&Model::shaftResults>},
    Maker{{.id = "weights", .tab = "table-weights", .isAnswer = true}, made<&Model::weightResults>},
    Maker{{.id = "hodograph-forces", .tab = "hodographs"}, made<hodograph<true>>},
    Maker{{.id = "hodograph-moments", .tab = "hodographs"}, made<hodograph<false>>},
    Maker{{.id = "forces-by-order", .tab = "orders"}, made<byOrder<Kind::Force>>},
    Maker{{.id = "moments-by-order", .tab = "orders"}, made<byOrder<Kind::Moment>>},
    Maker{{.id = "roll", .tab = "roll"}, made<roll>},
    Maker{{.id = "roll-by-order", .tab = "roll"}, made<byOrder<Kind::Roll>>},
    Maker{{.id = "forces-over-angle", .tab = "over-angle"}, made<ofAllOrders<true>>},
    Maker{{.id = "moments-over-angle", .tab = "over-angle"}, made<ofAllOrders<false>>},
};

/// True where the first two orders have no moment but a force: an engine in one plane.
bool hasForcesOnly(const Result& result) {
    bool force = false;
    for (int k = 1; k <= 2; ++k) {
        const EngineOrder& exact = result.unbalanced.order(k);
        // A moment of the balancing masses may have no scale but the forces'.
        const double rounding =
            zero_share *
            std::max(exact.moment_scale, exact.force_scale * result.engine.crank_radius);
        if (exact.moment.max() > rounding || result.remaining.order(k).moment.max() > rounding ||
            result.two_term_unbalanced.order(k).moment.max() > rounding) {
            return false;
        }
        force = force || exact.force.max() > zero_share * exact.force_scale;
    }
    return force;
}

}  // namespace

std::span<const PagePart> InertiaMomentsModel::parts() const {
    return partsOf(makers);
}

Content InertiaMomentsModel::part(std::string_view id) const {
    return makePart(makers, *this, id);
}

bool InertiaMomentsModel::showsForces() const {
    return forces_.value_or(hasForcesOnly(result()));
}

inertia_moments::Complex InertiaMomentsModel::vectorNow(int order, bool force) const {
    const EngineOrder& of = result().unbalanced.order(order);
    const RotatingPair& pair = vectorOf(of, force);
    return pair.max() > roundingOf(of, force) ? pair.at(order * crank_.degrees() * degree)
                                              : inertia_moments::Complex();
}

}  // namespace ravnoves

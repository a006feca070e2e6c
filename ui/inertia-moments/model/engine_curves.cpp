#include "inertia-moments/model/engine_curves.h"

#include <algorithm>
#include <cmath>

#include "numerics/constants.h"

namespace ravnoves::engine_curves {

using inertia_moments::EngineOrder;
using inertia_moments::Result;
using inertia_moments::RotatingPair;
using inertia_moments::WrenchCurves;
using inertia_moments::zero_share;

namespace {

constexpr int plotStep = 3;        // degrees between the points of one order
constexpr int cycleDegrees = 720;  // the paper's Fig. 6 shows two turns

/// Curves of one turn, shown over two.
std::vector<double> twice(const std::vector<double>& turn) {
    std::vector<double> both(turn);
    both.insert(both.end(), turn.begin() + 1, turn.end());
    return both;
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

void include(Interval& interval, const std::vector<double>& values) {
    for (const double value : values) {
        interval = {std::min(interval.low, value), std::max(interval.high, value)};
    }
}

}  // namespace

double Trace::reach() const {
    double reach = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        reach = std::max({reach, std::abs(x[i]), std::abs(y[i])});
    }
    return reach;
}

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

OrderMoments orderMoments(const Result& result, int order, bool force) {
    const auto pairOf = [force](const EngineOrder& of) -> const RotatingPair& {
        return force ? of.force : of.moment;
    };
    OrderMoments moments;
    constexpr auto points = static_cast<std::size_t>(cycleDegrees / plotStep) + 1;
    for (std::size_t i = 0; i < points; ++i) {
        moments.crankAngleDeg.push_back(static_cast<double>(i) * plotStep);
    }
    const EngineOrder& exact = result.unbalanced.order(order);
    const double rounding = zero_share * (force ? exact.force_scale : exact.moment_scale);
    // What is nothing but rounding is drawn as nothing.
    const auto trace = [&](const RotatingPair& pair) {
        Trace curve{std::vector<double>(points, 0.0), std::vector<double>(points, 0.0)};
        const bool something = pair.max() > rounding;
        for (std::size_t i = 0; i < points && something; ++i) {
            const auto vector = pair.at(moments.crankAngleDeg[i] * degree * order);
            curve.x[i] = vector.real();
            curve.y[i] = vector.imag();
        }
        return curve;
    };
    moments.exact = trace(pairOf(exact));
    moments.twoTerm = trace(pairOf(result.two_term_unbalanced.order(order)));
    moments.isSomething = pairOf(exact).max() > rounding;
    const RotatingPair& left = pairOf(result.remaining.order(order));
    if ((left - pairOf(exact)).max() > rounding) {
        moments.left = trace(left);
        moments.isSomething = moments.isSomething || left.max() > rounding;
    }
    return moments;
}

namespace {

/// Force or moment of an order, and what counts as nothing beside it.
const RotatingPair& vectorOf(const EngineOrder& order, bool force) {
    return force ? order.force : order.moment;
}
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

/// A curve over one turn; what is nothing but rounding is drawn as nothing.
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

/// True where counterweights or shafts change something.
bool isBalanced(const Result& result, bool force) {
    for (std::size_t i = 0; i < result.unbalanced.orders.size(); ++i) {
        const EngineOrder& before = result.unbalanced.orders[i];
        if ((vectorOf(result.remaining.orders[i], force) - vectorOf(before, force)).max() >
            roundingOf(before, force)) {
            return true;
        }
    }
    return false;
}

/// Moments about the crank are moments too: a four in line has no others.
void addRoll(Course& picture, const Result& result) {
    double nothing = 0.0;
    for (const EngineOrder& order : result.unbalanced.orders) {
        nothing += zero_share * order.roll_scale;
    }
    const auto& alone = result.curves.roll;
    const auto& left = result.remaining_curves.roll;
    const auto isAbove = [nothing](double value) { return std::abs(value) > nothing; };
    const auto shown = [&](const std::vector<double>& curve) {
        const bool something = std::any_of(curve.begin(), curve.end(), isAbove);
        picture.isSomething = picture.isSomething || something;
        return something ? twice(curve) : std::vector<double>(2 * curve.size() - 1, 0.0);
    };
    picture.roll = shown(alone);
    for (std::size_t i = 0; i < std::min(alone.size(), left.size()); ++i) {
        if (isAbove(left[i] - alone[i])) {
            picture.rollLeft = shown(left);
            break;
        }
    }
}

std::vector<double> twoTurns(std::size_t points) {
    std::vector<double> angles(points);
    for (std::size_t i = 0; i < points; ++i) {
        angles[i] = static_cast<double>(i) * cycleDegrees / static_cast<double>(points - 1);
    }
    return angles;
}

}  // namespace

inertia_moments::Complex vectorAt(const EngineOrder& order, bool force, double angle) {
    const RotatingPair& pair = vectorOf(order, force);
    return pair.max() > roundingOf(order, force) ? pair.at(angle) : inertia_moments::Complex();
}

Course course(const Result& result, bool force) {
    const double nothing = rounding(result, force);
    const auto trace = [&](const WrenchCurves& curves) {
        const Trace turn = turnOf(curves, force, nothing);
        return Trace{twice(turn.x), twice(turn.y)};
    };
    Course picture;
    picture.exact = trace(result.unbalanced_curves);
    picture.twoTerm = trace(
        inertia_moments::curves_of_orders(result.two_term_unbalanced, result.curves.crank_angle.size() - 1));
    if (isBalanced(result, force)) {
        picture.left = trace(result.remaining_curves);
    }
    picture.crankAngleDeg = twoTurns(picture.exact.x.size());
    picture.isSomething = picture.exact.reach() > 0.0 || picture.left.reach() > 0.0;
    if (!force) {
        addRoll(picture, result);
    }
    return picture;
}

Hodograph hodograph(const Result& result, bool force) {
    const double nothing = rounding(result, force);
    const auto ofOrder = [&](const EngineOrder& order) {
        const RotatingPair& pair = vectorOf(order, force);
        return ellipse(pair.max() > roundingOf(order, force) ? pair : RotatingPair{});
    };
    Hodograph picture;
    picture.first = ofOrder(result.unbalanced.order(1));
    picture.second = ofOrder(result.unbalanced.order(2));
    picture.all = turnOf(result.unbalanced_curves, force, nothing);
    if (isBalanced(result, force)) {
        picture.left = turnOf(result.remaining_curves, force, nothing);
    }
    for (const Trace* trace : {&picture.first, &picture.second, &picture.all, &picture.left}) {
        include(picture.x, trace->x);
        include(picture.y, trace->y);
    }
    // Rounding of a balanced engine is not a picture.
    const double least = std::max(1e3 * roundingOf(result.unbalanced.order(1), force), 1e-9);
    if (std::max(picture.x.span(), picture.y.span()) <= least) {
        const double reach = std::max(1.0, least);
        picture.x = picture.y = {-reach, reach};
    }
    return picture;
}

Roll roll(const Result& result) {
    const WrenchCurves& curves = result.curves;
    return {twoTurns(2 * curves.crank_angle.size() - 1), twice(curves.roll),
            twice(curves.inertia_roll), twice(curves.reaction_torque)};
}

}  // namespace ravnoves::engine_curves

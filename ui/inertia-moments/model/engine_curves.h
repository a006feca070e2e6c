#pragma once

#include <vector>

#include "inertia-moments/result.h"

namespace ravnoves::engine_curves {

/// A vector in the plane across the crank, point by point.
struct Trace {
    std::vector<double> x;
    std::vector<double> y;

    double reach() const;  ///< the largest |x| or |y|
};

/// What an axis shows.
struct Interval {
    double low = 0.0;
    double high = 0.0;

    double span() const { return high - low; }
    bool holds(const Interval& other) const { return low <= other.low && other.high <= high; }
};

/// True where the first two orders have no moment but a force: an engine in one plane.
bool hasForcesOnly(const inertia_moments::Result& result);

/// The moments (or forces) of one order over two turns, as the paper's Fig. 6 shows them, N·m (N).
struct OrderMoments {
    std::vector<double> crankAngleDeg;
    Trace exact;
    Trace twoTerm;
    Trace left;                ///< with all that acts on this order; empty where nothing does
    bool isSomething = false;  ///< one of exact and left is more than rounding
};
OrderMoments orderMoments(const inertia_moments::Result& result, int order, bool force = false);

/// Force or moment of an order at kφ (rad); 0 where it is nothing but rounding.
inertia_moments::Complex vectorAt(const inertia_moments::EngineOrder& order, bool force,
                                  double angle);

/// The ends of the vectors of force (N) or moment (N·m) over a cycle.
struct Hodograph {
    Trace first;
    Trace second;
    Trace all;
    Trace left;  ///< with rotating masses, counterweights and shafts; empty without them
    /// From the least to the largest of all of them, with the origin; wider and higher than what is
    /// only rounding.
    Interval x;
    Interval y;
};
Hodograph hodograph(const inertia_moments::Result& result, bool force);

/// Forces (N) or moments (N·m) of all orders over two turns.
struct Course {
    std::vector<double> crankAngleDeg;
    Trace exact;
    Trace twoTerm;
    Trace left;  ///< with rotating masses, counterweights and shafts; empty without them
    std::vector<double> roll;      ///< with the moments: about the crank, of the engine alone
    std::vector<double> rollLeft;  ///< with shafts; empty where they do not change it
    bool isSomething = false;      ///< one of them is more than rounding
};
Course course(const inertia_moments::Result& result, bool force);

/// The roll moment over two turns and its two parts, N·m.
struct Roll {
    std::vector<double> crankAngleDeg;
    std::vector<double> sum;
    std::vector<double> inertia;
    std::vector<double> reactionTorque;
};
Roll roll(const inertia_moments::Result& result);

}  // namespace ravnoves::engine_curves

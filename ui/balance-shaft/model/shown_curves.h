#pragma once

#include <vector>

#include "balance-shaft/envelope_study.h"
#include "balance-shaft/result.h"

// What the tabs plot of a result, in the units of their axes.
namespace ravnoves {

/// The order spectrum, N·m.
struct ShownOrders {
    std::vector<double> order;
    std::vector<double> without;  ///< a shaft
    std::vector<double> with;
};
ShownOrders shownOrders(const balance_shaft::Result& result);

/// Overall size over α, and range against overall size. The curves are closed: the first point
/// comes again at 360°.
struct ShownSizes {
    struct Point {
        double area;   ///< cm²
        double range;  ///< N·m
        double angle;  ///< °
    };
    std::vector<double> angle;       ///< °
    std::vector<double> width;       ///< mm
    std::vector<double> height;      ///< mm
    std::vector<double> area;        ///< cm²
    std::vector<double> range;       ///< N·m
    std::vector<double> builtRange;  ///< not a number where α cannot be built
    std::vector<Point> efficient;    ///< nothing that can be built is better in both
    std::vector<Point> marked;       ///< some of them, 15° apart or more
};
ShownSizes shownSizes(const balance_shaft::EnvelopeStudy& study);
/// Width × height, cm².
double boxArea(const balance_shaft::Envelope& box);

/// A computed torque and what it is made of.
struct ShownCycle {
    std::vector<double> torque;    ///< gas and inertia, N·m
    std::vector<double> pressure;  ///< bar
    std::vector<double> volume;    ///< cm³
    double largestVolume = 0.0;    ///< cm³
};
/// Empty where the torque is a table.
ShownCycle shownCycle(const balance_shaft::Result& result);

}  // namespace ravnoves

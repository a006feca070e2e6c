#pragma once

#include <vector>

#include "balance-shaft/solver.h"

namespace ravnoves::balance_shaft {

/// The fifth criterion of the paper: overall size over the shaft's angle, beside the moment's.
///
/// All vectors have one element per angle, every half degree, 0 ≤ α < 360°.
struct EnvelopeStudy {
    std::vector<double> shaft_angle_deg;
    std::vector<double> width;   ///< m, of the front view's box
    std::vector<double> height;  ///< m
    std::vector<double> area;    ///< m², width × height
    std::vector<double> range;   ///< ΔM_ups, N·m
    std::vector<bool> buildable;
    /// Feasible, and no other feasible one beats it in area or range without being worse in the
    /// other (Pareto); what differs by rounding_share is equal.
    std::vector<bool> efficient;
};

EnvelopeStudy envelope_study(const Solver& solver);

}  // namespace ravnoves::balance_shaft

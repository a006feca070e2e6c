#pragma once

#include <vector>

#include "balance-shaft/solver.h"

namespace ravnoves::balance_shaft {

/// The fifth criterion of the paper: overall size over the shaft's angle, beside the moment's.
///
/// All vectors have one element per angle, 0 ≤ α < 360°, equally spaced.
struct EnvelopeStudy {
    std::vector<double> shaft_angle_deg;
    std::vector<double> width;   ///< m, of the front view's box
    std::vector<double> height;  ///< m
    std::vector<double> area;    ///< m², width × height
    std::vector<double> range;   ///< ΔM_ups, N·m
    std::vector<bool> buildable;
    /// Feasible, and no other feasible one has both a smaller area and a smaller range (Pareto).
    std::vector<bool> efficient;
};

/// @param angles  how many, ≥ 2
EnvelopeStudy envelope_study(const Solver& solver, std::size_t angles = 720);

}  // namespace ravnoves::balance_shaft

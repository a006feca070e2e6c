#pragma once

#include <vector>

#include "numerics/periodic_piecewise.h"
#include "numerics/real50.h"

namespace ravnoves::methods {

inline constexpr double cycle_deg = 720.0;  ///< of a four-stroke engine

/// A tipping moment over the cycle of 720° with the moment of a balance shaft: what the kernels of
/// the scene "balance-shaft" work on.
struct TorqueCycle {
    std::vector<double> angle_deg;  ///< n + 1 ascending rows over 720°
    std::vector<double> moment;     ///< N·m, the last row equal to the first
    bool cubic = false;             ///< spline instead of straight lines
    double amplitude = 0.0;         ///< A = P₁ l, N·m
    double alpha = 0.0;             ///< α, rad

    PeriodicPiecewise interpolant() const {
        return cubic ? PeriodicPiecewise::cubic(angle_deg, moment)
                     : PeriodicPiecewise::linear(angle_deg, moment);
    }
    /// Largest |M| of the rows + A: what errors are relative to.
    double size() const;
};

/// The paper's engine: Table 2 at 376.8 rad/s with its shaft.
TorqueCycle paper_cycle();
/// The paper's shaft beside a tipping moment of 0: M_ups is a pure sine.
TorqueCycle pure_sine_cycle(double alpha_deg);
/// A torque with a combustion peak of 500 N·m and the given half width, on rows that are dense
/// there and every 15° elsewhere.
TorqueCycle peak_cycle(double width_deg);
/// A smooth torque on n equally spaced rows, read through the periodic spline.
TorqueCycle spline_cycle(double rows);
/// n rows at irregular angles with irregular torques, from a fixed seed.
TorqueCycle irregular_cycle(double rows);
/// A second-order torque whose best angles are two of equal range, and a first-order one of `share`
/// of it that makes one of them better.
TorqueCycle two_minima_cycle(double share);

}  // namespace ravnoves::methods

#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "methods/definition.h"
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
/// A second-order torque with two best angles of equal range, and a first-order one of `share` of
/// its size that makes one of them better.
TorqueCycle two_minima_cycle(double share);

/// The hard parameters of torques with those ids.
std::vector<Sweep<TorqueCycle>> torque_sweeps(std::initializer_list<std::string_view> ids);

}  // namespace ravnoves::methods

#pragma once

#include <optional>

namespace ravnoves::v8_plugs {

/// What the balancing machine has to reach, and what it reads.
struct BalancingCheck {
    double grade;                         ///< G = e ω, m/s
    double rotor_mass;                    ///< crankshaft with bob weights, kg
    double service_speed;                 ///< ω, rad/s
    double front_share = 0.5;             ///< part of the permissible unbalance in the front plane
    std::optional<double> front_reading;  ///< kg·m
    std::optional<double> rear_reading;   ///< kg·m

    friend bool operator==(const BalancingCheck&, const BalancingCheck&) = default;
};

/// One correction plane.
struct PlaneVerdict {
    double permissible;             ///< kg·m
    std::optional<double> reading;  ///< kg·m
    std::optional<bool> passes;     ///< nothing while there is no reading
};

struct BalancingVerdict {
    double permissible;  ///< U_per = m G / ω of the whole rotor, kg·m
    PlaneVerdict front;
    PlaneVerdict rear;
};

/// Permissible residual unbalance by [iso-21940-11], U_per = 1000 m G / ω in g·mm for m in kg and G
/// in mm/s, shared between the planes; and the readings against it. The standard keeps each
/// plane's share between 0.3 and 0.7.
BalancingVerdict judge(const BalancingCheck& check);
/// A reading against a limit, kg·m.
PlaneVerdict judge(double limit, const std::optional<double>& reading);

}  // namespace ravnoves::v8_plugs

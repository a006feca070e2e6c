#pragma once

#include <vector>

namespace ravnoves::balance_shaft {

/// A stretch of a shaft with one section all along.
struct ShaftPiece {
    double length = 0.0;           ///< m
    double stiffness = 0.0;        ///< E I, N·m²
    double mass = 0.0;             ///< ρ A, kg/m
    double eccentricity = 0.0;     ///< of the section's centroid from the axis, m
    double area = 0.0;             ///< m²
    double section_modulus = 0.0;  ///< I over the largest distance from the neutral axis, m³
};

/// How a shaft bends in its bearings: at rest under its weight and at speed under the centrifugal
/// load of its eccentric sections, which grows with the deflection. The weight counts in the
/// direction of the centrifugal load; that it shakes a section which bends more easily one way,
/// with a resonance between half and 1/√2 of the whirling speed, is left out.
struct ShaftBending {
    double critical_speed = 0.0;  ///< first whirling speed, rad/s
    double weight_sag = 0.0;      ///< largest deflection at rest, m
    double deflection = 0.0;      ///< largest at speed, with the weight's, m
    double journal_slope = 0.0;   ///< larger one in the bearings at speed, with the weight's, rad
    double bearing_load = 0.0;    ///< larger one, centrifugal and weight, N
    double bending_stress = 0.0;  ///< largest, Pa
    double combined_stress = 0.0;  ///< largest √(σ² + 3 τ²), τ = 4/3 of the mean shear stress, Pa
};

inline constexpr double shortest_shaft_piece = 1e-3;  ///< share of the whole

/// Finite elements of the beam of Euler and Bernoulli on two simple supports at its ends, 24 of
/// them or more: the whirling speed is off by less than 1e-6 of itself, static deflections at the
/// nodes and bearing loads only by rounding. Shear, which is left out, lowers the whirling speed of
/// a round bar of diameter D between bearings L apart by a share of 0.9 (D/L)².
///
/// At speeds from the whirling speed on all is left 0 but the critical speed, the weight's sag.
/// @param pieces  from bearing to bearing; those shorter than shortest_shaft_piece are left out
/// @param angular_speed  ω, rad/s
ShaftBending shaft_bending(const std::vector<ShaftPiece>& pieces, double angular_speed);

}  // namespace ravnoves::balance_shaft

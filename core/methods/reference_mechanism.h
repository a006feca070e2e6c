#pragma once

#include "elastic-hinge/input.h"
#include "methods/definition.h"
#include "numerics/real50.h"
#include "numerics/slider_crank.h"

/// Mechanisms in 50 digits from the closure of their links alone: what kernels are measured
/// against. No formula of the scenes is used.
namespace ravnoves::methods {

/// s, s′, s″ of the piston pin from (s − x)² + y² = L², x = R cos θ, y = R sin θ − e, and from what
/// differentiating that once and twice gives. The mechanism must not lock.
PistonMotion<Real50> reference_piston(const SliderCrank<double>& crank, const Real50& theta);

/// The distance from locking of a mechanism in units of R, as the paper's VR5 has it: by λ without
/// an offset, and by the offset.
/// @param nearest        of the sweeps
/// @param scene_nearest  that the scene answers for
std::vector<Sweep<SliderCrank<double>>> slider_crank_sweeps(double nearest, double scene_nearest);

/// The elastic-hinge scene's mechanism, without counterweight.
class ReferenceBars {
  public:
    explicit ReferenceBars(const elastic_hinge::Input& input);
    /// Twice the kinetic energy of the three bodies at crank speed 1, kg·m².
    Real50 inertia(const Real50& phi) const;
    /// Their potential energy, J.
    Real50 potential(const Real50& phi) const;

  private:
    Real50 crank_mass_, rod_mass_, slider_mass_, gravity_, radius_, length_;
};

}  // namespace ravnoves::methods

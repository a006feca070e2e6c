#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "balance-shaft/input.h"
#include "balance-shaft/moments.h"
#include "balance-shaft/result.h"
#include "balance-shaft/shaft_places.h"

namespace ravnoves::balance_shaft {

/// Prepares all that does not depend on α once (curve of M_up, its exact integrals, its first
/// order, the sweep over α, the best α), so that moving the shaft costs about a microsecond.
///
/// Copyable and cheap to copy (the prepared part is shared and constant); const member functions
/// may run in several threads.
class Solver {
  public:
    /// @throws InputError as check_input()
    explicit Solver(const Input& input);

    const Input& input() const { return prepared_->input; }
    /// The whole result at the input's α.
    Result result() const;
    /// Sets α in a result of this solver and updates all that follows it; allocates nothing
    /// for tables of up to 1000 different angles modulo 360°.
    /// @param shaft_angle  rad, any finite angle
    void move_shaft(double shaft_angle, Result& result) const;

    /// N·m; angle in rad, any.
    double M_up(double crank_angle) const { return moments().moment(crank_angle / degree); }
    /// N·m, equation (4).
    double M_s(double crank_angle, double shaft_angle) const {
        return moments().forces.moment_amplitude *
               std::sin(shaft_angle + crank_angle + moments().phase);
    }
    const Moments& moments() const { return *prepared_; }
    const BuildableAngles& buildable() const { return prepared_->base.buildable; }
    /// ΔM_ups of the continuous cycle at α, N·m.
    double range(double shaft_angle) const {
        return moments().plane.range(moments().shaft_moment(shaft_angle));
    }
    /// RMS of M_ups about its mean at α, N·m.
    double rms(double shaft_angle) const {
        return moments().plane.rms(moments().shaft_moment(shaft_angle));
    }
    const FrontView& front_view() const { return prepared_->places.view(); }

  private:
    struct Prepared : Moments {
        explicit Prepared(const Input& checked);

        void prepare_spectrum();
        void prepare_curves();
        void prepare_buildable();
        void prepare_sweep();
        void prepare_notes();

        Input input;
        ShaftPlaces places;
        /// What result() starts from: all but what follows the shaft's angle.
        Result base;
        std::vector<double> cos_curve;  ///< cos φ and sin φ at the curves' angles
        std::vector<double> sin_curve;
    };

    std::shared_ptr<const Prepared> prepared_;
};

/// Solver(input).result().
/// @throws InputError as check_input()
Result solve(const Input& input);

/// A point (m) or a force (N) in the front view.
struct Vector2 {
    double x = 0.0;
    double y = 0.0;
};

/// The mechanism at one crank angle, for the picture.
struct MechanismPose {
    Vector2 crankpin;
    Vector2 piston_pin;
    Vector2 crank_counterweight;  ///< its centre of mass
    Vector2 shaft_axis;
    Vector2 shaft_counterweight;  ///< its centre of mass
    Vector2 inertia_force_1;      ///< of the reciprocating mass, first order, at the piston pin
    Vector2 crank_counterweight_force;
    Vector2 shaft_counterweight_force;
};

/// The pose at a crank angle and a shaft angle, both rad, any.
MechanismPose mechanism_pose(const Solver& solver, double crank_angle, double shaft_angle);

}  // namespace ravnoves::balance_shaft

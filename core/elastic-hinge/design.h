#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "elastic-hinge/input.h"
#include "elastic-hinge/kinematics.h"

namespace ravnoves::elastic_hinge {

/// Equally spaced crank angles over one turn, both ends included.
struct AngleGrid {
    std::vector<double> angle_deg;  ///< 0…360
    std::vector<double> angle;      ///< rad
    std::vector<double> sin_phi;    ///< exact at multiples of 90°
    std::vector<double> cos_phi;

    std::size_t size() const { return angle.size(); }
};

/// The grid of `samples` angles (at least 13); the last one asked for is kept per thread.
std::shared_ptr<const AngleGrid> angle_grid(int samples);

/// What one crank angle of a mechanism has in common for every crank speed.
struct AngleState {
    RodAngle<double> exact;          ///< undefined for λ = 1, as is `inertia`
    ReducedInertia<double> inertia;  ///< always of the exact kinematics
    RodHingeMoment<double> moment;   ///< of the chosen kinematics
    double cos_psi;                  ///< of the chosen kinematics
};

/// Which hinge a guide is for.
enum class Hinge {
    crank,           ///< between frame and crank: gives M; turns through φ
    crank_with_rod,  ///< between frame and crank where the rod has its hinge: gives M₁, through φ
    rod,  ///< between crank and rod: gives M₁₂'s potential part; through θ = φ + ψ
};

/// What a hinge has to give out, at one crank angle. Derivatives are by the hinge's own angle.
struct Demand {
    double polar_angle;  ///< rad: φ or θ, the angle that the hinge has turned through
    double dpolar;       ///< d polar_angle / dφ, > 0
    double energy;       ///< J given out since φ = 0
    double moment;       ///< d energy / d polar_angle, N·m
    double dmoment;      ///< d moment / d polar_angle, N·m
};

/// The minimum and the maximum energy that a hinge has given out, over the turn.
struct DemandRange {
    double min = 0.0;        ///< J, ≤ 0
    double max = 0.0;        ///< J, ≥ 0
    double min_angle = 0.0;  ///< crank angle, rad, 0…2π
    double max_angle = 0.0;

    double span() const { return max - min; }  ///< J
};

/// All that follows from mechanism and design speed, before any spring is chosen.
///
/// Immutable after construction; const members may run in several threads.
class Design {
  public:
    /// @param with_rod  else nothing may be asked of the rod's hinge, nor of the crank's beside it
    /// @param with_moments  of the states; with_rod needs them
    /// @param samples  crank angles of the grid
    /// @throws InputError as check_input()
    explicit Design(const Input& input, bool with_rod = true, bool with_moments = true,
                    int samples = 721);

    const Mechanism<double>& mechanism() const { return mechanism_; }
    double angular_speed() const { return omega_; }
    /// False for λ = 1: M, M₁ and every guide need the exact kinematics.
    bool has_exact_kinematics() const { return mechanism_.lambda < 1.0; }

    /// ∮ M₁₂ dφ, J: the inertia part is odd in φ, the weights leave g × static moment × ∮ cos ψ dφ,
    /// which is 4 E(λ) exactly and 2π (1 − λ²/4) for the series. Independent of ω.
    double rod_hinge_integral() const { return integral_; }
    /// Its mean over the turn, N·m: what (5) takes off.
    double rod_hinge_mean() const { return integral_ / two_pi; }
    /// (m₃ + m₂/2) ℓ − m₄ ℓ₂, kg·m; exactly 0 for a counterweight that was solved.
    double static_moment() const { return static_moment_; }

    /// M₁₂ by the chosen kinematics.
    RodHingeMoment<double> rod_moment(double sin_phi, double cos_phi) const;
    /// Work of M₁₂'s potential part from φ = 0: ∫ (M₁₂ − mean) dθ, J. Periodic.
    /// @param phi  rad, any. Needs the exact kinematics.
    double rod_work(double phi) const;

    /// Needs the exact kinematics.
    Demand demand(Hinge hinge, double phi) const;
    /// The same at an angle of the grid.
    Demand demand_at(Hinge hinge, std::size_t i) const;
    const DemandRange& range(Hinge hinge) const { return ranges_[static_cast<int>(hinge)]; }

    const AngleGrid& grid() const { return *grid_; }
    /// At the angles of the grid.
    const std::vector<AngleState>& states() const { return states_; }

  private:
    void tabulate_states(bool with_moments);
    void tabulate_work();
    /// From the state of the angle.
    Demand demand(Hinge hinge, double phi, double sin_phi, double cos_phi, const AngleState& state,
                  double work) const;
    void find_range(Hinge hinge);
    double work_slope(double phi) const;
    double integrate_work(double from, double to) const;

    Mechanism<double> mechanism_;
    double omega_;
    Kinematics kinematics_;
    double static_moment_;
    double integral_;
    bool sharp_;  ///< λ so near 1 that the grid's step is too coarse for interpolation
    std::shared_ptr<const AngleGrid> grid_;
    std::vector<AngleState> states_;
    std::vector<double> work_;
    std::function<double(double)> interpolated_work_;
    DemandRange ranges_[3];
};

}  // namespace ravnoves::elastic_hinge

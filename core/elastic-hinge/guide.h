#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "case-file/message.h"
#include "elastic-hinge/design.h"
#include "elastic-hinge/input.h"

namespace ravnoves::elastic_hinge {

/// A point of the roller centre's path in the guide's polar coordinates.
struct GuidePoint {
    double angle;   ///< polar angle, rad: the hinge's own angle
    double radius;  ///< ρ, m; not a number where the guide does not exist
    double slope;   ///< dρ/d angle, m
    double second;  ///< d²ρ/d angle², m

    /// Curvature of the path, 1/m; positive where it bends around the centre, as a circle does.
    double curvature() const;
};

/// A point in the guide's plane, m.
struct PlanePoint {
    double x = 0.0;
    double y = 0.0;
};

/// The point at a distance along the path's outward normal (inward where negative), m: the profile
/// that a roller of that radius touches.
PlanePoint offset_point(const GuidePoint& point, double distance);

/// (3), ρ = ℓ₀/2 ∓ √(ℓ₀²/4 − B) with B = ℓ₀ρ₀ − ρ₀² + q, without cancellation:
/// ρ = ρ₀ ± q / (d₀ + √(d₀² − q)), m.
/// @param q  energy that the spring gives out since φ = 0, divided by 2c, m²; at most the square of
/// the preload d₀, else the guide does not exist there (not a number)
double guide_radius(const Spring& spring, Branch branch, double q);

/// The guide as a function of the crank angle: equation (3) for one hinge, one spring.
///
/// Owns its design; const members may run in several threads.
class GuideShape {
  public:
    /// The sign does not apply to the rod's hinge, whose guide always does the work of M₁₂.
    /// @param design  with exact kinematics
    GuideShape(std::shared_ptr<const Design> design, Hinge hinge, const Spring& spring,
               GuideSign sign);

    const Design& design() const { return *design_; }
    const Spring& spring() const { return spring_; }

    /// At a crank angle in rad, any; the radius is not a number where the spring would have to
    /// give out more than it stores.
    GuidePoint at(Branch branch, double phi) const {
        return at(branch, design_->demand(hinge_, phi));
    }
    GuidePoint at(Branch branch, const Demand& demand) const;
    /// Both branches at once: compressed, stretched.
    std::pair<GuidePoint, GuidePoint> both(const Demand& demand) const;
    /// What (3) calls B − ℓ₀ρ₀ + ρ₀²: energy given out / 2c, m².
    double given_out(const Demand& demand) const { return scale_ * demand.energy; }
    /// The same over the turn.
    DemandRange given_out() const;

    /// Negative rounding of preload² − given_out(), m²: a preload of exactly the minimum makes a
    /// guide.
    double rounding() const { return rounding_; }

  private:
    std::shared_ptr<const Design> design_;
    Hinge hinge_;
    Spring spring_;
    double scale_;     ///< ± 1 / (2c), m²/J
    double rounding_;  ///< of preload² − energy given out, m²
};

/// One branch of a guide.
struct BranchSummary {
    bool exists = false;
    double min_radius = 0.0;  ///< of the roller centre's path, m
    double max_radius = 0.0;
    double smallest_curvature_radius = 0.0;  ///< of the path, m
    /// The largest roller that follows the path without undercutting its profile, m. Empty: any.
    std::optional<double> largest_roller_radius;
    bool undercut = false;            ///< the input's roller is larger than that
    double profile_min_radius = 0.0;  ///< of the profile for the input's roller, m
    double profile_max_radius = 0.0;
    double max_pressure_angle = 0.0;  ///< rad
};

/// Both ends of the spring have a roller, 2ρ apart at every angle. The tracks differ by half a
/// turn, so they are beside each other and the rollers cannot collide; larger ones than the minimum
/// ρ leave no room for a spring in their planes. A sentence; empty where the rollers are apart.
Message overlap_note(Hinge hinge, const BranchSummary& branch, double roller_radius);

/// What waves on a guide's profile do: ε sin(n × polar angle + any phase) added to ρ.
struct ProfileError {
    double amplitude = 0.0;  ///< ε, m
    int waves = 0;           ///< n
    double torque = 0.0;     ///< maximum error of the hinge's moment over angle and phase, N·m
    double relative = 0.0;   ///< that against the hinge's maximum moment; 0 where it has none
    double energy = 0.0;     ///< maximum error of the spring's energy, J
};

/// A guide with all that a designer asks about it.
struct Guide {
    Hinge hinge = Hinge::crank;
    bool feasible = false;
    Message reason;              ///< why not, as a sentence; empty where feasible
    bool lacks_preload = false;  ///< that is why: Π < 0 somewhere

    double preload = 0.0;                     ///< |ℓ₀/2 − ρ₀|, m
    double minimum_preload = 0.0;             ///< that the guide needs, m
    std::optional<double> minimum_stiffness;  ///< that would do with this preload, N/m; empty: none
    double first_missing_angle = 0.0;         ///< crank angle where the guide first ends, rad
    double worst_angle = 0.0;  ///< crank angle where most energy has been given out, rad

    double relief = 0.0;                ///< max ρ − min ρ, m
    double largest_spring_force = 0.0;  ///< N
    double smallest_spring_force = 0.0;
    double largest_moment = 0.0;         ///< of the hinge, N·m
    Branch branch = Branch::compressed;  ///< of ρ₀
    BranchSummary compressed;
    BranchSummary stretched;
    ProfileError error;

    /// At the crank angles of the result; not a number where there is no guide.
    std::vector<double> polar_angle;        ///< rad
    std::vector<double> radius_compressed;  ///< m
    std::vector<double> radius_stretched;

    std::shared_ptr<const GuideShape> shape;  ///< empty without spring or exact kinematics

    const BranchSummary& summary() const { return summary(branch); }
    const BranchSummary& summary(Branch of) const {
        return of == Branch::compressed ? compressed : stretched;
    }
};

/// Builds the guide.
/// @param by_angle  else only what the range of the demands tells
Guide make_guide(std::shared_ptr<const Design> design, Hinge hinge,
                 const std::optional<Spring>& spring, const Input& input, bool by_angle);

}  // namespace ravnoves::elastic_hinge

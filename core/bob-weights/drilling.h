#pragma once

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ravnoves::bob_weights {

/// A hole drilled radially from a rim, or a slug in such a hole. SI.
struct Hole {
    double diameter;
    double depth;  ///< of the full diameter, without the cone of the point
    double angle;
    double mass;               ///< taken off, kg; of a slug: added, less what its hole took off
    double unbalance;          ///< of that mass about the crank axis, kg·m
    double slug = 0.0;         ///< the slug's own mass, kg
    double slug_radius = 0.0;  ///< of its centre of mass about the crank axis, m
    /// Of a hole that was there and is deepened: its place in the record, the run and the hole in
    /// it. Mass and unbalance are then what the deepening takes off.
    struct Place {
        std::size_t run;
        std::size_t hole;

        friend bool operator==(const Place&, const Place&) = default;
    };
    std::optional<Place> deepens{};
    double from_depth = 0.0;  ///< m
    bool is_axial = false;    ///< a slug parallel to the crankshaft

    /// The centrifugal force of the slug, N, at a speed in rad/s: m r ω².
    double slug_force(double speed) const { return slug * slug_radius * speed * speed; }

    friend bool operator==(const Hole&, const Hole&) = default;
};

/// The metal that a drill removes: ρ ∫ A(x) dx and ρ ∫ A(x) (R − x) dx over full diameter and cone.
/// For a slug the metal that it adds: its density over the full diameter, less the drilled metal,
/// for the cone beneath it remains empty.
struct Removed {
    double mass;        ///< kg
    double unbalance;   ///< kg·m
    double slug = 0.0;  ///< the slug's own mass, kg
};

/// One tool and where it works.
struct Cut {
    double radius;                         ///< R of the rim, m
    double density;                        ///< of the drilled metal, kg/m³
    double point_angle;                    ///< rad; π is flat
    std::optional<double> slug_density{};  ///< of the slug, kg/m³
    /// Metal between a slug parallel to the axis and the rim, m; empty for a radial one.
    std::optional<double> axial_wall{};

    /// Length of the cone, m.
    double cone(double diameter) const;
    /// From the crank axis to the middle of the full diameter, m.
    double lever(double diameter, double depth) const;
    Removed removed(double diameter, double depth) const;
};

/// A piece of the rim that has been drilled before.
struct Taken {
    double angle;  ///< its middle, rad
    /// To either side, half the wall included, rad; empty where there is no room at all.
    std::optional<double> half_width;
};

/// Where holes may be.
struct HoleLimits {
    double maximum_depth;  ///< m
    double depth_step;     ///< m; 0: depths are not rounded
    double minimum_wall;   ///< m
    int maximum_holes;
    double maximum_angle;  ///< from the heavy spot to a new hole, rad
    /// The sector that may be drilled, from and to, rad: new holes are wholly inside.
    std::optional<std::pair<double, double>> sector;
    std::vector<Taken> taken{};          ///< of the holes of earlier runs
    double smallest_depth = 0.0;         ///< m
    std::optional<double> heavy_spot{};  ///< rad; empty: where the holes are to take off

    /// Whether the middle of a hole may be there.
    bool allows(double angle) const;
};

/// Why the holes fall short of their target.
enum class Shortfall {
    none,
    nothing_fits,     ///< the smallest hole takes off too much
    too_little_room,  ///< the holes that have room take off too little
    rounding,         ///< the rounding of the depths leaves more than it may
    outside_sector,   ///< the sector that may be drilled is elsewhere
    beside_sector,    ///< it is beside the heavy spot, and holes at its limit leave too much
    light_slugs,      ///< slugs are hardly heavier than what their holes take off
    short_slugs       ///< a slug as long as may be does not outweigh the cone of its hole
};

struct HolePlan {
    std::vector<Hole> holes;
    double left;  ///< target less what the holes take off in its direction, kg·m; signed
    Shortfall shortfall = Shortfall::none;
};

/// What a hole takes of the rim to either side, rad: from its middle to the plane through the axis
/// that is half the wall away from its bottom; nothing where it reaches so near to the axis that no
/// plane is.
std::optional<double> half_width(const Cut& cut, double diameter, double depth, double wall);

/// How far the edge of a hole in the sector exceeds one of its limits, at its bottom, m; 0 inside.
double edge_beyond(const Cut& cut, const std::pair<double, double>& sector, const Hole& hole);

/// Equal holes to both sides of `angle` that remove `target` there: as few as possible, with the
/// tool that removes the minimum of metal. The holes' unbalances add up along the angle by
/// symmetry.
/// @param target     kg·m
/// @param tolerance  permissible residual, kg·m; negative where unknown: then the smallest that the
///                   rounding of the depths allows
HolePlan plan_holes(double target, double angle, const Cut& cut, std::span<const double> diameters,
                    const HoleLimits& limits, double tolerance);

/// The same where the sector does not reach the angle, or holes leave no room about it: about an
/// angle in the sector as near to it as the holes have room, to take off target · cos of the angle
/// between.
/// @return its `left` is the size of the vector that they leave; no holes where none lowers it
HolePlan plan_beside_sector(double target, double angle, const Cut& cut,
                            std::span<const double> diameters, const HoleLimits& limits,
                            double tolerance);

/// Why there is no room for a hole at an angle.
enum class NoRoom {
    none,         ///< there is
    too_deep,     ///< deeper than a hole may be
    behind_wall,  ///< the wall leaves it none
    in_sector,    ///< its edge would be beyond a limit
    beside_hole   ///< one that was drilled before is too near
};
NoRoom room_at(double angle, const Cut& cut, double diameter, double depth,
               const HoleLimits& limits);
/// The smallest and the largest depth of a hole, by the steps, m.
double smallest_hole(const HoleLimits& limits);
double deepest_hole(double diameter, const Cut& cut, const HoleLimits& limits);

/// Deepens present holes to minimise the residual unbalance: one where that is enough, else two,
/// else as many as help. Each keeps its wall to all others.
/// @param unbalance  of the plane, kg·m and direction
/// @param holes      their present depth in `depth`; `limits.taken` excludes them
/// @param enough     permissible residual, kg·m; the residual of the steps of the depths is enough,
///                   too, within the limit
/// @param limit      kg·m; infinity where unknown
/// @return the deepened ones, with mass and unbalance of the difference
HolePlan plan_deepening(std::complex<double> unbalance, const std::vector<Hole>& holes,
                        const Cut& cut, const HoleLimits& limits, double enough, double limit);

/// The two vectors U₁, U₂ at z₁, z₂ of the same force and moment as those at other positions.
std::array<std::complex<double>, 2> carried_over(
    const std::array<std::complex<double>, 2>& unbalance, const std::array<double, 2>& from,
    const std::array<double, 2>& to);

/// An angle in the turn 0 ≤ angle < 2π.
double turn_of(double angle);

/// Whether drills of that diameter are usual: by twentieths of a millimetre, or 64ths of an inch.
/// @param diameter  m
bool is_usual_drill(double diameter);

}  // namespace ravnoves::bob_weights

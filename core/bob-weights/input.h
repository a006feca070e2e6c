#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "case-file/field.h"
#include "numerics/constants.h"
#include "shop/job_header.h"
#include "shop/weigh_in.h"

namespace ravnoves {
class FieldVisitor;
}

/// Bob weights for the crankpins of any engine, and the correction of its crankshaft in two planes.
///
/// Angles of the balancing machine count from its zero mark, in one sense for readings and holes.
namespace ravnoves::bob_weights {

inline constexpr int max_cylinders = 64;
inline constexpr std::size_t max_runs = 9;  ///< of the machine, the one before drilling included

enum class EngineType { v, in_line, boxer };

struct Engine {
    EngineType type = EngineType::v;
    int cylinders = 8;
    std::optional<double> bank_angle;  ///< γ, rad; of a V
    int rods_per_pin = 2;
    /// δ, rad: the split of a throw's crankpins, positive where the firing interval of its two
    /// cylinders grows from γ to γ + δ.
    double pin_split = 0.0;

    /// A split crankpin is two, each with a rod and a bob weight of its own.
    int rods_on_crankpin() const { return pin_split != 0.0 ? 1 : rods_per_pin; }
    int crankpins() const { return cylinders / rods_on_crankpin(); }
    friend bool operator==(const Engine&, const Engine&) = default;
};

/// The balance factor: the part of the reciprocating mass in the bob weight.
struct Factor {
    std::optional<double> reciprocating;  ///< 1 for 100 %; empty: what theory gives
    double overbalance = 0.0;             ///< added to it

    friend bool operator==(const Factor&, const Factor&) = default;
};

/// Masses of one cylinder's parts, kg.
struct Parts {
    std::optional<double> piston;
    std::optional<double> pin;
    std::optional<double> rings;
    std::optional<double> locks;
    std::optional<double> small_end;
    std::optional<double> big_end;
    std::optional<double> shells;  ///< of one rod
    std::optional<double> oil;     ///< in one crankpin

    friend bool operator==(const Parts&, const Parts&) = default;
};

/// How a part counts in the bob weight.
enum class PartKind { reciprocating, rotating, crankpin };

/// One part: its description, where its mass is kept, and its column of the weigh-in sheet.
struct PartField {
    Field field;
    std::optional<double> Parts::*member;
    PartKind kind;
    std::optional<shop::Part> column;

    bool is_needed() const { return member == &Parts::piston || member == &Parts::big_end; }
};
/// In the order of a trade card: what reciprocates, what rotates, the oil.
std::span<const PartField> part_fields();

using shop::WeighIn;

/// One plane in which the crankshaft is corrected.
struct Plane {
    std::optional<double> position;    ///< along the crankshaft, m
    std::optional<double> radius;      ///< R, m: the rim that is drilled
    std::optional<double> from_angle;  ///< rad; the sector in which it may be drilled
    std::optional<double> to_angle;    ///< rad

    /// In which it may be drilled; nothing where not both ends are given.
    std::optional<std::pair<double, double>> sector() const {
        return from_angle && to_angle ? std::optional(std::pair(*from_angle, *to_angle))
                                      : std::nullopt;
    }
    /// One end is given, which says nothing.
    bool has_half_sector() const { return from_angle.has_value() != to_angle.has_value(); }

    friend bool operator==(const Plane&, const Plane&) = default;
};

/// What the machine reads: the heavy spot.
struct Reading {
    /// m; the plane's where empty. Runs before the newest are read where that is, and have none.
    std::optional<double> position;
    std::optional<double> unbalance;   ///< kg·m
    std::optional<double> angle;       ///< rad
    std::optional<double> bob_weight;  ///< that hung on the crankpins then, kg
    shop::ReadShaft shaft;

    friend bool operator==(const Reading&, const Reading&) = default;
};

/// Whether anything of a reading was given.
inline bool has_number(const Reading& reading) {
    return reading.unbalance || reading.angle;
}

/// Whether an unbalance has a direction: nothing has none.
constexpr bool has_direction(double unbalance) {
    return unbalance != 0.0;
}

/// A vector that is all read.
inline bool is_read(const Reading& reading) {
    return reading.unbalance && (reading.angle || !has_direction(*reading.unbalance));
}

/// The readings, with the positions of others; without one where the others have none.
std::vector<Reading> at_places_of(const std::vector<Reading>& others,
                                  std::vector<Reading> readings);

enum class PlaneName { front, rear };

/// What became of a planned hole.
enum class HoleState {
    as_planned,
    measured,     ///< depth and angle are those that were found
    not_drilled,  ///< it is not there
    wrong_side    ///< it is half a turn away
};

/// The direction of a slug in the counterweight.
enum class SlugDirection {
    axial,  ///< parallel to the crankshaft, as far below the rim as the wall between holes
    radial  ///< from the rim, open there
};

/// A hole that was planned after a run, or a slug.
struct DrilledHole {
    PlaneName plane = PlaneName::front;  ///< in which it is, whatever was planned
    double diameter = 0.0;               ///< m
    double depth = 0.0;                  ///< of the full diameter, m
    double from_depth = 0.0;             ///< of the hole that was deepened, m
    double angle = 0.0;                  ///< of the metal, rad
    /// Taken off, kg; negative: a slug, less what its hole took off; empty: by the sizes.
    std::optional<double> mass;
    std::optional<double> unbalance;  ///< of that mass by the plan, kg·m; of holes
    std::optional<double> slug;       ///< the slug's own mass, kg
    SlugDirection direction = SlugDirection::radial;
    HoleState state = HoleState::as_planned;

    bool is_slug() const { return slug || mass.value_or(0.0) < 0.0; }
    /// From `angle` to where the metal is missing, and back: half a turn on the wrong side.
    double turned(double value) const;

    friend bool operator==(const DrilledHole&, const DrilledHole&) = default;
};

/// The holes drilled after a run.
struct DrillingRecord {
    /// Planned when the next run began; empty: unknown.
    std::optional<std::vector<DrilledHole>> drilled;
    /// The readings of that plan, where they have been corrected since.
    std::vector<Reading> drilled_by;
    /// The machine's degrees counted the other way then.
    bool counted_otherwise = false;

    /// Any of the holes is there.
    bool is_drilled() const {
        return drilled && std::ranges::any_of(*drilled, [](const DrilledHole& hole) {
                   return hole.state != HoleState::not_drilled;
               });
    }

    friend bool operator==(const DrillingRecord&, const DrillingRecord&) = default;
};

/// A run of the machine whose holes have been drilled since.
struct EarlierRun : DrillingRecord {
    std::vector<Reading> readings = std::vector<Reading>(2);

    friend bool operator==(const EarlierRun&, const EarlierRun&) = default;
};

/// The drills at hand, and what limits the holes.
struct Drill {
    std::vector<double> diameters_mm;
    double density = steel_density;        ///< of the crankshaft, kg/m³
    std::optional<double> maximum_depth;   ///< of the full diameter, m
    double point_angle = 118.0 * degree;   ///< 180°: a flat end
    double depth_step = 0.1e-3;            ///< depths are rounded to it, m; 0: not rounded
    double minimum_wall = 3e-3;            ///< between holes, m
    int maximum_holes = 5;                 ///< in a plane
    double maximum_angle = 60.0 * degree;  ///< from the heavy spot to the last hole

    friend bool operator==(const Drill&, const Drill&) = default;
};

/// Heavy metal that is pressed into the counterweight.
struct Slug {
    std::optional<double> diameter;  ///< m
    std::optional<double> density;   ///< kg/m³
    SlugDirection direction = SlugDirection::axial;

    friend bool operator==(const Slug&, const Slug&) = default;
};

/// How much the holes take off.
enum class Aim {
    zero,      ///< all that they can
    tolerance  ///< as few holes as bring it within its limit
};

struct Correction {
    std::vector<Plane> planes = std::vector<Plane>(2);
    std::vector<Reading> readings = std::vector<Reading>(2);  ///< of the newest run: corrected
    /// Of the newest run, where a further one was begun and emptied again.
    DrillingRecord record;
    /// Planned when the job card was printed or the job put aside: by it the shop drills.
    DrillingRecord planned;
    std::vector<EarlierRun> earlier_runs;  ///< from the first, before drilling
    Drill drill;
    std::optional<Slug> slug;
    double smallest_depth = 1.5e-3;  ///< of a new hole, m
    Aim aim = Aim::zero;
    bool deepens = true;  ///< holes that are there; never in cases of bob-weights

    friend bool operator==(const Correction&, const Correction&) = default;
};

/// Place of the first run of the machine: what has no readings, not even blank ones, before it
/// represents the holes that were there.
inline std::size_t first_run(const std::optional<Correction>& correction) {
    return correction && !correction->earlier_runs.empty() &&
                   correction->earlier_runs.front().drilled &&
                   correction->earlier_runs.front().readings.empty()
               ? 1
               : 0;
}

/// What may remain: a grade, or an unbalance for each plane.
struct Tolerance {
    bool by_grade = true;
    std::optional<double> grade;          ///< G, m/s
    std::optional<double> rotor_mass;     ///< with the bob weights, kg
    std::optional<double> service_speed;  ///< rad/s
    std::optional<double> plane;          ///< kg·m
    // Where they are known, the share of each plane follows from them.
    std::optional<double> centre_of_mass;  ///< along the crankshaft, m
    std::optional<double> front_bearing;   ///< m
    std::optional<double> rear_bearing;    ///< m
    double front_share = 0.5;              ///< of the front plane where no places say it

    friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

/// Whether damper and flywheel carry a part of the counterweights.
enum class Balance { internal, external };

/// The input of the scene.
struct Input {
    Engine engine;
    Factor factor;
    Parts parts;
    std::optional<WeighIn> weigh_in;
    Balance balance = Balance::internal;
    std::optional<Correction> correction;
    std::optional<Tolerance> tolerance;
    shop::JobHeader job;

    friend bool operator==(const Input&, const Input&) = default;
};

void visit_fields(FieldVisitor& visitor, Engine& engine);
void visit_fields(FieldVisitor& visitor, Factor& factor);
void visit_fields(FieldVisitor& visitor, Parts& parts);
void visit_fields(FieldVisitor& visitor, Plane& plane);
void visit_fields(FieldVisitor& visitor, Input& input);

/// Gives the weigh-in sheet as many rows as the engine has cylinders: a change of their number
/// keeps the weighed masses, not the numbers of the sets. The written and the solved rows follow
/// the engine.
void fit_weigh_in(Input& input);
/// The input with its sheet so fitted.
Input fitted(const Input& input);

/// Whether the mean of its column represents a part: all of it is weighed.
bool is_weighed(const Input& input, const PartField& part);
/// The mass in use of a part: the mean of its column where all of it is weighed, else the typed
/// one.
std::optional<double> mass_of(const Input& input, const PartField& part);

/// A sentence for each typed mass that weighed ones replace.
std::vector<Message> replaced(const Input& input);
/// What else is typed or weighed and does not count; a sentence for each.
std::vector<Message> not_counted(const Input& input);

/// Of the tolerance; empty without a grade.
std::optional<double> service_speed(const Input& input);

/// Of both planes, m; nothing while one is not known.
std::optional<std::array<double, 2>> plane_positions(const Input& input);

/// Order of bearings, planes and centre of mass along the crankshaft.
enum class BearingPlaces {
    plausible,     ///< or not all known
    reversed,      ///< the rear bearing is on the front plane's side
    centre_beyond  ///< the centre of mass is beyond planes and bearings
};
BearingPlaces places_of_bearings(const Input& input);

/// Checks what joins the fields of engine and factor.
/// @throws InputError
void check_bob_weight(const Input& input);
/// Parts and weigh-in; with plugs the parts count by their nominal masses.
/// @throws InputError
void check_parts(const Input& input, bool has_plugs);
/// @param is_planned  the newest readings are to be made a plan of holes
/// @param is_older    of the format bob-weights: each reading has its angle
/// @throws InputError
void check_correction(const Correction& correction, bool is_planned, bool is_older);
void check_tolerance(const Tolerance& tolerance);

}  // namespace ravnoves::bob_weights

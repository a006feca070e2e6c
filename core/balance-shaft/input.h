#pragma once

#include <optional>
#include <string>
#include <vector>

#include "balance-shaft/cylinder_gas.h"
#include "balance-shaft/relieved_shaft.h"
#include "balance-shaft/table_reading.h"
#include "balance-shaft/torque_table.h"
#include "case-file/case_context.h"
#include "case-file/json_fwd.h"
#include "case-file/message.h"
#include "case-file/sha256.h"
#include "numerics/constants.h"

namespace ravnoves {
class FieldVisitor;
struct CaseFile;
}  // namespace ravnoves

/// The balance shaft of a single-cylinder engine.
///
/// Source: [gots-klevtsov] of the bibliography; equation numbers below are that paper's.
///
/// Front view; crank axis at the origin, cylinder axis = +y, crank angle φ from top dead centre,
/// positive in the direction of rotation, which is clockwise in the view. The balance shaft's axis
/// is at the distance l from the crank axis, at the angle α from the cylinder axis, measured in the
/// direction of rotation (α = 90°: beside the crank, to the right). It is geared 1:1 and turns the
/// opposite way. Two equal counterweights m₁ at the radius ρ₁, one on the crank, one on the shaft,
/// both point down at top dead centre. Moments are positive in the direction of rotation. Of a
/// cylinder that is offset by e to the right, φ counts from the true top dead centre, α from the
/// cylinder's direction, and the counterweights lag (PistonFirstOrder).
namespace ravnoves::balance_shaft {

/// One of the masses that move with the piston (the paper's Table 1).
struct NamedMass {
    std::string name;   ///< "piston", "pin", "rings", "rod_small_end" or any other
    double mass = 0.0;  ///< kg
    bool operator==(const NamedMass&) const = default;
};

/// How torque is read between the rows of its table.
enum class Interpolation {
    linear,          ///< straight lines
    periodic_cubic,  ///< the periodic cubic spline
};

/// The flywheel's target: exactly one of the two.
struct FlywheelTarget {
    std::optional<double> inertia;      ///< J of all that turns evenly, kg·m²
    std::optional<double> fluctuation;  ///< δ wanted, (ω_max − ω_min) / ω
    bool operator==(const FlywheelTarget&) const = default;
};

/// A file of measured values that a case names.
struct DataFile {
    std::string name;  ///< path, as in the case file
    /// SHA-256 when the case was made, as it has it, and now; both empty where no file was read.
    std::string sum_then;
    std::string sum_now;
    TableReading reading;  ///< as far as the case gives it

    bool has_changed() const { return is_other_sum(sum_then, sum_now); }
    bool operator==(const DataFile&) const = default;
};

/// Where the engine torque comes from.
struct TorqueSource {
    enum class Kind {
        table,     ///< the table itself is in the case file
        csv,       ///< the case file names a file beside it
        pressure,  ///< gas torque from a measured pressure trace, inertia torque from the masses
        cycle,     ///< gas torque from a computed cycle, inertia torque from the masses
    };
    Kind kind = Kind::table;
    TorqueTable table;                ///< the rows, for table and csv
    DataFile csv;                     ///< of the table
    PressureTrace trace;              ///< for pressure
    DataFile trace_file;              ///< of the trace
    double trace_shift = 0.0;         ///< added to its crank angles, rad
    GasCycle cycle;                   ///< for cycle
    double crankcase_pressure = 1e5;  ///< p₀, Pa, absolute; for pressure and cycle

    /// The torque follows the speed and the masses entered.
    bool is_computed() const { return kind == Kind::pressure || kind == Kind::cycle; }
    /// The file that is in use is not the one that the case was made with.
    bool has_changed() const {
        return (kind == Kind::csv && csv.has_changed()) ||
               (kind == Kind::pressure && trace_file.has_changed());
    }
    /// It has numbers or a file of a source that is not in use.
    bool keeps(Kind other) const;
    bool operator==(const TorqueSource&) const = default;
};

/// The cylinder and its rod, for every source of torque and for the front view.
struct CylinderSizes {
    std::optional<double> bore;        ///< m; default: the stroke, 2 r
    std::optional<double> rod_length;  ///< L, m; default r / default_lambda
    double offset = 0.0;               ///< e of the cylinder axis, m (sign of SliderCrank)
    bool operator==(const CylinderSizes&) const = default;
};

/// Sizes for the front view and the clearances, m; an empty one has a default made from the other
/// inputs, which its field and FrontView describe.
struct EnvelopeSizes {
    std::optional<double> cylinder_top;        ///< above the crank axis
    std::optional<double> cylinder_bottom;     ///< above the crank axis
    std::optional<double> cylinder_wall;       ///< thickness
    std::optional<double> rod_width;           ///< across the rod in the front view
    std::optional<double> crank_swing_radius;  ///< circle swept by crank and counterweight
    std::optional<double> shaft_swing_radius;  ///< circle swept by the shaft
    std::optional<double> gear_tip_radius;
    double clearance = 2e-3;  ///< smallest gap between the shaft and its obstacles
    double wall = 0.0;        ///< clearance and wall around every circle
    bool operator==(const EnvelopeSizes&) const = default;
};

/// Limits on the place of the shaft's axis, for example by a wall of the crankcase; empty means no
/// limit. They may contradict each other: then no place is feasible.
struct PlaceLimits {
    std::optional<double> centre_distance_min = {};  ///< m
    std::optional<double> centre_distance_max = {};  ///< m
    std::optional<double> shaft_angle_from = {};     ///< rad; where only the other is given 0
    std::optional<double> shaft_angle_to = {};       ///< rad; where only the other is given 2π
    std::optional<double> left = {};                 ///< smallest x, m
    std::optional<double> right = {};                ///< largest x, m
    std::optional<double> bottom = {};               ///< smallest y, m
    std::optional<double> top = {};                  ///< largest y, m
    bool operator==(const PlaceLimits&) const = default;
};

/// The gears between crank and shaft, 1:1.
struct GearPair {
    int teeth = 40;         ///< z of each gear, 6 to 1000
    int shifted_teeth = 0;  ///< k: the shaft is assembled k teeth ahead of its right place, |k| < z
    double backlash = 0.0;  ///< circumferential play at the pitch circle l/2, m
    bool operator==(const GearPair&) const = default;
};

/// A band of speeds to study, equally spaced, both ends included.
struct SpeedBand {
    double from = 0.0;  ///< rad/s
    double to = 0.0;    ///< rad/s, ≥ from
    int speeds = 60;
    bool map = false;  ///< the command line prints the map over (α, speed) too
    bool operator==(const SpeedBand&) const = default;
};

inline constexpr double default_lambda = 0.3;  ///< r/L where the rod's length is not given

/// The input of the scene.
struct Input {
    double angular_speed = 0.0;  ///< ω, rad/s
    bool speed_in_rpm = true;    ///< the case file gives the speed in min⁻¹ (not rad/s)
    double crank_radius = 0.0;   ///< r, m
    CylinderSizes cylinder;      ///< a computed torque needs its bore and its rod length
    /// Their sum is m_j, kg. One entry with an empty name represents reciprocating_mass_kg.
    std::vector<NamedMass> reciprocating_masses;
    std::optional<double> rod_mass;     ///< kg, the whole rod with shells (the paper's Table 1)
    double counterweight_radius = 0.0;  ///< ρ₁, m
    std::optional<double> counterweight_mass;  ///< m₁, kg; empty: by equation (1)
    double centre_distance = 0.0;              ///< l, m
    double shaft_angle = 0.0;                  ///< α, rad
    int strokes = 4;                           ///< 2 or 4; the cycle is 180° times that
    TorqueSource torque;                       ///< M_id
    Interpolation interpolation = Interpolation::linear;
    double step_deg = 1.0;  ///< step of the curves and of the sweep, °
    EnvelopeSizes envelope;
    PlaceLimits place_limits;
    double crank_share = 0.5;  ///< κ of the comparison without a shaft
    GearPair gears;
    std::optional<FlywheelTarget> flywheel;
    std::optional<SpeedBand> speed_band;
    std::optional<RelievedShaftSizes> relieved_shaft;

    double reciprocating_mass() const;  ///< m_j, kg
    double counterweight() const;       ///< m₁, kg, given or by equation (1)
    double unbalance() const { return counterweight() * counterweight_radius; }  ///< m₁ ρ₁, kg·m
    double effective_bore() const;                        ///< m, given or by default
    double effective_rod_length() const;                  ///< L, m, given or by default
    double cycle_deg() const { return 180.0 * strokes; }  ///< 720° or 360°
    /// What the torque's rows say of the strokes; `strokes` itself where it has none.
    int strokes_of_torque() const;
    bool operator==(const Input&) const = default;
};

/// The input's fields as fields.h describes them, for read_fields() and its like.
void visit_fields(FieldVisitor& visitor, Input& input);
void visit_fields(FieldVisitor& visitor, CylinderSizes& sizes);
void visit_fields(FieldVisitor& visitor, EnvelopeSizes& sizes);
void visit_fields(FieldVisitor& visitor, PlaceLimits& limits);
void visit_fields(FieldVisitor& visitor, GearPair& gears);
void visit_fields(FieldVisitor& visitor, FlywheelTarget& flywheel);
void visit_fields(FieldVisitor& visitor, SpeedBand& band);
void visit_fields(FieldVisitor& visitor, RelievedShaftSizes& sizes);
/// The unused sources of torque ("kept" of a case).
void visit_kept(FieldVisitor& visitor, TorqueSource& source);

/// Checks the ranges and that the sizes taken together stay in the range of numbers.
/// @throws InputError that names the JSON pointer, as read_input() would
void check_input(const Input& input);
/// The same without the ranges of the single fields.
void check_joined(const Input& input);
/// @throws InputError that names the JSON pointer below /input/speed_band
void check_speed_band(const SpeedBand& band);

/// Reads the "input" object of a case.
/// @throws InputError that names the JSON pointer
Input read_input(const Json& input, const CaseContext& context);
/// The "input" object that reads back to the same Input.
Json write_input(const Input& input);
/// The unused sources of torque in the input, as "kept" of its case; null without any.
Json write_kept(const Input& input);
/// Takes them over into an input that was read. A file that cannot be read stays named.
/// @throws InputError that names the JSON pointer
void read_kept(const Json& kept, const CaseContext& context, Input& input);
/// Cases of before have the cylinder's sizes in the object of their torque and in the envelope:
/// moves them to "cylinder", and what a study varies there. The bore of a kept torque that is
/// another than the cylinder's is left out, which CaseFile::changes says.
/// @throws InputError that names both places where two sizes differ
void gather_cylinder(CaseFile& file);

}  // namespace ravnoves::balance_shaft

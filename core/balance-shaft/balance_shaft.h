#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "balance-shaft/inertia_check.h"
#include "balance-shaft/relieved_shaft.h"
#include "balance-shaft/torque_table.h"
#include "case-file/case_context.h"
#include "case-file/json_fwd.h"
#include "case-file/range.h"
#include "numerics/constants.h"

/// The balance shaft of a single-cylinder engine.
///
/// Source: A. N. Gots, V. S. Klevtsov, "Selection of the optimal scheme of stabilization of the
/// one-cylinder engine"; equation numbers below are that paper's.
///
/// Front view; crank axis at the origin, cylinder axis = +y, crank angle φ from top dead centre,
/// positive in the direction of rotation, which is clockwise in the view. The balance shaft's axis
/// lies at the distance l from the crank axis on a line at the angle α from the cylinder axis,
/// measured in the direction of rotation (α = 90°: beside the crank, to the right). It is geared
/// 1:1 and turns the opposite way. Two equal counterweights m₁ at the radius ρ₁, one on the crank,
/// one on the shaft, both point down at top dead centre. Moments are positive in the direction of
/// rotation.
namespace ravnoves::balance_shaft {

// ---------------------------------------------------------------------------------------- input

/// The inputs that are one number, with the ranges that case file and form share.
namespace field {
inline constexpr double millimetre = 1e-3;  ///< m per mm
inline constexpr FieldSpec speed{"speed_rpm", "min⁻¹", Range::greater_than(0), rpm};
inline constexpr FieldSpec angular_speed{"angular_speed_rad_s", "rad/s", Range::greater_than(0)};
inline constexpr FieldSpec crank_radius{"crank_radius_mm", "mm", Range::greater_than(0),
                                        millimetre};
/// The sum, where the parts are not given one by one.
inline constexpr FieldSpec reciprocating_mass{"reciprocating_mass_kg", "kg",
                                              Range::greater_than(0)};
/// Each entry of reciprocating_masses_kg; together they must be more than 0.
inline constexpr FieldSpec reciprocating_mass_part{"", "kg", Range::at_least(0)};
/// Of the whole rod with its shells: bounds its small-end share.
inline constexpr FieldSpec rod_mass{"rod_mass_kg", "kg", Range::greater_than(0)};
inline constexpr FieldSpec counterweight_radius{"counterweight_radius_mm", "mm",
                                                Range::greater_than(0), millimetre};
inline constexpr FieldSpec counterweight_mass{"counterweight_mass_kg", "kg", Range::at_least(0)};
inline constexpr FieldSpec centre_distance{"centre_distance_mm", "mm", Range::at_least(0),
                                           millimetre};
inline constexpr FieldSpec shaft_angle{"shaft_angle_deg", "°", Range::between(-3600, 3600), degree};
inline constexpr FieldSpec step{"step_deg", "°", Range::between(0.01, 90), degree};
inline constexpr FieldSpec rod_length{"rod_length_mm", "mm", Range::greater_than(0), millimetre};
// Of the object "envelope".
inline constexpr FieldSpec cylinder_bore{"cylinder_bore_mm", "mm", Range::greater_than(0),
                                         millimetre};
inline constexpr FieldSpec cylinder_top{"cylinder_top_mm", "mm", Range::greater_than(0),
                                        millimetre};
inline constexpr FieldSpec crank_swing_radius{"crank_swing_radius_mm", "mm", Range::greater_than(0),
                                              millimetre};
inline constexpr FieldSpec shaft_swing_radius{"shaft_swing_radius_mm", "mm", Range::greater_than(0),
                                              millimetre};
inline constexpr FieldSpec gear_tip_radius{"gear_tip_radius_mm", "mm", Range::greater_than(0),
                                           millimetre};
inline constexpr FieldSpec wall{"wall_mm", "mm", Range::at_least(0), millimetre};
/// Part of m_j r that an engine without a shaft balances on the crank.
inline constexpr FieldSpec crank_share{"crank_share", "", Range::between(0, 1)};
// Of the object "gears".
inline constexpr FieldSpec backlash{"backlash_mm", "mm", Range::between(0, 10), millimetre};
inline constexpr int most_teeth = 1000;
// Of the objects "torque/pressure" and "torque/cycle".
inline constexpr double bar = 1e5;  ///< Pa per bar
inline constexpr FieldSpec bore{"bore_mm", "mm", Range::greater_than(0, 10000), millimetre};
inline constexpr FieldSpec offset{"offset_mm", "mm", Range{}, millimetre};
inline constexpr FieldSpec crankcase_pressure{"crankcase_pressure_bar", "bar",
                                              Range::between(0, 1e3), bar};
inline constexpr FieldSpec compression_ratio{"compression_ratio", "", Range::greater_than(1, 100)};
inline constexpr FieldSpec intake_pressure{"intake_pressure_bar", "bar",
                                           Range::greater_than(0, 1e3), bar};
inline constexpr FieldSpec exhaust_pressure{"exhaust_pressure_bar", "bar",
                                            Range::greater_than(0, 1e3), bar};
inline constexpr FieldSpec polytropic_compression{"polytropic_compression", "",
                                                  Range::between(1, 2)};
inline constexpr FieldSpec polytropic_expansion{"polytropic_expansion", "",
                                                Range::greater_than(1, 2)};
inline constexpr FieldSpec heat{"heat_J", "J", Range::between(0, 1e12)};
inline constexpr FieldSpec imep{"indicated_mean_effective_pressure_bar", "bar",
                                Range::between(-1e3, 1e3), bar};
/// 360° is the firing top dead centre.
inline constexpr FieldSpec combustion_start{"combustion_start_deg", "°", Range::between(270, 450),
                                            degree};
inline constexpr FieldSpec combustion_duration{"combustion_duration_deg", "°",
                                               Range::between(1, 180), degree};
// Of the object "speed_band".
inline constexpr FieldSpec band_from{"from_rpm", "min⁻¹", Range::greater_than(0), rpm};
inline constexpr FieldSpec band_to{"to_rpm", "min⁻¹", Range::greater_than(0), rpm};
inline constexpr int most_speeds = 1000;
inline constexpr FieldSpec wiebe_m{"wiebe_m", "", Range::between(0, 10)};
}  // namespace field

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

/// Where the engine torque comes from.
struct TorqueSource {
    enum class Kind {
        table,     ///< the table itself stands in the case file
        csv,       ///< the case file names a file beside it
        pressure,  ///< gas torque from a measured pressure trace, inertia torque from the masses
        cycle,     ///< gas torque from a computed cycle, inertia torque from the masses
    };
    Kind kind = Kind::table;
    TorqueTable table;       ///< the rows, for table and csv
    std::string csv;         ///< path as the case file has it, for csv and pressure
    PressureTrace trace;     ///< for pressure
    GasCycle cycle;          ///< for cycle
    CylinderSizes cylinder;  ///< for pressure and cycle

    /// The torque follows the speed and the masses entered.
    bool is_computed() const { return kind == Kind::pressure || kind == Kind::cycle; }
    bool operator==(const TorqueSource&) const = default;
};

/// Sizes for the front view; what is empty has a default made from the other inputs.
struct EnvelopeSizes {
    std::optional<double> cylinder_bore;       ///< m; default: the torque source's bore, else 2 r
    std::optional<double> cylinder_top;        ///< m above the crank axis; default r + L + bore/2
    std::optional<double> crank_swing_radius;  ///< m, circle swept by crank and counterweight;
                                               ///< default 1.3 max(r, ρ₁)
    std::optional<double> shaft_swing_radius;  ///< m, circle swept by the shaft; default 1.3 ρ₁
    std::optional<double> gear_tip_radius;     ///< m; default l/2, the pitch circles in contact
    double wall = 0.0;                         ///< m, clearance and wall around every circle
    bool operator==(const EnvelopeSizes&) const = default;
};

/// The gears between crank and shaft, 1:1.
struct GearPair {
    int teeth = 40;         ///< z of each gear, 6 to field::most_teeth
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
    /// Their sum is m_j, kg. One entry with an empty name stands for reciprocating_mass_kg.
    std::vector<NamedMass> reciprocating_masses;
    std::optional<double> rod_mass;     ///< kg, the whole rod with shells (the paper's Table 1)
    double counterweight_radius = 0.0;  ///< ρ₁, m
    std::optional<double> counterweight_mass;  ///< m₁, kg; empty: by equation (1)
    double centre_distance = 0.0;              ///< l, m
    double shaft_angle = 0.0;                  ///< α, rad
    TorqueSource torque;                       ///< M_id
    Interpolation interpolation = Interpolation::linear;
    double step_deg = 1.0;  ///< step of the curves and of the sweep, °
    /// L, m; default r / default_lambda. Needed where the torque is computed.
    std::optional<double> rod_length;
    EnvelopeSizes envelope;
    double crank_share = 0.5;  ///< κ of the comparison without a shaft
    GearPair gears;
    std::optional<SpeedBand> speed_band;
    std::optional<RelievedShaftSizes> relieved_shaft;

    double reciprocating_mass() const;    ///< m_j, kg
    double effective_rod_length() const;  ///< L, m, given or by default
    bool operator==(const Input&) const = default;
};

/// The TMZ-650D diesel of the paper: Tables 1 and 2 at 376.8 rad/s, α = 45°. l = 100.15 mm follows
/// from the printed amplitude; the torque at 555° is +30 N·m as printed.
Input preset_tmz_650d();

/// Reads the "input" object of a case.
/// @throws InputError that names the JSON pointer
Input read_input(const Json& input, const CaseContext& context);
/// The "input" object that reads back to the same Input.
Json write_input(const Input& input);
/// Checks the ranges and that the sizes taken together stay in the range of numbers.
/// @throws InputError that names the JSON pointer, as read_input() would
void check_input(const Input& input);
/// @throws InputError that names the JSON pointer below /input/speed_band
void check_speed_band(const SpeedBand& band);

// --------------------------------------------------------------------------------------- result

/// Criteria of one moment over the continuous cycle (not over its samples).
struct MomentMetrics {
    double mean = 0.0;       ///< N·m, cycle integral / 4π
    double max = 0.0;        ///< N·m
    double min = 0.0;        ///< N·m
    double range = 0.0;      ///< max − min, N·m
    double rms = 0.0;        ///< N·m, about the mean
    double max_angle = 0.0;  ///< crank angle of the maximum, rad, 0…4π
    double min_angle = 0.0;  ///< crank angle of the minimum, rad, 0…4π
};

/// Moments over the cycle, sampled at every step_deg, both ends included.
struct MomentCurves {
    std::vector<double> crank_angle_deg;  ///< 0…720
    std::vector<double> M_up;             ///< tipping moment −M_id, N·m
    std::vector<double> M_s;              ///< moment of the shaft, (4), N·m
    std::vector<double> M_ups;            ///< moment on the mounts, (5), N·m
    // Where the torque is computed, else empty:
    std::vector<double> M_gas;      ///< gas torque, a part of M_id = −M_up, N·m
    std::vector<double> M_inertia;  ///< inertia torque, the other part, N·m
    std::vector<double> pressure;   ///< Pa
    std::vector<double> volume;     ///< m³; of a pressure trace without the clearance volume
};

/// Criteria over the shaft's angle, at every step_deg, both ends included. The means are cycle
/// integrals; the printed ones average nodes as the paper did, with the cycle's end counted twice.
struct AngleSweep {
    std::vector<double> shaft_angle_deg;     ///< 0…360
    std::vector<double> range;               ///< ΔM_ups, N·m
    std::vector<double> rms;                 ///< of M_ups about its mean, N·m
    std::vector<double> mean_M_s;            ///< N·m, 0 for every α
    std::vector<double> mean_M_ups;          ///< N·m, the same for every α
    std::vector<double> printed_mean_M_s;    ///< M_sm of 25 nodes, N·m (the paper's Fig. 4)
    std::vector<double> printed_mean_M_ups;  ///< M_upsm: printed_mean_M_s + node mean of M_up
};

/// The shaft angle with the least value of a criterion.
struct Optimum {
    std::optional<double> shaft_angle;  ///< rad, 0…2π; empty: no α is better than another
    double value = 0.0;                 ///< N·m, the criterion there
    std::string note;                   ///< why there is no angle, as a sentence; else empty
};

/// Bounding box of the front view (crank and shaft circles with gears, cylinder), m.
struct Envelope {
    double left = 0.0;    ///< x, m
    double right = 0.0;   ///< x, m
    double bottom = 0.0;  ///< y, m
    double top = 0.0;     ///< y, m
    double width() const { return right - left; }
    double height() const { return top - bottom; }
};

/// The sizes of the front view with all defaults filled in, m.
struct FrontView {
    double crank_radius;
    double rod_length;
    double counterweight_radius;
    double centre_distance;
    double cylinder_bore;
    double cylinder_top;
    double crank_swing_radius;
    double shaft_swing_radius;
    double gear_pitch_radius;  ///< l/2
    double gear_tip_radius;
    double wall;
};

/// What the user should know about a result beyond its numbers. The kind is for translators, the
/// text is the English sentence that the command line prints.
struct Note {
    enum class Kind {
        no_shaft_moment,         ///< P₁ l = 0: the angle changes nothing
        range_without_gain,      ///< no α has a smaller range than the engine without a shaft
        rms_without_gain,        ///< no α has a smaller RMS than the engine without a shaft
        counterweight_mismatch,  ///< the given m₁ is not that of equation (1)
        inertia_mismatch,        ///< the torque does not belong to the masses and speed entered
    };
    Kind kind;
    std::string text;
};

/// One line of an order spectrum: amplitude × sin(order × φ + phase).
struct OrderLine {
    double order = 0.0;      ///< multiples of the crank's speed; a four-stroke has halves
    double amplitude = 0.0;  ///< N·m
    double phase = 0.0;      ///< rad
};

inline constexpr std::size_t spectrum_lines = 24;  ///< orders ½, 1 … 12

/// Everything that the page shows and that the command line prints.
struct Result {
    // What the shaft's angle does not change.
    double angular_speed = 0.0;        ///< ω, rad/s
    double reciprocating_mass = 0.0;   ///< m_j, kg
    double inertia_force_1_max = 0.0;  ///< P_j1 max = m_j r ω², N
    double counterweight_mass = 0.0;   ///< m₁, kg, (1) or as given
    double counterweight_force = 0.0;  ///< P₁ = m₁ ρ₁ ω², N
    double moment_amplitude = 0.0;     ///< P₁ l, N·m
    MomentMetrics M_up;
    double order_1_amplitude = 0.0;  ///< amplitude of M_up's first order, N·m
    double order_1_phase = 0.0;      ///< rad: that order is amplitude × sin(φ + phase)
    /// Part of M_up's variance that is of the first order, 0…1; empty where M_up is constant.
    std::optional<double> order_1_share;
    double printed_mean_M_up = 0.0;  ///< mean over the table's rows, both ends, N·m
    InertiaCheck inertia_check;
    std::vector<OrderLine> spectrum_M_up;     ///< spectrum_lines, exact for the interpolant
    std::optional<IndicatedCycle> indicated;  ///< where the torque is computed
    double indicated_power = 0.0;             ///< work × ω / 4π, W; where the torque is computed
    Optimum best_range;
    Optimum best_rms;
    AngleSweep sweep;
    std::vector<Note> notes;

    // What follows the shaft's angle: updated by Solver::move_shaft().
    double shaft_angle = 0.0;  ///< α, rad, 0…2π
    MomentMetrics M_s;
    MomentMetrics M_ups;
    double printed_mean_M_s = 0.0;    ///< mean over the paper's 25 nodes, N·m
    double printed_mean_M_ups = 0.0;  ///< printed_mean_M_s + printed_mean_M_up, N·m
    /// Change of range and RMS against the engine without a shaft, as a fraction (−0.1 is 10 %
    /// less); empty where M_up is constant.
    std::optional<double> range_change;
    std::optional<double> rms_change;
    MomentCurves curves;  ///< crank_angle_deg and M_up do not follow
    Envelope envelope;
    std::vector<OrderLine> spectrum_M_ups;  ///< differs from M_up's in order 1 alone
};

/// The "result" object of the contract, with what this program adds.
Json write_result(const Result& result);

// --------------------------------------------------------------------------------------- solver

/// Prepares all that does not depend on α once (curve of M_up, its exact integrals, its first
/// order, the sweep over α, the best α), so that moving the shaft costs about a microsecond.
///
/// Copyable and cheap to copy (the prepared part is shared and constant); const member functions
/// may run in several threads.
class Solver {
  public:
    /// @throws InputError as check_input()
    explicit Solver(const Input& input);

    const Input& input() const;
    /// The whole result at the input's α.
    Result result() const;
    /// Sets α in a result of this solver and updates all that follows it; allocates nothing
    /// for tables of up to 1000 different angles modulo 360°.
    /// @param shaft_angle  rad, any finite angle
    void move_shaft(double shaft_angle, Result& result) const;

    double M_up(double crank_angle) const;                     ///< N·m; angle in rad, any
    double M_s(double crank_angle, double shaft_angle) const;  ///< N·m, equation (4)
    /// ΔM_ups of the continuous cycle at α, N·m.
    double range(double shaft_angle) const;
    /// RMS of M_ups about its mean at α, N·m.
    double rms(double shaft_angle) const;
    double counterweight_force() const;  ///< P₁, N
    const FrontView& front_view() const;
    Envelope envelope(double shaft_angle) const;

    struct Prepared;

  private:
    std::shared_ptr<const Prepared> prepared_;
};

/// Solver(input).result().
/// @throws InputError as check_input()
Result solve(const Input& input);

// ------------------------------------------------------------------------------------ mechanism

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
    Vector2 inertia_force;    ///< of the reciprocating mass, exact kinematics, at the piston pin
    Vector2 inertia_force_1;  ///< its first order
    Vector2 crank_counterweight_force;
    Vector2 shaft_counterweight_force;
    double M_up = 0.0;   ///< N·m
    double M_s = 0.0;    ///< N·m
    double M_ups = 0.0;  ///< N·m
};

/// The pose at a crank angle and a shaft angle, both rad, any.
MechanismPose mechanism_pose(const Solver& solver, double crank_angle, double shaft_angle);

}  // namespace ravnoves::balance_shaft

#pragma once

#include <array>

#include "case-file/field.h"

/// The inputs of the scene, each described once. Source of the values named as examples:
/// [gots-klevtsov], Tables 1 and 2.
namespace ravnoves::balance_shaft::field {

/// What no engine leaves: beyond them results leave double's range, or searches have no end.
inline constexpr Range engine_lengths = Range::between(1e-3, 1e6);  ///< mm
inline constexpr Range some_lengths = Range::between(0, 1e6);       ///< mm, of what may be none
inline constexpr Range engine_masses = {.max = 1e9};                ///< kg
inline constexpr Range engine_speeds = Range::between(1e-6, 1e7);   ///< min⁻¹ or rad/s

inline constexpr Field speed{.key = "speed_rpm",
                             .range = Range::greater_than(0),
                             .size = engine_speeds,
                             .label = CORE_TEXT("balance-shaft", "&Speed n"),
                             .symbol = "n",
                             .hint = CORE_TEXT("balance-shaft", "Crankshaft speed.")};
inline constexpr Field angular_speed{.key = "angular_speed_rad_s",
                                     .range = Range::greater_than(0),
                                     .size = engine_speeds,
                                     .symbol = "ω",
                                     .hint = CORE_TEXT("balance-shaft", "Instead of the speed.")};
inline constexpr Field crank_radius{.key = "crank_radius_mm",
                                    .range = Range::greater_than(0),
                                    .size = engine_lengths,
                                    .label = CORE_TEXT("balance-shaft", "&Crank radius r"),
                                    .symbol = "r",
                                    .hint = CORE_TEXT("balance-shaft", "Half the stroke.")};
/// On the form beside the crank radius.
inline constexpr Field stroke{.key = "stroke_mm",
                              .range = crank_radius.range,
                              .label = CORE_TEXT("balance-shaft", "Stro&ke 2 r"),
                              .hint = CORE_TEXT("balance-shaft", "Twice the crank radius.")};
inline constexpr Field cylinder{
    .key = "cylinder",
    .hint = CORE_TEXT("balance-shaft",
                      "The cylinder and its rod, for every source of torque and for the front "
                      "view.")};
inline constexpr Field bore{
    .key = "bore_mm",
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "&Bore"),
    .hint = CORE_TEXT("balance-shaft",
                      "Diameter of the cylinder; a pressure trace or a computed cycle needs it."),
    .if_empty = CORE_TEXT("balance-shaft", "the stroke, 2 r"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field rod_length{
    .key = "rod_length_mm",
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Rod lengt&h L"),
    .symbol = "L",
    .hint = CORE_TEXT("balance-shaft",
                      "Distance between the centres of the rod's eyes. Clearance, the check of the "
                      "torque and a computed torque use it."),
    .if_empty = CORE_TEXT("balance-shaft", "r / 0.3"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field offset{
    .key = "offset_mm",
    .range = Range::between(-10000, 10000),
    .label = CORE_TEXT("balance-shaft", "O&ffset e"),
    .symbol = "e",
    .hint = CORE_TEXT("balance-shaft",
                      "Distance of the cylinder axis from the crank axis, positive on the side to "
                      "which the crankpin moves first. φ starts at the true top dead centre.")};
/// The object {name: kg}; its parts must add up to more than 0.
inline constexpr Field reciprocating_masses{
    .key = "reciprocating_masses_kg",
    .hint = CORE_TEXT(
        "balance-shaft",
        "Parts of the reciprocating mass by name, for example piston, pin, rings, rod_small_end.")};
/// The sum, where the parts are not given one by one.
inline constexpr Field reciprocating_mass{
    .key = "reciprocating_mass_kg",
    .range = Range::greater_than(0),
    .size = engine_masses,
    .symbol = "mⱼ",
    .hint = CORE_TEXT("balance-shaft", "Reciprocating mass of the cylinder as one number.")};
/// The parts that the form lists, in the paper's order; others have the same range.
inline constexpr std::array mass_parts{
    Field{.key = "piston",
          .unit = units::kg,
          .range = Range::at_least(0),
          .size = engine_masses,
          .label = CORE_TEXT("balance-shaft", "&Piston"),
          .hint = CORE_TEXT("balance-shaft", "Mass of the piston.")},
    Field{.key = "pin",
          .unit = units::kg,
          .range = Range::at_least(0),
          .size = engine_masses,
          .label = CORE_TEXT("balance-shaft", "Piston p&in"),
          .hint = CORE_TEXT("balance-shaft", "Mass of the piston pin.")},
    Field{.key = "rings",
          .unit = units::kg,
          .range = Range::at_least(0),
          .size = engine_masses,
          .label = CORE_TEXT("balance-shaft", "Rin&gs"),
          .hint = CORE_TEXT("balance-shaft", "Mass of the piston rings.")},
    Field{
        .key = "rod_small_end",
        .unit = units::kg,
        .range = Range::at_least(0),
        .size = engine_masses,
        .label = CORE_TEXT("balance-shaft", "Rod, small-&end share"),
        .hint = CORE_TEXT("balance-shaft", "Part of the rod's mass that moves with the piston.")}};
/// Bounds its small-end share.
inline constexpr Field rod_mass{
    .key = "rod_mass_kg",
    .range = Range::greater_than(0),
    .size = engine_masses,
    .label = CORE_TEXT("balance-shaft", "Whole rod with she&lls"),
    .hint = CORE_TEXT("balance-shaft",
                      "Mass of the whole rod, including the small-end share above; the crank's own "
                      "counterweights balance the rest."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field counterweight_radius{
    .key = "counterweight_radius_mm",
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Coun&terweight radius ρ₁"),
    .symbol = "ρ₁",
    .hint = CORE_TEXT("balance-shaft",
                      "From the axis to the centre of mass of each of the two equal "
                      "counterweights.")};
inline constexpr Field counterweight_mass{
    .key = "counterweight_mass_kg",
    .range = Range::at_least(0),
    .size = engine_masses,
    .label = CORE_TEXT("balance-shaft", "Counterweight &mass m₁"),
    .symbol = "m₁",
    .hint = CORE_TEXT("balance-shaft", "Mass of one of the two equal counterweights."),
    .if_empty =
        CORE_TEXT("balance-shaft", "by equation (1), m₁ = mⱼ r / (2 ρ₁); a number overrides it"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field centre_distance{
    .key = "centre_distance_mm",
    .range = Range::at_least(0),
    .size = Range::between(0, engine_lengths.max),
    .label = CORE_TEXT("balance-shaft", "Centre &distance l"),
    .symbol = "l",
    .hint = CORE_TEXT("balance-shaft", "From the crank axis to the shaft axis.")};
inline constexpr Field shaft_angle{.key = "shaft_angle_deg",
                                   .range = Range::between(-3600, 3600),
                                   .symbol = "α",
                                   .hint = CORE_TEXT("balance-shaft",
                                                     "From the crank axis to the shaft, measured "
                                                     "from the cylinder axis in the direction of "
                                                     "rotation.")};
inline constexpr Word stroke_words[] = {{"2", CORE_TEXT("balance-shaft", "two-stroke")},
                                        {"4", CORE_TEXT("balance-shaft", "four-stroke")}};
inline constexpr Field strokes{
    .key = "strokes",
    .label = CORE_TEXT("balance-shaft", "Stro&kes"),
    .hint = CORE_TEXT("balance-shaft",
                      "A four-stroke cycle takes two turns, 720°; a two-stroke cycle one, 360°. "
                      "Torque table and pressure trace must span the cycle."),
    .words = stroke_words};
inline constexpr Word interpolation_words[] = {
    {"linear", CORE_TEXT("balance-shaft", "straight lines")},
    {"periodic-cubic", CORE_TEXT("balance-shaft", "periodic cubic spline")}};
inline constexpr Field interpolation{
    .key = "interpolation",
    .label = CORE_TEXT("balance-shaft", "I&nterpolation"),
    .hint = CORE_TEXT("balance-shaft", "Criteria use the curve between the rows."),
    .words = interpolation_words};
/// In the struct in degrees too.
inline constexpr Field step{
    .key = "step_deg",
    .unit = {units::degree.name},
    .range = Range::between(0.01, 90),
    .hint = CORE_TEXT("balance-shaft", "Step of the curves and of the sweep over α."),
    .is_setting = true};
/// Part of m_j r that an engine without a shaft balances on the crank.
inline constexpr Field crank_share{
    .key = "crank_share",
    .range = Range::between(0, 1),
    .label = CORE_TEXT("balance-shaft", "Share &κ"),
    .symbol = "κ",
    .hint = CORE_TEXT("balance-shaft",
                      "Part of mⱼ r balanced on the crank alone, without a shaft. The force then "
                      "describes an ellipse: a line at 0 and 1, a circle at ½.")};

inline constexpr Field envelope{.key = "envelope",
                                .hint = CORE_TEXT("balance-shaft", "Sizes of the front view.")};
inline constexpr Field cylinder_top{
    .key = "cylinder_top_mm",
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Cylinder &top"),
    .hint = CORE_TEXT("balance-shaft", "Top of the engine above the crank axis."),
    .if_empty = CORE_TEXT("balance-shaft", "the piston pin at top dead centre plus half the bore"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field cylinder_bottom{
    .key = "cylinder_bottom_mm",
    .range = Range::at_least(0),
    .size = some_lengths,
    .label = CORE_TEXT("balance-shaft", "Cylinder bott&om"),
    .hint = CORE_TEXT("balance-shaft", "Lower end of the cylinder above the crank axis."),
    .if_empty =
        CORE_TEXT("balance-shaft", "the piston pin at bottom dead centre minus 0.3 of the bore"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field cylinder_wall{
    .key = "cylinder_wall_mm",
    .range = Range::at_least(0),
    .size = some_lengths,
    .label = CORE_TEXT("balance-shaft", "C&ylinder wall"),
    .hint = CORE_TEXT("balance-shaft", "Thickness of the cylinder wall; the shaft must clear it."),
    .if_empty = CORE_TEXT("balance-shaft", "0.06 of the bore"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field rod_width{
    .key = "rod_width_mm",
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Rod widt&h"),
    .hint = CORE_TEXT(
        "balance-shaft",
        "Width of the rod in the front view, including its ends; the shaft must clear the rod."),
    .if_empty = CORE_TEXT("balance-shaft", "r / 2"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field clearance{
    .key = "clearance_mm",
    .range = Range::at_least(0),
    .size = some_lengths,
    .label = CORE_TEXT("balance-shaft", "Clearance to sha&ft"),
    .hint = CORE_TEXT("balance-shaft",
                      "Minimum clearance of the shaft's swing circle to crank, rod and cylinder.")};
inline constexpr Field crank_swing_radius{
    .key = "crank_swing_radius_mm",
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Crank swing radi&us"),
    .hint = CORE_TEXT("balance-shaft", "Circle swept by crank and counterweight."),
    .if_empty =
        CORE_TEXT("balance-shaft", "r plus half the rod's width, at least the shaft's default"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field shaft_swing_radius{
    .key = "shaft_swing_radius_mm",
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Shaft swin&g radius"),
    .hint = CORE_TEXT("balance-shaft", "Circle swept by the balance shaft."),
    .if_empty = CORE_TEXT("balance-shaft",
                          "the bar of the relieved shaft, else a steel half disc as long as the "
                          "bore with the unbalance m₁ ρ₁"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field gear_tip_radius{
    .key = "gear_tip_radius_mm",
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Gear tip r&adius"),
    .hint = CORE_TEXT("balance-shaft", "Tip circle of each of the two gears."),
    .if_empty = CORE_TEXT("balance-shaft", "l/2, the pitch circle"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field wall{.key = "wall_mm",
                            .range = Range::at_least(0),
                            .size = some_lengths,
                            .label = CORE_TEXT("balance-shaft", "Housing &wall and gap"),
                            .hint = CORE_TEXT("balance-shaft",
                                              "Added around every circle, and above and beside "
                                              "the cylinder.")};

inline constexpr Field place_limits{
    .key = "place_limits",
    .hint = CORE_TEXT("balance-shaft",
                      "Limits on the place of the shaft's axis, in addition to the clearance.")};
inline constexpr Field centre_distance_min{
    .key = "centre_distance_min_mm",
    .range = Range::between(0, 1e6),
    .label = CORE_TEXT("balance-shaft", "Minimum l"),
    .symbol = "l",
    .hint = CORE_TEXT("balance-shaft", "Minimum distance between crank axis and shaft axis."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field centre_distance_max{
    .key = "centre_distance_max_mm",
    .range = Range::between(0, 1e6),
    .label = CORE_TEXT("balance-shaft", "Maximum l"),
    .symbol = "l",
    .hint = CORE_TEXT("balance-shaft", "Maximum distance between crank axis and shaft axis."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field shaft_angle_from{
    .key = "shaft_angle_from_deg",
    .range = Range::between(-360, 360),
    .label = CORE_TEXT("balance-shaft", "α from"),
    .symbol = "α",
    .hint = CORE_TEXT("balance-shaft", "Minimum angle of the shaft, in the direction of rotation."),
    .if_empty = CORE_TEXT("balance-shaft", "0 if the other end is given"),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field shaft_angle_to{
    .key = "shaft_angle_to_deg",
    .range = Range::between(-360, 720),
    .label = CORE_TEXT("balance-shaft", "α to"),
    .symbol = "α",
    .hint = CORE_TEXT("balance-shaft", "Maximum angle of the shaft."),
    .if_empty = CORE_TEXT("balance-shaft", "360° if the other end is given"),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field place_left{
    .key = "left_mm",
    .range = Range::between(-1e6, 1e6),
    .label = CORE_TEXT("balance-shaft", "Minimum x"),
    .symbol = "x",
    .hint = CORE_TEXT("balance-shaft",
                      "The shaft axis must be to the right of this line, x from the crank axis. "
                      "For a wall: add swing radius and clearance."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field place_right{
    .key = "right_mm",
    .range = Range::between(-1e6, 1e6),
    .label = CORE_TEXT("balance-shaft", "Maximum x"),
    .symbol = "x",
    .hint = CORE_TEXT("balance-shaft", "The shaft axis must be to the left of this line."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field place_bottom{
    .key = "bottom_mm",
    .range = Range::between(-1e6, 1e6),
    .label = CORE_TEXT("balance-shaft", "Minimum y"),
    .symbol = "y",
    .hint = CORE_TEXT("balance-shaft",
                      "The shaft axis must be above this line, y from the crank axis."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field place_top{
    .key = "top_mm",
    .range = Range::between(-1e6, 1e6),
    .label = CORE_TEXT("balance-shaft", "Maximum y"),
    .symbol = "y",
    .hint = CORE_TEXT("balance-shaft", "The shaft axis must be below this line."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};

inline constexpr Field gears{
    .key = "gears", .hint = CORE_TEXT("balance-shaft", "The pair of gears that drives the shaft.")};
inline constexpr Field teeth{
    .key = "teeth",
    .range = Range::between(6, 1000),
    .label = CORE_TEXT("balance-shaft", "Teeth &z"),
    .symbol = "z",
    .hint = CORE_TEXT("balance-shaft", "Teeth of each of the two equal gears.")};
inline constexpr Field shifted_teeth{
    .key = "shifted_teeth",
    .range = Range::between(-999, 999),
    .label = CORE_TEXT("balance-shaft", "Teeth out, &k"),
    .symbol = "k",
    .hint = CORE_TEXT("balance-shaft",
                      "The shaft is assembled k teeth ahead: a phase error of 360° k / z.")};
inline constexpr Field backlash{
    .key = "backlash_mm",
    .range = Range::between(0, 10),
    .label = CORE_TEXT("balance-shaft", "Back&lash"),
    .hint = CORE_TEXT("balance-shaft",
                      "Circumferential play at the pitch circle, whose radius is l/2.")};

inline constexpr Field torque{
    .key = "torque",
    .hint = CORE_TEXT(
        "balance-shaft",
        "Source of the engine torque: crank_angle_deg with torque_Nm, csv, pressure, or cycle.")};
inline constexpr Field table_angle{
    .key = "crank_angle_deg",
    .unit = {units::degree.name},
    .range = Range::between(-1e5, 1e5),
    .hint = CORE_TEXT("balance-shaft", "Rows of one cycle: the crank angles, ascending.")};
inline constexpr Field table_torque{
    .key = "torque_Nm",
    .range = Range::between(-1e12, 1e12),
    .hint = CORE_TEXT("balance-shaft", "Torque at these angles; the last value equals the first.")};
inline constexpr Field csv{
    .key = "csv",
    .hint = CORE_TEXT("balance-shaft",
                      "A file beside the case with two columns: crank angle, and torque (in "
                      "pressure: cylinder pressure). Several cycles are averaged.")};
inline constexpr Field csv_sum{
    .key = "csv_sha256",
    .label = CORE_TEXT("balance-shaft", "Checksum"),
    .hint = CORE_TEXT("balance-shaft",
                      "SHA-256 of the file when the case was made; a note reports a change.")};
inline constexpr Field csv_columns{
    .key = "columns",
    .label = CORE_TEXT("balance-shaft", "Columns"),
    .hint = CORE_TEXT("balance-shaft",
                      "Columns of crank angle and value: numbers from 1, or headings; required for "
                      "more than two columns. Angle 0: equal steps over one cycle.")};
inline constexpr Field csv_unit{
    .key = "unit",
    .label = CORE_TEXT("balance-shaft", "Unit of the file"),
    .hint = CORE_TEXT("balance-shaft",
                      "Unit of the values in the file: N·m, kN·m, lbf·ft or lbf·in; of pressures "
                      "bar, kPa, MPa, psi, mbar or Pa."),
    .if_empty = CORE_TEXT("balance-shaft", "the unit in the heading, else N·m or bar")};
inline constexpr Field csv_gauge{
    .key = "gauge",
    .label = CORE_TEXT("balance-shaft", "Gauge pressure"),
    .hint = CORE_TEXT("balance-shaft",
                      "True for pressures above atmospheric: 1.01325 bar is added. False for "
                      "absolute pressures."),
    .if_empty = CORE_TEXT("balance-shaft", "by the heading, else absolute")};
inline constexpr Field pressure{
    .key = "pressure",
    .hint = CORE_TEXT("balance-shaft", "Gas torque from a measured cylinder pressure.")};
inline constexpr Field trace_shift{
    .key = "crank_angle_shift_deg",
    .range = Range::between(-720, 720),
    .label = CORE_TEXT("balance-shaft", "&Shift of the angles"),
    .hint = CORE_TEXT("balance-shaft",
                      "Added to the crank angles of the trace; 360° if the trace starts at the "
                      "firing dead centre.")};
inline constexpr Field cycle{.key = "cycle",
                             .hint = CORE_TEXT("balance-shaft", "Gas torque of a computed cycle.")};
inline constexpr Field crankcase_pressure{
    .key = "crankcase_pressure_bar",
    .range = Range::between(0, 1e3),
    .label = CORE_TEXT("balance-shaft", "Crankcase &pressure"),
    .symbol = "p₀",
    .hint = CORE_TEXT("balance-shaft", "Absolute pressure under the piston, p₀.")};
inline constexpr Field compression_ratio{
    .key = "compression_ratio",
    .range = Range::greater_than(1, 100),
    .label = CORE_TEXT("balance-shaft", "Compression &ratio ε"),
    .symbol = "ε",
    .hint = CORE_TEXT("balance-shaft", "Maximum over minimum volume.")};
inline constexpr Field intake_pressure{
    .key = "intake_pressure_bar",
    .range = Range::greater_than(0, 1e3),
    .label = CORE_TEXT("balance-shaft", "&Intake pressure"),
    .hint = CORE_TEXT("balance-shaft", "Absolute, constant over intake.")};
inline constexpr Field exhaust_pressure{
    .key = "exhaust_pressure_bar",
    .range = Range::greater_than(0, 1e3),
    .label = CORE_TEXT("balance-shaft", "E&xhaust pressure"),
    .hint = CORE_TEXT("balance-shaft", "Absolute, constant over exhaust.")};
inline constexpr Field polytropic_compression{
    .key = "polytropic_compression",
    .range = Range::between(1, 2),
    .label = CORE_TEXT("balance-shaft", "Exponent, &compression"),
    .hint = CORE_TEXT("balance-shaft",
                      "Polytropic exponent until combustion begins; about 1.32 to 1.38.")};
inline constexpr Field polytropic_expansion{
    .key = "polytropic_expansion",
    .range = Range::greater_than(1, 2),
    .label = CORE_TEXT("balance-shaft", "Exponent, ex&pansion"),
    .hint = CORE_TEXT("balance-shaft",
                      "Polytropic exponent of combustion and expansion; about 1.22 to 1.32.")};
inline constexpr Field heat{
    .key = "heat_J",
    .range = Range::between(0, 1e12),
    .label = CORE_TEXT("balance-shaft", "&Heat"),
    .hint = CORE_TEXT("balance-shaft", "Heat released per cycle; instead of the IMEP."),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field imep{
    .key = "indicated_mean_effective_pressure_bar",
    .range = Range::between(-1e3, 1e3),
    .label = CORE_TEXT("balance-shaft", "I&MEP"),
    .hint = CORE_TEXT("balance-shaft", "Indicated mean effective pressure; the heat follows."),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field combustion_start{
    .key = "combustion_start_deg",
    .range = Range::between(270, 450),
    .label = CORE_TEXT("balance-shaft", "&Start of combustion"),
    .hint = CORE_TEXT("balance-shaft", "Crank angle; 360° is the firing top dead centre.")};
inline constexpr Field combustion_duration{
    .key = "combustion_duration_deg",
    .range = Range::between(1, 180),
    .label = CORE_TEXT("balance-shaft", "&Duration"),
    .hint = CORE_TEXT("balance-shaft", "Crank angle from the start to the end of heat release.")};
inline constexpr Field wiebe_m{
    .key = "wiebe_m",
    .unit = units::none,
    .range = Range::between(0, 10),
    .label = CORE_TEXT("balance-shaft", "&Wiebe exponent m"),
    .symbol = "m",
    .hint = CORE_TEXT("balance-shaft",
                      "Form exponent of Wiebe's law; 0.5 to 1.5 for diesels, 2 to 4 for petrol "
                      "engines.")};
inline constexpr Field ports_open{
    .key = "ports_open_deg",
    .range = Range::between(60, 175),
    .label = CORE_TEXT("balance-shaft", "Ports ope&n"),
    .hint = CORE_TEXT("balance-shaft",
                      "Crank angle after top dead centre at which the exhaust opens (two-stroke). "
                      "It closes at the same piston position.")};

inline constexpr Field flywheel{
    .key = "flywheel",
    .hint = CORE_TEXT("balance-shaft",
                      "Flywheel: moment of inertia J, or coefficient of fluctuation δ.")};
inline constexpr Field flywheel_inertia{
    .key = "inertia_kg_m2",
    .range = Range::greater_than(0, 1e9),
    .label = CORE_TEXT("balance-shaft", "Inertia &J"),
    .symbol = "J",
    .hint = CORE_TEXT("balance-shaft",
                      "Moment of inertia of flywheel, crank and all parts that turn with them. The "
                      "coefficient of fluctuation follows."),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field fluctuation{
    .key = "fluctuation",
    .range = Range::greater_than(0, 2),
    .label = CORE_TEXT("balance-shaft", "Fl&uctuation δ"),
    .symbol = "δ",
    .hint = CORE_TEXT("balance-shaft",
                      "Required (maximum − minimum) / mean speed; the moment of inertia follows. "
                      "About 1/20 for pumps, 1/100 for generators."),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};

inline constexpr Field speed_band{.key = "speed_band",
                                  .hint = CORE_TEXT("balance-shaft", "A band of speeds to study.")};
inline constexpr Field band_from{.key = "from_rpm",
                                 .range = Range::greater_than(0),
                                 .size = Range::at_least(0.1),  // below it inertia is rounding
                                 .label = CORE_TEXT("balance-shaft", "&Band from"),
                                 .hint = CORE_TEXT("balance-shaft", "Minimum speed of the band."),
                                 .is_setting = true};
inline constexpr Field band_to{.key = "to_rpm",
                               .range = Range::greater_than(0),
                               .size = {.max = engine_speeds.max},
                               .label = CORE_TEXT("balance-shaft", "Band &to"),
                               .hint = CORE_TEXT("balance-shaft", "Maximum speed of the band."),
                               .is_setting = true};
inline constexpr Field band_speeds{
    .key = "speeds",
    .range = Range::between(2, 1000),
    .hint = CORE_TEXT("balance-shaft", "Number of speeds, including both ends.")};
inline constexpr Field band_map{
    .key = "map",
    .hint = CORE_TEXT("balance-shaft", "Prints range and RMS over angle and speed too.")};

inline constexpr Field relieved_shaft{
    .key = "relieved_shaft",
    .hint =
        CORE_TEXT("balance-shaft", "A bar with a segment milled away in place of counterweights.")};
inline constexpr Field bar_diameter{
    .key = "diameter_mm",
    .range = Range::between(1e-3, 1e5),
    .label = CORE_TEXT("balance-shaft", "&Diameter D"),
    .symbol = "D",
    .hint = CORE_TEXT("balance-shaft",
                      "Diameter of the round bar; also the swing circle of the shaft.")};
inline constexpr Field relief_depth{
    .key = "depth_mm",
    .range = Range::between(1e-6, 1e5),
    .label = CORE_TEXT("balance-shaft", "Depth &h"),
    .symbol = "h",
    .hint = CORE_TEXT("balance-shaft", "Depth of the milled segment, from the bar's surface.")};
inline constexpr Field relief_length{
    .key = "length_mm",
    .range = Range::between(1e-3, 1e5),
    .label = CORE_TEXT("balance-shaft", "&Length b"),
    .symbol = "b",
    .hint = CORE_TEXT("balance-shaft", "Length of the milled segment.")};
inline constexpr Field density{
    .key = "density_kg_m3",
    .range = Range::between(100, 30000),
    .label = CORE_TEXT("balance-shaft", "Densit&y"),
    .hint = CORE_TEXT("balance-shaft",
                      "Density of the bar. Steel 7850, cast iron 7200, tungsten alloy 17500.")};
/// Of the shaft's bending in cases of before: read, and no longer used.
inline constexpr std::string_view bending_keys[] = {"elastic_modulus_GPa",  "bearing_span_mm",
                                                    "allowable_stress_MPa", "permitted_sag_mm",
                                                    "speed_margin",         "bearing_load_limit_N"};

}  // namespace ravnoves::balance_shaft::field

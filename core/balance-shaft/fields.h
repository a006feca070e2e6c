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
                             .unit = units::rpm,
                             .range = Range::greater_than(0),
                             .size = engine_speeds,
                             .label = CORE_TEXT("balance-shaft", "&Speed n"),
                             .symbol = "n",
                             .hint = CORE_TEXT("balance-shaft", "Crankshaft speed.")};
inline constexpr Field angular_speed{.key = "angular_speed_rad_s",
                                     .unit = units::rad_per_s,
                                     .range = Range::greater_than(0),
                                     .size = engine_speeds,
                                     .symbol = "ω",
                                     .hint = CORE_TEXT("balance-shaft", "Instead of the speed.")};
inline constexpr Field crank_radius{.key = "crank_radius_mm",
                                    .unit = units::mm,
                                    .range = Range::greater_than(0),
                                    .size = engine_lengths,
                                    .label = CORE_TEXT("balance-shaft", "&Crank radius r"),
                                    .symbol = "r",
                                    .hint = CORE_TEXT("balance-shaft", "Half the stroke.")};
/// On the form beside the crank radius.
inline constexpr Field stroke{.key = "stroke_mm",
                              .unit = units::mm,
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
    .unit = units::mm,
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "&Bore"),
    .hint = CORE_TEXT("balance-shaft",
                      "Diameter of the cylinder; a pressure trace or a computed cycle needs it."),
    .if_empty = CORE_TEXT("balance-shaft", "the stroke, 2 r"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field rod_length{
    .key = "rod_length_mm",
    .unit = units::mm,
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Rod lengt&h L"),
    .symbol = "L",
    .hint = CORE_TEXT("balance-shaft",
                      "Between the centres of the rod's eyes. It decides what can be built, the "
                      "r/L of the torque's check and a computed torque, which needs it."),
    .if_empty = CORE_TEXT("balance-shaft", "r / 0.3"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field offset{
    .key = "offset_mm",
    .unit = units::mm,
    .range = Range::between(-10000, 10000),
    .label = CORE_TEXT("balance-shaft", "O&ffset e"),
    .symbol = "e",
    .hint = CORE_TEXT("balance-shaft",
                      "Distance of the cylinder axis from the crank axis, positive on the side to "
                      "which the crankpin moves first. Crank angles count from the true top dead "
                      "centre, α from the direction of the cylinder.")};
/// The object {name: kg}; its parts must add up to more than 0.
inline constexpr Field reciprocating_masses{
    .key = "reciprocating_masses_kg",
    .unit = units::kg,
    .hint = CORE_TEXT("balance-shaft",
                      "Parts by name that add up to the reciprocating mass, for example piston, "
                      "pin, rings, rod_small_end.")};
/// The sum, where the parts are not given one by one.
inline constexpr Field reciprocating_mass{
    .key = "reciprocating_mass_kg",
    .unit = units::kg,
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
    .unit = units::kg,
    .range = Range::greater_than(0),
    .size = engine_masses,
    .label = CORE_TEXT("balance-shaft", "Whole rod with she&lls"),
    .hint = CORE_TEXT("balance-shaft",
                      "Its small-end share above is a part of it; the rest turns with the crankpin "
                      "and is balanced by the crank's own counterweights."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field counterweight_radius{
    .key = "counterweight_radius_mm",
    .unit = units::mm,
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Coun&terweight radius ρ₁"),
    .symbol = "ρ₁",
    .hint = CORE_TEXT("balance-shaft",
                      "From the axis to the centre of mass of each of the two equal "
                      "counterweights.")};
inline constexpr Field counterweight_mass{
    .key = "counterweight_mass_kg",
    .unit = units::kg,
    .range = Range::at_least(0),
    .size = engine_masses,
    .label = CORE_TEXT("balance-shaft", "Counterweight &mass m₁"),
    .symbol = "m₁",
    .hint = CORE_TEXT("balance-shaft", "One of the two equal counterweights."),
    .if_empty =
        CORE_TEXT("balance-shaft", "by equation (1), m₁ = mⱼ r / (2 ρ₁); a number overrides it"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field centre_distance{
    .key = "centre_distance_mm",
    .unit = units::mm,
    .range = Range::at_least(0),
    .size = Range::between(0, engine_lengths.max),
    .label = CORE_TEXT("balance-shaft", "Centre &distance l"),
    .symbol = "l",
    .hint = CORE_TEXT("balance-shaft", "From the crank axis to the shaft axis.")};
inline constexpr Field shaft_angle{.key = "shaft_angle_deg",
                                   .unit = units::degree,
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
    .hint =
        CORE_TEXT("balance-shaft",
                  "A four-stroke engine has a cycle of two turns, 720°, a two-stroke engine one "
                  "of one turn, 360°. Torque table and pressure trace must span it."),
    .words = stroke_words};
inline constexpr Word interpolation_words[] = {
    {"linear", CORE_TEXT("balance-shaft", "straight lines")},
    {"periodic-cubic", CORE_TEXT("balance-shaft", "periodic cubic spline")}};
inline constexpr Field interpolation{
    .key = "interpolation",
    .label = CORE_TEXT("balance-shaft", "I&nterpolation"),
    .hint = CORE_TEXT("balance-shaft",
                      "Criteria are those of the curve between the rows, not of the rows alone."),
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
                      "runs on an ellipse: a line at 0 and 1, a circle at ½.")};

inline constexpr Field envelope{.key = "envelope",
                                .hint = CORE_TEXT("balance-shaft", "Sizes of the front view.")};
inline constexpr Field cylinder_top{
    .key = "cylinder_top_mm",
    .unit = units::mm,
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Cylinder &top"),
    .hint = CORE_TEXT("balance-shaft", "Top of the engine above the crank axis."),
    .if_empty = CORE_TEXT("balance-shaft", "the piston pin at top dead centre and half the bore"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field cylinder_bottom{
    .key = "cylinder_bottom_mm",
    .unit = units::mm,
    .range = Range::at_least(0),
    .size = some_lengths,
    .label = CORE_TEXT("balance-shaft", "Cylinder bott&om"),
    .hint = CORE_TEXT("balance-shaft", "Lower end of the cylinder above the crank axis."),
    .if_empty =
        CORE_TEXT("balance-shaft", "the piston pin at bottom dead centre less 0.3 of the bore"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field cylinder_wall{
    .key = "cylinder_wall_mm",
    .unit = units::mm,
    .range = Range::at_least(0),
    .size = some_lengths,
    .label = CORE_TEXT("balance-shaft", "C&ylinder wall"),
    .hint = CORE_TEXT("balance-shaft",
                      "Thickness of the cylinder's wall, which the shaft must not meet."),
    .if_empty = CORE_TEXT("balance-shaft", "0.06 of the bore"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field rod_width{
    .key = "rod_width_mm",
    .unit = units::mm,
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Rod widt&h"),
    .hint = CORE_TEXT("balance-shaft",
                      "Across the rod, round ends included, in the front view; the shaft must "
                      "clear all that the rod sweeps."),
    .if_empty = CORE_TEXT("balance-shaft", "r / 2"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field clearance{
    .key = "clearance_mm",
    .unit = units::mm,
    .range = Range::at_least(0),
    .size = some_lengths,
    .label = CORE_TEXT("balance-shaft", "Gap of the sha&ft"),
    .hint = CORE_TEXT("balance-shaft",
                      "Least gap between the shaft's swing circle and crank, rod and cylinder; "
                      "an angle with less cannot be built.")};
inline constexpr Field crank_swing_radius{
    .key = "crank_swing_radius_mm",
    .unit = units::mm,
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Crank swing radi&us"),
    .hint = CORE_TEXT("balance-shaft", "Circle swept by crank and counterweight."),
    .if_empty = CORE_TEXT(
        "balance-shaft", "r and half the rod's width, or the shaft's default where that is larger"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field shaft_swing_radius{
    .key = "shaft_swing_radius_mm",
    .unit = units::mm,
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Shaft swin&g radius"),
    .hint = CORE_TEXT("balance-shaft", "Circle swept by the balance shaft."),
    .if_empty =
        CORE_TEXT("balance-shaft",
                  "the bar of the relieved shaft, else the half disc of steel, as long as the "
                  "bore, with the unbalance m₁ ρ₁"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field gear_tip_radius{
    .key = "gear_tip_radius_mm",
    .unit = units::mm,
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = CORE_TEXT("balance-shaft", "Gear tip r&adius"),
    .hint = CORE_TEXT("balance-shaft", "Tip circle of each of the two gears."),
    .if_empty = CORE_TEXT("balance-shaft", "l/2, the pitch circle"),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field wall{.key = "wall_mm",
                            .unit = units::mm,
                            .range = Range::at_least(0),
                            .size = some_lengths,
                            .label = CORE_TEXT("balance-shaft", "Housing &wall and gap"),
                            .hint = CORE_TEXT("balance-shaft",
                                              "Added around every circle, and above and beside "
                                              "the cylinder.")};

inline constexpr Field place_limits{
    .key = "place_limits",
    .hint = CORE_TEXT("balance-shaft",
                      "Limits on the place of the shaft's axis, beside what it must clear.")};
inline constexpr Field centre_distance_min{
    .key = "centre_distance_min_mm",
    .unit = units::mm,
    .range = Range::between(0, 1e6),
    .label = CORE_TEXT("balance-shaft", "Least l"),
    .symbol = "l",
    .hint =
        CORE_TEXT("balance-shaft", "Least distance between the crank axis and the shaft's axis."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field centre_distance_max{
    .key = "centre_distance_max_mm",
    .unit = units::mm,
    .range = Range::between(0, 1e6),
    .label = CORE_TEXT("balance-shaft", "Largest l"),
    .symbol = "l",
    .hint =
        CORE_TEXT("balance-shaft", "Largest distance between the crank axis and the shaft's axis."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field shaft_angle_from{
    .key = "shaft_angle_from_deg",
    .unit = units::degree,
    .range = Range::between(-360, 360),
    .label = CORE_TEXT("balance-shaft", "α from"),
    .symbol = "α",
    .hint = CORE_TEXT("balance-shaft",
                      "The shaft's angle is at least this, in the direction of rotation."),
    .if_empty = CORE_TEXT("balance-shaft", "0 where the other end is given"),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field shaft_angle_to{
    .key = "shaft_angle_to_deg",
    .unit = units::degree,
    .range = Range::between(-360, 720),
    .label = CORE_TEXT("balance-shaft", "α to"),
    .symbol = "α",
    .hint = CORE_TEXT("balance-shaft", "The shaft's angle is at most this."),
    .if_empty = CORE_TEXT("balance-shaft", "360° where the other end is given"),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field place_left{
    .key = "left_mm",
    .unit = units::mm,
    .range = Range::between(-1e6, 1e6),
    .label = CORE_TEXT("balance-shaft", "Least x"),
    .symbol = "x",
    .hint = CORE_TEXT("balance-shaft",
                      "The shaft's axis lies to the right of this line; x counts to the right from "
                      "the crank axis. Of a wall: its place, the shaft's swing radius and a gap."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field place_right{
    .key = "right_mm",
    .unit = units::mm,
    .range = Range::between(-1e6, 1e6),
    .label = CORE_TEXT("balance-shaft", "Largest x"),
    .symbol = "x",
    .hint = CORE_TEXT("balance-shaft", "The shaft's axis lies to the left of this line."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field place_bottom{
    .key = "bottom_mm",
    .unit = units::mm,
    .range = Range::between(-1e6, 1e6),
    .label = CORE_TEXT("balance-shaft", "Least y"),
    .symbol = "y",
    .hint = CORE_TEXT("balance-shaft",
                      "The shaft's axis lies above this line; y counts up from the crank axis."),
    .placeholder = CORE_TEXT("balance-shaft", "any")};
inline constexpr Field place_top{
    .key = "top_mm",
    .unit = units::mm,
    .range = Range::between(-1e6, 1e6),
    .label = CORE_TEXT("balance-shaft", "Largest y"),
    .symbol = "y",
    .hint = CORE_TEXT("balance-shaft", "The shaft's axis lies below this line."),
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
                      "The shaft is assembled k teeth ahead of its right place: a phase error of "
                      "360° k / z.")};
inline constexpr Field backlash{
    .key = "backlash_mm",
    .unit = units::mm,
    .range = Range::between(0, 10),
    .label = CORE_TEXT("balance-shaft", "Back&lash"),
    .hint = CORE_TEXT("balance-shaft",
                      "Circumferential play at the pitch circle, whose radius is l/2.")};

inline constexpr Field torque{
    .key = "torque",
    .hint = CORE_TEXT("balance-shaft",
                      "Where the torque of the engine comes from: one of crank_angle_deg with "
                      "torque_Nm, csv, pressure, cycle.")};
inline constexpr Field table_angle{
    .key = "crank_angle_deg",
    .unit = {units::degree.name},
    .range = Range::between(-1e5, 1e5),
    .hint = CORE_TEXT("balance-shaft", "Rows of one cycle: the crank angles, ascending.")};
inline constexpr Field table_torque{
    .key = "torque_Nm",
    .unit = units::N_m,
    .range = Range::between(-1e12, 1e12),
    .hint = CORE_TEXT("balance-shaft", "The torque at them; the last equals the first.")};
inline constexpr Field csv{
    .key = "csv",
    .hint = CORE_TEXT("balance-shaft",
                      "A file beside the case with two columns: crank angle, and torque (in "
                      "pressure: cylinder pressure). Several cycles are averaged.")};
inline constexpr Field csv_sum{
    .key = "csv_sha256",
    .label = CORE_TEXT("balance-shaft", "Sum of the file"),
    .hint = CORE_TEXT("balance-shaft",
                      "SHA-256 of that file as the case was made: where it is another now, the "
                      "result says so.")};
inline constexpr Field csv_columns{
    .key = "columns",
    .label = CORE_TEXT("balance-shaft", "Columns"),
    .hint = CORE_TEXT("balance-shaft",
                      "Columns of the crank angle and of the value: two numbers from 1, or two "
                      "headings. A file with more than two columns needs them. 0 for the angle: "
                      "the rows are equal steps over one cycle.")};
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
                      "True for pressures above the atmosphere: 1.01325 bar is added. False for "
                      "absolute pressures."),
    .if_empty = CORE_TEXT("balance-shaft", "as the heading says, else absolute")};
inline constexpr Field pressure{
    .key = "pressure",
    .hint = CORE_TEXT("balance-shaft", "Gas torque from a measured cylinder pressure.")};
inline constexpr Field trace_shift{
    .key = "crank_angle_shift_deg",
    .unit = units::degree,
    .range = Range::between(-720, 720),
    .label = CORE_TEXT("balance-shaft", "&Shift of the angles"),
    .hint = CORE_TEXT("balance-shaft",
                      "Added to the crank angles of the pressure trace; 360° of one that counts "
                      "from the firing top dead centre.")};
inline constexpr Field cycle{.key = "cycle",
                             .hint = CORE_TEXT("balance-shaft", "Gas torque of a computed cycle.")};
inline constexpr Field crankcase_pressure{
    .key = "crankcase_pressure_bar",
    .unit = units::bar,
    .range = Range::between(0, 1e3),
    .label = CORE_TEXT("balance-shaft", "Crankcase &pressure"),
    .symbol = "p₀",
    .hint = CORE_TEXT("balance-shaft", "Absolute pressure under the piston, p₀.")};
inline constexpr Field compression_ratio{
    .key = "compression_ratio",
    .range = Range::greater_than(1, 100),
    .label = CORE_TEXT("balance-shaft", "Compression &ratio ε"),
    .symbol = "ε",
    .hint = CORE_TEXT("balance-shaft", "Largest over smallest volume.")};
inline constexpr Field intake_pressure{
    .key = "intake_pressure_bar",
    .unit = units::bar,
    .range = Range::greater_than(0, 1e3),
    .label = CORE_TEXT("balance-shaft", "&Intake pressure"),
    .hint = CORE_TEXT("balance-shaft", "Absolute, constant over intake.")};
inline constexpr Field exhaust_pressure{
    .key = "exhaust_pressure_bar",
    .unit = units::bar,
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
    .unit = units::joule,
    .range = Range::between(0, 1e12),
    .label = CORE_TEXT("balance-shaft", "&Heat"),
    .hint = CORE_TEXT("balance-shaft", "Heat released per cycle; instead of the IMEP."),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field imep{
    .key = "indicated_mean_effective_pressure_bar",
    .unit = units::bar,
    .range = Range::between(-1e3, 1e3),
    .label = CORE_TEXT("balance-shaft", "I&MEP"),
    .hint = CORE_TEXT("balance-shaft",
                      "Indicated mean effective pressure; the heat that gives it is found."),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field combustion_start{
    .key = "combustion_start_deg",
    .unit = units::degree,
    .range = Range::between(270, 450),
    .label = CORE_TEXT("balance-shaft", "&Start of combustion"),
    .hint = CORE_TEXT("balance-shaft", "Crank angle; 360° is the firing top dead centre.")};
inline constexpr Field combustion_duration{
    .key = "combustion_duration_deg",
    .unit = units::degree,
    .range = Range::between(1, 180),
    .label = CORE_TEXT("balance-shaft", "&Duration"),
    .hint = CORE_TEXT("balance-shaft", "Crank angle from the start to the end of heat release.")};
inline constexpr Field wiebe_m{
    .key = "wiebe_m",
    .range = Range::between(0, 10),
    .label = CORE_TEXT("balance-shaft", "&Wiebe exponent m"),
    .symbol = "m",
    .hint = CORE_TEXT("balance-shaft",
                      "Form exponent of Wiebe's law; 0.5 to 1.5 for diesels, 2 to 4 for petrol "
                      "engines.")};
inline constexpr Field ports_open{
    .key = "ports_open_deg",
    .unit = units::degree,
    .range = Range::between(60, 175),
    .label = CORE_TEXT("balance-shaft", "Ports ope&n"),
    .hint = CORE_TEXT("balance-shaft",
                      "Of a two-stroke engine: crank angle after top dead centre at which the "
                      "exhaust opens. It closes at the same place of the piston.")};

inline constexpr Field flywheel{
    .key = "flywheel",
    .hint = CORE_TEXT("balance-shaft", "What evens out the speed within a cycle: J or δ.")};
inline constexpr Field flywheel_inertia{
    .key = "inertia_kg_m2",
    .unit = units::kg_m2,
    .range = Range::greater_than(0, 1e9),
    .label = CORE_TEXT("balance-shaft", "Inertia &J"),
    .symbol = "J",
    .hint = CORE_TEXT("balance-shaft",
                      "Of flywheel, crank and all that turns with them. The coefficient of "
                      "fluctuation follows from it."),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};
inline constexpr Field fluctuation{
    .key = "fluctuation",
    .range = Range::greater_than(0, 2),
    .label = CORE_TEXT("balance-shaft", "Fl&uctuation δ"),
    .symbol = "δ",
    .hint = CORE_TEXT("balance-shaft",
                      "Coefficient of fluctuation wanted: highest less lowest speed over the mean "
                      "one. About 1/20 for pumps, 1/100 for generators. The moment of inertia "
                      "follows from it."),
    .placeholder = CORE_TEXT("balance-shaft", "auto")};

inline constexpr Field speed_band{.key = "speed_band",
                                  .hint = CORE_TEXT("balance-shaft", "A band of speeds to study.")};
inline constexpr Field band_from{.key = "from_rpm",
                                 .unit = units::rpm,
                                 .range = Range::greater_than(0),
                                 .size = Range::at_least(0.1),  // below it inertia is rounding
                                 .label = CORE_TEXT("balance-shaft", "&Band from"),
                                 .hint = CORE_TEXT("balance-shaft", "Lowest speed of the band."),
                                 .is_setting = true};
inline constexpr Field band_to{.key = "to_rpm",
                               .unit = units::rpm,
                               .range = Range::greater_than(0),
                               .size = {.max = engine_speeds.max},
                               .label = CORE_TEXT("balance-shaft", "Band &to"),
                               .hint = CORE_TEXT("balance-shaft", "Highest speed of the band."),
                               .is_setting = true};
inline constexpr Field band_speeds{
    .key = "speeds",
    .range = Range::between(2, 1000),
    .hint = CORE_TEXT("balance-shaft", "How many speeds, with both ends.")};
inline constexpr Field band_map{
    .key = "map",
    .hint = CORE_TEXT("balance-shaft", "Prints range and RMS over angle and speed too.")};

inline constexpr Field relieved_shaft{
    .key = "relieved_shaft",
    .hint =
        CORE_TEXT("balance-shaft", "A bar with a segment milled away in place of counterweights.")};
inline constexpr Field bar_diameter{
    .key = "diameter_mm",
    .unit = units::mm,
    .range = Range::between(1e-3, 1e5),
    .label = CORE_TEXT("balance-shaft", "&Diameter D"),
    .symbol = "D",
    .hint = CORE_TEXT("balance-shaft", "Of the round bar; also the circle that the shaft sweeps.")};
inline constexpr Field relief_depth{
    .key = "depth_mm",
    .unit = units::mm,
    .range = Range::between(1e-6, 1e5),
    .label = CORE_TEXT("balance-shaft", "Depth &h"),
    .symbol = "h",
    .hint =
        CORE_TEXT("balance-shaft", "Of the segment that is milled away, from the bar's surface.")};
inline constexpr Field relief_length{
    .key = "length_mm",
    .unit = units::mm,
    .range = Range::between(1e-3, 1e5),
    .label = CORE_TEXT("balance-shaft", "&Length b"),
    .symbol = "b",
    .hint = CORE_TEXT("balance-shaft", "Over which the segment is milled away.")};
inline constexpr Field density{
    .key = "density_kg_m3",
    .unit = units::kg_m3,
    .range = Range::between(100, 30000),
    .label = CORE_TEXT("balance-shaft", "Densit&y"),
    .hint = CORE_TEXT("balance-shaft",
                      "Of the bar. Steel 7850, cast iron 7200, tungsten alloy 17500.")};
/// Of the shaft's bending in cases of before: read, and no longer used.
inline constexpr std::string_view bending_keys[] = {"elastic_modulus_GPa",  "bearing_span_mm",
                                                    "allowable_stress_MPa", "permitted_sag_mm",
                                                    "speed_margin",         "bearing_load_limit_N"};

}  // namespace ravnoves::balance_shaft::field

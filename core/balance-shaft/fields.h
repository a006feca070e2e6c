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
                             .label = Text::tr("&Speed n"),
                             .symbol = "n",
                             .hint = Text::tr("Crankshaft speed.")};
inline constexpr Field angular_speed{.key = "angular_speed_rad_s",
                                     .range = Range::greater_than(0),
                                     .size = engine_speeds,
                                     .symbol = "ω",
                                     .hint = Text::tr("Instead of the speed.")};
inline constexpr Field crank_radius{.key = "crank_radius_mm",
                                    .range = Range::greater_than(0),
                                    .size = engine_lengths,
                                    .label = Text::tr("&Crank radius r"),
                                    .symbol = "r",
                                    .hint = Text::tr("Half the stroke.")};
/// On the form beside the crank radius.
inline constexpr Field stroke{.key = "stroke_mm",
                              .range = crank_radius.range,
                              .label = Text::tr("Stro&ke 2 r"),
                              .hint = Text::tr("Twice the crank radius.")};
inline constexpr Field cylinder{
    .key = "cylinder",
    .hint = Text::tr("The cylinder and its rod, for every source of torque and for the front "
                     "view.")};
inline constexpr Field bore{
    .key = "bore_mm",
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = Text::tr("&Bore"),
    .hint = Text::tr("Diameter of the cylinder; a pressure trace or a computed cycle needs it."),
    .if_empty = Text::tr("the stroke, 2 r"),
    .placeholder = Text::tr("auto")};
inline constexpr Field rod_length{
    .key = "rod_length_mm",
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = Text::tr("Rod lengt&h L"),
    .symbol = "L",
    .hint = Text::tr("Distance between the centres of the rod's eyes. Clearance, the check of the "
                     "torque and a computed torque use it."),
    .if_empty = Text::tr("r / 0.3"),
    .placeholder = Text::tr("auto")};
inline constexpr Field offset{
    .key = "offset_mm",
    .range = Range::between(-10000, 10000),
    .label = Text::tr("O&ffset e"),
    .symbol = "e",
    .hint = Text::tr("Distance of the cylinder axis from the crank axis, positive on the side to "
                     "which the crankpin moves first. φ starts at the true top dead centre.")};
/// The object {name: kg}; its parts must add up to more than 0.
inline constexpr Field reciprocating_masses{
    .key = "reciprocating_masses_kg",
    .hint = Text::tr(
        "Parts of the reciprocating mass by name, for example piston, pin, rings, rod_small_end.")};
/// The sum, where the parts are not given one by one.
inline constexpr Field reciprocating_mass{
    .key = "reciprocating_mass_kg",
    .range = Range::greater_than(0),
    .size = engine_masses,
    .symbol = "mⱼ",
    .hint = Text::tr("Reciprocating mass of the cylinder as one number.")};
constexpr Field mass_part(const char* key, Text label, Text hint) {
    return {.key = key,
            .unit = units::kg,
            .range = Range::at_least(0),
            .size = engine_masses,
            .label = label,
            .hint = hint};
}
/// The parts that the form lists, in the paper's order; others have the same range.
inline constexpr std::array mass_parts{
    mass_part("piston", Text::tr("&Piston"), Text::tr("Mass of the piston.")),
    mass_part("pin", Text::tr("Piston p&in"), Text::tr("Mass of the piston pin.")),
    mass_part("rings", Text::tr("Rin&gs"), Text::tr("Mass of the piston rings.")),
    mass_part("rod_small_end", Text::tr("Rod, small-&end share"),
              Text::tr("Part of the rod's mass that moves with the piston."))};
/// Bounds its small-end share.
inline constexpr Field rod_mass{
    .key = "rod_mass_kg",
    .range = Range::greater_than(0),
    .size = engine_masses,
    .label = Text::tr("Whole rod with she&lls"),
    .hint = Text::tr("Mass of the whole rod, including the small-end share above; the crank's own "
                     "counterweights balance the rest."),
    .placeholder = Text::tr("any")};
inline constexpr Field counterweight_radius{
    .key = "counterweight_radius_mm",
    .range = Range::greater_than(0),
    .size = engine_lengths,
    .label = Text::tr("Coun&terweight radius ρ₁"),
    .symbol = "ρ₁",
    .hint = Text::tr("From the axis to the centre of mass of each of the two equal "
                     "counterweights.")};
inline constexpr Field counterweight_mass{
    .key = "counterweight_mass_kg",
    .range = Range::at_least(0),
    .size = engine_masses,
    .label = Text::tr("Counterweight &mass m₁"),
    .symbol = "m₁",
    .hint = Text::tr("Mass of one of the two equal counterweights."),
    .if_empty = Text::tr("by equation (1), m₁ = mⱼ r / (2 ρ₁); a number overrides it"),
    .placeholder = Text::tr("auto")};
inline constexpr Field centre_distance{.key = "centre_distance_mm",
                                       .range = Range::at_least(0),
                                       .size = Range::between(0, engine_lengths.max),
                                       .label = Text::tr("Centre &distance l"),
                                       .symbol = "l",
                                       .hint = Text::tr("From the crank axis to the shaft axis.")};
inline constexpr Field shaft_angle{.key = "shaft_angle_deg",
                                   .range = Range::between(-3600, 3600),
                                   .symbol = "α",
                                   .hint = Text::tr("From the crank axis to the shaft, measured "
                                                    "from the cylinder axis in the direction of "
                                                    "rotation.")};
inline constexpr Word stroke_words[] = {{"2", Text::tr("two-stroke")},
                                        {"4", Text::tr("four-stroke")}};
inline constexpr Field strokes{
    .key = "strokes",
    .label = Text::tr("Stro&kes"),
    .hint = Text::tr("A four-stroke cycle takes two turns, 720°; a two-stroke cycle one, 360°. "
                     "Torque table and pressure trace must span the cycle."),
    .words = stroke_words};
inline constexpr Word interpolation_words[] = {
    {"linear", Text::tr("straight lines")}, {"periodic-cubic", Text::tr("periodic cubic spline")}};
inline constexpr Field interpolation{.key = "interpolation",
                                     .label = Text::tr("I&nterpolation"),
                                     .hint = Text::tr("Criteria use the curve between the rows."),
                                     .words = interpolation_words};
/// In the struct in degrees too.
inline constexpr Field step{.key = "step_deg",
                            .unit = {units::degree.name},
                            .range = Range::between(0.01, 90),
                            .hint = Text::tr("Step of the curves and of the sweep over α."),
                            .is_setting = true};
/// Part of m_j r that an engine without a shaft balances on the crank.
inline constexpr Field crank_share{
    .key = "crank_share",
    .range = Range::between(0, 1),
    .label = Text::tr("Share &κ"),
    .symbol = "κ",
    .hint = Text::tr("Part of mⱼ r balanced on the crank alone, without a shaft. The force then "
                     "describes an ellipse: a line at 0 and 1, a circle at ½.")};

inline constexpr Field envelope{.key = "envelope", .hint = Text::tr("Sizes of the front view.")};
/// One that follows from the others where it is empty.
constexpr Field front_size(const char* key, const Range& size, Text label, Text hint,
                           Text if_empty) {
    return {.key = key,
            .range = size.min > 0.0 ? Range::greater_than(0) : Range::at_least(0),
            .size = size,
            .label = label,
            .hint = hint,
            .if_empty = if_empty,
            .placeholder = Text::tr("auto")};
}
inline constexpr Field cylinder_top =
    front_size("cylinder_top_mm", engine_lengths, Text::tr("Cylinder &top"),
               Text::tr("Top of the engine above the crank axis."),
               Text::tr("the piston pin at top dead centre plus half the bore"));
inline constexpr Field cylinder_bottom =
    front_size("cylinder_bottom_mm", some_lengths, Text::tr("Cylinder bott&om"),
               Text::tr("Lower end of the cylinder above the crank axis."),
               Text::tr("the piston pin at bottom dead centre minus 0.3 of the bore"));
inline constexpr Field cylinder_wall =
    front_size("cylinder_wall_mm", some_lengths, Text::tr("C&ylinder wall"),
               Text::tr("Thickness of the cylinder wall; the shaft must clear it."),
               Text::tr("0.06 of the bore"));
inline constexpr Field rod_width = front_size(
    "rod_width_mm", engine_lengths, Text::tr("Rod widt&h"),
    Text::tr(
        "Width of the rod in the front view, including its ends; the shaft must clear the rod."),
    Text::tr("r / 2"));
inline constexpr Field clearance{
    .key = "clearance_mm",
    .range = Range::at_least(0),
    .size = some_lengths,
    .label = Text::tr("Clearance to sha&ft"),
    .hint = Text::tr("Minimum clearance of the shaft's swing circle to crank, rod and cylinder.")};
inline constexpr Field crank_swing_radius =
    front_size("crank_swing_radius_mm", engine_lengths, Text::tr("Crank swing radi&us"),
               Text::tr("Circle swept by crank and counterweight."),
               Text::tr("r plus half the rod's width, at least the shaft's default"));
inline constexpr Field shaft_swing_radius =
    front_size("shaft_swing_radius_mm", engine_lengths, Text::tr("Shaft swin&g radius"),
               Text::tr("Circle swept by the balance shaft."),
               Text::tr("the bar of the relieved shaft, else a steel half disc as long as the bore "
                        "with the unbalance m₁ ρ₁"));
inline constexpr Field gear_tip_radius =
    front_size("gear_tip_radius_mm", engine_lengths, Text::tr("Gear tip r&adius"),
               Text::tr("Tip circle of each of the two gears."), Text::tr("l/2, the pitch circle"));
inline constexpr Field wall{.key = "wall_mm",
                            .range = Range::at_least(0),
                            .size = some_lengths,
                            .label = Text::tr("Housing &wall and gap"),
                            .hint = Text::tr("Added around every circle, and above and beside "
                                             "the cylinder.")};

inline constexpr Field place_limits{
    .key = "place_limits",
    .hint = Text::tr("Limits on the place of the shaft's axis, in addition to the clearance.")};
constexpr Field place_limit(const char* key, const Range& range, Text label, const char* symbol,
                            Text hint, Text if_empty = {}) {
    return {.key = key,
            .range = range,
            .label = label,
            .symbol = symbol,
            .hint = hint,
            .if_empty = if_empty,
            .placeholder = Text::tr("any"),
            .is_setting = true};
}
inline constexpr Field centre_distance_min =
    place_limit("centre_distance_min_mm", Range::between(0, 1e6), Text::tr("Minimum l"), "l",
                Text::tr("Minimum distance between crank axis and shaft axis."));
inline constexpr Field centre_distance_max =
    place_limit("centre_distance_max_mm", Range::between(0, 1e6), Text::tr("Maximum l"), "l",
                Text::tr("Maximum distance between crank axis and shaft axis."));
inline constexpr Field shaft_angle_from =
    place_limit("shaft_angle_from_deg", Range::between(-360, 360), Text::tr("α from"), "α",
                Text::tr("First angle of the shaft, in the direction of rotation."),
                Text::tr("0 if the other end is given"));
inline constexpr Field shaft_angle_to =
    place_limit("shaft_angle_to_deg", Range::between(-360, 720), Text::tr("α to"), "α",
                Text::tr("Last angle of the shaft; across 0° it is less than the first."),
                Text::tr("360° if the other end is given"));
inline constexpr Field place_left =
    place_limit("left_mm", Range::between(-1e6, 1e6), Text::tr("Minimum x"), "x",
                Text::tr("The shaft axis must be to the right of this line, x from the crank axis. "
                         "For a wall: add swing radius and clearance."));
inline constexpr Field place_right =
    place_limit("right_mm", Range::between(-1e6, 1e6), Text::tr("Maximum x"), "x",
                Text::tr("The shaft axis must be to the left of this line."));
inline constexpr Field place_bottom =
    place_limit("bottom_mm", Range::between(-1e6, 1e6), Text::tr("Minimum y"), "y",
                Text::tr("The shaft axis must be above this line, y from the crank axis."));
inline constexpr Field place_top =
    place_limit("top_mm", Range::between(-1e6, 1e6), Text::tr("Maximum y"), "y",
                Text::tr("The shaft axis must be below this line."));

inline constexpr Field gears{.key = "gears",
                             .hint = Text::tr("The pair of gears that drives the shaft.")};
inline constexpr Field teeth{.key = "teeth",
                             .range = Range::between(6, 1000),
                             .label = Text::tr("Teeth &z"),
                             .symbol = "z",
                             .hint = Text::tr("Teeth of each of the two equal gears.")};
inline constexpr Field shifted_teeth{
    .key = "shifted_teeth",
    .range = Range::between(-999, 999),
    .label = Text::tr("Teeth out, &k"),
    .symbol = "k",
    .hint = Text::tr("The shaft is assembled k teeth ahead: a phase error of 360° k / z.")};
inline constexpr Field backlash{
    .key = "backlash_mm",
    .range = Range::between(0, 10),
    .label = Text::tr("Back&lash"),
    .hint = Text::tr("Circumferential play at the pitch circle, whose radius is l/2.")};

inline constexpr Field torque{
    .key = "torque",
    .hint = Text::tr(
        "Source of the engine torque: crank_angle_deg with torque_Nm, csv, pressure, or cycle.")};
inline constexpr Field table_angle{
    .key = "crank_angle_deg",
    .unit = {units::degree.name},
    .range = Range::between(-1e5, 1e5),
    .hint = Text::tr("Rows of one cycle: the crank angles, ascending.")};
inline constexpr Field table_torque{
    .key = "torque_Nm",
    .range = Range::between(-1e12, 1e12),
    .hint = Text::tr("Torque at these angles; the last value equals the first.")};
inline constexpr Field csv{
    .key = "csv",
    .hint = Text::tr("A file beside the case with two columns: crank angle, and torque (in "
                     "pressure: cylinder pressure). Several cycles are averaged.")};
inline constexpr Field csv_sum{
    .key = "csv_sha256",
    .label = Text::tr("Checksum"),
    .hint = Text::tr("SHA-256 of the file when the case was made; a note reports a change.")};
inline constexpr Field csv_columns{
    .key = "columns",
    .label = Text::tr("Columns"),
    .hint = Text::tr("Columns of crank angle and value: numbers from 1, or headings; required for "
                     "more than two columns. Angle 0: equal steps over one cycle.")};
inline constexpr Field csv_unit{
    .key = "unit",
    .label = Text::tr("Unit of the file"),
    .hint = Text::tr("Unit of the values in the file: N·m, kN·m, lbf·ft or lbf·in; of pressures "
                     "bar, kPa, MPa, psi, mbar or Pa."),
    .if_empty = Text::tr("the unit in the heading, else N·m or bar")};
inline constexpr Field csv_gauge{
    .key = "gauge",
    .label = Text::tr("Gauge pressure"),
    .hint = Text::tr("True for pressures above atmospheric: 1.01325 bar is added. False for "
                     "absolute pressures."),
    .if_empty = Text::tr("by the heading, else absolute")};
inline constexpr Field pressure{.key = "pressure",
                                .hint = Text::tr("Gas torque from a measured cylinder pressure.")};
inline constexpr Field trace_shift{
    .key = "crank_angle_shift_deg",
    .range = Range::between(-720, 720),
    .label = Text::tr("&Shift of the angles"),
    .hint = Text::tr("Added to the crank angles of the trace; 360° if the trace starts at the "
                     "firing dead centre.")};
inline constexpr Field cycle{.key = "cycle", .hint = Text::tr("Gas torque of a computed cycle.")};
inline constexpr Field crankcase_pressure{
    .key = "crankcase_pressure_bar",
    .range = Range::between(0, 1e3),
    .label = Text::tr("Crankcase &pressure"),
    .symbol = "p₀",
    .hint = Text::tr("Absolute pressure under the piston, p₀.")};
inline constexpr Field compression_ratio{.key = "compression_ratio",
                                         .range = Range::greater_than(1, 100),
                                         .label = Text::tr("Compression &ratio ε"),
                                         .symbol = "ε",
                                         .hint = Text::tr("Maximum over minimum volume.")};
inline constexpr Field intake_pressure{.key = "intake_pressure_bar",
                                       .range = Range::greater_than(0, 1e3),
                                       .label = Text::tr("&Intake pressure"),
                                       .hint = Text::tr("Absolute, constant over intake.")};
inline constexpr Field exhaust_pressure{.key = "exhaust_pressure_bar",
                                        .range = Range::greater_than(0, 1e3),
                                        .label = Text::tr("E&xhaust pressure"),
                                        .hint = Text::tr("Absolute, constant over exhaust.")};
inline constexpr Field polytropic_compression{
    .key = "polytropic_compression",
    .range = Range::between(1, 2),
    .label = Text::tr("Exponent, &compression"),
    .hint = Text::tr("Polytropic exponent until combustion begins; about 1.32 to 1.38.")};
inline constexpr Field polytropic_expansion{
    .key = "polytropic_expansion",
    .range = Range::greater_than(1, 2),
    .label = Text::tr("Exponent, ex&pansion"),
    .hint = Text::tr("Polytropic exponent of combustion and expansion; about 1.22 to 1.32.")};
inline constexpr Field heat{.key = "heat_J",
                            .range = Range::between(0, 1e12),
                            .label = Text::tr("&Heat"),
                            .hint = Text::tr("Heat released per cycle; instead of the IMEP."),
                            .placeholder = Text::tr("auto")};
inline constexpr Field imep{
    .key = "indicated_mean_effective_pressure_bar",
    .range = Range::between(-1e3, 1e3),
    .label = Text::tr("I&MEP"),
    .hint = Text::tr("Indicated mean effective pressure; the heat follows."),
    .placeholder = Text::tr("auto")};
inline constexpr Field combustion_start{
    .key = "combustion_start_deg",
    .range = Range::between(270, 450),
    .label = Text::tr("&Start of combustion"),
    .hint = Text::tr("Crank angle; 360° is the firing top dead centre.")};
inline constexpr Field combustion_duration{
    .key = "combustion_duration_deg",
    .range = Range::between(1, 180),
    .label = Text::tr("&Duration"),
    .hint = Text::tr("Crank angle from the start to the end of heat release.")};
inline constexpr Field wiebe_m{
    .key = "wiebe_m",
    .unit = units::none,
    .range = Range::between(0, 10),
    .label = Text::tr("&Wiebe exponent m"),
    .symbol = "m",
    .hint = Text::tr("Form exponent of Wiebe's law; 0.5 to 1.5 for diesels, 2 to 4 for petrol "
                     "engines.")};
inline constexpr Field ports_open{
    .key = "ports_open_deg",
    .range = Range::between(60, 175),
    .label = Text::tr("Ports ope&n"),
    .hint = Text::tr("Crank angle after top dead centre at which the exhaust opens (two-stroke). "
                     "It closes at the same piston position.")};

inline constexpr Field flywheel{
    .key = "flywheel",
    .hint = Text::tr("Flywheel: moment of inertia J, or coefficient of fluctuation δ.")};
inline constexpr Field flywheel_inertia{
    .key = "inertia_kg_m2",
    .range = Range::greater_than(0, 1e9),
    .label = Text::tr("Inertia &J"),
    .symbol = "J",
    .hint = Text::tr("Moment of inertia of flywheel, crank and all parts that turn with them. The "
                     "coefficient of fluctuation follows."),
    .placeholder = Text::tr("auto")};
inline constexpr Field fluctuation{
    .key = "fluctuation",
    .range = Range::greater_than(0, 2),
    .label = Text::tr("Fl&uctuation δ"),
    .symbol = "δ",
    .hint = Text::tr("Required (maximum − minimum) / mean speed; the moment of inertia follows. "
                     "About 1/20 for pumps, 1/100 for generators."),
    .placeholder = Text::tr("auto")};

inline constexpr Field speed_band{.key = "speed_band",
                                  .hint = Text::tr("A band of speeds to study.")};
inline constexpr Field band_from{.key = "from_rpm",
                                 .range = Range::greater_than(0),
                                 .size = Range::at_least(0.1),  // below it inertia is rounding
                                 .label = Text::tr("&Band from"),
                                 .hint = Text::tr("Minimum speed of the band."),
                                 .is_setting = true};
inline constexpr Field band_to{.key = "to_rpm",
                               .range = Range::greater_than(0),
                               .size = {.max = engine_speeds.max},
                               .label = Text::tr("Band &to"),
                               .hint = Text::tr("Maximum speed of the band."),
                               .is_setting = true};
inline constexpr Field band_speeds{.key = "speeds",
                                   .range = Range::between(2, 1000),
                                   .hint = Text::tr("Number of speeds, including both ends.")};
inline constexpr Field band_map{.key = "map",
                                .hint = Text::tr("Prints range and RMS over angle and speed too.")};

inline constexpr Field relieved_shaft{
    .key = "relieved_shaft",
    .hint = Text::tr("A bar with a segment milled away in place of counterweights.")};
inline constexpr Field bar_diameter{
    .key = "diameter_mm",
    .range = Range::between(1e-3, 1e5),
    .label = Text::tr("&Diameter D"),
    .symbol = "D",
    .hint = Text::tr("Diameter of the round bar; also the swing circle of the shaft."),
    .placeholder = Text::tr("auto")};
inline constexpr Field relief_depth{
    .key = "depth_mm",
    .range = Range::between(1e-6, 1e5),
    .label = Text::tr("Depth &h"),
    .symbol = "h",
    .hint = Text::tr("Depth of the milled segment, from the bar's surface."),
    .placeholder = Text::tr("auto")};
inline constexpr Field relief_length{.key = "length_mm",
                                     .range = Range::between(1e-3, 1e5),
                                     .label = Text::tr("&Length b"),
                                     .symbol = "b",
                                     .hint = Text::tr("Length of the milled segment."),
                                     .placeholder = Text::tr("auto")};
inline constexpr Field density{
    .key = "density_kg_m3",
    .range = Range::between(100, 30000),
    .label = Text::tr("Densit&y"),
    .hint = Text::tr("Density of the bar. Steel 7850, cast iron 7200, tungsten alloy 17500.")};
/// Of the shaft's bending in cases of before: read, and no longer used.
inline constexpr std::string_view bending_keys[] = {"elastic_modulus_GPa",  "bearing_span_mm",
                                                    "allowable_stress_MPa", "permitted_sag_mm",
                                                    "speed_margin",         "bearing_load_limit_N"};

}  // namespace ravnoves::balance_shaft::field

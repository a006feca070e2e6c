#pragma once

#include "bob-weights/input.h"
#include "shop/balance_grade.h"

/// The inputs of the scene, each described once; the masses are part_fields().
namespace ravnoves::bob_weights {

inline constexpr Word type_words[] = {
    {"v", Text::tr("V")}, {"inline", Text::tr("In line")}, {"boxer", Text::tr("Boxer")}};
inline constexpr Word rods_words[] = {{"1", Text::tr("One")}, {"2", Text::tr("Two")}};
inline constexpr Word balance_words[] = {
    {"internal", Text::tr("Internal: in the crankshaft alone")},
    {"external", Text::tr("External: damper and flywheel too")}};

inline constexpr Word aim_words[] = {{"zero", Text::tr("Zero")}, {"tolerance", Text::tr("Limit")}};
inline constexpr Word direction_words[] = {{"axial", Text::tr("Parallel to the crankshaft")},
                                           {"radial", Text::tr("Radial, open at the rim")}};
inline constexpr Word state_words[] = {{"as-planned", Text::tr("As planned")},
                                       {"measured", Text::tr("As measured")},
                                       {"not-drilled", Text::tr("Not drilled")},
                                       {"wrong-side", Text::tr("On the wrong side")}};
inline constexpr Word plane_words[] = {{"front", Text::tr("Front")}, {"rear", Text::tr("Rear")}};

namespace field {

using namespace shop::field;

// --------------------------------------------------------------------------------- engine
inline constexpr Field engine{.key = "engine", .hint = Text::tr("The engine.")};
inline constexpr Field type{.key = "type",
                            .label = Text::tr("&Engine"),
                            .hint = Text::tr("Layout of the cylinders."),
                            .words = type_words};
inline constexpr Field cylinders{.key = "cylinders",
                                 .range = Range::between(1, max_cylinders),
                                 .label = Text::tr("&Cylinders"),
                                 .hint = Text::tr("Number of cylinders.")};
inline constexpr Field bank_angle{.key = "bank_angle_deg",
                                  .range = Range::between(0, 180),
                                  .label = Text::tr("&Bank angle γ"),
                                  .hint = Text::tr("Angle between the two banks of a V."),
                                  .placeholder = Text::tr("required")};
inline constexpr Field rods_per_pin{
    .key = "rods_per_pin",
    .range = Range::between(1, 2),
    .label = Text::tr("&Rods on a bob weight"),
    .hint = Text::tr(
        "Two if two rods share a crankpin. Each split crankpin has one rod and one bob weight."),
    .words = rods_words};
inline constexpr Field pin_split{
    .key = "pin_split_deg",
    .range = Range::between(-120, 120),
    .label = Text::tr("Crankpin &split δ"),
    .hint = Text::tr("Angle between the two crankpins of a throw; positive if the firing interval "
                     "is γ + δ. A 90° V-6 with 30° fires evenly.")};

// --------------------------------------------------------------------------------- factor
inline constexpr Field factor{
    .key = "factor", .hint = Text::tr("Part of the reciprocating mass in the bob weight.")};
inline constexpr Field reciprocating_percent{
    .key = "reciprocating_percent",
    .range = Range::between(0, 100),
    .label = Text::tr("Balance &factor"),
    .hint = Text::tr("Part of the reciprocating mass in the bob weight."),
    .if_empty = Text::tr("by theory; prefer the manufacturer's figure"),
    .placeholder = Text::tr("by theory")};
inline constexpr Field overbalance_percent{
    .key = "overbalance_percent",
    .range = Range::between(-50, 50),
    .label = Text::tr("&Overbalance"),
    .hint = Text::tr("Added to the factor; negative for underbalance. Usual for high speeds: 1 to "
                     "3 %.")};

// ---------------------------------------------------------------------------------- parts
inline constexpr Field parts{.key = "parts_g", .hint = Text::tr("Masses of one cylinder's parts.")};
inline constexpr Field balance{
    .key = "balance",
    .label = Text::tr("B&alanced"),
    .hint =
        Text::tr("Balance an externally balanced crankshaft with damper and flywheel in place."),
    .words = balance_words};

// ----------------------------------------------------------------------------- correction
inline constexpr Field correction{
    .key = "correction", .hint = Text::tr("Readings of the machine and their correction.")};
inline constexpr Field planes{.key = "planes", .hint = Text::tr("The two correction planes.")};
inline constexpr Field plane_position{
    .key = "position_mm",
    .range = Range::between(-10'000, 10'000),
    .label = Text::tr("Position"),
    .hint = Text::tr("Position along the crankshaft, from any point; use the same point for "
                     "planes, readings and bearings."),
    .placeholder = Text::tr("required")};
inline constexpr Field plane_radius{
    .key = "radius_mm",
    .range = Range::between(1, 2000),
    .label = Text::tr("Radius"),
    .hint = Text::tr("From the axis to the drilled rim; masses to take off refer to this radius."),
    .placeholder = Text::tr("required")};
inline constexpr Field from_angle{
    .key = "from_deg",
    .range = Range::between(-360, 360),
    .label = Text::tr("Drill from"),
    .hint = Text::tr("Start of the drilling sector of the counterweight. New holes are wholly "
                     "inside."),
    .if_empty = Text::tr("whole rim"),
    .placeholder = Text::tr("whole rim")};
inline constexpr Field to_angle{.key = "to_deg",
                                .range = Range::between(-360, 360),
                                .label = Text::tr("Drill to"),
                                .hint = Text::tr("End of the sector, towards larger angles."),
                                .if_empty = Text::tr("whole rim"),
                                .placeholder = Text::tr("whole rim")};
inline constexpr Field readings{
    .key = "readings",
    .hint = Text::tr("Readings of the latest run, with the bob weights on the crankpins.")};
inline constexpr Field earlier_runs{
    .key = "earlier_runs",
    .hint = Text::tr("Runs before the latest; the first is the crankshaft as received. Each has "
                     "two readings, at the positions of the latest.")};
inline constexpr Field run_readings{.key = "readings", .hint = Text::tr("Readings of that run.")};
inline constexpr Field reading_position{.key = "position_mm",
                                        .range = plane_position.range,
                                        .label = Text::tr("Read at"),
                                        .hint = Text::tr("Position of the reading."),
                                        .if_empty = Text::tr("in the correction plane"),
                                        .placeholder = Text::tr("the plane")};
inline constexpr Field unbalance{
    .key = "unbalance_g_mm",
    .range = Range::between(0, 1e9),
    .label = Text::tr("Unbalance"),
    .hint = Text::tr("Reading of the machine. It has no sign: turn the angle by 180° instead."),
    .placeholder = Text::tr("required")};
inline constexpr Field angle{
    .key = "angle_deg",
    .range = Range::between(-360, 360),
    .label = Text::tr("Angle shown"),
    .hint = Text::tr("Angle that the machine shows, from its zero mark: of the heavy spot, or of "
                     "the light spot, 180° away. A reading of 0 has no angle."),
    .placeholder = Text::tr("required")};
using shop::field::bob_weight_then;
inline constexpr Field drill{.key = "drill", .hint = Text::tr("Available drills.")};
inline constexpr Field diameters{.key = "diameters_mm",
                                 .range = Range::greater_than(0, 100),
                                 .label = Text::tr("&Drills"),
                                 .hint = Text::tr("Diameters of the available drills.")};
inline constexpr Field density{
    .key = "density_kg_m3",
    .range = Range::between(1000, 25'000),
    .label = Text::tr("De&nsity"),
    .hint = Text::tr("Density of the crankshaft: steel 7850, cast iron 7200 kg/m³.")};
inline constexpr Field maximum_depth{
    .key = "maximum_depth_mm",
    .range = Range::greater_than(0, 500),
    .label = Text::tr("&Maximum depth"),
    .hint = Text::tr("Depth of the full diameter, without the drill point; of an axial slug at "
                     "most the thickness of the counterweight."),
    .placeholder = Text::tr("required")};
inline constexpr Field point_angle{
    .key = "point_angle_deg",
    .range = Range::between(60, 180),
    .label = Text::tr("&Point angle"),
    .hint = Text::tr("Angle of the drill's point: 118°, 135°; 180° for a flat end. It applies to "
                     "holes of slugs too.")};
inline constexpr Field depth_step{
    .key = "depth_step_mm",
    .range = Range::between(0, 10),
    .label = Text::tr("Depth &step"),
    .hint = Text::tr("Depths are rounded to this step. 0: no rounding.")};
inline constexpr Field minimum_wall{
    .key = "minimum_wall_mm",
    .range = Range::between(0, 100),
    .label = Text::tr("&Wall between holes"),
    .hint = Text::tr("Minimum wall between two holes at their bottoms, and between an "
                     "axial slug and the rim.")};
inline constexpr Field maximum_holes{.key = "maximum_holes",
                                     .range = Range::between(1, 15),
                                     .label = Text::tr("Maximum h&oles"),
                                     .hint = Text::tr("Maximum number of holes in one plane.")};
inline constexpr Field maximum_angle{
    .key = "maximum_angle_deg",
    .range = Range::between(0, 85),
    .label = Text::tr("Max. an&gle from heavy spot"),
    .hint = Text::tr("Maximum angle from the heavy spot to a hole, on either side.")};
inline constexpr Field smallest_depth{.key = "smallest_depth_mm",
                                      .range = Range::between(0, 50),
                                      .label = Text::tr("Minimum depth"),
                                      .hint = Text::tr("Minimum depth of a new hole.")};
inline constexpr Field aim{
    .key = "aim",
    .label = Text::tr("Aim"),
    .hint =
        Text::tr("Take off as much as possible, or stop within the limit with the fewest holes."),
    .words = aim_words};
inline constexpr Field drilled{
    .key = "drilled",
    .hint = Text::tr("Holes and slugs planned after that run; later holes keep clear of them. "
                     "Without a list they are planned from its readings.")};
inline constexpr Field drilled_after_newest{
    .key = drilled.key,
    .hint = Text::tr("Holes of the latest run, if a further run was begun and cleared again.")};
inline constexpr Field planned{
    .key = "planned",
    .hint = Text::tr("Plan when the job card was printed or the job put aside; its holes are "
                     "recorded as drilled once the next run is read.")};
inline constexpr Field planned_holes{.key = drilled.key,
                                     .hint = Text::tr("Holes and slugs of that plan.")};
inline constexpr Field drilled_by{
    .key = "drilled_by",
    .hint = Text::tr("Readings from which the holes were planned, if they were corrected since.")};
inline constexpr Field counted_otherwise{
    .key = "drilled_counting_otherwise",
    .hint =
        Text::tr("True if the machine counted degrees in the other direction during drilling.")};
inline constexpr Field drilled_plane{.key = "plane",
                                     .label = Text::tr("Plane"),
                                     .hint = Text::tr("Plane of the hole."),
                                     .words = plane_words};
inline constexpr Field drilled_diameter{.key = "diameter_mm",
                                        .range = diameters.range,
                                        .label = Text::tr("Hole"),
                                        .hint = Text::tr("Diameter of hole or slug.")};
inline constexpr Field drilled_depth{.key = "depth_mm",
                                     .range = Range::between(0, 500),
                                     .label = Text::tr("Depth"),
                                     .hint = Text::tr("Depth of the full diameter, without the "
                                                      "drill point.")};
inline constexpr Field drilled_angle{.key = "angle_deg",
                                     .range = Range::between(-360, 360),
                                     .label = Text::tr("Angle"),
                                     .hint = Text::tr("Angle from the machine's zero mark.")};
inline constexpr Field drilled_mass{
    .key = "removed_g",
    .range = Range::between(-1e6, 1e6),
    .label = Text::tr("Takes off"),
    .hint = Text::tr("Mass taken off; negative for a slug, minus the mass of its hole.")};
inline constexpr Field drilled_unbalance{.key = "removed_g_mm",
                                         .range = unbalance.range,
                                         .label = Text::tr("Takes off, unbalance"),
                                         .hint = Text::tr("Unbalance that the plan takes off.")};
inline constexpr Field drilled_slug{.key = "slug_g",
                                    .range = Range::between(0, 1e6),
                                    .label = Text::tr("Slug"),
                                    .hint = Text::tr("Mass of the slug itself.")};
inline constexpr Field drilled_from_depth{
    .key = "from_depth_mm",
    .range = drilled_depth.range,
    .label = Text::tr("Depth before"),
    .hint = Text::tr("Depth of the hole before it was deepened.")};
inline constexpr Field drilled_direction{.key = "direction",
                                         .label = Text::tr("Direction"),
                                         .hint = Text::tr("Direction of a slug."),
                                         .words = direction_words};
inline constexpr Field drilled_state{
    .key = "state",
    .label = Text::tr("State"),
    .hint = Text::tr("Actual drilling. Measured: depth and angle as found; wrong side: half a "
                     "turn from the given angle."),
    .words = state_words};
inline constexpr Field slug{.key = "slug",
                            .hint = Text::tr("Heavy metal pressed in opposite the heavy spot.")};
inline constexpr Field slug_diameter{.key = "diameter_mm",
                                     .range = Range::greater_than(0, 100),
                                     .label = Text::tr("Slug diame&ter"),
                                     .hint = Text::tr("Diameter of the available slugs."),
                                     .if_empty = Text::tr("no slugs"),
                                     .placeholder = Text::tr("no slugs")};
inline constexpr Field slug_density{
    .key = "density_kg_m3",
    .range = Range::between(1000, 25'000),
    .label = Text::tr("Slug dens&ity"),
    .hint = Text::tr("Tungsten heavy metal 17 000 to 18 500 kg/m³."),
    .placeholder = Text::tr("required")};

inline constexpr Field slug_direction{.key = "direction",
                                      .label = Text::tr("Direction"),
                                      .hint = Text::tr("Direction in which slugs are pressed in."),
                                      .words = direction_words};

// ------------------------------------------------------------------------------ tolerance
inline constexpr Field tolerance{.key = "tolerance",
                                 .hint = Text::tr("Permissible residual unbalance in each plane.")};
inline constexpr Field plane_tolerance{
    .key = "g_mm",
    .unit = units::gram_mm,
    .range = Range::between(0, 1e9),
    .label = Text::tr("&Limit of a plane"),
    .hint = Text::tr("Permissible residual unbalance in each plane."),
    .placeholder = Text::tr("required")};
inline constexpr Field centre_of_mass{.key = "centre_of_mass_mm",
                                      .range = plane_position.range,
                                      .label = Text::tr("Centre of mass"),
                                      .hint = Text::tr("Along the crankshaft."),
                                      .if_empty = Text::tr("midway"),
                                      .placeholder = Text::tr("midway")};
inline constexpr Field front_bearing{
    .key = "front_bearing_mm",
    .range = plane_position.range,
    .label = Text::tr("Front bearing"),
    .hint = Text::tr("With both end bearings the standard's limits apply there; the limits of the "
                     "planes follow from the distances."),
    .if_empty = Text::tr("the standard's limits are shared between the planes"),
    .placeholder = Text::tr("not given")};
inline constexpr Field front_share{
    .key = "front_share",
    .range = Range::between(0.3, 0.7),
    .label = Text::tr("&Share of the first plane"),
    .hint = Text::tr(
        "Share of the permissible unbalance, without positions of bearings or centre of mass.")};
inline constexpr Field rear_bearing{.key = "rear_bearing_mm",
                                    .range = plane_position.range,
                                    .label = Text::tr("Rear bearing"),
                                    .hint = front_bearing.hint,
                                    .if_empty = front_bearing.if_empty,
                                    .placeholder = front_bearing.placeholder};

}  // namespace field
}  // namespace ravnoves::bob_weights

#pragma once

#include "bob-weights/input.h"
#include "shop/balance_grade.h"

/// The inputs of the scene, each described once; the masses are part_fields().
namespace ravnoves::bob_weights {

inline constexpr Word type_words[] = {{"v", CORE_TEXT("bob-weights", "V")},
                                      {"inline", CORE_TEXT("bob-weights", "In line")},
                                      {"boxer", CORE_TEXT("bob-weights", "Boxer")}};
inline constexpr Word rods_words[] = {{"1", CORE_TEXT("bob-weights", "One")},
                                      {"2", CORE_TEXT("bob-weights", "Two")}};
inline constexpr Word numbering_words[] = {
    {"bank-by-bank", CORE_TEXT("bob-weights", "Bank by bank")},
    {"alternating", CORE_TEXT("bob-weights", "1 and 2, 3 and 4, …")}};
inline constexpr Word balance_words[] = {
    {"internal", CORE_TEXT("bob-weights", "Internal: in the crankshaft alone")},
    {"external", CORE_TEXT("bob-weights", "External: damper and flywheel too")}};

inline constexpr Word aim_words[] = {{"zero", CORE_TEXT("bob-weights", "Zero")},
                                     {"tolerance", CORE_TEXT("bob-weights", "Limit")}};
inline constexpr Word direction_words[] = {
    {"axial", CORE_TEXT("bob-weights", "Parallel to the crankshaft")},
    {"radial", CORE_TEXT("bob-weights", "Radial, open at the rim")}};
inline constexpr Word state_words[] = {
    {"as-planned", CORE_TEXT("bob-weights", "As planned")},
    {"measured", CORE_TEXT("bob-weights", "As measured")},
    {"not-drilled", CORE_TEXT("bob-weights", "Not drilled")},
    {"wrong-side", CORE_TEXT("bob-weights", "On the wrong side")}};
inline constexpr Word plane_words[] = {{"front", CORE_TEXT("bob-weights", "Front")},
                                       {"rear", CORE_TEXT("bob-weights", "Rear")}};

namespace field {

using namespace shop::field;

// --------------------------------------------------------------------------------- engine
inline constexpr Field engine{.key = "engine", .hint = CORE_TEXT("bob-weights", "The engine.")};
inline constexpr Field type{.key = "type",
                            .label = CORE_TEXT("bob-weights", "&Engine"),
                            .hint = CORE_TEXT("bob-weights", "Layout of the cylinders."),
                            .words = type_words};
inline constexpr Field cylinders{.key = "cylinders",
                                 .range = Range::between(1, max_cylinders),
                                 .label = CORE_TEXT("bob-weights", "&Cylinders"),
                                 .hint = CORE_TEXT("bob-weights", "Number of cylinders.")};
inline constexpr Field bank_angle{
    .key = "bank_angle_deg",
    .range = Range::between(0, 180),
    .label = CORE_TEXT("bob-weights", "&Bank angle γ"),
    .hint = CORE_TEXT("bob-weights", "Angle between the two banks of a V."),
    .placeholder = CORE_TEXT("V8", "required")};
inline constexpr Field rods_per_pin{
    .key = "rods_per_pin",
    .range = Range::between(1, 2),
    .label = CORE_TEXT("bob-weights", "&Rods on a bob weight"),
    .hint = CORE_TEXT(
        "bob-weights",
        "Two if two rods share a crankpin. Each split crankpin has one rod and one bob weight."),
    .words = rods_words};
inline constexpr Field pin_split{
    .key = "pin_split_deg",
    .range = Range::between(-120, 120),
    .label = CORE_TEXT("bob-weights", "Crankpin &split δ"),
    .hint = CORE_TEXT("bob-weights",
                      "Angle between the two crankpins of a throw; positive if the firing interval "
                      "is γ + δ. A 90° V-6 with 30° fires evenly.")};

// --------------------------------------------------------------------------------- factor
inline constexpr Field factor{
    .key = "factor",
    .hint = CORE_TEXT("bob-weights", "Part of the reciprocating mass in the bob weight.")};
inline constexpr Field reciprocating_percent{
    .key = "reciprocating_percent",
    .range = Range::between(0, 100),
    .label = CORE_TEXT("bob-weights", "Balance &factor"),
    .hint = CORE_TEXT("bob-weights", "Part of the reciprocating mass in the bob weight."),
    .if_empty = CORE_TEXT("bob-weights", "by theory; prefer the manufacturer's figure"),
    .placeholder = CORE_TEXT("bob-weights", "by theory")};
inline constexpr Field overbalance_percent{
    .key = "overbalance_percent",
    .range = Range::between(-50, 50),
    .label = CORE_TEXT("bob-weights", "&Overbalance"),
    .hint = CORE_TEXT("bob-weights",
                      "Added to the factor; negative for underbalance. Usual for high speeds: 1 to "
                      "3 %.")};

// ---------------------------------------------------------------------------------- parts
inline constexpr Field parts{.key = "parts_g",
                             .hint = CORE_TEXT("bob-weights", "Masses of one cylinder's parts.")};
inline constexpr Field numbering{
    .key = "cylinder_numbering",
    .label = CORE_TEXT("bob-weights", "C&ylinders of a crankpin"),
    .hint = CORE_TEXT("V8", "The two cylinders that share a crankpin."),
    .words = numbering_words};
inline constexpr Field part_mass{.key = "mass_g",
                                 .range = nominal.range,
                                 .hint = CORE_TEXT("bob-weights", "Masses by cylinder.")};
inline constexpr Field balance{
    .key = "balance",
    .label = CORE_TEXT("bob-weights", "B&alanced"),
    .hint =
        CORE_TEXT("bob-weights",
                  "Balance an externally balanced crankshaft with damper and flywheel in place."),
    .words = balance_words};

// ----------------------------------------------------------------------------- correction
inline constexpr Field correction{
    .key = "correction",
    .hint = CORE_TEXT("bob-weights", "Readings of the machine and their correction.")};
inline constexpr Field planes{.key = "planes",
                              .hint = CORE_TEXT("bob-weights", "The two correction planes.")};
inline constexpr Field plane_position{
    .key = "position_mm",
    .range = Range::between(-10'000, 10'000),
    .label = CORE_TEXT("bob-weights", "Position"),
    .hint = CORE_TEXT("bob-weights",
                      "Position along the crankshaft, from any point; use the same point for "
                      "planes, readings and bearings."),
    .placeholder = CORE_TEXT("V8", "required")};
inline constexpr Field plane_radius{
    .key = "radius_mm",
    .range = Range::between(1, 2000),
    .label = CORE_TEXT("bob-weights", "Radius"),
    .hint = CORE_TEXT("bob-weights",
                      "From the axis to the drilled rim; masses to take off refer to this radius."),
    .placeholder = CORE_TEXT("V8", "required")};
inline constexpr Field from_angle{
    .key = "from_deg",
    .range = Range::between(-360, 360),
    .label = CORE_TEXT("bob-weights", "Drill from"),
    .hint = CORE_TEXT("bob-weights",
                      "Start of the drilling sector of the counterweight. New holes are wholly "
                      "inside."),
    .if_empty = CORE_TEXT("bob-weights", "whole rim"),
    .placeholder = CORE_TEXT("bob-weights", "whole rim")};
inline constexpr Field to_angle{
    .key = "to_deg",
    .range = Range::between(-360, 360),
    .label = CORE_TEXT("bob-weights", "Drill to"),
    .hint = CORE_TEXT("bob-weights", "End of the sector, towards larger angles."),
    .if_empty = CORE_TEXT("bob-weights", "whole rim"),
    .placeholder = CORE_TEXT("bob-weights", "whole rim")};
inline constexpr Field readings{
    .key = "readings",
    .hint = CORE_TEXT("bob-weights",
                      "Readings of the latest run, with the bob weights on the crankpins.")};
inline constexpr Field earlier_runs{
    .key = "earlier_runs",
    .hint = CORE_TEXT("bob-weights",
                      "Runs before the latest; the first is the crankshaft as received. Each has "
                      "two readings, at the positions of the latest.")};
inline constexpr Field run_readings{.key = "readings",
                                    .hint = CORE_TEXT("bob-weights", "Readings of that run.")};
inline constexpr Field reading_position{
    .key = "position_mm",
    .range = plane_position.range,
    .label = CORE_TEXT("bob-weights", "Read at"),
    .hint = CORE_TEXT("bob-weights", "Position of the reading."),
    .if_empty = CORE_TEXT("bob-weights", "in the correction plane"),
    .placeholder = CORE_TEXT("bob-weights", "the plane")};
inline constexpr Field unbalance{.key = "unbalance_g_mm",
                                 .range = Range::between(0, 1e9),
                                 .label = CORE_TEXT("bob-weights", "Unbalance"),
                                 .hint = CORE_TEXT("bob-weights", "Reading of the machine."),
                                 .placeholder = CORE_TEXT("V8", "required")};
inline constexpr Field angle{
    .key = "angle_deg",
    .range = Range::between(-360, 360),
    .label = CORE_TEXT("bob-weights", "Heavy spot"),
    .hint = CORE_TEXT("bob-weights",
                      "Angle of the heavy spot from the machine's zero mark; the light spot is "
                      "180° away. A reading of 0 has no angle."),
    .placeholder = CORE_TEXT("V8", "required")};
using shop::field::bob_weight_then;
inline constexpr Field drill{.key = "drill", .hint = CORE_TEXT("bob-weights", "Available drills.")};
inline constexpr Field diameters{
    .key = "diameters_mm",
    .range = Range::greater_than(0, 100),
    .label = CORE_TEXT("bob-weights", "&Drills"),
    .hint = CORE_TEXT("bob-weights", "Diameters of the available drills.")};
inline constexpr Field density{
    .key = "density_kg_m3",
    .range = Range::between(1000, 25'000),
    .label = CORE_TEXT("bob-weights", "De&nsity"),
    .hint =
        CORE_TEXT("bob-weights", "Density of the crankshaft: steel 7850, cast iron 7200 kg/m³.")};
inline constexpr Field maximum_depth{
    .key = "maximum_depth_mm",
    .range = Range::greater_than(0, 500),
    .label = CORE_TEXT("bob-weights", "&Maximum depth"),
    .hint = CORE_TEXT("bob-weights",
                      "Depth of the full diameter, without the drill point; of an axial slug at "
                      "most the thickness of the counterweight."),
    .placeholder = CORE_TEXT("V8", "required")};
inline constexpr Field point_angle{
    .key = "point_angle_deg",
    .range = Range::between(60, 180),
    .label = CORE_TEXT("bob-weights", "&Point angle"),
    .hint = CORE_TEXT("bob-weights",
                      "Angle of the drill's point: 118°, 135°; 180° for a flat end. It applies to "
                      "holes of slugs too.")};
inline constexpr Field depth_step{
    .key = "depth_step_mm",
    .range = Range::between(0, 10),
    .label = CORE_TEXT("bob-weights", "Depth &step"),
    .hint = CORE_TEXT("bob-weights", "Depths are rounded to this step. 0: no rounding.")};
inline constexpr Field minimum_wall{
    .key = "minimum_wall_mm",
    .range = Range::between(0, 100),
    .label = CORE_TEXT("bob-weights", "&Wall between holes"),
    .hint = CORE_TEXT("bob-weights",
                      "Minimum wall between two holes at their bottoms, and between an "
                      "axial slug and the rim.")};
inline constexpr Field maximum_holes{
    .key = "maximum_holes",
    .range = Range::between(1, 15),
    .label = CORE_TEXT("bob-weights", "Maximum h&oles"),
    .hint = CORE_TEXT("bob-weights", "Maximum number of holes in one plane.")};
inline constexpr Field maximum_angle{
    .key = "maximum_angle_deg",
    .range = Range::between(0, 85),
    .label = CORE_TEXT("bob-weights", "Max. an&gle from heavy spot"),
    .hint =
        CORE_TEXT("bob-weights", "Maximum angle from the heavy spot to a hole, on either side.")};
inline constexpr Field smallest_depth{
    .key = "smallest_depth_mm",
    .range = Range::between(0, 50),
    .label = CORE_TEXT("bob-weights", "Minimum depth"),
    .hint = CORE_TEXT("bob-weights", "Minimum depth of a new hole.")};
inline constexpr Field aim{
    .key = "aim",
    .label = CORE_TEXT("bob-weights", "Aim"),
    .hint =
        CORE_TEXT("bob-weights",
                  "Take off as much as possible, or stop within the limit with the fewest holes."),
    .words = aim_words};
inline constexpr Field drilled{
    .key = "drilled",
    .hint = CORE_TEXT("bob-weights",
                      "Holes and slugs planned after that run; later holes keep clear of them. "
                      "Without a list they are planned from its readings.")};
inline constexpr Field drilled_after_newest{
    .key = drilled.key,
    .hint = CORE_TEXT("bob-weights",
                      "Holes of the latest run, if a further run was begun and cleared again.")};
inline constexpr Field drilled_by{
    .key = "drilled_by",
    .hint = CORE_TEXT("bob-weights",
                      "Readings from which the holes were planned, if they were corrected since.")};
inline constexpr Field counted_otherwise{
    .key = "drilled_counting_otherwise",
    .hint =
        CORE_TEXT("bob-weights",
                  "True if the machine counted degrees in the other direction during drilling.")};
inline constexpr Field drilled_plane{.key = "plane",
                                     .label = CORE_TEXT("bob-weights", "Plane"),
                                     .hint = CORE_TEXT("bob-weights", "Plane of the hole."),
                                     .words = plane_words};
inline constexpr Field drilled_diameter{
    .key = "diameter_mm",
    .range = diameters.range,
    .label = CORE_TEXT("bob-weights", "Hole"),
    .hint = CORE_TEXT("bob-weights", "Diameter of hole or slug.")};
inline constexpr Field drilled_depth{.key = "depth_mm",
                                     .range = Range::between(0, 500),
                                     .label = CORE_TEXT("bob-weights", "Depth"),
                                     .hint = CORE_TEXT("bob-weights",
                                                       "Depth of the full diameter, without the "
                                                       "drill point.")};
inline constexpr Field drilled_angle{
    .key = "angle_deg",
    .range = Range::between(-360, 360),
    .label = CORE_TEXT("bob-weights", "Angle"),
    .hint = CORE_TEXT("bob-weights", "Angle from the machine's zero mark.")};
inline constexpr Field drilled_mass{
    .key = "removed_g",
    .range = Range::between(-1e6, 1e6),
    .label = CORE_TEXT("bob-weights", "Takes off"),
    .hint = CORE_TEXT("bob-weights",
                      "Mass taken off; negative for a slug, minus the mass of its hole.")};
inline constexpr Field drilled_slug{.key = "slug_g",
                                    .range = Range::between(0, 1e6),
                                    .label = CORE_TEXT("bob-weights", "Slug"),
                                    .hint = CORE_TEXT("bob-weights", "Mass of the slug itself.")};
inline constexpr Field drilled_from_depth{
    .key = "from_depth_mm",
    .range = drilled_depth.range,
    .label = CORE_TEXT("bob-weights", "Depth before"),
    .hint = CORE_TEXT("bob-weights", "Depth of the hole before it was deepened.")};
inline constexpr Field drilled_direction{.key = "direction",
                                         .label = CORE_TEXT("bob-weights", "Direction"),
                                         .hint = CORE_TEXT("bob-weights", "Direction of a slug."),
                                         .words = direction_words};
inline constexpr Field drilled_state{
    .key = "state",
    .label = CORE_TEXT("bob-weights", "State"),
    .hint = CORE_TEXT("bob-weights",
                      "Actual drilling. Measured: depth and angle as found; wrong side: half a "
                      "turn from the given angle."),
    .words = state_words};
inline constexpr Field slug{
    .key = "slug",
    .hint = CORE_TEXT("bob-weights", "Heavy metal pressed in opposite the heavy spot.")};
inline constexpr Field slug_diameter{
    .key = "diameter_mm",
    .range = Range::greater_than(0, 100),
    .label = CORE_TEXT("bob-weights", "Slug diame&ter"),
    .hint = CORE_TEXT("bob-weights", "Diameter of the available slugs."),
    .if_empty = CORE_TEXT("bob-weights", "no slugs"),
    .placeholder = CORE_TEXT("bob-weights", "no slugs")};
inline constexpr Field slug_density{
    .key = "density_kg_m3",
    .range = Range::between(1000, 25'000),
    .label = CORE_TEXT("bob-weights", "Slug dens&ity"),
    .hint = CORE_TEXT("bob-weights", "Tungsten heavy metal 17 000 to 18 500 kg/m³."),
    .placeholder = CORE_TEXT("V8", "required")};

inline constexpr Field slug_direction{
    .key = "direction",
    .label = CORE_TEXT("bob-weights", "Direction"),
    .hint = CORE_TEXT("bob-weights", "Direction in which slugs are pressed in."),
    .words = direction_words};

// ------------------------------------------------------------------------------ tolerance
inline constexpr Field tolerance{
    .key = "tolerance",
    .hint = CORE_TEXT("bob-weights", "Permissible residual unbalance in each plane.")};
inline constexpr Field plane_tolerance{
    .key = "g_mm",
    .unit = units::gram_mm,
    .range = Range::between(0, 1e9),
    .label = CORE_TEXT("bob-weights", "&Limit of a plane"),
    .hint = CORE_TEXT("bob-weights", "Permissible residual unbalance in each plane."),
    .placeholder = CORE_TEXT("V8", "required")};
inline constexpr Field centre_of_mass{.key = "centre_of_mass_mm",
                                      .range = plane_position.range,
                                      .label = CORE_TEXT("bob-weights", "Centre of mass"),
                                      .hint = CORE_TEXT("bob-weights", "Along the crankshaft."),
                                      .if_empty = CORE_TEXT("bob-weights", "midway"),
                                      .placeholder = CORE_TEXT("bob-weights", "midway")};
inline constexpr Field front_bearing{
    .key = "front_bearing_mm",
    .range = plane_position.range,
    .label = CORE_TEXT("bob-weights", "Front bearing"),
    .hint = CORE_TEXT("bob-weights",
                      "With both end bearings the standard's limits apply there; the limits of the "
                      "planes follow from the distances."),
    .if_empty = CORE_TEXT("bob-weights", "the standard's limits are shared between the planes"),
    .placeholder = CORE_TEXT("bob-weights", "not given")};
inline constexpr Field front_share{
    .key = "front_share",
    .range = Range::between(0.3, 0.7),
    .label = CORE_TEXT("V8", "&Share of the first plane"),
    .hint = CORE_TEXT(
        "bob-weights",
        "Share of the permissible unbalance, without positions of bearings or centre of mass.")};
inline constexpr Field rear_bearing{.key = "rear_bearing_mm",
                                    .range = plane_position.range,
                                    .label = CORE_TEXT("bob-weights", "Rear bearing"),
                                    .hint = front_bearing.hint,
                                    .if_empty = front_bearing.if_empty,
                                    .placeholder = front_bearing.placeholder};

}  // namespace field
}  // namespace ravnoves::bob_weights

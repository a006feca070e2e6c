#pragma once

#include <string_view>

#include "case-file/field.h"
#include "case-file/input_error.h"
#include "inertia-moments/input.h"

/// Every input of the scene, described once.
namespace ravnoves::inertia_moments::field {

inline constexpr Field crank_radius{
    .key = "crank_radius_mm",
    .range = Range::greater_than(0),
    .label = CORE_TEXT("inertia-moments", "&Crank radius R"),
    .symbol = "R",
    .hint = CORE_TEXT("inertia-moments",
                      "Half the stroke (a little less with offset). Volkswagen VR5: 45 mm.")};
inline constexpr Field lambda{.key = "lambda",
                              .range = Range::greater_than(0),
                              .label = CORE_TEXT("inertia-moments", "&λ = R / L"),
                              .symbol = "λ",
                              .hint = CORE_TEXT("inertia-moments",
                                                "Crank radius over rod length; the crank turns if "
                                                "λ (1 + |e|/R) < 1. Volkswagen VR5: 0.265.")};
inline constexpr Field rod_length{
    .key = "rod_length_mm",
    .range = Range::greater_than(0),
    .label = CORE_TEXT("inertia-moments", "Ro&d length L"),
    .symbol = "L",
    .hint = CORE_TEXT("inertia-moments",
                      "From crankpin to piston pin. Enter λ or the length; the entered one is kept "
                      "when the crank radius changes.")};
inline constexpr Field speed{
    .key = "speed_rpm",
    .range = Range::greater_than(0),
    .label = CORE_TEXT("inertia-moments", "Speed &n"),
    .symbol = "n",
    .hint =
        CORE_TEXT("inertia-moments", "Crankshaft speed; forces and moments grow with its square.")};
inline constexpr Field reciprocating_mass{
    .key = "reciprocating_mass_kg",
    .range = Range::greater_than(0),
    .label = CORE_TEXT("inertia-moments", "Re&ciprocating mass"),
    .hint = CORE_TEXT("inertia-moments",
                      "Mass of one cylinder: piston with pin and rings, and the rod's share unless "
                      "the rod is a rigid body. Volkswagen VR5: 0.622 kg.")};
inline constexpr Field rotating_mass{
    .key = "rotating_mass_kg",
    .range = Range::at_least(0),
    .label = CORE_TEXT("inertia-moments", "R&otating mass"),
    .hint = CORE_TEXT(
        "inertia-moments",
        "Mass of one cylinder at the crank radius: its part of the throw, and the rod's share "
        "unless the rod is a rigid body. A crankpin with two rods carries it twice.")};
inline constexpr Field rotating_mass_per_throw{
    .key = "rotating_mass_per_throw_kg",
    .range = Range::at_least(0),
    .label = CORE_TEXT("inertia-moments", "R&otating mass of a throw"),
    .hint = CORE_TEXT("inertia-moments",
                      "Rotating mass on one crankpin, with the shares of its rods unless the rod "
                      "is a rigid body. All crankpins must carry the same number of rods.")};
inline constexpr Word stroke_words[] = {{"2", CORE_TEXT("inertia-moments", "two strokes, 360°")},
                                        {"4", CORE_TEXT("inertia-moments", "four strokes, 720°")}};
inline constexpr Field strokes{
    .key = "strokes",
    .label = CORE_TEXT("inertia-moments", "C&ycle"),
    .hint = CORE_TEXT("inertia-moments",
                      "The cylinders fire over 720° (four strokes) or 360° (two strokes). "
                      "Crankpins for even firing are adjusted."),
    .words = stroke_words};
inline constexpr Field reference_position{
    .key = "reference_position_mm",
    .label = CORE_TEXT("inertia-moments", "Centre of mass &z"),
    .symbol = "z",
    .hint = CORE_TEXT(
        "inertia-moments",
        "Axial position of the reference point of moments, positive towards cylinder 1.")};
inline constexpr Field step{
    .key = "step_deg",
    .range = Range::between(0.01, 90),
    .hint = CORE_TEXT("inertia-moments",
                      "Step of the curves in the result; without a step there are no curves."),
    .is_setting = true};
/// Of a table; also of a layout.
inline constexpr Field firing_order{
    .key = "firing_order",
    .range = Range::between(1, max_cylinders),
    .label = CORE_TEXT("inertia-moments", "&Firing order"),
    .hint = CORE_TEXT("inertia-moments",
                      "Numbers of the cylinders, for example 1-2-4-5-3. Crankpins for even firing "
                      "are adjusted.")};

// Of each entry of "cylinders".
inline constexpr Field cylinders{
    .key = "cylinders",
    .hint = CORE_TEXT("inertia-moments", "The cylinders one by one, instead of a layout.")};
inline constexpr Field axial_position{
    .key = "axial_position_mm",
    .label = CORE_TEXT("inertia-moments", "Axial position"),
    .symbol = "z",
    .hint = CORE_TEXT("inertia-moments", "Axial position, positive towards cylinder 1")};
inline constexpr Field bank_angle{
    .key = "bank_angle_deg",
    .range = Range::between(-3600, 3600),
    .label = CORE_TEXT("inertia-moments", "Bank angle"),
    .symbol = "β",
    .hint = CORE_TEXT("inertia-moments",
                      "Direction of the cylinder's axis, counter-clockwise from up")};
inline constexpr Field offset{
    .key = "offset_mm",
    .label = CORE_TEXT("inertia-moments", "Offset"),
    .symbol = "e",
    .hint = CORE_TEXT("inertia-moments",
                      "Distance of the cylinder's axis from the crank axis, positive on the "
                      "counter-clockwise side")};
inline constexpr Field crankpin_angle{
    .key = "crankpin_angle_deg",
    .range = Range::between(-3600, 3600),
    .label = CORE_TEXT("inertia-moments", "Crankpin angle"),
    .symbol = "κ",
    .hint = CORE_TEXT("inertia-moments", "Crankpin, counter-clockwise from crankpin 1")};

// Of the object "articulated" of a cylinder.
inline constexpr Field articulated{
    .key = "articulated",
    .label = CORE_TEXT("inertia-moments", "Articulated rod"),
    .hint = CORE_TEXT("inertia-moments",
                      "The rod is attached to the master rod by a knuckle pin (radials); otherwise "
                      "it runs on the crankpin.")};
inline constexpr Field knuckle_radius{
    .key = "knuckle_radius_mm",
    .range = Range::between(0, 1e6),
    .label = CORE_TEXT("inertia-moments", "Knuckle radius"),
    .symbol = "rₖ",
    .hint = CORE_TEXT("inertia-moments",
                      "Articulated rod: distance of its knuckle pin from the crankpin's centre."),
    .if_empty = CORE_TEXT("inertia-moments", "the rod runs on the crankpin")};
inline constexpr Field knuckle_angle{
    .key = "knuckle_angle_deg",
    .range = Range::between(-3600, 3600),
    .label = CORE_TEXT("inertia-moments", "Knuckle angle"),
    .symbol = "γₖ",
    .hint = CORE_TEXT("inertia-moments",
                      "Articulated rod: its knuckle pin about the crankpin, counter-clockwise from "
                      "the master rod's axis."),
    .if_empty = CORE_TEXT("inertia-moments", "the difference of the bank angles")};
inline constexpr Field articulated_length{
    .key = "rod_length_mm",
    .range = Range::greater_than(0, 1e6),
    .label = CORE_TEXT("inertia-moments", "Rod length"),
    .symbol = "l",
    .hint =
        CORE_TEXT("inertia-moments", "Articulated rod: its length from knuckle pin to piston pin."),
    .if_empty = CORE_TEXT("inertia-moments", "the master rod's length minus the knuckle radius")};
inline constexpr Field master{
    .key = "master",
    .range = Range::between(0, max_cylinders),
    .label = CORE_TEXT("inertia-moments", "Master rod"),
    .hint = CORE_TEXT("inertia-moments",
                      "Articulated rod: number of the cylinder with its master rod."),
    .if_empty = CORE_TEXT("inertia-moments", "0, the only rod on the crankpin")};
inline constexpr Field knuckle_mass{
    .key = "knuckle_mass_kg",
    .range = Range::at_least(0),
    .label = CORE_TEXT("inertia-moments", "Knuckle mass"),
    .symbol = "mₖ",
    .hint = CORE_TEXT("inertia-moments",
                      "Articulated rod: part of the cylinder's rotating mass at the knuckle pin "
                      "instead of the crankpin")};

// Of the object "layout".
enum class LayoutType { vr, library };
inline constexpr Word layout_types[] = {
    {"vr", CORE_TEXT("inertia-moments", "VR engine")},
    {"library", CORE_TEXT("inertia-moments", "of the library")}};
inline constexpr Field layout{
    .key = "layout",
    .hint = CORE_TEXT("inertia-moments", "A layout, instead of the cylinders one by one.")};
inline constexpr Field layout_type{
    .key = "type",
    .label = CORE_TEXT("inertia-moments", "Kind of layout"),
    .hint = CORE_TEXT("inertia-moments",
                      "A VR engine of any number of cylinders, or a layout of the library."),
    .words = layout_types};
extern const Field layout_name;  ///< its words are the names of the library
inline constexpr Field layout_cylinders{
    .key = "cylinders",
    .range = Range::between(1, max_cylinders),
    .hint = CORE_TEXT("inertia-moments", "Number of cylinders of a VR engine.")};
inline constexpr Field included_angle{
    .key = "bank_angle_deg",
    .range = Range::between(0, 180),
    .label = CORE_TEXT("inertia-moments", "Bank an&gle γ"),
    .symbol = "γ",
    .hint = CORE_TEXT("inertia-moments",
                      "Angle between the banks, 0 to 180°. Crankpins for even firing are adjusted; "
                      "in a table only the bank angles are scaled.")};
inline constexpr Field layout_offset{
    .key = "offset_mm",
    .label = CORE_TEXT("inertia-moments", "O&ffset e"),
    .symbol = "e",
    .hint = CORE_TEXT("inertia-moments",
                      "Distance of the cylinder axes from the crank axis. In a table: the maximum; "
                      "the others are scaled.")};
inline constexpr Field spacing{
    .key = "spacing_mm",
    .range = Range::greater_than(0),
    .label = CORE_TEXT("inertia-moments", "&Spacing a"),
    .symbol = "a",
    .hint = CORE_TEXT("inertia-moments",
                      "Distance along the crank between neighbouring crankpins, or throws of a "
                      "V engine. Volkswagen VR5: 63 mm.")};
inline constexpr Field stagger{.key = "stagger_mm",
                               .label = CORE_TEXT("inertia-moments", "Sta&gger"),
                               .hint = CORE_TEXT("inertia-moments",
                                                 "Distance along the crank from bank 1's to bank "
                                                 "2's cylinder of a throw. 0 for forked rods.")};
inline constexpr Field first_position{
    .key = "first_position_mm",
    .label = CORE_TEXT("inertia-moments", "&Position of cylinder 1"),
    .symbol = "z",
    .hint = CORE_TEXT("inertia-moments",
                      "Axial position z of cylinder 1. Volkswagen VR5: 3 a + l = 204.8 mm, with "
                      "the centre of mass at z = 0."),
    .if_empty = CORE_TEXT("inertia-moments", "z = 0 in the middle")};

// Of the object "rod".
inline constexpr Field rod{
    .key = "rod",
    .label = CORE_TEXT("inertia-moments", "Rod as a rigid body"),
    .hint = CORE_TEXT("inertia-moments",
                      "The rod as a rigid body; otherwise its shares are in the masses.")};
inline constexpr Field rod_mass{.key = "mass_kg",
                                .range = Range::at_least(0),
                                .label = CORE_TEXT("inertia-moments", "Rod &mass"),
                                .hint = CORE_TEXT("inertia-moments", "Whole rod")};
inline constexpr Field rod_centre{
    .key = "centre_from_big_end_mm",
    .label = CORE_TEXT("inertia-moments", "Centre from &big end"),
    .hint = CORE_TEXT("inertia-moments", "Centre of mass, from the big end towards the small end")};
inline constexpr Field rod_inertia{
    .key = "inertia_kg_m2",
    .range = Range::at_least(0),
    .label = CORE_TEXT("inertia-moments", "&Inertia"),
    .hint = CORE_TEXT("inertia-moments", "Moment of inertia about the centre of mass")};

// Of each entry of "balance_shafts", and the orders that they are designed for.
inline constexpr Word bases[] = {{"exact", CORE_TEXT("inertia-moments", "exact orders")},
                                 {"two-term", CORE_TEXT("inertia-moments", "two-term form")}};
inline constexpr Word directions[] = {{"forward", CORE_TEXT("inertia-moments", "+kω")},
                                      {"backward", CORE_TEXT("inertia-moments", "−kω")}};
inline constexpr Word tasks[] = {{"moment", CORE_TEXT("inertia-moments", "moment")},
                                 {"force", CORE_TEXT("inertia-moments", "force")}};
inline constexpr Range weight_range = Range::between(1e-3, 1e9);
inline constexpr Field shaft_basis{
    .key = "balance_shaft_basis",
    .label = CORE_TEXT("inertia-moments", "&Designed for"),
    .hint = CORE_TEXT("inertia-moments",
                      "The paper designs its shafts by the two-term form; the residual is then the "
                      "error of this form."),
    .words = bases};
inline constexpr Field shafts{
    .key = "balance_shafts",
    .hint = CORE_TEXT("inertia-moments",
                      "The balance shafts, each made for the order that it cancels.")};
inline constexpr Field shaft_order{
    .key = "order",
    .range = Range::between(1, highest_order),
    .label = CORE_TEXT("inertia-moments", "Order of the shaft"),
    .symbol = "k",
    .hint =
        CORE_TEXT("inertia-moments",
                  "Order that the shaft cancels; the shaft turns k times as fast as the crank.")};
inline constexpr Field shaft_direction{
    .key = "direction",
    .label = CORE_TEXT("inertia-moments", "Direction of the shaft"),
    .hint = CORE_TEXT("inertia-moments", "With the crank (+kω) or against it (−kω)"),
    .words = directions};
inline constexpr Field shaft_task{
    .key = "balances",
    .label = CORE_TEXT("inertia-moments", "Task of the shaft"),
    .hint =
        CORE_TEXT("inertia-moments", "Two opposite weights against a moment, one against a force"),
    .words = tasks};
inline constexpr Field weight_distance{
    .key = "weight_distance_mm",
    .range = weight_range,
    .label = CORE_TEXT("inertia-moments", "Distance of the shaft's weights"),
    .symbol = "L",
    .hint = CORE_TEXT("inertia-moments", "Distance between the two weights along the shaft")};
inline constexpr Field shaft_position{
    .key = "axial_position_mm",
    .label = CORE_TEXT("inertia-moments", "Place of the shaft"),
    .symbol = "z",
    .hint = CORE_TEXT("inertia-moments", "Axial position of the weight."),
    .if_empty = CORE_TEXT("inertia-moments", "at the reference point of moments"),
    .placeholder = CORE_TEXT("inertia-moments", "c. m.")};
inline constexpr Field weight_radius{
    .key = "weight_radius_mm",
    .range = weight_range,
    .label = CORE_TEXT("inertia-moments", "Radius of the shaft's weights"),
    .symbol = "ρ",
    .hint =
        CORE_TEXT("inertia-moments", "Radius of the weights' centres of mass; gives their mass."),
    .if_empty = CORE_TEXT("inertia-moments", "only mρ is given")};
inline constexpr Field phase_error{
    .key = "phase_error_deg",
    .range = Range::between(-360, 360),
    .label = CORE_TEXT("inertia-moments", "Phase of the shaft"),
    .symbol = "δ",
    .hint = CORE_TEXT(
        "inertia-moments",
        "Phase error of the shaft, positive ahead in its own direction; 0 for correct timing.")};
inline constexpr Field shaft_enabled{
    .key = "enabled",
    .label = CORE_TEXT("inertia-moments", "Shaft on"),
    .hint = CORE_TEXT("inertia-moments", "If on, the shaft is included in the residual.")};

// Of the object "counterweights".
inline constexpr Field end_webs{
    .key = "counterweights",
    .hint = CORE_TEXT("inertia-moments", "The two counterweights on the end webs.")};
inline constexpr Field front_position{
    .key = "front_position_mm",
    .label = CORE_TEXT("inertia-moments", "&Front web at z"),
    .hint = CORE_TEXT("inertia-moments", "Axial position of the front weight")};
inline constexpr Field rear_position{
    .key = "rear_position_mm",
    .label = CORE_TEXT("inertia-moments", "R&ear web at z"),
    .hint = CORE_TEXT("inertia-moments", "Axial position of the rear weight")};
inline constexpr Field front_radius{
    .key = "front_radius_mm",
    .range = weight_range,
    .label = CORE_TEXT("inertia-moments", "Front &radius ρ"),
    .hint = CORE_TEXT("inertia-moments", "Radius of the front weight's centre of mass")};
inline constexpr Field rear_radius{
    .key = "rear_radius_mm",
    .range = weight_range,
    .label = CORE_TEXT("inertia-moments", "Rear ra&dius ρ"),
    .hint = CORE_TEXT("inertia-moments", "Radius of the rear weight's centre of mass")};
inline constexpr Field first_order_share{
    .key = "first_order_share",
    .range = Range::between(0, 1),
    .label = CORE_TEXT("inertia-moments", "&Share of forward order 1"),
    .hint = CORE_TEXT("inertia-moments",
                      "1 cancels the forward half of the reciprocating first order; in a single "
                      "cylinder this is a balance factor of 50 %.")};
inline constexpr Field webs_enabled{
    .key = "enabled",
    .hint =
        CORE_TEXT("inertia-moments", "If on, the counterweights are included in the residual.")};

}  // namespace ravnoves::inertia_moments::field

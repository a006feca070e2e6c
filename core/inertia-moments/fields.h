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
    .label = Text::tr("&Crank radius R"),
    .symbol = "R",
    .hint = Text::tr("Half the stroke (a little less with offset). Volkswagen VR5: 45 mm.")};
inline constexpr Field lambda{.key = "lambda",
                              .range = Range::greater_than(0),
                              .label = Text::tr("&λ = R / L"),
                              .symbol = "λ",
                              .hint = Text::tr("Crank radius over rod length; the crank turns if "
                                               "λ (1 + |e|/R) < 1. Volkswagen VR5: 0.265.")};
inline constexpr Field rod_length{
    .key = "rod_length_mm",
    .range = Range::greater_than(0),
    .label = Text::tr("Ro&d length L"),
    .symbol = "L",
    .hint = Text::tr("From crankpin to piston pin. Enter λ or the length; the entered one is kept "
                     "when the crank radius changes.")};
inline constexpr Field speed{
    .key = "speed_rpm",
    .range = Range::greater_than(0),
    .label = Text::tr("Speed &n"),
    .symbol = "n",
    .hint = Text::tr("Crankshaft speed; forces and moments grow with its square.")};
inline constexpr Field reciprocating_mass{
    .key = "reciprocating_mass_kg",
    .range = Range::greater_than(0),
    .label = Text::tr("Re&ciprocating mass"),
    .hint = Text::tr("Mass of one cylinder: piston with pin and rings, and the rod's share unless "
                     "the rod is a rigid body. Volkswagen VR5: 0.622 kg.")};
inline constexpr Field rotating_mass{
    .key = "rotating_mass_kg",
    .range = Range::at_least(0),
    .label = Text::tr("R&otating mass"),
    .hint = Text::tr(
        "Mass of one cylinder at the crank radius: its part of the throw, and the rod's share "
        "unless the rod is a rigid body. A crankpin with two rods carries it twice.")};
inline constexpr Field rotating_mass_per_throw{
    .key = "rotating_mass_per_throw_kg",
    .range = Range::at_least(0),
    .label = Text::tr("R&otating mass of a throw"),
    .hint = Text::tr("Rotating mass on one crankpin, with the shares of its rods unless the rod "
                     "is a rigid body. All crankpins must carry the same number of rods.")};
inline constexpr Word stroke_words[] = {{"2", Text::tr("two strokes, 360°")},
                                        {"4", Text::tr("four strokes, 720°")}};
inline constexpr Field strokes{
    .key = "strokes",
    .label = Text::tr("C&ycle"),
    .hint = Text::tr("The cylinders fire over 720° (four strokes) or 360° (two strokes). "
                     "Crankpins for even firing are adjusted."),
    .words = stroke_words};
inline constexpr Field reference_position{
    .key = "reference_position_mm",
    .label = Text::tr("Centre of mass &z₀"),
    .symbol = "z₀",
    .hint =
        Text::tr("Axial position of the reference point of moments, positive towards cylinder 1.")};
inline constexpr Field step{
    .key = "step_deg",
    .range = Range::between(0.01, 90),
    .hint = Text::tr("Step of the curves in the result; without a step there are no curves."),
    .is_setting = true};
/// Of a table; also of a layout.
inline constexpr Field firing_order{
    .key = "firing_order",
    .range = Range::between(1, max_cylinders),
    .label = Text::tr("&Firing order"),
    .hint = Text::tr("Numbers of the cylinders, for example 1-2-4-5-3. Crankpins for even firing "
                     "are adjusted.")};

// Of each entry of "cylinders".
inline constexpr Field cylinders{
    .key = "cylinders", .hint = Text::tr("The cylinders one by one, instead of a layout.")};
inline constexpr Field axial_position{
    .key = "axial_position_mm",
    .label = Text::tr("Axial position"),
    .symbol = "z",
    .hint = Text::tr("Axial position, positive towards cylinder 1")};
inline constexpr Field bank_angle{
    .key = "bank_angle_deg",
    .range = Range::between(-3600, 3600),
    .label = Text::tr("Bank angle"),
    .symbol = "β",
    .hint = Text::tr("Direction of the cylinder's axis, counter-clockwise from up")};
inline constexpr Field offset{
    .key = "offset_mm",
    .label = Text::tr("Offset"),
    .symbol = "e",
    .hint = Text::tr("Distance of the cylinder's axis from the crank axis, positive on the "
                     "counter-clockwise side")};
inline constexpr Field crankpin_angle{
    .key = "crankpin_angle_deg",
    .range = Range::between(-3600, 3600),
    .label = Text::tr("Crankpin angle"),
    .symbol = "κ",
    .hint = Text::tr("Crankpin, counter-clockwise from crankpin 1")};

// Of the object "articulated" of a cylinder.
inline constexpr Field articulated{
    .key = "articulated",
    .label = Text::tr("Articulated rod"),
    .hint = Text::tr("The rod is attached to the master rod by a knuckle pin (radials); otherwise "
                     "it runs on the crankpin.")};
inline constexpr Field knuckle_radius{
    .key = "knuckle_radius_mm",
    .range = Range::between(0, 1e6),
    .label = Text::tr("Knuckle radius"),
    .symbol = "rₖ",
    .hint = Text::tr("Articulated rod: distance of its knuckle pin from the crankpin's centre."),
    .if_empty = Text::tr("the rod runs on the crankpin")};
inline constexpr Field knuckle_angle{
    .key = "knuckle_angle_deg",
    .range = Range::between(-3600, 3600),
    .label = Text::tr("Knuckle angle"),
    .symbol = "γₖ",
    .hint = Text::tr("Articulated rod: its knuckle pin about the crankpin, counter-clockwise from "
                     "the master rod's axis."),
    .if_empty = Text::tr("the difference of the bank angles")};
inline constexpr Field articulated_length{
    .key = "rod_length_mm",
    .range = Range::greater_than(0, 1e6),
    .label = Text::tr("Rod length"),
    .symbol = "l",
    .hint = Text::tr("Articulated rod: its length from knuckle pin to piston pin."),
    .if_empty = Text::tr("the master rod's length minus the knuckle radius")};
inline constexpr Field master{
    .key = "master",
    .range = Range::between(0, max_cylinders),
    .label = Text::tr("Master rod"),
    .hint = Text::tr("Articulated rod: number of the cylinder with its master rod."),
    .if_empty = Text::tr("0, the only rod on the crankpin")};
inline constexpr Field knuckle_mass{
    .key = "knuckle_mass_kg",
    .range = Range::at_least(0),
    .label = Text::tr("Knuckle mass"),
    .symbol = "mₖ",
    .hint = Text::tr("Articulated rod: part of the cylinder's rotating mass at the knuckle pin "
                     "instead of the crankpin")};

// Of the object "layout".
enum class LayoutType { vr, library };
inline constexpr Word layout_types[] = {{"vr", Text::tr("VR engine")},
                                        {"library", Text::tr("of the library")}};
inline constexpr Field layout{.key = "layout",
                              .hint = Text::tr("A layout, instead of the cylinders one by one.")};
inline constexpr Field layout_type{
    .key = "type",
    .label = Text::tr("Kind of layout"),
    .hint = Text::tr("A VR engine of any number of cylinders, or a layout of the library."),
    .words = layout_types};
extern const Field layout_name;  ///< its words are the names of the library
inline constexpr Field layout_cylinders{.key = "cylinders",
                                        .range = Range::between(1, max_cylinders),
                                        .hint = Text::tr("Number of cylinders of a VR engine.")};
inline constexpr Field included_angle{
    .key = "bank_angle_deg",
    .range = Range::between(0, 180),
    .label = Text::tr("Bank an&gle γ"),
    .symbol = "γ",
    .hint = Text::tr("Angle between the banks, 0 to 180°. Crankpins for even firing are adjusted; "
                     "in a table only the bank angles are scaled.")};
inline constexpr Field layout_offset{
    .key = "offset_mm",
    .label = Text::tr("O&ffset e"),
    .symbol = "e",
    .hint = Text::tr("Distance of the cylinder axes from the crank axis. In a table: the maximum; "
                     "the others are scaled.")};
inline constexpr Field spacing{
    .key = "spacing_mm",
    .range = Range::greater_than(0),
    .label = Text::tr("&Spacing a"),
    .symbol = "a",
    .hint = Text::tr("Distance along the crank between neighbouring crankpins, or throws of a "
                     "V engine. Volkswagen VR5: 63 mm.")};
inline constexpr Field stagger{.key = "stagger_mm",
                               .label = Text::tr("Sta&gger"),
                               .hint = Text::tr("Distance along the crank from bank 1's to bank "
                                                "2's cylinder of a throw. 0 for forked rods.")};
inline constexpr Field first_position{
    .key = "first_position_mm",
    .label = Text::tr("&Position of cylinder 1"),
    .symbol = "z",
    .hint = Text::tr("Axial position z of cylinder 1. Volkswagen VR5: 3 a + l = 204.8 mm, with "
                     "the centre of mass at z = 0."),
    .if_empty = Text::tr("z = 0 in the middle")};

// Of the object "rod".
inline constexpr Field rod{
    .key = "rod",
    .label = Text::tr("Rod as a rigid body"),
    .hint = Text::tr("The rod as a rigid body; otherwise its shares are in the masses.")};
inline constexpr Field rod_mass{.key = "mass_kg",
                                .range = Range::at_least(0),
                                .label = Text::tr("Rod &mass"),
                                .hint = Text::tr("Whole rod")};
inline constexpr Field rod_centre{
    .key = "centre_from_big_end_mm",
    .label = Text::tr("Centre from &big end"),
    .hint = Text::tr("Centre of mass, from the big end towards the small end")};
inline constexpr Field rod_inertia{.key = "inertia_kg_m2",
                                   .range = Range::at_least(0),
                                   .label = Text::tr("&Inertia"),
                                   .hint = Text::tr("Moment of inertia about the centre of mass")};

// Of each entry of "balance_shafts", and the orders that they are designed for.
inline constexpr Word bases[] = {{"exact", Text::tr("exact orders")},
                                 {"two-term", Text::tr("two-term form")}};
inline constexpr Word directions[] = {{"forward", Text::tr("+kω")}, {"backward", Text::tr("−kω")}};
inline constexpr Word tasks[] = {{"moment", Text::tr("moment")}, {"force", Text::tr("force")}};
inline constexpr Range weight_range = Range::between(1e-3, 1e9);
inline constexpr Field shaft_basis{
    .key = "balance_shaft_basis",
    .label = Text::tr("&Designed for"),
    .hint = Text::tr("The paper designs its shafts by the two-term form; the residual is then the "
                     "error of this form."),
    .words = bases};
inline constexpr Field shafts{
    .key = "balance_shafts",
    .hint = Text::tr("The balance shafts, each made for the order that it cancels.")};
inline constexpr Field shaft_order{
    .key = "order",
    .range = Range::between(1, highest_order),
    .label = Text::tr("Order of the shaft"),
    .symbol = "k",
    .hint =
        Text::tr("Order that the shaft cancels; the shaft turns k times as fast as the crank.")};
inline constexpr Field shaft_direction{.key = "direction",
                                       .label = Text::tr("Direction of the shaft"),
                                       .hint = Text::tr("With the crank (+kω) or against it (−kω)"),
                                       .words = directions};
inline constexpr Field shaft_task{
    .key = "balances",
    .label = Text::tr("Task of the shaft"),
    .hint = Text::tr("Two opposite weights against a moment, one against a force"),
    .words = tasks};
inline constexpr Field weight_distance{
    .key = "weight_distance_mm",
    .range = weight_range,
    .label = Text::tr("Distance of the shaft's weights"),
    .symbol = "L",
    .hint = Text::tr("Distance between the two weights along the shaft")};
inline constexpr Field shaft_position{.key = "axial_position_mm",
                                      .label = Text::tr("Place of the shaft"),
                                      .symbol = "z",
                                      .hint = Text::tr("Axial position of the weight."),
                                      .if_empty = Text::tr("at the reference point of moments"),
                                      .placeholder = Text::tr("c. m.")};
inline constexpr Field weight_radius{
    .key = "weight_radius_mm",
    .range = weight_range,
    .label = Text::tr("Radius of the shaft's weights"),
    .symbol = "ρ",
    .hint = Text::tr("Radius of the weights' centres of mass; gives their mass."),
    .if_empty = Text::tr("only mρ is given")};
inline constexpr Field phase_error{
    .key = "phase_error_deg",
    .range = Range::between(-360, 360),
    .label = Text::tr("Phase of the shaft"),
    .symbol = "δ",
    .hint = Text::tr(
        "Phase error of the shaft, positive ahead in its own direction; 0 for correct timing.")};
inline constexpr Field shaft_enabled{
    .key = "enabled",
    .label = Text::tr("Shaft on"),
    .hint = Text::tr("If on, the shaft is included in the residual.")};

// Of the object "counterweights".
inline constexpr Field end_webs{.key = "counterweights",
                                .hint = Text::tr("The two counterweights on the end webs.")};
inline constexpr Field front_position{.key = "front_position_mm",
                                      .label = Text::tr("&Front web at z"),
                                      .hint = Text::tr("Axial position of the front weight")};
inline constexpr Field rear_position{.key = "rear_position_mm",
                                     .label = Text::tr("R&ear web at z"),
                                     .hint = Text::tr("Axial position of the rear weight")};
inline constexpr Field front_radius{
    .key = "front_radius_mm",
    .range = weight_range,
    .label = Text::tr("Front &radius ρ"),
    .hint = Text::tr("Radius of the front weight's centre of mass")};
inline constexpr Field rear_radius{.key = "rear_radius_mm",
                                   .range = weight_range,
                                   .label = Text::tr("Rear ra&dius ρ"),
                                   .hint = Text::tr("Radius of the rear weight's centre of mass")};
inline constexpr Field first_order_share{
    .key = "first_order_share",
    .range = Range::between(0, 1),
    .label = Text::tr("&Share of forward order 1"),
    .hint = Text::tr("1 cancels the forward half of the reciprocating first order; in a single "
                     "cylinder this is a balance factor of 50 %.")};
inline constexpr Field webs_enabled{
    .key = "enabled", .hint = Text::tr("If on, the counterweights are included in the residual.")};

}  // namespace ravnoves::inertia_moments::field

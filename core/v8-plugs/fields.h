#pragma once

#include <array>

#include "case-file/field.h"
#include "shop/weigh_in.h"
#include "v8-plugs/plug_geometry.h"

/// The inputs of the scene, each described once; the engine's are engine_fields().
namespace ravnoves::v8_plugs {

inline constexpr Word process_words[] = {{"manufacture", CORE_TEXT("V8", "Manufacture")},
                                         {"repair", CORE_TEXT("V8", "Repair")}};
inline constexpr Word crankshaft_words[] = {
    {"standard", CORE_TEXT("V8", "Standard")},
    {"new-plugs", CORE_TEXT("V8", "Made for plugs of the new design")}};
inline constexpr Word numbering_words[] = {{"bank-by-bank", CORE_TEXT("V8", "1+5, 2+6, 3+7, 4+8")},
                                           {"alternating", CORE_TEXT("V8", "1+2, 3+4, 5+6, 7+8")}};
inline constexpr Word source_words[] = {{"typed", CORE_TEXT("V8", "Typed")},
                                        {"weigh-in", CORE_TEXT("V8", "Masses of the parts")}};

namespace field {

inline constexpr Field engine{
    .key = "engine",
    .label = CORE_TEXT("V8", "&Engine"),
    .hint = CORE_TEXT("V8", "Engines of the paper by displacement, then your own."),
    .placeholder = CORE_TEXT("V8", "other")};
inline constexpr Field engine_overrides{
    .key = "engine_overrides",
    .hint = CORE_TEXT("V8", "Values that replace or complete the preset.")};
inline constexpr Field process{
    .key = "process",
    .label = CORE_TEXT("V8", "&Work"),
    .hint = CORE_TEXT("V8", "In manufacture, repair pistons and repair shells are not used."),
    .words = process_words};
inline constexpr Field crankshaft{
    .key = "crankshaft",
    .label = CORE_TEXT("V8", "Cran&kshaft"),
    .hint = CORE_TEXT("V8", "Plugs for which the counterweights of the crankshaft were made."),
    .words = crankshaft_words};
inline constexpr Field mass_changes{
    .key = "mass_changes_g",
    .hint = CORE_TEXT("V8", "Mass of the parts minus nominal; negative if lighter.")};
inline constexpr Field changes_source{
    .key = "mass_changes_from",
    .label = CORE_TEXT("V8", "Source of the mass changes"),
    .hint = CORE_TEXT("V8",
                      "Source of the changes: weighed masses, or the changes typed on the sheet."),
    .words = source_words};
inline constexpr Field tolerance{
    .key = "tolerance_g_mm",
    .range = Range::between(0, 1e6),
    .label = CORE_TEXT("V8", "Permissible residu&al unbalance"),
    .hint = CORE_TEXT("V8",
                      "Limit in each correction plane. Nazarov's experiments left 5 g·mm; a repair "
                      "manual may allow much more (2 oz·in is 1440 g·mm).")};

// ------------------------------------------------------------------------- weigh-in sheet
using shop::field::nominal;
using shop::field::permitted_spread;
using shop::field::weigh_in;
inline constexpr Field numbering{
    .key = "cylinder_numbering",
    .label = CORE_TEXT("V8", "C&ylinders of a crankpin"),
    .hint = CORE_TEXT("V8", "The two cylinders that share a crankpin."),
    .words = numbering_words};
inline constexpr Field part_mass{
    .key = "mass_g", .range = nominal.range, .hint = CORE_TEXT("V8", "Eight masses, by cylinder.")};

// ----------------------------------------------------------------------------------- plug
inline constexpr Field plug{.key = "plug", .hint = CORE_TEXT("V8", "Sizes of the plug.")};
inline constexpr Field thread{
    .key = "thread",
    .label = CORE_TEXT("V8", "&Thread"),
    .hint = CORE_TEXT("V8", "Metric thread with its pitch, like M22x1.5."),
    .placeholder = {"", "M22x1.5"}};
inline constexpr Field plug_height{.key = "height_mm",
                                   .range = Range::between(0.1, 200),
                                   .label = CORE_TEXT("V8", "&Height h"),
                                   .hint = CORE_TEXT("V8", "Height of the whole plug.")};
inline constexpr Field bore_diameter{.key = "bore_diameter_mm",
                                     .range = Range::between(0, 200),
                                     .label = CORE_TEXT("V8", "&Bore diameter"),
                                     .hint = CORE_TEXT("V8", "Diameter of the present bore."),
                                     .if_empty = CORE_TEXT("V8", "a solid plug")};
inline constexpr Field bore_depth{.key = "bore_depth_mm",
                                  .range = Range::between(0, 200),
                                  .label = CORE_TEXT("V8", "Bore de&pth"),
                                  .hint = CORE_TEXT("V8", "Depth from the outer face."),
                                  .if_empty = CORE_TEXT("V8", "a solid plug")};
inline constexpr Field cutter_diameter{.key = "cutter_diameter_mm",
                                       .range = Range::between(0.1, 200),
                                       .label = CORE_TEXT("V8", "&Cutter diameter"),
                                       .if_empty = CORE_TEXT("V8", "no boring is planned")};
inline constexpr Field minimum_wall{
    .key = "minimum_wall_mm",
    .range = Range::between(0, 100),
    .label = CORE_TEXT("V8", "Minimum &wall"),
    .hint = CORE_TEXT("V8", "Minimum between the bore and the root of the thread."),
    .if_empty = CORE_TEXT("V8", "no limit")};
inline constexpr Field minimum_bottom{
    .key = "minimum_bottom_mm",
    .range = Range::between(0, 100),
    .label = CORE_TEXT("V8", "Minimum b&ottom"),
    .hint = CORE_TEXT("V8", "Minimum between the bore and the inner face."),
    .if_empty = CORE_TEXT("V8", "no limit")};
inline constexpr Field steel_density{.key = "steel_density_kg_m3",
                                     .range = Range::between(1000, 25000),
                                     .label = CORE_TEXT("V8", "&Steel"),
                                     .hint = CORE_TEXT("V8", "Carbon steel 7850 kg/m³.")};
inline constexpr Field aluminium_density{
    .key = "aluminium_density_kg_m3",
    .range = Range::between(1000, 25000),
    .label = CORE_TEXT("V8", "&Aluminium"),
    .hint = CORE_TEXT("V8", "Wrought alloys 2640 to 2850 kg/m³.")};

}  // namespace field
}  // namespace ravnoves::v8_plugs

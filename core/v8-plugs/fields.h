#pragma once

#include <array>

#include "case-file/field.h"
#include "shop/weigh_in.h"
#include "v8-plugs/plug_geometry.h"

/// The inputs of the scene, each described once; the engine's are engine_fields().
namespace ravnoves::v8_plugs {

inline constexpr Word process_words[] = {{"manufacture", Text::tr("Manufacture")},
                                         {"repair", Text::tr("Repair")}};
inline constexpr Word crankshaft_words[] = {
    {"standard", Text::tr("Standard")},
    {"new-plugs", Text::tr("Made for plugs of the new design")}};
inline constexpr Word source_words[] = {{"typed", Text::tr("Typed")},
                                        {"weigh-in", Text::tr("Masses of the parts")}};

namespace field {

inline constexpr Field engine{.key = "engine",
                              .label = Text::tr("&Engine"),
                              .hint = Text::tr("Engines of the paper by displacement."),
                              .placeholder = Text::tr("other")};
inline constexpr Field engine_overrides{
    .key = "engine_overrides", .hint = Text::tr("Values that replace or complete the preset.")};
inline constexpr Field process{
    .key = "process",
    .label = Text::tr("&Work"),
    .hint = Text::tr("In manufacture, repair pistons and repair shells are not used."),
    .words = process_words};
inline constexpr Field crankshaft{
    .key = "crankshaft",
    .label = Text::tr("Cran&kshaft"),
    .hint = Text::tr("Plugs for which the counterweights of the crankshaft were made."),
    .words = crankshaft_words};
inline constexpr Field mass_changes{
    .key = "mass_changes_g",
    .hint = Text::tr("Mass of the parts minus nominal; negative if lighter.")};
inline constexpr Field changes_source{
    .key = "mass_changes_from",
    .label = Text::tr("Source of the mass changes"),
    .hint = Text::tr("Source of the changes: weighed masses, or the changes typed on the sheet."),
    .words = source_words};
inline constexpr Field tolerance{
    .key = "tolerance_g_mm",
    .range = Range::between(0, 1e6),
    .label = Text::tr("Permissible residu&al unbalance"),
    .hint = Text::tr("Limit in each correction plane. Nazarov's experiments left 5 g·mm; a repair "
                     "manual may allow much more (2 oz·in is 1440 g·mm).")};

// ----------------------------------------------------------------------------------- plug
inline constexpr Field plug{.key = "plug", .hint = Text::tr("Sizes of the plug.")};
inline constexpr Field thread{.key = "thread",
                              .label = Text::tr("&Thread"),
                              .hint = Text::tr("Metric thread with its pitch, like M22x1.5."),
                              .placeholder = {"M22x1.5"}};
inline constexpr Field plug_height{.key = "height_mm",
                                   .range = Range::between(0.1, 200),
                                   .label = Text::tr("&Height h"),
                                   .hint = Text::tr("Height of the whole plug.")};
inline constexpr Field bore_diameter{.key = "bore_diameter_mm",
                                     .range = Range::between(0, 200),
                                     .label = Text::tr("&Bore diameter"),
                                     .hint = Text::tr("Diameter of the present bore."),
                                     .if_empty = Text::tr("a solid plug")};
inline constexpr Field bore_depth{.key = "bore_depth_mm",
                                  .range = Range::between(0, 200),
                                  .label = Text::tr("Bore de&pth"),
                                  .hint = Text::tr("Depth from the outer face."),
                                  .if_empty = Text::tr("a solid plug")};
inline constexpr Field cutter_diameter{.key = "cutter_diameter_mm",
                                       .range = Range::between(0.1, 200),
                                       .label = Text::tr("&Cutter diameter"),
                                       .if_empty = Text::tr("no boring is planned")};
inline constexpr Field minimum_wall{
    .key = "minimum_wall_mm",
    .range = Range::between(0, 100),
    .label = Text::tr("Minimum &wall"),
    .hint = Text::tr("Minimum between the bore and the root of the thread."),
    .if_empty = Text::tr("no limit")};
inline constexpr Field minimum_bottom{
    .key = "minimum_bottom_mm",
    .range = Range::between(0, 100),
    .label = Text::tr("Minimum b&ottom"),
    .hint = Text::tr("Minimum between the bore and the inner face."),
    .if_empty = Text::tr("no limit")};
inline constexpr Field steel_density{.key = "steel_density_kg_m3",
                                     .range = Range::between(1000, 25000),
                                     .label = Text::tr("&Steel"),
                                     .hint = Text::tr("Carbon steel 7850 kg/m³.")};
inline constexpr Field aluminium_density{.key = "aluminium_density_kg_m3",
                                         .range = Range::between(1000, 25000),
                                         .label = Text::tr("&Aluminium"),
                                         .hint = Text::tr("Wrought alloys 2640 to 2850 kg/m³.")};

}  // namespace field
}  // namespace ravnoves::v8_plugs

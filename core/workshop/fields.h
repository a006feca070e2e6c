#pragma once

#include "case-file/field.h"

/// The inputs of a job that the scenes bob-weights and v8-plugs do not have.
namespace ravnoves::workshop {

inline constexpr Word counts_words[] = {
    {"clockwise", CORE_TEXT("workshop", "Clockwise")},
    {"counter-clockwise", CORE_TEXT("workshop", "Counter-clockwise")}};
inline constexpr Word shows_words[] = {{"heavy", CORE_TEXT("workshop", "Heavy spot")},
                                       {"light", CORE_TEXT("workshop", "Light spot")}};

namespace field {

inline constexpr Field plugs{
    .key = "plugs",
    .hint = CORE_TEXT("workshop",
                      "Sludge-trap plugs of a V-8, as in the module v8-plugs, without its "
                      "weigh-in, balancing and job.")};
inline constexpr Field machine{.key = "machine",
                               .hint = CORE_TEXT("workshop", "Settings of the balancing machine.")};
inline constexpr Field plane_names{
    .key = "planes",
    .label = CORE_TEXT("workshop", "Names of the planes"),
    .hint = CORE_TEXT("workshop", "Two names, as “front” and “rear” or “left” and “right”.")};
inline constexpr Field counts{
    .key = "counts",
    .label = CORE_TEXT("workshop", "Degrees count"),
    .hint = CORE_TEXT("workshop", "Direction seen from the front of the crankshaft."),
    .words = counts_words};
inline constexpr Field shows{
    .key = "shows",
    .label = CORE_TEXT("workshop", "Machine shows"),
    .hint = CORE_TEXT("workshop",
                      "Spot shown by the machine; holes are always planned at the heavy spot."),
    .words = shows_words};
inline constexpr Field zero{.key = "zero",
                            .label = CORE_TEXT("workshop", "Zero mark"),
                            .hint = CORE_TEXT("workshop", "Place of 0° on the crankshaft.")};

}  // namespace field
}  // namespace ravnoves::workshop

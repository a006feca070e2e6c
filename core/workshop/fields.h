#pragma once

#include "bob-weights/fields.h"

/// The inputs of a job that the scenes bob-weights and v8-plugs do not have.
namespace ravnoves::workshop {

inline constexpr Word counts_words[] = {{"clockwise", Text::tr("Clockwise")},
                                        {"counter-clockwise", Text::tr("Counter-clockwise")}};
inline constexpr Word shows_words[] = {{"heavy", Text::tr("Heavy spot")},
                                       {"light", Text::tr("Light spot")}};

namespace field {

using namespace bob_weights::field;

inline constexpr Field plugs{
    .key = "plugs",
    .hint = Text::tr("Sludge-trap plugs of a V-8, as in the module v8-plugs, without its "
                     "weigh-in, balancing and job.")};
inline constexpr Field machine{.key = "machine",
                               .hint = Text::tr("Settings of the balancing machine.")};
inline constexpr Field plane_names{
    .key = "planes",
    .label = Text::tr("Names of the planes"),
    .hint = Text::tr("Two names, as “front” and “rear” or “left” and “right”.")};
inline constexpr Field counts{.key = "counts",
                              .label = Text::tr("Degrees count"),
                              .hint = Text::tr("Direction seen from the front of the crankshaft."),
                              .words = counts_words};
inline constexpr Field shows{
    .key = "shows",
    .label = Text::tr("Machine shows"),
    .hint = Text::tr("Spot shown by the machine; holes are always planned at the heavy spot."),
    .words = shows_words};
inline constexpr Field zero{.key = "zero",
                            .label = Text::tr("Zero mark"),
                            .hint = Text::tr("Place of 0° on the crankshaft.")};

}  // namespace field
}  // namespace ravnoves::workshop

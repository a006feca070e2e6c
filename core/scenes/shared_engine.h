#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "case-file/json_fwd.h"
#include "case-file/message.h"

namespace ravnoves {

/// What the engines of cases of several scenes share, SI; none of what a case does not give.
struct SharedEngine {
    std::optional<double> bore = {};
    std::optional<double> crank_radius = {};
    std::optional<double> rod_length = {};
    std::optional<double> offset = {};
    std::optional<double> speed = {};
    std::optional<double> reciprocating_mass = {};
    std::optional<double> rotating_mass = {};  ///< of one cylinder, at the crankpin

    friend bool operator==(const SharedEngine&, const SharedEngine&) = default;
};

/// Of the "input" object of a scene.
SharedEngine engine_of(std::string_view scene, const Json& input);

/// What give_engine() has done.
struct GivenEngine {
    std::vector<Text> changed{};
    std::vector<Text> kept{};  ///< what the input has otherwise, or the engine does not give
};

/// Changes an "input" object of a scene so that it has the same engine, as far as it has a place
/// for it. A mass given in parts becomes their sum where that is another.
GivenEngine give_engine(const SharedEngine& engine, std::string_view scene, Json& input);

}  // namespace ravnoves

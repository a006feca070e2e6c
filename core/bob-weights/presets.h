#pragma once

#include <span>

#include "bob-weights/input.h"
#include "case-file/message.h"

namespace ravnoves::bob_weights {

/// An engine to begin with; its masses are to be weighed.
struct Preset {
    Text name;
    Engine engine;
};
std::span<const Preset> presets();

}  // namespace ravnoves::bob_weights

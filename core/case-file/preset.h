#pragma once

#include "case-file/message.h"

namespace ravnoves {

/// A case to begin with. A scene's presets() are these, its default first.
template <typename Input>
struct Preset {
    Message title;
    Input input;
};

}  // namespace ravnoves

#pragma once

#include <cstddef>

#include "case-file/input_error.h"

namespace ravnoves {

inline constexpr std::size_t largest_text = 64U << 20U;  ///< that is read, bytes

inline constexpr Text too_large = Text::tr("must be at most 64 MiB");
inline constexpr Text not_a_file = Text::tr("must be a file, not a pipe or a device");

/// @throws InputError for a text that is not read again
inline void check_text_size(std::size_t bytes) {
    if (bytes > largest_text) {
        throw InputError("", too_large);
    }
}

}  // namespace ravnoves

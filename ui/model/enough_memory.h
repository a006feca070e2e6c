#pragma once

#include <new>

#include "case-file/input_error.h"

namespace ravnoves {

/// What the work returns. @throws InputError where it runs out of memory
template <typename Work>
auto withinMemory(const Work& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw InputError("/input", Text::tr("needs more memory than available"));
    }
}

}  // namespace ravnoves

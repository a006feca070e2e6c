#pragma once

#include <cstddef>
#include <functional>

namespace ravnoves {

/// Bytes of a text that is read faster than a thread begins and the window paints.
inline constexpr std::size_t longestReadAtOnce = 500'000;

/// Runs work in a thread of its own and returns when it is done. The window lives meanwhile, but
/// takes neither keys nor mouse. What the work throws is thrown here.
void runBeside(const std::function<void()>& work);

}  // namespace ravnoves

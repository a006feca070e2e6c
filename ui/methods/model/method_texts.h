#pragma once

#include <span>

namespace ravnoves {

/// The texts of core that the page shows, marked for the translators: core itself knows no
/// languages. Numbers in them stand as %1, %2, … where a text is made with numbers.
std::span<const char* const> methodTexts();
/// The same for the words of the validation report.
std::span<const char* const> validationTexts();

}  // namespace ravnoves

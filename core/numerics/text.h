#pragma once

namespace ravnoves {

/// A text for the user, written once: in English. `%1`, `%2` … are places of values.
struct Text {
    const char* english = "";

    /// Marks a text for translation: lupdate extracts it.
    static constexpr Text tr(const char* english) { return {english}; }

    constexpr bool empty() const { return *english == '\0'; }
};

}  // namespace ravnoves

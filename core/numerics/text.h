#pragma once

namespace ravnoves {

/// A text for the user, written once: in English, with the context in which translators see it.
/// `%1`, `%2` … are places of values.
struct Text {
    const char* context = "";
    const char* english = "";

    constexpr bool empty() const { return *english == '\0'; }
};

/// Marks a text for translation; lupdate extracts it (as it does QT_TRANSLATE_NOOP). The context is
/// the scene's word, or "core" for what scenes share.
#define CORE_TEXT(context, english) \
    ::ravnoves::Text {              \
        context, english            \
    }

}  // namespace ravnoves

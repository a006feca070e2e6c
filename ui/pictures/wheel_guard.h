#pragma once

#include <Qt>

namespace ravnoves {

/// How the focus came: the user went to the widget, it comes back to where it was, or neither.
enum class FocusWay { went, back, other };
FocusWay focusWay(Qt::FocusReason reason);

/// Lets the wheel change a number or a slider only where the user focused it, by a click, a key or
/// its letter, and never a closed list; elsewhere the page below scrolls. Once for the whole
/// program; further calls have no effect.
void guardWheel();

}  // namespace ravnoves

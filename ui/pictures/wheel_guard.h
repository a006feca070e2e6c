#pragma once

#include <Qt>

namespace ravnoves {

/// How the focus came: the user went to the widget, it comes back to where it was, or neither.
enum class FocusWay { went, back, other };
FocusWay focusWay(Qt::FocusReason reason);

/// From now on the wheel changes a number or a slider only where the user went to it, by a click, a
/// key or its letter, and it has the focus, and never a list that is closed; elsewhere what lies
/// below scrolls. Once for the whole program; further calls do nothing.
void guardWheel();

}  // namespace ravnoves

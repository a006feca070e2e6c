#pragma once

class QWidget;

namespace ravnoves {

/// Lets the wheel change a number or a slider only where the user focused it, by a click, a key or
/// its letter, and never a closed list; elsewhere the page below scrolls. Once for the whole
/// program; further calls have no effect.
void guardWheel();

/// The user went to this widget, as the guard knows, and it has the focus.
bool isWheelOf(const QWidget* widget);

}  // namespace ravnoves

#pragma once

namespace ravnoves {

/// From now on the wheel changes a number, a choice or a slider only where the user went to it, by
/// a click, a key or its letter, and it has the focus; elsewhere what lies below scrolls. Once for
/// the whole program; further calls do nothing.
void guardWheel();

}  // namespace ravnoves

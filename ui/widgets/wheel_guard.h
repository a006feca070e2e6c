#pragma once

namespace ravnoves {

/// From now on the wheel changes a number, a choice or a slider only where it has the focus;
/// elsewhere what lies below scrolls. Once for the whole program; further calls do nothing.
void guardWheel();

}  // namespace ravnoves

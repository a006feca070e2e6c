#pragma once

namespace ravnoves {

/// From now on the tip of a table's cell or heading, of a choice, of an entry of a legend or of a
/// plot's title begins with its whole text where there is too little room for that, and that of a
/// field with the whole number where it shows fewer digits. Once for the whole program; further
/// calls do nothing.
void showElidedTips();

}  // namespace ravnoves

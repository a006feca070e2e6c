#pragma once

namespace ravnoves {

/// From now on a label, a message box and a tip write their text as it is, unless they are told
/// that it is rich: numbers, names and paths come from files, and what looks like HTML there would
/// load pictures and hide the rest. A tip's line that is longer than 80 letters wraps. Once for the
/// whole program; further calls do nothing.
void keepTextPlain();

}  // namespace ravnoves

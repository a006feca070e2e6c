#pragma once

namespace ravnoves {

/// From now on a screen reader that asks a PlotView for its description gets its sentence, made
/// then and not at every frame.
void makePlotsAccessible();

}  // namespace ravnoves

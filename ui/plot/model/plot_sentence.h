#pragma once

#include <QString>

#include "plot/model/plot_data.h"

namespace ravnoves {

/// A plot as text, curve by curve: its extremes and their places, or its trend where it only rises
/// or falls: "Over φ from 0 to 720 °. Mᵤₚ: from −512 at 372 to 551 N·m at 12; …".
QString plotSentence(const PlotData& data);

}  // namespace ravnoves

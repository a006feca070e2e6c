#pragma once

#include <vector>

#include "balance-shaft/clearance.h"
#include "plot/model/plot_data.h"

namespace ravnoves {

/// Shades the angles of the shaft, 0 to 360°, that cannot be built.
/// @param orientation  Qt::Horizontal where α runs along x
std::vector<plot::Band> unbuildableBands(const balance_shaft::BuildableAngles& buildable,
                                             Qt::Orientation orientation = Qt::Horizontal);

}  // namespace ravnoves

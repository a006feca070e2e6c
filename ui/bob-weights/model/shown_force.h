#pragma once

#include <optional>

#include "bob-weights/result.h"

// What the plot of the first-order force shows of a result, in the units of its axes.
namespace ravnoves {

/// The ellipses that the force runs round in a turn, in grams at the crank radius.
struct ShownForce {
    bob_weights::ForcePath bare;  ///< without counterweights
    bob_weights::ForcePath left;  ///< with those that hold the bob weight
    double reach = 0.0;           ///< of both axes: holds both ellipses, with room around
};
/// Nothing while the force is not known.
std::optional<ShownForce> shownForce(const bob_weights::Result& result);

/// The reach to show after another one: that one while the masses change a little.
double steadyReach(double reach, double shown);

}  // namespace ravnoves

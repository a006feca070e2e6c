#pragma once

#include "bob-weights/input.h"
#include "bob-weights/result.h"
#include "shop/matching.h"

namespace ravnoves::bob_weights {

/// The crankshaft of the engine; its angles are the weigh-in sheet's, else the usual ones: in line
/// 1, 3 to 6; V with two rods on a bob weight, and boxer, of 1 (not in line), 3, 5 or 6 throws as
/// in line, cross-plane of 4, 180° of 2. Empty for others.
shop::Crank crank_of(const Input& input);

/// How often the parts count that are weighed whole.
/// @param factor  of the reciprocating mass, overbalance included
shop::PartFactors weighed_factors(const Input& input, double factor);
/// Places the weighed parts, and where the bob weight is known gives each crankpin its own.
void place_parts(const Input& input, const shop::PartFactors& factors, Result& result);

}  // namespace ravnoves::bob_weights

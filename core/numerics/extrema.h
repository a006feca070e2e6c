#pragma once

#include <boost/container/static_vector.hpp>

#include "numerics/periodic_piecewise.h"

namespace ravnoves {

/// Up to 12 places on an interval, ascending.
using Places = boost::container::static_vector<double, 12>;

/// The places in (0, h) where the slope of p(t) + A sin(ωt + φ₀) changes sign, p cubic, to
/// machine accuracy and none left out: the third derivative's zeros are known in closed form,
/// between them the second is monotone, and between the second's zeros the first is.
/// @param h  0 ≤ ωh ≤ 2π, so that there are at most 12 places at each level
Places stationary_points(const PiecewiseCubic& p, double amplitude, double angular_frequency,
                         double phase, double h);

}  // namespace ravnoves

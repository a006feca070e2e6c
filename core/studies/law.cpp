#include "studies/law.h"

#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

namespace ravnoves::studies {

double Law::at(double u) const {
    if (!normal) {
        return low + (high - low) * u;
    }
    using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
    return mean - deviation * std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * u, Policy());
}

Law law_of(const Varied& varied, double nominal) {
    using Spread = Varied::Spread;
    Law law;
    if (varied.spread == Spread::normal) {
        const double size = varied.size;
        return {true, nominal, size, nominal - 3.0 * size, nominal + 3.0 * size};
    }
    law.low = varied.from;
    law.high = varied.to;
    if (varied.spread == Spread::plus_minus || varied.spread == Spread::plus_minus_percent) {
        const bool percent = varied.spread == Spread::plus_minus_percent;
        const double half = percent ? std::abs(nominal) * varied.size / 100.0 : varied.size;
        law.low = nominal - half;
        law.high = nominal + half;
    }
    const double width = law.high - law.low;
    law.mean = law.low + 0.5 * width;
    law.deviation = width / std::sqrt(12.0);
    return law;
}

}  // namespace ravnoves::studies

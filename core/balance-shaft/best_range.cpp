#include "balance-shaft/best_range.h"

#include <cmath>

#include "numerics/real50.h"

namespace ravnoves::balance_shaft {

template <typename Scalar>
Cut<Scalar> range_cut(const BasicCycleExtrema<Scalar>& extrema, const Scalar& alpha) {
    using std::cos;
    using std::sin;
    const Scalar& degree = boost::math::constants::degree<Scalar>();
    const BasicExtrema<Scalar> found = extrema(alpha);
    const Scalar amplitude = extrema.amplitude();
    const Scalar high = found.max.angle_deg * degree;
    const Scalar low = found.min.angle_deg * degree;
    Cut<Scalar> cut{alpha, found.max.value - found.min.value, {}};
    cut.bound.p = amplitude * (sin(high) - sin(low));
    cut.bound.q = amplitude * (cos(high) - cos(low));
    cut.bound.constant = cut.value - cut.bound.p * cos(alpha) - cut.bound.q * sin(alpha);
    return cut;
}

template <typename Scalar>
BasicBestRange<Scalar> minimise_range(const BasicCycleExtrema<Scalar>& extrema,
                                      const std::vector<AngleStretch>& within) {
    // |dR/dα| ≤ 2A.
    const auto best =
        minimise_over_angle<Scalar>([&](const Scalar& alpha) { return range_cut(extrema, alpha); },
                                    Scalar(2 * extrema.amplitude()), extrema.amplitude(), within);
    return {best.alpha, best.value, best.worst, best.gap, best.evaluations};
}

template Cut<double> range_cut(const BasicCycleExtrema<double>&, const double&);
template BasicBestRange<double> minimise_range(const BasicCycleExtrema<double>&,
                                               const std::vector<AngleStretch>&);
template BasicBestRange<Real50> minimise_range(const BasicCycleExtrema<Real50>&,
                                               const std::vector<AngleStretch>&);

}  // namespace ravnoves::balance_shaft

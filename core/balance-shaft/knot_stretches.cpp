#include "balance-shaft/knot_stretches.h"

#include <algorithm>
#include <cmath>

#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

KnotStretches::KnotStretches(std::span<const double> knots) {
    if (knots.size() <= few) {
        return;
    }
    const auto count = static_cast<Eigen::Index>(knots.size());
    stretches_.reserve(knots.size() / static_cast<std::size_t>(length) + 1);
    for (Eigen::Index first = 0; first < count; first += length) {
        const Eigen::Index knots_here = std::min(length, count - first);
        const double from = knots[static_cast<std::size_t>(first)];
        const double to = knots[static_cast<std::size_t>(first + knots_here - 1)];
        const double middle = from + (to - from) / 2.0;
        const double half = (to - from) / 2.0;
        const bool wide = half >= pi / 2.0;
        stretches_.push_back({std::cos(middle), std::sin(middle), wide ? -1.0 : std::cos(half),
                              wide ? 1.0 : std::sin(half), first, knots_here});
    }
}

KnotStretches::Bounds KnotStretches::sine(std::size_t stretch, double a, double b) const {
    // From the middle it is even cos t + odd sin t.
    const Stretch& here = stretches_[stretch];
    const double even = a * here.cos + b * here.sin;
    const double off = std::abs(b * here.cos - a * here.sin) * here.sin_half;
    const double far = even * here.cos_half;
    return {std::min(even, far) - off, std::max(even, far) + off};
}

std::vector<double> KnotStretches::greatest(const Eigen::ArrayXd& values) const {
    std::vector<double> found;
    found.reserve(size());
    for (const Stretch& here : stretches_) {
        found.push_back(values.segment(here.first, here.count).maxCoeff());
    }
    return found;
}

std::vector<double> KnotStretches::least(const Eigen::ArrayXd& values) const {
    std::vector<double> found;
    found.reserve(size());
    for (const Stretch& here : stretches_) {
        found.push_back(values.segment(here.first, here.count).minCoeff());
    }
    return found;
}

}  // namespace ravnoves::balance_shaft

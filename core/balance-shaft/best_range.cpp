#include "balance-shaft/best_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "numerics/real50.h"

namespace ravnoves::balance_shaft {

namespace {

/// constant + p cos α + q sin α
template <typename Scalar>
struct Sinusoid {
    Scalar constant = Scalar(0);
    Scalar p = Scalar(0);
    Scalar q = Scalar(0);

    Scalar operator()(const Scalar& alpha) const {
        using std::cos;
        using std::sin;
        return constant + p * cos(alpha) + q * sin(alpha);
    }
};

/// An evaluated angle with its lower bound of the range everywhere.
template <typename Scalar>
struct Cut {
    Scalar alpha = Scalar(0);
    Scalar range = Scalar(0);
    Sinusoid<Scalar> bound;
};

template <typename Scalar>
struct Bound {
    Scalar alpha = Scalar(0);
    Scalar value = Scalar(0);
};

template <typename Scalar>
Cut<Scalar> evaluate(const BasicCycleExtrema<Scalar>& extrema, const Scalar& alpha) {
    using std::cos;
    using std::sin;
    const Scalar degree = boost::math::constants::degree<Scalar>();
    const BasicExtrema<Scalar> found = extrema(alpha);
    const Scalar amplitude = extrema.amplitude();
    const Scalar high = found.max.angle_deg * degree;
    const Scalar low = found.min.angle_deg * degree;
    Cut<Scalar> cut{alpha, found.max.value - found.min.value, {}};
    cut.bound.p = amplitude * (sin(high) - sin(low));
    cut.bound.q = amplitude * (cos(high) - cos(low));
    cut.bound.constant = cut.range - cut.bound.p * cos(alpha) - cut.bound.q * sin(alpha);
    return cut;
}

/// Minimum of the larger of two sinusoids between their angles: at an end, at a sinusoid's own
/// minimum or where they cross.
template <typename Scalar>
Bound<Scalar> least_of_larger(const Cut<Scalar>& left, const Cut<Scalar>& right) {
    using std::abs;
    using std::acos;
    using std::atan2;
    using std::sqrt;
    const Scalar pi = boost::math::constants::pi<Scalar>();
    const Scalar two_pi = boost::math::constants::two_pi<Scalar>();
    const auto larger = [&](const Scalar& alpha) {
        return std::max(left.bound(alpha), right.bound(alpha));
    };
    Bound<Scalar> best{left.alpha, larger(left.alpha)};
    const auto consider = [&](Scalar alpha) {
        while (alpha < left.alpha) {  // at most a few turns
            alpha += two_pi;
        }
        while (alpha >= left.alpha + two_pi) {
            alpha -= two_pi;
        }
        if (alpha < right.alpha) {
            const Scalar value = larger(alpha);
            if (value < best.value) {
                best = {alpha, value};
            }
        }
    };
    consider(atan2(left.bound.q, left.bound.p) + pi);
    consider(atan2(right.bound.q, right.bound.p) + pi);
    const Scalar p = left.bound.p - right.bound.p;
    const Scalar q = left.bound.q - right.bound.q;
    const Scalar amplitude = sqrt(Scalar(p * p + q * q));
    const Scalar constant = left.bound.constant - right.bound.constant;
    if (abs(constant) < amplitude) {
        const Scalar middle = atan2(q, p);
        const Scalar spread = acos(-constant / amplitude);
        consider(middle + spread);
        consider(middle - spread);
    }
    const Scalar value = larger(right.alpha);
    if (value < best.value) {
        best = {right.alpha, value};
    }
    return best;
}

}  // namespace

template <typename Scalar>
BasicBestRange<Scalar> minimise_range(const BasicCycleExtrema<Scalar>& extrema) {
    const Scalar two_pi = boost::math::constants::two_pi<Scalar>();
    constexpr int first_angles = 36;
    BasicBestRange<Scalar> best;
    std::vector<Cut<Scalar>> cuts;
    cuts.reserve(first_angles + 1);
    for (int i = 0; i < first_angles; ++i) {
        cuts.push_back(evaluate(extrema, Scalar(two_pi * i / first_angles)));
    }
    best.evaluations = first_angles;
    const auto by_range = [](const Cut<Scalar>& a, const Cut<Scalar>& b) {
        return a.range < b.range;
    };
    const auto [least, worst] = std::minmax_element(cuts.begin(), cuts.end(), by_range);
    best.shaft_angle = least->alpha;
    best.range = least->range;
    best.worst = worst->range;
    cuts.push_back(cuts.front());
    cuts.back().alpha = two_pi;

    // Bounds closer than this are rounding.
    const Scalar rounding = 450 * std::numeric_limits<Scalar>::epsilon();
    const Scalar tolerance = rounding * (best.worst + extrema.amplitude());
    constexpr int most_evaluations = 20'000;
    std::vector<std::array<Cut<Scalar>, 2>> open;
    for (std::size_t i = first_angles; i-- > 0;) {
        open.push_back({cuts[i], cuts[i + 1]});
    }
    while (!open.empty()) {
        const std::array<Cut<Scalar>, 2> interval = open.back();
        open.pop_back();
        // A cheap bound first: |dR/dα| ≤ 2A.
        const Scalar width = interval[1].alpha - interval[0].alpha;
        if ((interval[0].range + interval[1].range) / 2 - extrema.amplitude() * width >=
            best.range) {
            continue;
        }
        Bound<Scalar> bound = least_of_larger(interval[0], interval[1]);
        if (bound.value >= best.range - tolerance) {
            continue;
        }
        if (best.evaluations >= most_evaluations || width < rounding) {
            best.gap = std::max(best.gap, Scalar(best.range - bound.value));
            continue;
        }
        // A split at an end would not end; there the bound touches R, up to rounding.
        if (bound.alpha <= interval[0].alpha || bound.alpha >= interval[1].alpha) {
            bound.alpha = interval[0].alpha + width / 2;
        }
        const Cut<Scalar> cut = evaluate(extrema, bound.alpha);
        ++best.evaluations;
        best.worst = std::max(best.worst, cut.range);
        if (cut.range < best.range) {
            best.range = cut.range;
            best.shaft_angle = cut.alpha;
        }
        open.push_back({cut, interval[1]});
        open.push_back({interval[0], cut});
    }
    if (best.shaft_angle >= two_pi) {
        best.shaft_angle -= two_pi;
    }
    return best;
}

template BasicBestRange<double> minimise_range(const BasicCycleExtrema<double>&);
template BasicBestRange<Real50> minimise_range(const BasicCycleExtrema<Real50>&);

}  // namespace ravnoves::balance_shaft

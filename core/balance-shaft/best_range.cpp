#include "balance-shaft/best_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

namespace {

/// constant + p cos α + q sin α
struct Sinusoid {
    double constant = 0.0;
    double p = 0.0;
    double q = 0.0;

    double operator()(double alpha) const {
        return constant + p * std::cos(alpha) + q * std::sin(alpha);
    }
};

/// An evaluated angle with its lower bound of the range everywhere.
struct Cut {
    double alpha = 0.0;
    double range = 0.0;
    Sinusoid bound;
};

struct Bound {
    double alpha = 0.0;
    double value = 0.0;
};

Cut evaluate(const CycleExtrema& extrema, double alpha) {
    const Extrema found = extrema(alpha);
    const double amplitude = extrema.amplitude();
    const double high = found.max.angle_deg * degree;
    const double low = found.min.angle_deg * degree;
    Cut cut{alpha, found.max.value - found.min.value, {}};
    cut.bound.p = amplitude * (std::sin(high) - std::sin(low));
    cut.bound.q = amplitude * (std::cos(high) - std::cos(low));
    cut.bound.constant = cut.range - cut.bound.p * std::cos(alpha) - cut.bound.q * std::sin(alpha);
    return cut;
}

/// Minimum of the larger of two sinusoids between their angles: at an end, at a sinusoid's own
/// minimum or where they cross.
Bound least_of_larger(const Cut& left, const Cut& right) {
    const auto larger = [&](double alpha) {
        return std::max(left.bound(alpha), right.bound(alpha));
    };
    Bound best{left.alpha, larger(left.alpha)};
    const auto consider = [&](double alpha) {
        alpha = left.alpha + std::remainder(alpha - left.alpha, two_pi);
        if (alpha < left.alpha) {
            alpha += two_pi;
        }
        if (alpha < right.alpha) {
            const double value = larger(alpha);
            if (value < best.value) {
                best = {alpha, value};
            }
        }
    };
    consider(std::atan2(left.bound.q, left.bound.p) + pi);
    consider(std::atan2(right.bound.q, right.bound.p) + pi);
    const double p = left.bound.p - right.bound.p;
    const double q = left.bound.q - right.bound.q;
    const double amplitude = std::hypot(p, q);
    const double constant = left.bound.constant - right.bound.constant;
    if (std::abs(constant) < amplitude) {
        const double middle = std::atan2(q, p);
        const double spread = std::acos(-constant / amplitude);
        consider(middle + spread);
        consider(middle - spread);
    }
    const double value = larger(right.alpha);
    if (value < best.value) {
        best = {right.alpha, value};
    }
    return best;
}

}  // namespace

BestRange minimise_range(const CycleExtrema& extrema) {
    constexpr int first_angles = 36;
    BestRange best;
    std::vector<Cut> cuts;
    cuts.reserve(first_angles + 1);
    for (int i = 0; i < first_angles; ++i) {
        cuts.push_back(evaluate(extrema, two_pi * i / first_angles));
    }
    best.evaluations = first_angles;
    const auto by_range = [](const Cut& a, const Cut& b) { return a.range < b.range; };
    const auto [least, worst] = std::minmax_element(cuts.begin(), cuts.end(), by_range);
    best.shaft_angle = least->alpha;
    best.range = least->range;
    best.worst = worst->range;
    cuts.push_back(cuts.front());
    cuts.back().alpha = two_pi;

    // Bounds closer than this are rounding.
    const double tolerance = 1e-13 * (best.worst + extrema.amplitude());
    constexpr int most_evaluations = 20'000;
    std::vector<std::array<Cut, 2>> open;
    for (std::size_t i = first_angles; i-- > 0;) {
        open.push_back({cuts[i], cuts[i + 1]});
    }
    while (!open.empty()) {
        const std::array<Cut, 2> interval = open.back();
        open.pop_back();
        // A cheap bound first: |dR/dα| ≤ 2A.
        const double width = interval[1].alpha - interval[0].alpha;
        if ((interval[0].range + interval[1].range) / 2.0 - extrema.amplitude() * width >=
            best.range) {
            continue;
        }
        Bound bound = least_of_larger(interval[0], interval[1]);
        if (bound.value >= best.range - tolerance) {
            continue;
        }
        if (best.evaluations >= most_evaluations || width < 1e-13) {
            best.gap = std::max(best.gap, best.range - bound.value);
            continue;
        }
        // A split at an end would not end; there the bound touches R, up to rounding.
        if (bound.alpha <= interval[0].alpha || bound.alpha >= interval[1].alpha) {
            bound.alpha = interval[0].alpha + width / 2.0;
        }
        const Cut cut = evaluate(extrema, bound.alpha);
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

}  // namespace ravnoves::balance_shaft

#include "balance-shaft/play_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "balance-shaft/best_range.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

namespace {

using Interval = std::array<Cut<double>, 2>;

/// The largest value of the chord plus A (α − a)(b − α), and where.
Bound<double> most_of(const Interval& interval, double amplitude) {
    const double width = interval[1].alpha - interval[0].alpha;
    const double rise = interval[1].value - interval[0].value;
    // About the middle: chord + A (w²/4 − t²), at its top where 2 A t = rise/w.
    const double half = width / 2.0;
    const double t =
        amplitude > 0.0 ? std::clamp(rise / (2.0 * amplitude * width), -half, half) : 0.0;
    return {interval[0].alpha + half + t,
            interval[0].value + rise / 2.0 + rise / width * t + amplitude * (half * half - t * t)};
}

}  // namespace

PlayRange play_range(const CycleExtrema& extrema, double from, double to) {
    const auto evaluate = [&](double alpha) { return range_cut(extrema, alpha); };
    const Cut<double> first = evaluate(from);
    PlayRange result{first.value, first.value};
    const double amplitude = extrema.amplitude();
    if (!(to > from) || amplitude == 0.0) {
        return result;
    }
    constexpr double rounding = 450.0 * std::numeric_limits<double>::epsilon();
    constexpr int most_evaluations = 20'000;
    const double narrow = rounding * std::max(1.0, std::abs(from) + std::abs(to));
    std::vector<Interval> open;
    // Some to begin with, so that no sinusoid bounds more than a part of a turn.
    const int parts = 2 + static_cast<int>((to - from) / (10.0 * degree));
    Cut<double> left = first;
    for (int i = 1; i <= parts; ++i) {
        const Cut<double> right = evaluate(i == parts ? to : from + (to - from) * i / parts);
        open.push_back({left, right});
        left = right;
    }
    const auto offer = [&](const Cut<double>& cut) {
        result.low = std::min(result.low, cut.value);
        result.high = std::max(result.high, cut.value);
    };
    for (const Interval& interval : open) {
        offer(interval[1]);
    }
    for (int evaluations = 0; !open.empty() && evaluations < most_evaluations; ++evaluations) {
        const Interval interval = open.back();
        open.pop_back();
        const double tolerance = rounding * (result.high + amplitude);
        const double width = interval[1].alpha - interval[0].alpha;
        if (width < narrow) {
            continue;
        }
        const Bound<double> least = least_of_larger(interval[0], interval[1]);
        const Bound<double> most = most_of(interval, amplitude);
        double place = 0.0;
        if (least.value < result.low - tolerance) {
            place = least.alpha;
        } else if (most.value > result.high + tolerance) {
            place = most.alpha;
        } else {
            continue;
        }
        // A split at an end would not end.
        constexpr double least_part = 0.05;
        place = std::clamp(place, interval[0].alpha + least_part * width,
                           interval[1].alpha - least_part * width);
        const Cut<double> cut = evaluate(place);
        offer(cut);
        open.push_back({cut, interval[1]});
        open.push_back({interval[0], cut});
    }
    return result;
}

}  // namespace ravnoves::balance_shaft

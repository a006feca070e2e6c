#include "balance-shaft/angle_search.h"

#include <algorithm>
#include <array>
#include <limits>

#include "numerics/angle.h"

namespace ravnoves::balance_shaft {

namespace {

struct Bound {
    double alpha = 0.0;
    double value = 0.0;
};

/// Minimum of the larger of two sinusoids between their angles: at an end, at a sinusoid's own
/// minimum or where they cross.
Bound min_of_larger(const Cut& left, const Cut& right) {
    const auto larger = [&](double alpha) {
        return std::max(left.bound(alpha), right.bound(alpha));
    };
    Bound best{left.alpha, larger(left.alpha)};
    const auto offer = [&](double alpha) {
        const double value = larger(alpha);
        if (alpha <= right.alpha && value < best.value) {
            best = {alpha, value};
        }
    };
    const auto consider = [&](double alpha) { offer(left.alpha + wrap_turn(alpha - left.alpha)); };
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
    offer(right.alpha);
    return best;
}

}  // namespace

std::vector<AngleStretch> turned(std::vector<AngleStretch> stretches, double by) {
    for (AngleStretch& stretch : stretches) {
        stretch.from += by;
        stretch.to += by;
    }
    return stretches;
}

AngleMinimum minimise_over_angle(const std::function<Cut(double)>& evaluate, double size,
                                 const std::vector<AngleStretch>& within) {
    constexpr int first_angles = 36;
    AngleMinimum best;
    std::vector<std::array<Cut, 2>> open;
    std::vector<Cut> cuts;
    for (const AngleStretch& stretch : within) {
        const double span = stretch.to - stretch.from;
        const int parts = std::max(1, static_cast<int>(std::ceil(first_angles * span / two_pi)));
        for (int i = 0; i <= parts; ++i) {
            cuts.push_back(evaluate(stretch.from + span * i / parts));
            if (i > 0) {
                open.push_back({cuts.end()[-2], cuts.back()});
            }
        }
    }
    std::reverse(open.begin(), open.end());
    const auto by_value = [](const Cut& a, const Cut& b) { return a.value < b.value; };
    const auto ends = std::minmax_element(cuts.begin(), cuts.end(), by_value);
    best.worst = ends.second->value;
    // Values and bounds closer than this are rounding.
    const double rounding = 450 * std::numeric_limits<double>::epsilon();
    const double tolerance = rounding * (best.worst + size);
    // Of angles that are as good the first: the ends of what can be built often mirror each other.
    const auto chosen = std::find_if(cuts.begin(), cuts.end(), [&](const Cut& cut) {
        return cut.value <= ends.first->value + tolerance;
    });
    best.alpha = chosen->alpha;
    best.value = chosen->value;
    constexpr int max_evaluations = 20'000;
    for (int evaluations = 0; !open.empty();) {
        const std::array<Cut, 2> interval = open.back();
        open.pop_back();
        const double width = interval[1].alpha - interval[0].alpha;
        Bound bound = min_of_larger(interval[0], interval[1]);
        if (bound.value >= best.value - tolerance) {
            continue;
        }
        if (evaluations >= max_evaluations || width < rounding) {
            best.gap = std::max(best.gap, best.value - bound.value);
            continue;
        }
        // A split at an end would not end; there the bound touches the function, up to rounding.
        if (bound.alpha <= interval[0].alpha || bound.alpha >= interval[1].alpha) {
            bound.alpha = interval[0].alpha + width / 2;
        }
        const Cut cut = evaluate(bound.alpha);
        ++evaluations;
        best.worst = std::max(best.worst, cut.value);
        if (cut.value < best.value) {
            best.value = cut.value;
            best.alpha = cut.alpha;
        }
        open.push_back({cut, interval[1]});
        open.push_back({interval[0], cut});
    }
    best.alpha = wrap_turn(best.alpha);
    return best;
}

void sweep(const MomentPlane& plane, double amplitude, std::span<const double> alpha,
           std::span<double> range, std::span<double> rms) {
    constexpr std::size_t group = 8;
    std::array<MomentPlane::Moment, group> shafts;
    for (std::size_t from = 0; from < alpha.size(); from += group) {
        const std::size_t count = std::min(group, alpha.size() - from);
        for (std::size_t i = 0; i < count; ++i) {
            shafts[i] = shaft_at(amplitude, alpha[from + i]);
            rms[from + i] = plane.rms(shafts[i]);
        }
        plane.ranges(std::span(shafts).first(count), range.subspan(from, count));
    }
}

Cut range_cut(const MomentPlane& plane, double amplitude, double alpha) {
    const MomentPlane::Extrema found = plane(shaft_at(amplitude, alpha));
    // By the shaft's moment the slope is constant along the bound.
    const MomentPlane::Moment slope = amplitude * found.slope();
    Cut cut{alpha, found.range(), {0.0, slope.y(), slope.x()}};
    cut.bound.constant = cut.value - cut.bound(alpha);
    return cut;
}

AngleMinimum minimise_range(const MomentPlane& plane, double amplitude,
                            const std::vector<AngleStretch>& within) {
    return minimise_over_angle([&](double alpha) { return range_cut(plane, amplitude, alpha); },
                               amplitude, within);
}

}  // namespace ravnoves::balance_shaft

#pragma once

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <vector>

namespace ravnoves::balance_shaft {

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

/// Angles from one to another, rad: 0 ≤ from < 2π, from ≤ to ≤ from + 2π.
struct AngleStretch {
    double from = 0.0;
    double to = boost::math::constants::two_pi<double>();

    bool is_whole_turn() const { return to - from >= boost::math::constants::two_pi<double>(); }
    bool operator==(const AngleStretch&) const = default;
};

inline std::vector<AngleStretch> whole_turn() {
    return {AngleStretch{}};
}

/// An evaluated angle with a lower bound of the function everywhere that touches it there.
template <typename Scalar>
struct Cut {
    Scalar alpha = Scalar(0);
    Scalar value = Scalar(0);
    Sinusoid<Scalar> bound;
};

template <typename Scalar>
struct Bound {
    Scalar alpha = Scalar(0);
    Scalar value = Scalar(0);
};

/// The least value of a function of α and what is known of the others.
template <typename Scalar>
struct AngleMinimum {
    Scalar alpha = Scalar(0);  ///< rad, 0…2π
    Scalar value = Scalar(0);
    Scalar worst = Scalar(0);  ///< the largest value met on the way
    Scalar gap = Scalar(0);    ///< no α has a value below value − gap
    int evaluations = 0;
};

/// Minimum of the larger of two sinusoids between their angles: at an end, at a sinusoid's own
/// minimum or where they cross.
template <typename Scalar>
Bound<Scalar> least_of_larger(const Cut<Scalar>& left, const Cut<Scalar>& right) {
    using std::abs;
    using std::acos;
    using std::atan2;
    using std::sqrt;
    const Scalar& pi = boost::math::constants::pi<Scalar>();
    const Scalar& two_pi = boost::math::constants::two_pi<Scalar>();
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

/// The global minimum over α of a function of period 2π, by cutting planes: every evaluated angle
/// gives a sinusoid that lies below the function everywhere. Between two evaluated angles the
/// larger of their two sinusoids bounds it; the interval is split at that bound's minimum until no
/// bound lies under the best value. Kinks and several minima need no care, since the bounds are
/// global. Of angles at the ends that are as good up to rounding it is the least.
/// @param evaluate  α → Cut
/// @param steepest  Lipschitz constant of the function
/// @param size      scale of its rounding, besides its values
/// @param within    the angles to choose from, one stretch at least; default: all
template <typename Scalar, typename Evaluate>
AngleMinimum<Scalar> minimise_over_angle(const Evaluate& evaluate, const Scalar& steepest,
                                         const Scalar& size,
                                         const std::vector<AngleStretch>& within = whole_turn()) {
    const Scalar& two_pi = boost::math::constants::two_pi<Scalar>();
    constexpr int first_angles = 36;
    AngleMinimum<Scalar> best;
    std::vector<std::array<Cut<Scalar>, 2>> open;
    std::vector<Cut<Scalar>> cuts;
    for (const AngleStretch& stretch : within) {
        // The ends of the whole turn are one angle.
        const bool whole = stretch.is_whole_turn();
        const Scalar from = stretch.from;
        const Scalar span = whole ? two_pi : Scalar(stretch.to - stretch.from);
        const int parts = whole ? first_angles
                                : 1 + static_cast<int>(static_cast<double>(first_angles) *
                                                       (stretch.to - stretch.from) /
                                                       boost::math::constants::two_pi<double>());
        const std::size_t first = cuts.size();
        for (int i = 0; i < parts + (whole ? 0 : 1); ++i) {
            cuts.push_back(evaluate(Scalar(from + span * i / parts)));
            ++best.evaluations;
        }
        if (whole) {
            cuts.push_back(cuts[first]);
            cuts.back().alpha = from + two_pi;
        }
        for (std::size_t i = first; i + 1 < cuts.size(); ++i) {
            open.push_back({cuts[i], cuts[i + 1]});
        }
    }
    std::reverse(open.begin(), open.end());
    const auto by_value = [](const Cut<Scalar>& a, const Cut<Scalar>& b) {
        return a.value < b.value;
    };
    const auto [least, worst] = std::minmax_element(cuts.begin(), cuts.end(), by_value);
    best.worst = worst->value;
    // Values and bounds closer than this are rounding.
    const Scalar rounding = 450 * std::numeric_limits<Scalar>::epsilon();
    const Scalar tolerance = rounding * (best.worst + size);
    // Of angles that are as good the first: the ends of what can be built often mirror each other.
    const auto chosen = std::find_if(cuts.begin(), cuts.end(), [&](const Cut<Scalar>& cut) {
        return cut.value <= least->value + tolerance;
    });
    best.alpha = chosen->alpha;
    best.value = chosen->value;
    constexpr int most_evaluations = 20'000;
    while (!open.empty()) {
        const std::array<Cut<Scalar>, 2> interval = open.back();
        open.pop_back();
        // A cheap bound first, by the Lipschitz constant.
        const Scalar width = interval[1].alpha - interval[0].alpha;
        if ((interval[0].value + interval[1].value - steepest * width) / 2 >= best.value) {
            continue;
        }
        Bound<Scalar> bound = least_of_larger(interval[0], interval[1]);
        if (bound.value >= best.value - tolerance) {
            continue;
        }
        if (best.evaluations >= most_evaluations || width < rounding) {
            best.gap = std::max(best.gap, Scalar(best.value - bound.value));
            continue;
        }
        // A split at an end would not end; there the bound touches the function, up to rounding.
        if (bound.alpha <= interval[0].alpha || bound.alpha >= interval[1].alpha) {
            bound.alpha = interval[0].alpha + width / 2;
        }
        const Cut<Scalar> cut = evaluate(bound.alpha);
        ++best.evaluations;
        best.worst = std::max(best.worst, cut.value);
        if (cut.value < best.value) {
            best.value = cut.value;
            best.alpha = cut.alpha;
        }
        open.push_back({cut, interval[1]});
        open.push_back({interval[0], cut});
    }
    while (best.alpha >= two_pi) {
        best.alpha -= two_pi;
    }
    return best;
}

}  // namespace ravnoves::balance_shaft

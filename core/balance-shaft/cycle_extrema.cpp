#include "balance-shaft/cycle_extrema.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numerics/angle.h"
#include "numerics/extrema.h"
#include "numerics/real50.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr Eigen::Index block = 16;
template <typename Scalar>
using Block = Eigen::Array<Scalar, block, 1>;

template <typename Scalar>
Scalar degree_of() {
    return boost::math::constants::degree<Scalar>();
}

}  // namespace

template <typename Scalar>
struct BasicCycleExtrema<Scalar>::Search {
    Scalar x = Scalar(0);          ///< A sin α, multiplies cos φ
    Scalar y = Scalar(0);          ///< A cos α, multiplies sin φ
    Scalar alpha_deg = Scalar(0);  ///< 0…360
    BasicExtrema<Scalar> found{{-std::numeric_limits<Scalar>::infinity(), Scalar(0)},
                               {std::numeric_limits<Scalar>::infinity(), Scalar(0)}};

    Scalar highest = Scalar(0);  ///< the best at the knots
    Scalar lowest = Scalar(0);

    /// True where neither bound can improve on what is known.
    bool beaten(const Scalar& top, const Scalar& bottom) const {
        return top < std::max(highest, found.max.value) &&
               bottom > std::min(lowest, found.min.value);
    }
    void offer_max(const Scalar& value, const Scalar& angle_deg) {
        if (value > found.max.value) {
            found.max = {value, angle_deg};
        }
    }
    void offer_min(const Scalar& value, const Scalar& angle_deg) {
        if (value < found.min.value) {
            found.min = {value, angle_deg};
        }
    }
};

template <typename Scalar>
BasicCycleExtrema<Scalar>::BasicCycleExtrema(const BasicPeriodicPiecewise<Scalar>& moment,
                                             const Scalar& amplitude)
    : amplitude_(amplitude), period_(moment.period()), linear_(moment.is_linear()) {
    using std::abs;
    using std::acos;
    using std::cos;
    using std::sin;
    using std::sqrt;
    const Scalar degree = degree_of<Scalar>();
    knot_deg_.reserve(moment.size() + 1);
    for (std::size_t i = 0; i < moment.size(); ++i) {
        knot_deg_.push_back(wrap<Scalar>(moment.knots()[i], Scalar(360)));
    }
    std::sort(knot_deg_.begin(), knot_deg_.end());
    knot_deg_.erase(std::unique(knot_deg_.begin(), knot_deg_.end()), knot_deg_.end());
    count_ = knot_deg_.size();
    knot_deg_.push_back(knot_deg_.front() + 360);

    const auto padded = (static_cast<Eigen::Index>(count_) + block - 1) / block * block;
    cos_.resize(padded);
    sin_.resize(padded);
    upper_.resize(padded);
    lower_.resize(padded);
    branches_.reserve(2 * count_);
    for (std::size_t j = 0; j < count_; ++j) {
        const Scalar left = knot_deg_[j];
        const Scalar h = knot_deg_[j + 1] - left;
        std::array<Scalar, 2> value{};
        for (std::size_t turn = 0; turn < 2; ++turn) {
            // The piece is looked up at the middle, so that rounding at a knot cannot pick the
            // neighbour; its origin then moves to the left knot.
            const auto place = moment.find(left + h / 2 + Scalar(360 * static_cast<int>(turn)));
            const Cubic& piece = moment.pieces()[place.piece];
            Scalar offset = place.t - h / 2;
            if (abs(offset) < 1e-10) {
                offset = Scalar(0);  // keeps the table's own value at its knot
            }
            Branch branch;
            branch.cubic = piece.shifted(offset);
            value[turn] = branch.cubic.y;
            const Scalar slope = branch.cubic.c1 / degree;  // N·m/rad
            if (abs(slope) < amplitude_) {
                branch.steepest = acos(Scalar(-slope / amplitude_)) / degree;
                branch.rise = sqrt(Scalar((amplitude_ - slope) * (amplitude_ + slope)));
            } else {
                branch.has_interior = false;
            }
            // The cubic less its chord is −t (h − t) (c₂ + c₃ (t + h)).
            const Cubic& c = branch.cubic;
            const Scalar bend_left = c.c2 + c.c3 * h;
            const Scalar bend_right = bend_left + c.c3 * h;
            const Scalar chord_of_sine = amplitude_ * degree * degree * h * h / 8;
            branch.last = c.value(h);
            branch.above =
                chord_of_sine +
                std::max(Scalar(0), Scalar(-std::min(bend_left, bend_right) * h * h / 4));
            branch.below = chord_of_sine +
                           std::max(Scalar(0), Scalar(std::max(bend_left, bend_right) * h * h / 4));
            branches_.push_back(branch);
        }
        const auto row = static_cast<Eigen::Index>(j);
        cos_[row] = cos(Scalar(left * degree));
        sin_[row] = sin(Scalar(left * degree));
        upper_[row] = std::max(value[0], value[1]);
        lower_[row] = std::min(value[0], value[1]);
    }
    for (auto row = static_cast<Eigen::Index>(count_); row < padded; ++row) {
        cos_[row] = cos_[0];
        sin_[row] = sin_[0];
        upper_[row] = upper_[0];
        lower_[row] = lower_[0];
    }
    // Rounding must not hide an interval whose excess is just the bound.
    const Scalar size =
        std::max({amplitude_, Scalar(upper_.maxCoeff()), Scalar(-lower_.minCoeff())});
    const Scalar slack = 50 * std::numeric_limits<Scalar>::epsilon() * size;
    for (Branch& branch : branches_) {
        branch.above = branch.above * (1 + 1e-9) + slack;
        branch.below = branch.below * (1 + 1e-9) + slack;
    }
    above_.setZero(padded);
    below_.setZero(padded);
    for (std::size_t j = 0; j < count_; ++j) {
        const std::size_t before = j == 0 ? count_ - 1 : j - 1;
        const auto row = static_cast<Eigen::Index>(j);
        for (const std::size_t branch : {2 * before, 2 * before + 1, 2 * j, 2 * j + 1}) {
            above_[row] = std::max(above_[row], branches_[branch].above);
            below_[row] = std::max(below_[row], branches_[branch].below);
        }
    }
    block_above_.resize(padded / block);
    block_below_.resize(padded / block);
    for (Eigen::Index k = 0; k < padded / block; ++k) {
        block_above_[k] = above_.template segment<block>(k * block).maxCoeff();
        block_below_[k] = below_.template segment<block>(k * block).maxCoeff();
    }
}

template <typename Scalar>
void BasicCycleExtrema<Scalar>::search_interval(Eigen::Index j, Search& search) const {
    using std::sin;
    const Scalar degree = degree_of<Scalar>();
    const Scalar left = knot_deg_[static_cast<std::size_t>(j)];
    const Scalar h = knot_deg_[static_cast<std::size_t>(j) + 1] - left;
    const Eigen::Index next = j + 1 < static_cast<Eigen::Index>(count_) ? j + 1 : 0;
    const Scalar sine_left = search.x * cos_[j] + search.y * sin_[j];
    const Scalar sine_right = search.x * cos_[next] + search.y * sin_[next];
    for (int turn = 0; turn < 2; ++turn) {
        const Branch& branch = branches_[static_cast<std::size_t>(2 * j + turn)];
        const Scalar value_left = branch.cubic.y + sine_left;
        const Scalar value_right = branch.last + sine_right;
        if (search.beaten(std::max(value_left, value_right) + branch.above,
                          std::min(value_left, value_right) - branch.below)) {
            continue;
        }
        const Scalar origin = left + 360 * turn;
        if (linear_) {
            if (!branch.has_interior) {
                continue;
            }
            for (const int sign : {1, -1}) {
                Scalar t = sign * branch.steepest - search.alpha_deg - left;
                while (t < 0) {  // at most three turns
                    t += 360;
                }
                while (t >= 360) {
                    t -= 360;
                }
                if (t < h) {
                    const Scalar value = branch.cubic.y + branch.cubic.c1 * t + sign * branch.rise;
                    search.offer_max(value, origin + t);
                    search.offer_min(value, origin + t);
                }
            }
            continue;
        }
        const Scalar phase = (search.alpha_deg + left) * degree;
        for (const Scalar& t :
             stationary_points<Scalar>(branch.cubic, amplitude_, degree, phase, h)) {
            const Scalar value =
                branch.cubic.value(t) + amplitude_ * sin(Scalar(degree * t + phase));
            search.offer_max(value, origin + t);
            search.offer_min(value, origin + t);
        }
    }
}

template <typename Scalar>
BasicExtrema<Scalar> BasicCycleExtrema<Scalar>::operator()(const Scalar& alpha) const {
    using std::cos;
    using std::sin;
    const Scalar degree = degree_of<Scalar>();
    Search search;
    search.x = amplitude_ * sin(alpha);
    search.y = amplitude_ * cos(alpha);
    search.alpha_deg = wrap<Scalar>(alpha / degree, Scalar(360));

    // First pass: extrema at the knots, block by block; they are kept so that the second pass opens
    // only blocks near the best.
    const auto blocks = cos_.size() / block;
    constexpr Eigen::Index most_on_stack = 64;
    std::array<Scalar, 2 * most_on_stack> stack;  // filled as far as it is read
    std::vector<Scalar> heap;
    Scalar* block_max = stack.data();
    if (blocks > most_on_stack) {
        heap.resize(static_cast<std::size_t>(2 * blocks));
        block_max = heap.data();
    }
    Scalar* const block_min = block_max + blocks;
    Scalar highest = -std::numeric_limits<Scalar>::infinity();
    Scalar lowest = std::numeric_limits<Scalar>::infinity();
    for (Eigen::Index k = 0; k < blocks; ++k) {
        const Block<Scalar> sine = search.x * cos_.template segment<block>(k * block) +
                                   search.y * sin_.template segment<block>(k * block);
        block_max[k] = (upper_.template segment<block>(k * block) + sine).maxCoeff();
        block_min[k] = (lower_.template segment<block>(k * block) + sine).minCoeff();
        highest = std::max(highest, block_max[k]);
        lowest = std::min(lowest, block_min[k]);
    }

    search.highest = highest;
    search.lowest = lowest;

    // Second pass: every knot that near to the best is offered with the interior extrema of the
    // intervals on its two sides.
    Eigen::Index searched = -1;  // the last interval searched
    for (Eigen::Index k = 0; k < blocks; ++k) {
        if (search.beaten(block_max[k] + block_above_[k], block_min[k] - block_below_[k])) {
            continue;
        }
        const Eigen::Index end = std::min((k + 1) * block, static_cast<Eigen::Index>(count_));
        for (Eigen::Index row = k * block; row < end; ++row) {
            const Scalar sine = search.x * cos_[row] + search.y * sin_[row];
            const Scalar top = upper_[row] + sine;
            const Scalar bottom = lower_[row] + sine;
            if (search.beaten(top + above_[row], bottom - below_[row])) {
                continue;
            }
            const auto j = static_cast<std::size_t>(row);
            const bool second_is_upper = branches_[2 * j].cubic.y < branches_[2 * j + 1].cubic.y;
            search.offer_max(top, knot_deg_[j] + Scalar(second_is_upper ? 360 : 0));
            search.offer_min(bottom, knot_deg_[j] + Scalar(second_is_upper ? 0 : 360));
            const Eigen::Index before = (row == 0 ? static_cast<Eigen::Index>(count_) : row) - 1;
            if (before != searched) {
                search_interval(before, search);
            }
            if (row != before) {
                search_interval(row, search);
            }
            searched = row;
        }
    }
    search.found.max.angle_deg = wrap<Scalar>(search.found.max.angle_deg, period_);
    search.found.min.angle_deg = wrap<Scalar>(search.found.min.angle_deg, period_);
    return search.found;
}

template class BasicCycleExtrema<double>;
template class BasicCycleExtrema<Real50>;

}  // namespace ravnoves::balance_shaft

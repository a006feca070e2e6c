#include "balance-shaft/cycle_extrema.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numerics/constants.h"
#include "numerics/extrema.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr Eigen::Index block = 16;
using Block = Eigen::Array<double, block, 1>;

double wrap(double x, double period) {
    x = std::fmod(x, period);
    if (x < 0.0) {
        x += period;
    }
    return x < period ? x : 0.0;
}

}  // namespace

struct CycleExtrema::Search {
    double x = 0.0;          ///< A sin α, multiplies cos φ
    double y = 0.0;          ///< A cos α, multiplies sin φ
    double alpha_deg = 0.0;  ///< 0…360
    Extrema found{{-std::numeric_limits<double>::infinity(), 0.0},
                  {std::numeric_limits<double>::infinity(), 0.0}};

    double highest = 0.0;  ///< the best at the knots
    double lowest = 0.0;

    /// True where neither bound can improve on what is known.
    bool beaten(double top, double bottom) const {
        return top < std::max(highest, found.max.value) &&
               bottom > std::min(lowest, found.min.value);
    }
    void offer_max(double value, double angle_deg) {
        if (value > found.max.value) {
            found.max = {value, angle_deg};
        }
    }
    void offer_min(double value, double angle_deg) {
        if (value < found.min.value) {
            found.min = {value, angle_deg};
        }
    }
};

CycleExtrema::CycleExtrema(const PeriodicPiecewise& moment, double amplitude)
    : amplitude_(amplitude), linear_(moment.is_linear()) {
    knot_deg_.reserve(moment.size() + 1);
    for (std::size_t i = 0; i < moment.size(); ++i) {
        knot_deg_.push_back(wrap(moment.knots()[i], 360.0));
    }
    std::sort(knot_deg_.begin(), knot_deg_.end());
    knot_deg_.erase(std::unique(knot_deg_.begin(), knot_deg_.end()), knot_deg_.end());
    count_ = knot_deg_.size();
    knot_deg_.push_back(knot_deg_.front() + 360.0);

    const auto padded = (static_cast<Eigen::Index>(count_) + block - 1) / block * block;
    cos_.resize(padded);
    sin_.resize(padded);
    upper_.resize(padded);
    lower_.resize(padded);
    branches_.reserve(2 * count_);
    for (std::size_t j = 0; j < count_; ++j) {
        const double left = knot_deg_[j];
        const double h = knot_deg_[j + 1] - left;
        std::array<double, 2> value{};
        for (std::size_t turn = 0; turn < 2; ++turn) {
            // The piece is looked up at the middle, so that rounding at a knot cannot pick the
            // neighbour; its origin then moves to the left knot.
            const auto place = moment.find(left + h / 2.0 + 360.0 * static_cast<double>(turn));
            const Cubic& piece = moment.pieces()[place.piece];
            double offset = place.t - h / 2.0;
            if (std::abs(offset) < 1e-10) {
                offset = 0.0;  // keeps the table's own value at its knot
            }
            Branch branch;
            branch.cubic = piece.shifted(offset);
            value[turn] = branch.cubic.y;
            const double slope = branch.cubic.c1 / degree;  // N·m/rad
            if (std::abs(slope) < amplitude_) {
                branch.steepest = std::acos(-slope / amplitude_) / degree;
                branch.rise = std::sqrt((amplitude_ - slope) * (amplitude_ + slope));
            } else {
                branch.has_interior = false;
            }
            // The cubic less its chord is −t (h − t) (c₂ + c₃ (t + h)).
            const Cubic& c = branch.cubic;
            const double bend_left = c.c2 + c.c3 * h;
            const double bend_right = bend_left + c.c3 * h;
            const double chord_of_sine = amplitude_ * degree * degree * h * h / 8.0;
            branch.last = c.value(h);
            branch.above =
                chord_of_sine + std::max(0.0, -std::min(bend_left, bend_right) * h * h / 4.0);
            branch.below =
                chord_of_sine + std::max(0.0, std::max(bend_left, bend_right) * h * h / 4.0);
            branches_.push_back(branch);
        }
        const auto row = static_cast<Eigen::Index>(j);
        cos_[row] = std::cos(left * degree);
        sin_[row] = std::sin(left * degree);
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
    const double size = std::max({amplitude_, upper_.maxCoeff(), -lower_.minCoeff()});
    for (Branch& branch : branches_) {
        branch.above = branch.above * (1.0 + 1e-9) + 1e-14 * size;
        branch.below = branch.below * (1.0 + 1e-9) + 1e-14 * size;
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
        block_above_[k] = above_.segment<block>(k * block).maxCoeff();
        block_below_[k] = below_.segment<block>(k * block).maxCoeff();
    }
}

void CycleExtrema::search_interval(Eigen::Index j, Search& search) const {
    const double left = knot_deg_[static_cast<std::size_t>(j)];
    const double h = knot_deg_[static_cast<std::size_t>(j) + 1] - left;
    const Eigen::Index next = j + 1 < static_cast<Eigen::Index>(count_) ? j + 1 : 0;
    const double sine_left = search.x * cos_[j] + search.y * sin_[j];
    const double sine_right = search.x * cos_[next] + search.y * sin_[next];
    for (int turn = 0; turn < 2; ++turn) {
        const Branch& branch = branches_[static_cast<std::size_t>(2 * j + turn)];
        const double value_left = branch.cubic.y + sine_left;
        const double value_right = branch.last + sine_right;
        if (search.beaten(std::max(value_left, value_right) + branch.above,
                          std::min(value_left, value_right) - branch.below)) {
            continue;
        }
        const double origin = left + 360.0 * turn;
        if (linear_) {
            if (!branch.has_interior) {
                continue;
            }
            for (const double sign : {1.0, -1.0}) {
                double t = sign * branch.steepest - search.alpha_deg - left;
                while (t < 0.0) {  // at most three turns
                    t += 360.0;
                }
                while (t >= 360.0) {
                    t -= 360.0;
                }
                if (t < h) {
                    const double value = branch.cubic.y + branch.cubic.c1 * t + sign * branch.rise;
                    search.offer_max(value, origin + t);
                    search.offer_min(value, origin + t);
                }
            }
            continue;
        }
        const double phase = (search.alpha_deg + left) * degree;
        for (const double t : stationary_points(branch.cubic, amplitude_, degree, phase, h)) {
            const double value = branch.cubic.value(t) + amplitude_ * std::sin(degree * t + phase);
            search.offer_max(value, origin + t);
            search.offer_min(value, origin + t);
        }
    }
}

Extrema CycleExtrema::operator()(double alpha) const {
    Search search;
    search.x = amplitude_ * std::sin(alpha);
    search.y = amplitude_ * std::cos(alpha);
    search.alpha_deg = wrap(alpha / degree, 360.0);

    // First pass: extrema at the knots, block by block; they are kept so that the second pass opens
    // only blocks near the best.
    const auto blocks = cos_.size() / block;
    constexpr Eigen::Index most_on_stack = 64;
    std::array<double, 2 * most_on_stack> stack;  // filled as far as it is read
    std::vector<double> heap;
    double* block_max = stack.data();
    if (blocks > most_on_stack) {
        heap.resize(static_cast<std::size_t>(2 * blocks));
        block_max = heap.data();
    }
    double* const block_min = block_max + blocks;
    double highest = -std::numeric_limits<double>::infinity();
    double lowest = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < blocks; ++k) {
        const Block sine =
            search.x * cos_.segment<block>(k * block) + search.y * sin_.segment<block>(k * block);
        block_max[k] = (upper_.segment<block>(k * block) + sine).maxCoeff();
        block_min[k] = (lower_.segment<block>(k * block) + sine).minCoeff();
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
            const double sine = search.x * cos_[row] + search.y * sin_[row];
            const double top = upper_[row] + sine;
            const double bottom = lower_[row] + sine;
            if (search.beaten(top + above_[row], bottom - below_[row])) {
                continue;
            }
            const auto j = static_cast<std::size_t>(row);
            const bool second_is_upper = branches_[2 * j].cubic.y < branches_[2 * j + 1].cubic.y;
            search.offer_max(top, knot_deg_[j] + (second_is_upper ? 360.0 : 0.0));
            search.offer_min(bottom, knot_deg_[j] + (second_is_upper ? 0.0 : 360.0));
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
    search.found.max.angle_deg = wrap(search.found.max.angle_deg, 720.0);
    search.found.min.angle_deg = wrap(search.found.min.angle_deg, 720.0);
    return search.found;
}

}  // namespace ravnoves::balance_shaft

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
            const double curvature =
                2.0 * std::max(std::abs(branch.cubic.c2),
                               std::abs(branch.cubic.c2 + 3.0 * branch.cubic.c3 * h));
            largest_excess_ =
                std::max(largest_excess_, h * h / 8.0 * (amplitude_ * degree * degree + curvature));
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
    largest_excess_ = largest_excess_ * (1.0 + 1e-9) + 1e-14 * size;
}

void CycleExtrema::search_interval(std::size_t j, Search& search) const {
    const double left = knot_deg_[j];
    const double h = knot_deg_[j + 1] - left;
    for (std::size_t turn = 0; turn < 2; ++turn) {
        const Branch& branch = branches_[2 * j + turn];
        const double origin = left + 360.0 * static_cast<double>(turn);
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

    // Second pass: every knot that near to the best is offered with the interior extrema of the
    // intervals on its two sides.
    const auto beaten = [&](double top, double bottom) {
        return top + largest_excess_ < std::max(highest, search.found.max.value) &&
               bottom - largest_excess_ > std::min(lowest, search.found.min.value);
    };
    std::size_t searched = count_;  // the last interval searched
    for (Eigen::Index k = 0; k < blocks; ++k) {
        if (beaten(block_max[k], block_min[k])) {
            continue;
        }
        const Eigen::Index end = std::min((k + 1) * block, static_cast<Eigen::Index>(count_));
        for (Eigen::Index row = k * block; row < end; ++row) {
            const double sine = search.x * cos_[row] + search.y * sin_[row];
            const double top = upper_[row] + sine;
            const double bottom = lower_[row] + sine;
            if (beaten(top, bottom)) {
                continue;
            }
            const auto j = static_cast<std::size_t>(row);
            const bool second_is_upper = branches_[2 * j].cubic.y < branches_[2 * j + 1].cubic.y;
            search.offer_max(top, knot_deg_[j] + (second_is_upper ? 360.0 : 0.0));
            search.offer_min(bottom, knot_deg_[j] + (second_is_upper ? 0.0 : 360.0));
            const std::size_t before = j == 0 ? count_ - 1 : j - 1;
            if (before != searched) {
                search_interval(before, search);
            }
            if (j != before) {
                search_interval(j, search);
            }
            searched = j;
        }
    }
    search.found.max.angle_deg = wrap(search.found.max.angle_deg, 720.0);
    search.found.min.angle_deg = wrap(search.found.min.angle_deg, 720.0);
    return search.found;
}

}  // namespace ravnoves::balance_shaft

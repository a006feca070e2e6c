#include "balance-shaft/cycle_extrema.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "numerics/angle.h"
#include "numerics/extrema.h"
#include "numerics/real50.h"
#include "numerics/short_trigonometry.h"
#include "numerics/vector_lanes.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr Eigen::Index block = 16;
template <typename Scalar>
using Block = Eigen::Array<Scalar, block, 1>;

template <typename Scalar>
Scalar degree_of() {
    return boost::math::constants::degree<Scalar>();
}

/// Of the knots, padded to whole blocks.
struct KnotColumns {
    const double* cos;
    const double* sin;
    const double* upper;
    const double* lower;
    std::size_t blocks;
};

/// The largest upper and the least lower value of each block.
struct BlockExtrema {
    template <typename Lanes>
    RAVNOVES_KERNEL static void run(const KnotColumns& knots, double x, double y, double* highest,
                                    double* lowest) {
        Lanes by_cos;
        Lanes by_sin;
        set_all(by_cos, x);
        set_all(by_sin, y);
        for (std::size_t k = 0; k < knots.blocks; ++k) {
            Lanes top;
            Lanes bottom;
            set_all(top, -std::numeric_limits<double>::infinity());
            set_all(bottom, std::numeric_limits<double>::infinity());
            for (std::size_t i = k * block; i < (k + 1) * block; i += lanes_of<Lanes>) {
                Lanes cos;
                Lanes sin;
                Lanes upper;
                Lanes lower_value;
                load(cos, knots.cos + i);
                load(sin, knots.sin + i);
                load(upper, knots.upper + i);
                load(lower_value, knots.lower + i);
                const Lanes sine = by_cos * cos + by_sin * sin;
                upper += sine;
                lower_value += sine;
                raise(top, upper);
                lower(bottom, lower_value);
            }
            highest[k] = greatest(top);
            lowest[k] = least(bottom);
        }
    }
};

/// Newton's method within a bracket, which is halved where a step would leave it.
/// @param rises   the function is positive right of its root
/// @param enough  the last change
/// @param at      the function and its slope at t
template <typename At>
double root_within(double low, double high, double t, bool rises, double enough, const At& at) {
    constexpr int most_steps = 40;
    double change = high - low;
    for (int step = 0; step < most_steps && change > enough; ++step) {
        const auto [value, slope] = at(t);
        ((value > 0.0) == rises ? high : low) = t;
        double moved = t - value / slope;
        if (!(moved >= low && moved <= high)) {
            moved = (low + high) / 2.0;
        }
        change = std::abs(moved - t);
        t = moved;
    }
    return t;
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
    /// The last interval searched.
    std::size_t searched = std::numeric_limits<std::size_t>::max();

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
    slack_ = slack;
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
    if constexpr (std::is_same_v<Scalar, double>) {
        std::vector<double> knots;
        if (count_ > KnotStretches::few) {
            knots.assign(knot_deg_.begin(), knot_deg_.end() - 1);
        }
        for (double& knot : knots) {
            knot *= degree;
        }
        stretches_ = KnotStretches(knots);
        stretch_upper_ = stretches_.greatest(upper_);
        stretch_lower_ = stretches_.least(lower_);
        stretch_above_ = stretches_.greatest(above_);
        stretch_below_ = stretches_.greatest(below_);
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
        if constexpr (std::is_same_v<Scalar, double>) {
            if (search_smooth(branch, j, value_left, value_right, origin, search)) {
                continue;
            }
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

/// The extrema within, where the bend changes its sign once at most.
/// @return false where it may do so more often: nothing is known then
template <typename Scalar>
bool BasicCycleExtrema<Scalar>::search_smooth(
    const Branch& branch, Eigen::Index j, const Scalar& value_left, const Scalar& value_right,
    const Scalar& origin, Search& search) const requires std::is_same_v<Scalar, double> {
    using std::abs;
    using std::cos;
    using std::sin;
    const Scalar w = degree_of<Scalar>();
    const Scalar h =
        knot_deg_[static_cast<std::size_t>(j) + 1] - knot_deg_[static_cast<std::size_t>(j)];
    const Eigen::Index next = j + 1 < static_cast<Eigen::Index>(count_) ? j + 1 : 0;
    const Cubic& p = branch.cubic;
    // A sin(φ + α) is sine cos(wt) + slope sin(wt) from the left knot.
    const Scalar sine = search.x * cos_[j] + search.y * sin_[j];
    const Scalar slope = search.y * cos_[j] - search.x * sin_[j];
    const Scalar sine_last = search.x * cos_[next] + search.y * sin_[next];
    const Scalar slope_last = search.y * cos_[next] - search.x * sin_[next];
    // What can matter here; an arch has a maximum at most, a hollow a minimum.
    const bool wants_max = std::max(value_left, value_right) + branch.above >=
                           std::max(search.highest, search.found.max.value);
    const bool wants_min = std::min(value_left, value_right) - branch.below <=
                           std::min(search.lowest, search.found.min.value);
    const auto cos_sin = [&](const Scalar& t) -> CosSin {
        const Scalar angle = w * t;
        return angle <= longest_short_angle ? short_cos_sin(angle) : CosSin{cos(angle), sin(angle)};
    };
    const Scalar enough = 1e-9 * h;  // Newton's next step would be of the order of its square
    struct End {
        Scalar t;
        Scalar value;
        Scalar rise;
    };
    const auto search_bow = [&](const End& left, const End& right, bool is_arch) {
        if (is_arch ? !(wants_max && left.rise > 0 && right.rise < 0)
                    : !(wants_min && left.rise < 0 && right.rise > 0)) {
            return;
        }
        // It lies within the tangents at its ends, so not beyond the place where they meet.
        const Scalar corner =
            left.value + left.rise * (right.value - left.value - right.rise * (right.t - left.t)) /
                             (left.rise - right.rise);
        if (is_arch ? corner < std::max(search.highest, search.found.max.value)
                    : corner > std::min(search.lowest, search.found.min.value)) {
            return;
        }
        const Scalar guess = left.t + (right.t - left.t) * left.rise / (left.rise - right.rise);
        const Scalar t =
            root_within(left.t, right.t, guess, !is_arch, enough, [&](const Scalar& at) {
                const auto [c, s] = cos_sin(at);
                return std::pair(p.slope(at) + w * (slope * c - sine * s),
                                 2 * p.c2 + 6 * p.c3 * at - w * w * (sine * c + slope * s));
            });
        const auto [c, s] = cos_sin(t);
        const Scalar value = p.value(t) + sine * c + slope * s;
        if (is_arch) {
            search.offer_max(value, origin + t);
        } else {
            search.offer_min(value, origin + t);
        }
    };

    const End first{Scalar(0), value_left, p.c1 + w * slope};
    const End last{h, value_right, p.slope(h) + w * slope_last};
    // A sine is off its chord by at most this.
    const Scalar off = amplitude_ * w * w * h * h / 8;
    const Scalar cubic_first = 2 * p.c2;
    const Scalar cubic_last = cubic_first + 6 * p.c3 * h;
    if (std::max(cubic_first, cubic_last) < w * w * (std::min(sine, sine_last) - off)) {
        search_bow(first, last, true);
        return true;
    }
    if (std::min(cubic_first, cubic_last) > w * w * (std::max(sine, sine_last) + off)) {
        search_bow(first, last, false);
        return true;
    }
    // The third derivative is 6 c₃ − w³ × (the cosine): where it keeps its sign, the bend changes
    // its own once at most.
    const Scalar third = 6 * p.c3 / (w * w * w);
    if (third <= std::max(slope, slope_last) + off && third >= std::min(slope, slope_last) - off) {
        return false;
    }
    const Scalar bend_first = cubic_first - w * w * sine;
    const Scalar bend_last = cubic_last - w * w * sine_last;
    if ((bend_first < 0) == (bend_last < 0)) {
        search_bow(first, last, bend_first < 0);
        return true;
    }
    const bool begins_as_arch = bend_first < 0;
    const bool first_matters =
        begins_as_arch ? wants_max && first.rise > 0 : wants_min && first.rise < 0;
    const bool last_matters =
        begins_as_arch ? wants_min && last.rise > 0 : wants_max && last.rise < 0;
    if (!first_matters && !last_matters) {
        return true;
    }
    const Scalar t = root_within(
        Scalar(0), h, h * bend_first / (bend_first - bend_last), begins_as_arch, enough,
        [&](const Scalar& at) {
            const auto [c, s] = cos_sin(at);
            return std::pair(cubic_first + 6 * p.c3 * at - w * w * (sine * c + slope * s),
                             6 * p.c3 - w * w * w * (slope * c - sine * s));
        });
    const auto [c, s] = cos_sin(t);
    const End between{t, p.value(t) + sine * c + slope * s,
                      p.slope(t) + w * (slope * c - sine * s)};
    search_bow(first, between, begins_as_arch);
    search_bow(between, last, !begins_as_arch);
    return true;
}

template <typename Scalar>
typename BasicCycleExtrema<Scalar>::Search BasicCycleExtrema<Scalar>::search_at(
    const Scalar& alpha) const {
    using std::cos;
    using std::sin;
    Search search;
    search.x = amplitude_ * sin(alpha);
    search.y = amplitude_ * cos(alpha);
    search.alpha_deg = wrap<Scalar>(alpha / degree_of<Scalar>(), Scalar(360));
    return search;
}

/// Offers a knot that is near the best, and what lies in the intervals on its two sides.
template <typename Scalar>
void BasicCycleExtrema<Scalar>::offer_knot(std::size_t j, const Scalar& top, const Scalar& bottom,
                                           Search& search) const {
    const bool second_is_upper = branches_[2 * j].cubic.y < branches_[2 * j + 1].cubic.y;
    search.offer_max(top, knot_deg_[j] + Scalar(second_is_upper ? 360 : 0));
    search.offer_min(bottom, knot_deg_[j] + Scalar(second_is_upper ? 0 : 360));
    const std::size_t before = (j == 0 ? count_ : j) - 1;
    if (before != search.searched) {
        search_interval(static_cast<Eigen::Index>(before), search);
    }
    if (j != before) {
        search_interval(static_cast<Eigen::Index>(j), search);
    }
    search.searched = j;
}

/// Every knot of a block that is near to the best is offered with the interior extrema of the
/// intervals on its two sides.
template <typename Scalar>
void BasicCycleExtrema<Scalar>::search_block(Eigen::Index k, const Scalar& block_max,
                                             const Scalar& block_min, Search& search) const {
    if (search.beaten(block_max + block_above_[k], block_min - block_below_[k])) {
        return;
    }
    const Eigen::Index end = std::min((k + 1) * block, static_cast<Eigen::Index>(count_));
    for (Eigen::Index row = k * block; row < end; ++row) {
        const Scalar sine = search.x * cos_[row] + search.y * sin_[row];
        const Scalar top = upper_[row] + sine;
        const Scalar bottom = lower_[row] + sine;
        if (search.beaten(top + above_[row], bottom - below_[row])) {
            continue;
        }
        offer_knot(static_cast<std::size_t>(row), top, bottom, search);
    }
}

template <typename Scalar>
KnotStretches::Bounds BasicCycleExtrema<Scalar>::reach(
    std::size_t stretch, const Scalar& x,
    const Scalar& y) const requires std::is_same_v<Scalar, double> {
    const KnotStretches::Bounds sine = stretches_.sine(stretch, x, y);
    return {stretch_lower_[stretch] + sine.low - slack_,
            stretch_upper_[stretch] + sine.high + slack_};
}

/// The two passes of operator(), but stretches that cannot hold an extremum are passed over.
template <typename Scalar>
void BasicCycleExtrema<Scalar>::search_many(
    Search& search) const requires std::is_same_v<Scalar, double> {
    constexpr Eigen::Index blocks = KnotStretches::length / block;
    std::array<double, static_cast<std::size_t>(blocks)> block_max;  // filled as far as it is read
    std::array<double, static_cast<std::size_t>(blocks)> block_min;
    const auto look = [&](std::size_t stretch) -> Eigen::Index {
        const auto first = static_cast<Eigen::Index>(stretch) * KnotStretches::length;
        const Eigen::Index count = std::min(blocks, (cos_.size() - first) / block);
        const KnotColumns knots{cos_.data() + first, sin_.data() + first, upper_.data() + first,
                                lower_.data() + first, static_cast<std::size_t>(count)};
        run_kernel<BlockExtrema>(knots, search.x, search.y, block_max.data(), block_min.data());
        return count;
    };
    thread_local std::vector<KnotStretches::Bounds> reaches;
    reaches.resize(stretches_.size());
    std::size_t highest = 0;
    std::size_t lowest = 0;
    for (std::size_t k = 0; k < reaches.size(); ++k) {
        reaches[k] = reach(k, search.x, search.y);
        highest = reaches[k].high > reaches[highest].high ? k : highest;
        lowest = reaches[k].low < reaches[lowest].low ? k : lowest;
    }
    search.highest = -std::numeric_limits<double>::infinity();
    search.lowest = std::numeric_limits<double>::infinity();
    const auto look_at_knots = [&](std::size_t stretch) {
        const Eigen::Index count = look(stretch);
        search.highest =
            std::max(search.highest, *std::max_element(block_max.data(), block_max.data() + count));
        search.lowest =
            std::min(search.lowest, *std::min_element(block_min.data(), block_min.data() + count));
    };
    look_at_knots(highest);
    look_at_knots(lowest);
    for (std::size_t k = 0; k < reaches.size(); ++k) {
        if (k != highest && k != lowest &&
            (reaches[k].high >= search.highest || reaches[k].low <= search.lowest)) {
            look_at_knots(k);
        }
    }
    for (std::size_t k = 0; k < reaches.size(); ++k) {
        if (search.beaten(reaches[k].high + stretch_above_[k],
                          reaches[k].low - stretch_below_[k])) {
            continue;
        }
        const Eigen::Index count = look(k);
        for (Eigen::Index i = 0; i < count; ++i) {
            search_block(static_cast<Eigen::Index>(k) * blocks + i,
                         block_max[static_cast<std::size_t>(i)],
                         block_min[static_cast<std::size_t>(i)], search);
        }
    }
}

template <typename Scalar>
BasicExtrema<Scalar> BasicCycleExtrema<Scalar>::operator()(const Scalar& alpha) const {
    Search search = search_at(alpha);
    const auto found = [&]() -> BasicExtrema<Scalar> {
        search.found.max.angle_deg = wrap<Scalar>(search.found.max.angle_deg, period_);
        search.found.min.angle_deg = wrap<Scalar>(search.found.min.angle_deg, period_);
        return search.found;
    };
    if constexpr (std::is_same_v<Scalar, double>) {
        if (stretches_.size() > 0) {
            search_many(search);
            return found();
        }
    }

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
    if constexpr (std::is_same_v<Scalar, double>) {
        const KnotColumns knots{cos_.data(), sin_.data(), upper_.data(), lower_.data(),
                                static_cast<std::size_t>(blocks)};
        run_kernel<BlockExtrema>(knots, search.x, search.y, block_max, block_min);
    } else {
        for (Eigen::Index k = 0; k < blocks; ++k) {
            const Block<Scalar> sine = search.x * cos_.template segment<block>(k * block) +
                                       search.y * sin_.template segment<block>(k * block);
            block_max[k] = (upper_.template segment<block>(k * block) + sine).maxCoeff();
            block_min[k] = (lower_.template segment<block>(k * block) + sine).minCoeff();
        }
    }
    for (Eigen::Index k = 0; k < blocks; ++k) {
        highest = std::max(highest, block_max[k]);
        lowest = std::min(lowest, block_min[k]);
    }

    search.highest = highest;
    search.lowest = lowest;

    for (Eigen::Index k = 0; k < blocks; ++k) {
        search_block(k, block_max[k], block_min[k], search);
    }
    return found();
}

template <typename Scalar>
struct BasicCycleExtrema<Scalar>::Near {
    std::vector<std::size_t> knots;
    std::vector<Scalar> cos, sin, upper, lower, above, below;  ///< of these knots
    std::vector<Scalar> top, bottom;
    std::vector<Scalar> block_max, block_min;  ///< of all knots
};

/// @param apart  the shaft's moment at the angles is no farther from (x, y) than this, N·m
template <typename Scalar>
void BasicCycleExtrema<Scalar>::find_near(
    const Scalar& x, const Scalar& y, const Scalar& apart,
    Near& near) const requires std::is_same_v<Scalar, double> {
    near.knots.clear();
    for (std::vector<Scalar>* const column :
         {&near.cos, &near.sin, &near.upper, &near.lower, &near.above, &near.below}) {
        column->clear();
    }
    const auto blocks = static_cast<std::size_t>(cos_.size() / block);
    near.block_max.resize(blocks);
    near.block_min.resize(blocks);
    const KnotColumns knots{cos_.data(), sin_.data(), upper_.data(), lower_.data(), blocks};
    run_kernel<BlockExtrema>(knots, x, y, near.block_max.data(), near.block_min.data());
    const auto highest = std::max_element(near.block_max.begin(), near.block_max.end());
    const auto lowest = std::min_element(near.block_min.begin(), near.block_min.end());
    const auto sine = [&](Eigen::Index row) { return x * cos_[row] + y * sin_[row]; };
    Eigen::Index best = (highest - near.block_max.begin()) * block;
    Eigen::Index worst = (lowest - near.block_min.begin()) * block;
    for (Eigen::Index row = best; row < best / block * block + block; ++row) {
        best = upper_[row] + sine(row) > upper_[best] + sine(best) ? row : best;
    }
    for (Eigen::Index row = worst; row < worst / block * block + block; ++row) {
        worst = lower_[row] + sine(row) < lower_[worst] + sine(worst) ? row : worst;
    }
    // From (x, y) to an angle's moment a knot gains on the best one by at most the distance of
    // their directions times that of the moments.
    const Scalar square = 2 * apart * apart;
    const Scalar slack = 100 * std::numeric_limits<Scalar>::epsilon() *
                         (amplitude_ + std::max(*highest, Scalar(-*lowest)));
    for (std::size_t k = 0; k < blocks; ++k) {
        const auto first = static_cast<Eigen::Index>(k) * block;
        const Scalar gain = 2 * apart + slack;
        if (*highest - near.block_max[k] - block_above_[static_cast<Eigen::Index>(k)] > gain &&
            near.block_min[k] - block_below_[static_cast<Eigen::Index>(k)] - *lowest > gain) {
            continue;
        }
        const Eigen::Index end = std::min(first + block, static_cast<Eigen::Index>(count_));
        for (Eigen::Index row = first; row < end; ++row) {
            const auto within = [&](const Scalar& lack, Eigen::Index from) {
                return lack <= 0 ||
                       lack * lack <= square * (1 + Scalar(1e-9) - cos_[row] * cos_[from] -
                                                sin_[row] * sin_[from]);
            };
            if (within(*highest - upper_[row] - sine(row) - above_[row] - slack, best) ||
                within(lower_[row] + sine(row) - below_[row] - *lowest - slack, worst)) {
                near.knots.push_back(static_cast<std::size_t>(row));
                near.cos.push_back(cos_[row]);
                near.sin.push_back(sin_[row]);
                near.upper.push_back(upper_[row]);
                near.lower.push_back(lower_[row]);
                near.above.push_back(above_[row]);
                near.below.push_back(below_[row]);
            }
        }
    }
    near.top.resize(near.knots.size());
    near.bottom.resize(near.knots.size());
}

template <typename Scalar>
void BasicCycleExtrema<Scalar>::ranges(std::span<const Scalar> alpha, std::span<Scalar> range)
    const requires std::is_same_v<Scalar, double> {
    using std::sqrt;
    constexpr std::size_t group = 8;
    thread_local Near near;
    for (std::size_t from = 0; from < alpha.size(); from += group) {
        const std::size_t to = std::min(from + group, alpha.size());
        std::array<Search, group> searches;
        for (std::size_t i = from; i < to; ++i) {
            searches[i - from] = search_at(alpha[i]);
        }
        const Search middle = searches[(to - from) / 2];
        Scalar apart(0);
        for (std::size_t i = from; i < to; ++i) {
            const Scalar x = searches[i - from].x - middle.x;
            const Scalar y = searches[i - from].y - middle.y;
            apart = std::max(apart, Scalar(x * x + y * y));
        }
        find_near(middle.x, middle.y, sqrt(apart), near);
        const auto count = static_cast<Eigen::Index>(near.knots.size());
        using Given = Eigen::Map<const Column>;
        Eigen::Map<Column> top(near.top.data(), count);
        Eigen::Map<Column> bottom(near.bottom.data(), count);
        for (std::size_t i = from; i < to; ++i) {
            Search& search = searches[i - from];
            bottom =
                search.x * Given(near.cos.data(), count) + search.y * Given(near.sin.data(), count);
            top = Given(near.upper.data(), count) + bottom;
            bottom += Given(near.lower.data(), count);
            search.highest = top.maxCoeff();
            search.lowest = bottom.minCoeff();
            for (std::size_t n = 0; n < near.knots.size(); ++n) {
                if (!search.beaten(near.top[n] + near.above[n], near.bottom[n] - near.below[n])) {
                    offer_knot(near.knots[n], near.top[n], near.bottom[n], search);
                }
            }
            range[i] = search.found.max.value - search.found.min.value;
        }
    }
}

template class BasicCycleExtrema<double>;
// By members: clang 14 would instantiate those that are for double alone, too.
template BasicCycleExtrema<Real50>::BasicCycleExtrema(const BasicPeriodicPiecewise<Real50>&,
                                                      const Real50&);
template BasicExtrema<Real50> BasicCycleExtrema<Real50>::operator()(const Real50&) const;

}  // namespace ravnoves::balance_shaft

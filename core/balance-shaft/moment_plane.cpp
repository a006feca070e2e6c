#include "balance-shaft/moment_plane.h"

#include <algorithm>
#include <limits>

#include "numerics/angle.h"
#include "numerics/vector_lanes.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr std::size_t block = 16;  ///< knots
constexpr double longest_interval_deg = 15.0;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Of the knots, padded to whole blocks.
struct KnotColumns {
    const double* cos;
    const double* sin;
    const double* peak;
    std::size_t blocks;
};

/// The largest peak + a cos + b sin of each block; returns that of all.
struct BlockPeaks {
    template <typename Lanes>
    RAVNOVES_KERNEL static double run(const KnotColumns& knots, double a, double b, double* out) {
        Lanes by_cos;
        Lanes by_sin;
        Lanes of_all;
        set_all(by_cos, a);
        set_all(by_sin, b);
        set_all(of_all, -unbounded);
        for (std::size_t k = 0; k < knots.blocks; ++k) {
            Lanes top;
            set_all(top, -unbounded);
            for (std::size_t i = k * block; i < (k + 1) * block; i += lanes_of<Lanes>) {
                Lanes cos;
                Lanes sin;
                Lanes peak;
                load(cos, knots.cos + i);
                load(sin, knots.sin + i);
                load(peak, knots.peak + i);
                const Lanes value = peak + (by_cos * cos + by_sin * sin);
                raise(top, value);
            }
            out[k] = max_of(top);
            raise(of_all, top);
        }
        return max_of(of_all);
    }
};

struct CosSin {
    double cos;
    double sin;
};

/// For |t| ≤ 15°; the next terms are below 1e-17.
CosSin short_cos_sin(double t) {
    const double q = t * t;
    return {1.0 + q * (-1.0 / 2 +
                       q * (1.0 / 24 +
                            q * (-1.0 / 720 + q * (1.0 / 40320 +
                                                   q * (-1.0 / 3628800 + q * (1.0 / 479001600)))))),
            t * (1.0 + q * (-1.0 / 6 +
                            q * (1.0 / 120 +
                                 q * (-1.0 / 5040 + q * (1.0 / 362880 + q * (-1.0 / 39916800))))))};
}

Eigen::ArrayXd block_maxima(const Eigen::ArrayXd& of) {
    constexpr auto rows = static_cast<Eigen::Index>(block);
    Eigen::ArrayXd maxima(of.size() / rows);
    for (Eigen::Index k = 0; k < maxima.size(); ++k) {
        maxima[k] = of.segment<rows>(k * rows).maxCoeff();
    }
    return maxima;
}

}  // namespace

MomentPlane::MomentPlane(const PeriodicPiecewise& moment)
    : period_(moment.period()), mean_(moment.mean()) {
    turns_ = period_ > 540.0 ? 2 : 1;
    find_knots(moment);
    for (Side* const side : {&up_, &down_}) {
        find_branches(moment, *side);
    }
    slack_ = 50.0 * epsilon * std::max(up_.peak.abs().maxCoeff(), down_.peak.abs().maxCoeff());
    const FourierPair order = moment.fourier(degree);
    opposed_ = {-order.a, -order.b};
    min_variance_ = std::max(0.0, moment.variance() - opposed_.squaredNorm() / 2.0);
}

void MomentPlane::find_knots(const PeriodicPiecewise& moment) {
    std::vector<double> knots;
    knots.reserve(moment.size() + 1);
    for (std::size_t i = 0; i < moment.size(); ++i) {
        knots.push_back(wrap(moment.knots()[i], turn_deg));
    }
    std::sort(knots.begin(), knots.end());
    // Knots that rounding sets apart are one.
    knots.erase(
        std::unique(knots.begin(), knots.end(), [](double a, double b) { return b - a < 1e-10; }),
        knots.end());
    knots.push_back(knots.front() + turn_deg);
    knot_deg_.reserve(knots.size() + 25);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double width = knots[i + 1] - knots[i];
        const int parts =
            std::max(1, static_cast<int>(std::ceil(width / longest_interval_deg - 1e-9)));
        for (int k = 0; k < parts; ++k) {
            knot_deg_.push_back(knots[i] + width * k / parts);
        }
    }
    count_ = knot_deg_.size();
    knot_deg_.push_back(knots.back());

    const auto padded = static_cast<Eigen::Index>((count_ + block - 1) / block * block);
    cos_.resize(padded);
    sin_.resize(padded);
    for (Eigen::Index row = 0; row < padded; ++row) {
        const auto j = static_cast<std::size_t>(row);
        const double angle = knot_deg_[j < count_ ? j : 0] * degree;
        cos_[row] = std::cos(angle);
        sin_[row] = std::sin(angle);
    }
    for (std::size_t j = 0; j < count_; ++j) {
        width_.push_back((knot_deg_[j + 1] - knot_deg_[j]) * degree);
        chord_.push_back(width_[j] * width_[j] / 8.0 * (1.0 + 1e-9));
    }
    chord_beside_.setZero(padded);
    for (std::size_t j = 0; j < count_; ++j) {
        chord_beside_[static_cast<Eigen::Index>(j)] =
            std::max(chord_[j], chord_[j == 0 ? count_ - 1 : j - 1]);
    }
    block_chord_ = block_maxima(chord_beside_);
}

void MomentPlane::find_branches(const PeriodicPiecewise& moment, Side& side) const {
    side.peak.setConstant(cos_.size(), -unbounded);
    side.above.setZero(cos_.size());
    side.branches.reserve(turns_ * count_);
    for (std::size_t j = 0; j < count_; ++j) {
        const double half_deg = (knot_deg_[j + 1] - knot_deg_[j]) / 2.0;
        const double width = width_[j];
        const auto row = static_cast<Eigen::Index>(j);
        const auto next = static_cast<Eigen::Index>(j + 1 < count_ ? j + 1 : 0);
        for (std::size_t turn = 0; turn < turns_; ++turn) {
            Branch branch;
            branch.from_deg = knot_deg_[j] + turn_deg * static_cast<double>(turn);
            // Looked up at the middle: rounding at a knot cannot pick the neighbour.
            const auto place = moment.find(branch.from_deg + half_deg);
            double offset = place.t - half_deg;
            if (std::abs(offset) < 1e-10) {
                offset = 0.0;  // keeps the table's own value at its knot
            }
            const PiecewiseCubic piece = moment.pieces()[place.piece].shifted(offset);
            branch.cubic = {side.sign * piece.y, side.sign * piece.c1 / degree,
                            side.sign * piece.c2 / (degree * degree),
                            side.sign * piece.c3 / (degree * degree * degree)};
            branch.last = branch.cubic.value(width);
            // The cubic less its chord is −t (h − t) (c₂ + c₃ (t + h)).
            const double bend = std::min(branch.cubic.c2 + branch.cubic.c3 * width,
                                         branch.cubic.c2 + 2.0 * branch.cubic.c3 * width);
            branch.above = std::max(0.0, -bend * width * width / 4.0 * (1.0 + 1e-9));
            side.peak[row] = std::max(side.peak[row], branch.cubic.y);
            side.above[row] = std::max(side.above[row], branch.above);
            side.above[next] = std::max(side.above[next], branch.above);
            side.branches.push_back(branch);
        }
    }
    for (auto row = static_cast<Eigen::Index>(count_); row < cos_.size(); ++row) {
        side.peak[row] = side.peak[0];
    }
    side.block_above = block_maxima(side.above);
}

/// Offers the left end and the highest place within.
void MomentPlane::search_branch(const Side& side, std::size_t interval, std::size_t turn,
                                const At& at, Place& best) const {
    const Branch& branch = side.branches[turns_ * interval + turn];
    const auto j = static_cast<Eigen::Index>(interval);
    const auto next = interval + 1 < count_ ? j + 1 : 0;
    const PiecewiseCubic& cubic = branch.cubic;
    const double sine = at.a * cos_[j] + at.b * sin_[j];
    const double left = cubic.y + sine;
    if (left > best.value) {
        best = {left, cos_[j], sin_[j], branch.from_deg};
    }
    const double sine_last = at.a * cos_[next] + at.b * sin_[next];
    const double bow = at.size * chord_[interval];
    if (std::max(left, branch.last + sine_last) + branch.above + bow + at.slack < best.value) {
        return;
    }
    const double slope = at.b * cos_[j] - at.a * sin_[j];
    struct Look {
        double value, rise, bend;  ///< and its first two derivatives
        CosSin turned;
    };
    const auto look = [&](double t) -> Look {
        const auto [c, s] = short_cos_sin(t);
        const double wave = sine * c + slope * s;
        return {cubic.value(t) + wave,
                cubic.slope(t) - sine * s + slope * c,
                2.0 * cubic.c2 + 6.0 * cubic.c3 * t - wave,
                {c, s}};
    };
    const auto offer = [&](double t, const Look& here) {
        if (here.value > best.value) {
            const auto [c, s] = here.turned;
            best = {here.value, cos_[j] * c - sin_[j] * s, sin_[j] * c + cos_[j] * s,
                    branch.from_deg + t / degree};
        }
    };
    // Parts that are neither concave nor convex are halved where the slope may change its sign.
    const auto search = [&](const auto& self, double from, const Look& first, double to,
                            const Look& last) -> void {
        const double width = to - from;
        const double bow_of_bend = at.size * width * width / 8.0;
        const double most = std::max(first.bend, last.bend) + bow_of_bend;
        const double least = std::min(first.bend, last.bend) - bow_of_bend;
        if (most <= 0.0 && first.rise > 0.0 && last.rise < 0.0) {
            double low = from;
            double high = to;
            double t = from + width * first.rise / (first.rise - last.rise);
            for (int step = 0; step < 20; ++step) {
                const Look here = look(t);
                (here.rise > 0.0 ? low : high) = t;
                double moved = t - here.rise / here.bend;
                if (!(moved >= low && moved <= high)) {
                    moved = (low + high) / 2.0;
                }
                const double change = std::abs(moved - t);
                t = moved;
                // The next step's would be the square of this, and the value is flat there.
                if (change <= 1e-5 * width) {
                    break;
                }
            }
            offer(t, look(t));
            return;
        }
        constexpr double narrow = 1e-9;
        if (most <= 0.0 || least >= 0.0 || width < narrow ||
            (first.rise * last.rise > 0.0 &&
             std::abs(first.rise) + std::abs(last.rise) > std::max(most, -least) * width)) {
            return;  // an end is highest
        }
        const double t = (from + to) / 2.0;
        const Look middle = look(t);
        offer(t, middle);
        self(self, from, first, t, middle);
        self(self, t, middle, to, last);
    };
    const double width = width_[interval];
    const Look first{left, cubic.c1 + slope, 2.0 * cubic.c2 - sine, {}};
    const Look last{branch.last + sine_last,
                    cubic.slope(width) + at.b * cos_[next] - at.a * sin_[next],
                    2.0 * cubic.c2 + 6.0 * cubic.c3 * width - sine_last,
                    {}};
    search(search, 0.0, first, width, last);
}

/// The highest place so far.
struct MomentPlane::Search {
    double top;  ///< at the knots
    Place best{.value = -unbounded};
    std::size_t searched = std::numeric_limits<std::size_t>::max();  ///< the last interval

    bool beaten(double reach, const At& at) const {
        return reach + at.slack < std::max(top, best.value);
    }
};

void MomentPlane::search_beside(const Side& side, const At& at, std::size_t knot,
                                Search& search) const {
    for (const std::size_t interval : {(knot == 0 ? count_ : knot) - 1, knot}) {
        if (interval != search.searched) {
            for (std::size_t turn = 0; turn < turns_; ++turn) {
                search_branch(side, interval, turn, at, search.best);
            }
        }
    }
    search.searched = knot;
}

MomentPlane::Place MomentPlane::highest(const Side& side, const At& at,
                                        std::vector<double>& block_peaks) const {
    const auto blocks = static_cast<std::size_t>(block_chord_.size());
    block_peaks.resize(blocks);
    Search search{.top = run_kernel<BlockPeaks>(
                      KnotColumns{cos_.data(), sin_.data(), side.peak.data(), blocks}, at.a, at.b,
                      block_peaks.data())};
    for (std::size_t k = 0; k < blocks; ++k) {
        const auto of_block = static_cast<Eigen::Index>(k);
        if (search.beaten(
                block_peaks[k] + side.block_above[of_block] + at.size * block_chord_[of_block],
                at)) {
            continue;
        }
        for (std::size_t j = k * block; j < std::min((k + 1) * block, count_); ++j) {
            const auto row = static_cast<Eigen::Index>(j);
            const double value = side.peak[row] + at.a * cos_[row] + at.b * sin_[row];
            if (!search.beaten(value + side.above[row] + at.size * chord_beside_[row], at)) {
                search_beside(side, at, j, search);
            }
        }
    }
    return search.best;
}

MomentPlane::At MomentPlane::at(const Side& side, const Moment& shaft) const {
    const double size = shaft.norm();
    return {side.sign * shaft.x(), side.sign * shaft.y(), size, slack_ + 50.0 * epsilon * size};
}

MomentPlane::Extrema MomentPlane::operator()(const Moment& shaft) const {
    thread_local std::vector<double> block_peaks;
    Extrema found{highest(up_, at(up_, shaft), block_peaks),
                  highest(down_, at(down_, shaft), block_peaks)};
    found.min.value = -found.min.value;
    for (Place* const place : {&found.max, &found.min}) {
        place->angle_deg = wrap(place->angle_deg, period_);
    }
    return found;
}

/// Adds the maximum of one side with each moment.
void MomentPlane::add_highest(const Side& side, std::span<const Moment> shafts,
                              std::span<double> to) const {
    thread_local std::vector<double> block_peaks;
    struct Near {
        std::vector<std::size_t> knots;
        std::vector<double> peak, cos, sin, above, chord, value;
    };
    thread_local Near near;
    near.knots.clear();
    for (std::vector<double>* const column :
         {&near.peak, &near.cos, &near.sin, &near.above, &near.chord}) {
        column->clear();
    }
    const Moment centre = (shafts.front() + shafts.back()) / 2.0;
    double square = 0.0;
    for (const Moment& shaft : shafts) {
        square = std::max(square, (shaft - centre).squaredNorm());
    }
    const double radius = std::sqrt(square);
    const At middle = at(side, centre);
    const Place best = highest(side, middle, block_peaks);
    // From the middle to another moment a knot gains on the best by at most the distance of their
    // directions times that of the moments; the sine's bow grows with its size.
    const double size = middle.size + radius;
    const double reached = best.value - middle.slack;
    for (std::size_t k = 0; k < block_peaks.size(); ++k) {
        const auto of_block = static_cast<Eigen::Index>(k);
        if (reached - block_peaks[k] - side.block_above[of_block] - size * block_chord_[of_block] >
            2.0 * radius * (1.0 + 1e-9)) {
            continue;
        }
        for (std::size_t j = k * block; j < std::min((k + 1) * block, count_); ++j) {
            const auto row = static_cast<Eigen::Index>(j);
            const double below = reached - side.peak[row] - middle.a * cos_[row] -
                                 middle.b * sin_[row] - side.above[row] - size * chord_beside_[row];
            if (below > 0.0 &&
                below * below >
                    2.0 * square * (1.0 + 1e-9 - best.cos * cos_[row] - best.sin * sin_[row])) {
                continue;
            }
            near.knots.push_back(j);
            near.peak.push_back(side.peak[row]);
            near.cos.push_back(cos_[row]);
            near.sin.push_back(sin_[row]);
            near.above.push_back(side.above[row]);
            near.chord.push_back(chord_beside_[row]);
        }
    }
    const auto count = static_cast<Eigen::Index>(near.knots.size());
    near.value.resize(near.knots.size());
    using Column = Eigen::Map<const Eigen::ArrayXd>;
    const Column peak(near.peak.data(), count);
    const Column cosines(near.cos.data(), count);
    const Column sines(near.sin.data(), count);
    const Column above(near.above.data(), count);
    const Column chord(near.chord.data(), count);
    Eigen::Map<Eigen::ArrayXd> value(near.value.data(), count);
    for (std::size_t i = 0; i < shafts.size(); ++i) {
        const At here = at(side, shafts[i]);
        value = peak + here.a * cosines + here.b * sines;
        Search search{.top = value.maxCoeff()};
        value += above + here.size * chord;
        for (Eigen::Index n = 0; n < count; ++n) {
            if (!search.beaten(value[n], here)) {
                search_beside(side, here, near.knots[static_cast<std::size_t>(n)], search);
            }
        }
        to[i] += search.best.value;
    }
}

void MomentPlane::ranges(std::span<const Moment> shafts, std::span<double> ranges) const {
    std::fill(ranges.begin(), ranges.end(), 0.0);
    add_highest(up_, shafts, ranges);
    add_highest(down_, shafts, ranges);
}

}  // namespace ravnoves::balance_shaft

#include "balance-shaft/moment_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "numerics/angle.h"
#include "numerics/extrema.h"
#include "numerics/short_trigonometry.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr Eigen::Index lanes = 16;  ///< knots of a block
using Lanes = Eigen::Array<double, lanes, 1>;
constexpr double longest_interval_deg = 15.0;
constexpr std::size_t tile = 8;  ///< cells of a map's tile, each way
constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

MomentPlane::MomentPlane(const PeriodicPiecewise& moment) {
    std::vector<double> knots;
    knots.reserve(moment.size() + 25);
    for (std::size_t i = 0; i < moment.size(); ++i) {
        knots.push_back(wrap(moment.knots()[i], 360.0));
    }
    std::sort(knots.begin(), knots.end());
    // Knots that rounding sets apart are one.
    knots.erase(
        std::unique(knots.begin(), knots.end(), [](double a, double b) { return b - a < 1e-10; }),
        knots.end());
    knots.push_back(knots.front() + 360.0);
    std::vector<double> fine;
    fine.reserve(knots.size() + 25);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double width = knots[i + 1] - knots[i];
        const int parts =
            std::max(1, static_cast<int>(std::ceil(width / longest_interval_deg - 1e-9)));
        for (int k = 0; k < parts; ++k) {
            fine.push_back(knots[i] + width * k / parts);
        }
    }
    count_ = fine.size();
    fine.push_back(fine.front() + 360.0);

    const auto padded = (static_cast<Eigen::Index>(count_) + lanes - 1) / lanes * lanes;
    cos_.resize(padded);
    sin_.resize(padded);
    knot_.reserve(count_ + 1);
    chord_.reserve(count_);
    for (std::size_t j = 0; j <= count_; ++j) {
        knot_.push_back(fine[j] * degree);
        if (j < count_) {
            cos_[static_cast<Eigen::Index>(j)] = std::cos(knot_[j]);
            sin_[static_cast<Eigen::Index>(j)] = std::sin(knot_[j]);
            const double width = (fine[j + 1] - fine[j]) * degree;
            chord_.push_back(width * width / 8.0 * (1.0 + 1e-9));
        }
    }
    chord_beside_.setZero(padded);
    for (std::size_t j = 0; j < count_; ++j) {
        chord_beside_[static_cast<Eigen::Index>(j)] =
            std::max(chord_[j], chord_[j == 0 ? count_ - 1 : j - 1]);
    }
    for (auto row = static_cast<Eigen::Index>(count_); row < padded; ++row) {
        cos_[row] = cos_[0];
        sin_[row] = sin_[0];
    }
    block_chord_.resize(padded / lanes);
    for (Eigen::Index k = 0; k < padded / lanes; ++k) {
        block_chord_[k] = chord_beside_.segment<lanes>(k * lanes).maxCoeff();
    }
    stretches_ = KnotStretches(std::span(knot_).first(count_));
    stretch_chord_ = stretches_.greatest(chord_beside_);
    prepare(moment);
    slack_ = 50.0 * epsilon * std::max(up_.peak.abs().maxCoeff(), down_.peak.abs().maxCoeff());
}

void MomentPlane::prepare(const PeriodicPiecewise& moment) {
    const auto turns = moment.period() > 540.0 ? std::size_t{2} : std::size_t{1};
    for (Side* const side : {&up_, &down_}) {
        side->peak.setConstant(cos_.size(), -std::numeric_limits<double>::infinity());
        side->above.setZero(cos_.size());
        side->branches.reserve(turns * count_);
    }
    turns_ = turns;
    for (std::size_t j = 0; j < count_; ++j) {
        const double left = knot_[j] / degree;
        const double width = knot_[j + 1] - knot_[j];
        const auto row = static_cast<Eigen::Index>(j);
        const auto next = static_cast<Eigen::Index>(j + 1 < count_ ? j + 1 : 0);
        for (std::size_t turn = 0; turn < turns; ++turn) {
            // Looked up at the middle: rounding at a knot cannot pick the neighbour.
            const double half = width / degree / 2.0;
            const auto place = moment.find(left + half + 360.0 * static_cast<double>(turn));
            double offset = place.t - half;
            if (std::abs(offset) < 1e-10) {
                offset = 0.0;  // keeps the table's own value at its knot
            }
            const PiecewiseCubic<double> piece = moment.pieces()[place.piece].shifted(offset);
            const PiecewiseCubic<double> by_radian{piece.y, piece.c1 / degree,
                                                   piece.c2 / (degree * degree),
                                                   piece.c3 / (degree * degree * degree)};
            for (Side* const side : {&up_, &down_}) {
                const double sign = side == &up_ ? 1.0 : -1.0;
                Branch branch;
                branch.interval = j;
                branch.cubic = {sign * by_radian.y, sign * by_radian.c1, sign * by_radian.c2,
                                sign * by_radian.c3};
                branch.last = branch.cubic.value(width);
                // The cubic less its chord is −t (h − t) (c₂ + c₃ (t + h)).
                const double bend = std::min(branch.cubic.c2 + branch.cubic.c3 * width,
                                             branch.cubic.c2 + 2.0 * branch.cubic.c3 * width);
                branch.above = std::max(0.0, -bend * width * width / 4.0 * (1.0 + 1e-9));
                side->peak[row] = std::max(side->peak[row], branch.cubic.y);
                side->above[row] = std::max(side->above[row], branch.above);
                side->above[next] = std::max(side->above[next], branch.above);
                side->branches.push_back(branch);
            }
        }
    }
    for (Side* const side : {&up_, &down_}) {
        for (auto row = static_cast<Eigen::Index>(count_); row < cos_.size(); ++row) {
            side->peak[row] = side->peak[0];
        }
        side->block_above.resize(cos_.size() / lanes);
        for (Eigen::Index k = 0; k < side->block_above.size(); ++k) {
            side->block_above[k] = side->above.segment<lanes>(k * lanes).maxCoeff();
        }
        side->stretch_peak = stretches_.greatest(side->peak);
        side->stretch_above = stretches_.greatest(side->above);
    }
}

/// Offers the left end and the highest place within.
void MomentPlane::search_branch(const Branch& branch, const Vector& at, Place& best) const {
    const auto j = static_cast<Eigen::Index>(branch.interval);
    const auto next = branch.interval + 1 < count_ ? j + 1 : 0;
    const PiecewiseCubic<double>& cubic = branch.cubic;
    const double sine = at.a * cos_[j] + at.b * sin_[j];
    const double left = cubic.y + sine;
    if (left > best.value) {
        best = {left, cubic.y, cos_[j], sin_[j]};
    }
    const double sine_last = at.a * cos_[next] + at.b * sin_[next];
    const double bow = at.size * chord_[branch.interval];
    if (std::max(left, branch.last + sine_last) + branch.above + bow + at.slack < best.value) {
        return;
    }
    const double width = knot_[branch.interval + 1] - knot_[branch.interval];
    const double slope = at.b * cos_[j] - at.a * sin_[j];
    const double rise = cubic.c1 + slope;
    const double rise_last = cubic.slope(width) + at.b * cos_[next] - at.a * sin_[next];
    const auto offer = [&](double t) {
        const auto [c, s] = short_cos_sin(t);
        const double moment = cubic.value(t);
        const double value = moment + sine * c + slope * s;
        if (value > best.value) {
            best = {value, moment, cos_[j] * c - sin_[j] * s, sin_[j] * c + cos_[j] * s};
        }
    };
    // The second derivative is 2 c₂ + 6 c₃ t − sine.
    const double bend_first = 2.0 * cubic.c2;
    const double bend_last = bend_first + 6.0 * cubic.c3 * width;
    const double most = std::max(bend_first, bend_last) - std::min(sine, sine_last) + bow;
    if (most <= 0.0) {
        if (rise <= 0.0 || rise_last >= 0.0) {
            return;
        }
        double low = 0.0;
        double high = width;
        double t = width * rise / (rise - rise_last);
        for (int step = 0; step < 20; ++step) {
            const auto [c, s] = short_cos_sin(t);
            const double first = cubic.slope(t) - sine * s + slope * c;
            const double second = bend_first + 6.0 * cubic.c3 * t - sine * c - slope * s;
            (first > 0.0 ? low : high) = t;
            double moved = t - first / second;
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
        offer(t);
        return;
    }
    const double least = std::min(bend_first, bend_last) - std::max(sine, sine_last) - bow;
    if (least >= 0.0) {
        return;  // convex: an end is highest
    }
    // sine cos t + slope sin t = A sin(t + phase)
    for (const double t :
         stationary_points<double>(cubic, at.size, 1.0, std::atan2(sine, slope), width)) {
        offer(t);
    }
}

/// The highest place so far.
struct MomentPlane::Search {
    double top = -std::numeric_limits<double>::infinity();  ///< at the knots
    Place best;
    std::size_t searched;  ///< the last interval searched

    bool beaten(double reach, const Vector& at) const {
        return reach + at.slack < std::max(top, best.value);
    }
};

double MomentPlane::block_top(const Side& side, const Vector& at, Eigen::Index block) const {
    const Lanes value = side.peak.segment<lanes>(block * lanes) +
                        at.a * cos_.segment<lanes>(block * lanes) +
                        at.b * sin_.segment<lanes>(block * lanes);
    return value.maxCoeff();
}

void MomentPlane::search_block(const Side& side, const Vector& at, Eigen::Index block,
                               double block_top, Search& search) const {
    if (search.beaten(block_top + side.block_above[block] + at.size * block_chord_[block], at)) {
        return;
    }
    const Eigen::Index end = std::min((block + 1) * lanes, static_cast<Eigen::Index>(count_));
    for (Eigen::Index row = block * lanes; row < end; ++row) {
        const double value = side.peak[row] + at.a * cos_[row] + at.b * sin_[row];
        if (search.beaten(value + side.above[row] + at.size * chord_beside_[row], at)) {
            continue;
        }
        const auto j = static_cast<std::size_t>(row);
        const std::size_t before = (j == 0 ? count_ : j) - 1;
        for (const std::size_t interval : {before, j}) {
            if (interval == search.searched) {
                continue;
            }
            for (std::size_t i = turns_ * interval; i < turns_ * (interval + 1); ++i) {
                search_branch(side.branches[i], at, search.best);
            }
        }
        search.searched = j;
    }
}

MomentPlane::Place MomentPlane::highest(const Side& side, const Vector& at) const {
    if (stretches_.size() > 0) {
        return highest_of_many(side, at);
    }
    const Eigen::Index blocks = cos_.size() / lanes;
    std::array<double, KnotStretches::few / lanes> block_max;  // filled as far as it is read
    Search search;
    search.best.value = -std::numeric_limits<double>::infinity();
    search.searched = count_;
    for (Eigen::Index k = 0; k < blocks; ++k) {
        block_max[static_cast<std::size_t>(k)] = block_top(side, at, k);
        search.top = std::max(search.top, block_max[static_cast<std::size_t>(k)]);
    }
    for (Eigen::Index k = 0; k < blocks; ++k) {
        search_block(side, at, k, block_max[static_cast<std::size_t>(k)], search);
    }
    return search.best;
}

/// The same, but stretches that cannot hold it are passed over.
MomentPlane::Place MomentPlane::highest_of_many(const Side& side, const Vector& at) const {
    Search search;
    search.best.value = -std::numeric_limits<double>::infinity();
    search.searched = count_;
    thread_local std::vector<double> reach;  // most at the knots of a stretch
    reach.resize(stretches_.size());
    for (std::size_t k = 0; k < reach.size(); ++k) {
        reach[k] = side.stretch_peak[k] + stretches_.sine(k, at.a, at.b).high + at.slack;
    }
    constexpr Eigen::Index blocks = KnotStretches::length / lanes;
    const auto each_block = [&](std::size_t stretch, const auto& look) {
        const auto first = static_cast<Eigen::Index>(stretch) * blocks;
        const Eigen::Index end = std::min(first + blocks, cos_.size() / lanes);
        for (Eigen::Index k = first; k < end; ++k) {
            look(k, block_top(side, at, k));
        }
    };
    const auto look_at_knots = [&](std::size_t stretch) {
        each_block(stretch, [&](Eigen::Index /*block*/, double block_top) {
            search.top = std::max(search.top, block_top);
        });
    };
    const auto promising =
        static_cast<std::size_t>(std::max_element(reach.begin(), reach.end()) - reach.begin());
    look_at_knots(promising);
    for (std::size_t k = 0; k < reach.size(); ++k) {
        if (k != promising && reach[k] >= search.top) {
            look_at_knots(k);
        }
    }
    for (std::size_t k = 0; k < reach.size(); ++k) {
        if (!search.beaten(reach[k] + side.stretch_above[k] + at.size * stretch_chord_[k], at)) {
            each_block(k, [&](Eigen::Index block, double block_top) {
                search_block(side, at, block, block_top, search);
            });
        }
    }
    return search.best;
}

MomentPlane::Vector MomentPlane::vector(double a, double b) const {
    const double size = std::sqrt(a * a + b * b);
    return {a, b, size, slack_ + 50.0 * epsilon * size};
}

MomentPlane::Extrema MomentPlane::operator()(double a, double b) const {
    Extrema found{highest(up_, vector(a, b)), highest(down_, vector(-a, -b))};
    found.min.value = -found.min.value;
    found.min.moment = -found.min.moment;
    return found;
}

/// Adds the maximum of one side to a tile's ranges.
void MomentPlane::add_tile(const Side& side, const Grid& grid, std::size_t column, std::size_t row,
                           std::vector<double>& ranges) const {
    const double sign = &side == &up_ ? 1.0 : -1.0;
    const std::size_t columns = std::min(tile, grid.columns - column);
    const std::size_t rows = std::min(tile, grid.rows - row);
    const auto at = [&](double i, double k) -> Vector {
        const double a = sign * (grid.origin[0] + i * grid.along[0] + k * grid.across[0]);
        const double b = sign * (grid.origin[1] + i * grid.along[1] + k * grid.across[1]);
        return vector(a, b);
    };
    const double half_column = (static_cast<double>(columns) - 1.0) / 2.0;
    const double half_row = (static_cast<double>(rows) - 1.0) / 2.0;
    const auto first_column = static_cast<double>(column);
    const auto first_row = static_cast<double>(row);
    const Vector middle = at(first_column + half_column, first_row + half_row);
    const double radius = half_column * std::hypot(grid.along[0], grid.along[1]) +
                          half_row * std::hypot(grid.across[0], grid.across[1]);
    const Place best = highest(side, middle);
    // From the middle to another place of the tile a knot gains on the best by at most the distance
    // of their directions times that of the places; the sine's bow grows with its size.
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
    const double size = middle.size + radius;
    for (Eigen::Index k = 0; k < cos_.size(); k += lanes) {
        if (stretches_.size() > 0 && k % KnotStretches::length == 0) {
            const auto stretch = static_cast<std::size_t>(k / KnotStretches::length);
            const double reach = side.stretch_peak[stretch] +
                                 stretches_.sine(stretch, middle.a, middle.b).high + middle.slack +
                                 side.stretch_above[stretch] + size * stretch_chord_[stretch];
            if (best.value - middle.slack - reach > 2.0 * radius * (1.0 + 1e-9)) {
                k += KnotStretches::length - lanes;
                continue;
            }
        }
        const Lanes below = best.value - middle.slack -
                            (side.peak.segment<lanes>(k) + middle.a * cos_.segment<lanes>(k) +
                             middle.b * sin_.segment<lanes>(k) + side.above.segment<lanes>(k) +
                             size * chord_beside_.segment<lanes>(k));
        const Lanes apart =
            2.0 * radius * radius *
            (1.0 + 1e-9 - best.cos * cos_.segment<lanes>(k) - best.sin * sin_.segment<lanes>(k));
        const Eigen::Array<bool, lanes, 1> candidates = below <= 0.0 || below.square() <= apart;
        if (!candidates.any()) {
            continue;
        }
        const Eigen::Index end =
            std::min<Eigen::Index>(lanes, static_cast<Eigen::Index>(count_) - k);
        for (Eigen::Index i = 0; i < end; ++i) {
            if (candidates[i]) {
                near.knots.push_back(static_cast<std::size_t>(k + i));
                near.peak.push_back(side.peak[k + i]);
                near.cos.push_back(cos_[k + i]);
                near.sin.push_back(sin_[k + i]);
                near.above.push_back(side.above[k + i]);
                near.chord.push_back(chord_beside_[k + i]);
            }
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
    for (std::size_t k = 0; k < rows; ++k) {
        double* const out = &ranges[(row + k) * grid.columns + column];
        for (std::size_t i = 0; i < columns; ++i) {
            const Vector here =
                at(first_column + static_cast<double>(i), first_row + static_cast<double>(k));
            value = peak + here.a * cosines + here.b * sines;
            const double top = value.maxCoeff();
            value += above + here.size * chord;
            Place highest;
            highest.value = -std::numeric_limits<double>::infinity();
            std::size_t searched = count_;
            for (Eigen::Index n = 0; n < count; ++n) {
                if (value[n] + here.slack < std::max(top, highest.value)) {
                    continue;
                }
                const std::size_t j = near.knots[static_cast<std::size_t>(n)];
                for (const std::size_t interval : {j == 0 ? count_ - 1 : j - 1, j}) {
                    if (interval == searched) {
                        continue;
                    }
                    for (std::size_t m = turns_ * interval; m < turns_ * (interval + 1); ++m) {
                        search_branch(side.branches[m], here, highest);
                    }
                }
                searched = j;
            }
            out[i] += highest.value;
        }
    }
}

std::vector<double> MomentPlane::ranges(const Grid& grid) const {
    std::vector<double> ranges(grid.columns * grid.rows, 0.0);
    for (std::size_t row = 0; row < grid.rows; row += tile) {
        for (std::size_t column = 0; column < grid.columns; column += tile) {
            add_tile(up_, grid, column, row, ranges);
            add_tile(down_, grid, column, row, ranges);
        }
    }
    return ranges;
}

}  // namespace ravnoves::balance_shaft

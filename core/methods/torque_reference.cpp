#include "methods/torque_reference.h"

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

const Real50& exact_degree() {
    return boost::math::constants::degree<Real50>();
}

/// Second derivatives of the periodic cubic spline at the rows x[0]…x[n − 1], by relaxation: the
/// system of slope continuity is dominated by its diagonal, so every pass gains half a digit.
std::vector<Real50> spline_bends(const std::vector<Real50>& x, const std::vector<Real50>& y) {
    const std::size_t n = x.size() - 1;
    std::vector<Real50> bend(n, Real50(0));
    constexpr int passes = 120;
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t before = i == 0 ? n - 1 : i - 1;
            const Real50 left = x[before + 1] - x[before];
            const Real50 right = x[i + 1] - x[i];
            const Real50 jump = (y[i + 1] - y[i]) / right - (y[before + 1] - y[before]) / left;
            bend[i] =
                (6 * jump - left * bend[before] - right * bend[(i + 1) % n]) / (2 * (left + right));
        }
    }
    return bend;
}

}  // namespace

template <typename Scalar>
Scalar TorqueReference::Piece<Scalar>::value(const Scalar& t) const {
    const Scalar b = t / width;
    const Scalar a = 1 - b;
    return a * y0 + b * y1 +
           ((a * a * a - a) * bend0 + (b * b * b - b) * bend1) * width * width / 6;
}

template <typename Scalar>
Scalar TorqueReference::Piece<Scalar>::slope(const Scalar& t) const {
    const Scalar b = t / width;
    const Scalar a = 1 - b;
    return (y1 - y0) / width + ((3 * b * b - 1) * bend1 - (3 * a * a - 1) * bend0) * width / 6;
}

TorqueReference::TorqueReference(const TorqueCycle& cycle)
    : cubic_(cycle.cubic),
      amplitude_(cycle.amplitude),
      size_(cycle.size()),
      alpha_(Real50(cycle.alpha)) {
    const std::vector<Real50> x(cycle.angle_deg.begin(), cycle.angle_deg.end());
    const std::vector<Real50> y(cycle.moment.begin(), cycle.moment.end());
    const std::size_t n = x.size() - 1;
    const std::vector<Real50> bend = cubic_ ? spline_bends(x, y) : std::vector<Real50>(n);
    for (std::size_t i = 0; i < n; ++i) {
        exact_.push_back({x[i], x[i + 1] - x[i], y[i], y[i + 1], bend[i], bend[(i + 1) % n]});
        const Piece<Real50>& piece = exact_.back();
        const auto plain = [](const Real50& value) { return static_cast<double>(value); };
        pieces_.push_back({plain(piece.start), plain(piece.width), plain(piece.y0), plain(piece.y1),
                           plain(piece.bend0), plain(piece.bend1)});
        const Piece<double>& p = pieces_.back();
        const double curvature =
            std::max(std::abs(p.bend0), std::abs(p.bend1)) + std::abs(amplitude_) * degree * degree;
        const int parts = std::max(static_cast<int>(std::ceil(p.width)), 1);
        for (int k = 0; k < parts; ++k) {
            const Cell cell{i, p.width * k / parts, p.width * (k + 1) / parts, curvature};
            cells_.push_back(cell);
            const double angle = (p.start + cell.from) * degree;
            start_.push_back(p.value(cell.from));
            sine_.push_back(std::sin(angle));
            cosine_.push_back(std::cos(angle));
        }
    }
}

Real50 TorqueReference::mean() const {
    Real50 sum(0);
    for (const Piece<Real50>& p : exact_) {
        sum += p.width * (p.y0 + p.y1) / 2 - p.width * p.width * p.width * (p.bend0 + p.bend1) / 24;
    }
    return sum / Real50(cycle_deg);
}

Real50 TorqueReference::rms() const {
    Real50 square(0);
    for (const Piece<Real50>& p : exact_) {
        const Real50 k = p.width * p.width / 6;
        square += p.width * ((p.y0 * p.y0 + p.y0 * p.y1 + p.y1 * p.y1) / 3 -
                             k * (4 * (p.y0 * p.bend0 + p.y1 * p.bend1) / 15 +
                                  7 * (p.y0 * p.bend1 + p.y1 * p.bend0) / 30) +
                             k * k *
                                 (8 * (p.bend0 * p.bend0 + p.bend1 * p.bend1) / 105 +
                                  31 * p.bend0 * p.bend1 / 210));
    }
    square /= Real50(cycle_deg);
    const Real50 amplitude(amplitude_);
    const Real50 average = mean();
    const auto order = first_order();
    const Real50 variance =
        square - average * average +
        amplitude * (amplitude / 2 + order.a * sin(alpha_) + order.b * cos(alpha_));
    return variance > 0 ? Real50(sqrt(variance)) : Real50(0);
}

BasicFourierPair<Real50> TorqueReference::first_order() const {
    // ∮ M sin φ dφ = −∮ M″ sin = ∮ M⁗ sin, and the last one that is not 0 is jumps alone.
    BasicFourierPair<Real50> order;
    for (std::size_t i = 0; i < exact_.size(); ++i) {
        const Piece<Real50>& after = exact_[i];
        const Piece<Real50>& before = exact_[i == 0 ? exact_.size() - 1 : i - 1];
        const auto jump = [&](const auto& of) { return Real50(of(after) - of(before)); };
        Real50 strength;
        if (cubic_) {
            const Real50 per_radian = 1 / exact_degree();
            strength = jump([](const auto& p) { return Real50((p.bend1 - p.bend0) / p.width); }) *
                       per_radian * per_radian * per_radian;
        } else {
            strength = -jump([](const auto& p) { return Real50((p.y1 - p.y0) / p.width); }) /
                       exact_degree();
        }
        const Real50 angle = after.start * exact_degree();
        order.a += strength * cos(angle);
        order.b += strength * sin(angle);
    }
    const Real50& turn = boost::math::constants::two_pi<Real50>();
    return {order.a / turn, order.b / turn};
}

// ----------------------------------------------------------------------------------- extrema

double TorqueReference::height(const Cell& cell, double t, double alpha, double sign) const {
    const Piece<double>& piece = pieces_[cell.piece];
    return sign * (piece.value(t) + amplitude_ * std::sin((piece.start + t) * degree + alpha));
}

void TorqueReference::look_within(const Cell& cell, double alpha, double sign, double enough,
                                  std::vector<Candidate>& found) const {
    const Piece<double>& piece = pieces_[cell.piece];
    const double width = cell.to - cell.from;
    const double rise = cell.curvature * width * width / 8.0;  // above the larger end, at most
    const double end =
        std::max(height(cell, cell.from, alpha, sign), height(cell, cell.to, alpha, sign));
    constexpr double rounding = 1e-22;
    if (end + rise < enough || !(rise > rounding * size_)) {
        return;
    }
    const auto slope = [&](double t) {
        return sign * (piece.slope(t) +
                       amplitude_ * degree * std::cos((piece.start + t) * degree + alpha));
    };
    const double middle = std::midpoint(cell.from, cell.to);
    const double bend = piece.bend(middle) - amplitude_ * degree * degree *
                                                 std::sin((piece.start + middle) * degree + alpha);
    const double change = std::abs(piece.bend1 - piece.bend0) / piece.width +
                          std::abs(amplitude_) * degree * degree * degree;
    if (!(std::abs(bend) > change * width / 2.0)) {  // the slope may turn back within
        look_within({cell.piece, cell.from, middle, cell.curvature}, alpha, sign, enough, found);
        look_within({cell.piece, middle, cell.to, cell.curvature}, alpha, sign, enough, found);
        return;
    }
    double from = cell.from;
    double to = cell.to;
    if (!(slope(from) >= 0.0 && slope(to) <= 0.0)) {
        return;
    }
    for (int i = 0; i < 60; ++i) {
        const double t = std::midpoint(from, to);
        (slope(t) > 0.0 ? from : to) = t;
    }
    found.push_back({cell.piece, true, from, height(cell, from, alpha, sign)});
}

std::vector<TorqueReference::Candidate> TorqueReference::candidates(double alpha, double sign,
                                                                    double part) const {
    const double x = amplitude_ * std::sin(alpha);
    const double y = amplitude_ * std::cos(alpha);
    std::vector<double> node(cells_.size() + 1);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        node[i] = sign * (start_[i] + x * cosine_[i] + y * sine_[i]);
    }
    node.back() = node.front();
    const double best = *std::max_element(node.begin(), node.end());
    const double margin = part * size_;
    std::vector<Candidate> found;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const Cell& cell = cells_[i];
        const double width = cell.to - cell.from;
        if (cell.from == 0.0 && node[i] >= best - margin) {
            found.push_back({cell.piece, false, 0.0, node[i]});
        }
        const double rise = cell.curvature * width * width / 8.0;
        if (std::max(node[i], node[i + 1]) + rise >= best - margin) {
            look_within(cell, alpha, sign, best - margin, found);
        }
    }
    double highest = best;
    for (const Candidate& candidate : found) {
        highest = std::max(highest, candidate.height);
    }
    std::erase_if(found,
                  [&](const Candidate& candidate) { return candidate.height < highest - margin; });
    return found;
}

TorqueReference::Extremum TorqueReference::followed(Extremum extremum, const Real50& alpha) const {
    const Piece<Real50>& piece = exact_[extremum.piece];
    const Real50& degree = exact_degree();
    const Real50 amplitude(amplitude_);
    const auto angle = [&] { return Real50((piece.start + extremum.t) * degree + alpha); };
    constexpr int most = 12;
    const Real50 least = Real50("1e-48") * piece.width;
    for (int i = 0; extremum.interior && i < most; ++i) {
        const Real50 slope = piece.slope(extremum.t) + amplitude * degree * cos(angle());
        const Real50 bend = piece.bend(extremum.t) - amplitude * degree * degree * sin(angle());
        if (bend == 0) {
            break;
        }
        const Real50 step = slope / bend;
        extremum.t -= step;
        if (abs(step) < least) {
            break;
        }
    }
    extremum.value = piece.value(extremum.t) + amplitude * sin(angle());
    extremum.slope = amplitude * cos(angle());
    return extremum;
}

TorqueReference::Extremum TorqueReference::extremum(const Real50& alpha, double sign) const {
    Extremum best;
    bool first = true;
    for (const Candidate& candidate : candidates(static_cast<double>(alpha), sign)) {
        Extremum polished =
            followed({candidate.piece, candidate.interior, Real50(candidate.t), {}, {}}, alpha);
        if (first || sign * polished.value > sign * best.value) {
            best = std::move(polished);
            first = false;
        }
    }
    return best;
}

TorqueReference::At TorqueReference::at(const Real50& alpha) const {
    return {alpha, extremum(alpha, 1.0), extremum(alpha, -1.0)};
}

Real50 TorqueReference::range(const Real50& alpha) const {
    return at(alpha).range();
}

// -------------------------------------------------------------------------------- best angle

double TorqueReference::plain_range(double alpha) const {
    double range = 0.0;
    for (const double sign : {1.0, -1.0}) {
        double best = -std::numeric_limits<double>::infinity();
        for (const Candidate& candidate : candidates(alpha, sign)) {
            best = std::max(best, candidate.height);
        }
        range += best;
    }
    return range;
}

double TorqueReference::plain_slope(double alpha) const {
    double slope = 0.0;
    for (const double sign : {1.0, -1.0}) {
        const auto found = candidates(alpha, sign);
        const auto best =
            std::max_element(found.begin(), found.end(),
                             [](const auto& a, const auto& b) { return a.height < b.height; });
        if (best != found.end()) {
            const double angle = (pieces_[best->piece].start + best->t) * degree;
            slope += sign * amplitude_ * std::cos(angle + alpha);
        }
    }
    return slope;
}

TorqueReference::At TorqueReference::followed(const At& branch, const Real50& alpha) const {
    return {alpha, followed(branch.high, alpha), followed(branch.low, alpha)};
}

Real50 TorqueReference::lowest(const At& left, const At& right) const {
    const bool one_branch = left.high.is_branch_of(right.high) && left.low.is_branch_of(right.low);
    constexpr int most = 12;
    const Real50 least("1e-48");
    if (one_branch) {
        // The secant through the slopes.
        Real50 a = left.alpha;
        Real50 b = right.alpha;
        Real50 slope_a = left.slope();
        Real50 slope_b = right.slope();
        for (int i = 0; i < most && slope_a != slope_b && abs(Real50(b - a)) > least; ++i) {
            const Real50 next = b - slope_b * (b - a) / (slope_b - slope_a);
            a = b;
            slope_a = slope_b;
            b = next;
            slope_b = followed(left, b).slope();
        }
        return b;
    }
    Real50 alpha = (left.alpha + right.alpha) / 2;
    for (int i = 0; i < most; ++i) {
        const At a = followed(left, alpha);
        const At b = followed(right, alpha);
        if (a.slope() == b.slope()) {
            break;
        }
        const Real50 step = (a.range() - b.range()) / (a.slope() - b.slope());
        alpha -= step;
        if (abs(step) < least) {
            break;
        }
    }
    return alpha;
}

Real50 TorqueReference::least_between(double from, double to) const {
    // In double first, as far as its slopes can be told from rounding.
    constexpr double resolution = 1e-9;
    for (int i = 0; i < 60 && to - from > resolution; ++i) {
        const double middle = std::midpoint(from, to);
        (plain_slope(middle) < 0.0 ? from : to) = middle;
    }
    At left = at(Real50(from));
    At right = at(Real50(to));
    Real50 least = std::min(left.range(), right.range());
    const Real50 enough = Real50("1e-46") * Real50(size_);
    constexpr int most = 200;
    for (int i = 0; i < most && left.slope() < 0 && right.slope() > 0; ++i) {
        Real50 alpha = lowest(left, right);
        const bool within = alpha > left.alpha && alpha < right.alpha;
        if (!within) {
            alpha = (left.alpha + right.alpha) / 2;
        }
        const At found = at(alpha);
        least = std::min(least, found.range());
        // No other branch rises above the two there.
        if ((within && found.range() - followed(left, alpha).range() <= enough) ||
            right.alpha - left.alpha < enough / Real50(size_)) {
            break;
        }
        (found.slope() < 0 ? left : right) = found;
    }
    return least;
}

Real50 TorqueReference::least_range() const {
    struct Interval {
        double from, to, at_from, at_to;
        double least_possible(double steepest) const {
            return 0.5 * (at_from + at_to - steepest * (to - from));
        }
    };
    const double steepest = 2.0 * std::abs(amplitude_);
    constexpr int first_angles = 720;
    std::vector<Interval> open;
    double best = std::numeric_limits<double>::infinity();
    double last = plain_range(0.0);
    for (int i = 0; i < first_angles; ++i) {
        const double to = two_pi * (i + 1) / first_angles;
        const double next = plain_range(to);
        open.push_back({two_pi * i / first_angles, to, last, next});
        last = next;
        best = std::min(best, next);
    }
    const double margin = 1e-11 * size_;
    constexpr int halvings = 6;  // down to 0.008°
    constexpr std::size_t most_open = 20'000;
    for (int pass = 0; pass < halvings && open.size() < most_open; ++pass) {
        std::vector<Interval> halves;
        for (const Interval& interval : open) {
            if (interval.least_possible(steepest) > best + margin) {
                continue;
            }
            const double middle = std::midpoint(interval.from, interval.to);
            const double there = plain_range(middle);
            best = std::min(best, there);
            halves.push_back({interval.from, middle, interval.at_from, there});
            halves.push_back({middle, interval.to, there, interval.at_to});
        }
        open = std::move(halves);
    }
    std::erase_if(open, [&](const Interval& interval) {
        return interval.least_possible(steepest) > best + margin;
    });
    // Every local minimum among what is left.
    Real50 least = range(Real50(0));
    std::size_t begin = 0;
    while (begin < open.size()) {
        std::size_t end = begin + 1;
        while (end < open.size() && open[end].from == open[end - 1].to) {
            ++end;
        }
        for (std::size_t i = begin; i < end; ++i) {
            const bool falls = i == begin || open[i].at_from <= open[i - 1].at_from;
            const bool rises = i + 1 == end || open[i].at_from < open[i + 1].at_from;
            if (falls && rises) {
                const double width = open[i].to - open[i].from;
                least = std::min(least, least_between(open[i].from - width, open[i].to + width));
            }
        }
        begin = end;
    }
    return least;
}

// -------------------------------------------------------------------------------- best place

void TorqueReference::set_amplitude(double amplitude) {
    const double change = (std::abs(amplitude) - std::abs(amplitude_)) * degree * degree;
    for (Cell& cell : cells_) {
        cell.curvature += change;
    }
    size_ += std::abs(amplitude) - std::abs(amplitude_);
    amplitude_ = amplitude;
}

Real50 TorqueReference::range(const Real50& a, const Real50& b) const {
    // The places in double, their values in 50 digits: a place off by 1e-9 is as good as the place.
    TorqueReference there = *this;
    const double x = static_cast<double>(a);
    const double y = static_cast<double>(b);
    there.set_amplitude(std::hypot(x, y));
    const Real50& degree = exact_degree();
    Real50 range(0);
    for (const double sign : {1.0, -1.0}) {
        bool first = true;
        Real50 best(0);
        for (const Candidate& candidate : there.candidates(std::atan2(x, y), sign)) {
            const Piece<Real50>& piece = exact_[candidate.piece];
            Real50 t(candidate.t);
            for (int i = 0; candidate.interior && i < 8; ++i) {
                const Real50 angle = (piece.start + t) * degree;
                const Real50 bend =
                    piece.bend(t) - degree * degree * (a * cos(angle) + b * sin(angle));
                if (bend == 0) {
                    break;
                }
                t -= (piece.slope(t) + degree * (b * cos(angle) - a * sin(angle))) / bend;
            }
            const Real50 angle = (piece.start + t) * degree;
            const Real50 value = sign * (piece.value(t) + a * cos(angle) + b * sin(angle));
            if (first || value > best) {
                best = value;
                first = false;
            }
        }
        range += best;
    }
    return range;
}

std::optional<Real50> TorqueReference::range_at_rest(const std::vector<Candidate>& high,
                                                     const std::vector<Candidate>& low, double a,
                                                     double b) const {
    using Matrix = Eigen::Matrix<Real50, Eigen::Dynamic, Eigen::Dynamic>;
    using Column = Eigen::Matrix<Real50, Eigen::Dynamic, 1>;
    std::vector<Candidate> all = high;
    all.insert(all.end(), low.begin(), low.end());
    const auto count = static_cast<Eigen::Index>(all.size());
    const auto highs = static_cast<Eigen::Index>(high.size());
    std::vector<Eigen::Index> moving;  // extrema within pieces, whose places are unknowns too
    for (Eigen::Index i = 0; i < count; ++i) {
        if (all[static_cast<std::size_t>(i)].interior) {
            moving.push_back(i);
        }
    }
    // a, b, highest, lowest, the weights, the moving places.
    const Eigen::Index size = 4 + count + static_cast<Eigen::Index>(moving.size());
    Column x = Column::Zero(size);
    x[0] = Real50(a);
    x[1] = Real50(b);
    for (Eigen::Index i = 0; i < count; ++i) {
        x[4 + i] = Real50(1) / (i < highs ? highs : count - highs);
    }
    for (std::size_t k = 0; k < moving.size(); ++k) {
        x[4 + count + static_cast<Eigen::Index>(k)] =
            Real50(all[static_cast<std::size_t>(moving[k])].t);
    }
    const Real50& degree = exact_degree();
    const Real50 scale(size_);
    constexpr int most = 14;
    Real50 change(1);
    for (int step = 0; step < most && change > Real50("1e-46"); ++step) {
        Matrix rates = Matrix::Zero(size, size);
        Column rest = Column::Zero(size);
        Eigen::Index place = 4 + count;
        for (Eigen::Index i = 0; i < count; ++i) {
            const Candidate& one = all[static_cast<std::size_t>(i)];
            const Piece<Real50>& piece = exact_[one.piece];
            const Real50 t = one.interior ? x[place] : Real50(one.t);
            const Real50 angle = (piece.start + t) * degree;
            const Real50 c = cos(angle);
            const Real50 s = sin(angle);
            const bool is_high = i < highs;
            const Real50 sign(is_high ? 1 : -1);
            // Row i: of one height. Rows count…: the weights add up to 1 and hold each other.
            rest[i] = piece.value(t) + x[0] * c + x[1] * s - x[is_high ? 2 : 3];
            rates(i, 0) = c;
            rates(i, 1) = s;
            rates(i, is_high ? 2 : 3) = Real50(-1);
            rest[count + (is_high ? 0 : 1)] += x[4 + i];
            rates(count + (is_high ? 0 : 1), 4 + i) = Real50(1);
            rest[count + 2] += sign * x[4 + i] * c;
            rest[count + 3] += sign * x[4 + i] * s;
            rates(count + 2, 4 + i) = sign * c;
            rates(count + 3, 4 + i) = sign * s;
            if (one.interior) {
                const Real50 slope = piece.slope(t) + degree * (x[1] * c - x[0] * s);
                rates(i, place) = slope;
                rates(count + 2, place) = -sign * x[4 + i] * s * degree;
                rates(count + 3, place) = sign * x[4 + i] * c * degree;
                rest[place] = slope;
                rates(place, 0) = -degree * s;
                rates(place, 1) = degree * c;
                rates(place, place) = piece.bend(t) - degree * degree * (x[0] * c + x[1] * s);
                ++place;
            }
        }
        rest[count] -= 1;
        rest[count + 1] -= 1;
        const Eigen::FullPivLU<Matrix> lu(rates);
        if (!lu.isInvertible()) {
            return std::nullopt;
        }
        const Column moved = lu.solve(rest);
        x -= moved;
        change = Real50(0);
        for (Eigen::Index i = 0; i < size; ++i) {
            change = std::max(change, Real50(abs(moved[i]) / (i < 4 ? scale : Real50(1))));
        }
    }
    if (!(change <= Real50("1e-40"))) {
        return std::nullopt;
    }
    for (Eigen::Index i = 0; i < count; ++i) {
        if (x[4 + i] < Real50("-1e-30")) {
            return std::nullopt;
        }
    }
    // No other extremum is beyond them.
    const Real50 range_there = x[2] - x[3];
    if (abs(Real50(range(x[0], x[1]) - range_there)) > Real50("1e-38") * scale) {
        return std::nullopt;
    }
    return range_there;
}

Real50 TorqueReference::least_range_of_all() const {
    TorqueReference here = *this;
    here.set_amplitude(0.0);
    const double reach = here.plain_range(0.0);
    Eigen::Vector2d at(0.0, 0.0);
    Eigen::Vector2d best_at = at;
    double best = std::numeric_limits<double>::infinity();
    Eigen::Matrix2d ellipse = reach * reach * Eigen::Matrix2d::Identity();
    constexpr int most = 420;
    for (int i = 0; i < most; ++i) {
        here.set_amplitude(at.norm());
        const double alpha = std::atan2(at.x(), at.y());
        Eigen::Vector2d slope(0.0, 0.0);
        double range = 0.0;
        for (const double sign : {1.0, -1.0}) {
            const auto found = here.candidates(alpha, sign, 0.0);
            const auto top =
                std::max_element(found.begin(), found.end(),
                                 [](const auto& a, const auto& b) { return a.height < b.height; });
            const double angle = (pieces_[top->piece].start + top->t) * degree;
            slope += sign * Eigen::Vector2d(std::cos(angle), std::sin(angle));
            range += top->height;
        }
        if (range < best) {
            best = range;
            best_at = at;
        }
        const double along = std::sqrt(slope.dot(ellipse * slope));
        if (!(along > 1e-17 * reach)) {
            break;
        }
        const Eigen::Vector2d step = ellipse * slope / along;
        at -= step / 3.0;
        ellipse = 4.0 / 3.0 * (ellipse - 2.0 / 3.0 * step * step.transpose());
        ellipse(1, 0) = ellipse(0, 1);
    }
    const double alpha = std::atan2(best_at.x(), best_at.y());
    here.set_amplitude(best_at.norm());
    // Rows that are no extrema of their own, and one place found from two cells, are left out.
    const auto extrema_of = [&](double sign, double part) {
        std::vector<Candidate> found;
        for (const Candidate& one : here.candidates(alpha, sign, part)) {
            const auto place = [&](const Candidate& of) { return pieces_[of.piece].start + of.t; };
            const auto slope = [&](std::size_t piece, double t) {
                return sign * (pieces_[piece].slope(t) +
                               here.amplitude_ * degree * std::cos(place(one) * degree + alpha));
            };
            const std::size_t before = (one.piece == 0 ? pieces_.size() : one.piece) - 1;
            constexpr double flat = 1e-9;
            const bool is_kink = one.interior || (slope(before, pieces_[before].width) > flat &&
                                                  slope(one.piece, 0.0) < -flat);
            if (is_kink && std::none_of(found.begin(), found.end(), [&](const Candidate& other) {
                    return std::abs(place(other) - place(one)) < 1e-6;
                })) {
                found.push_back(one);
            }
        }
        return found;
    };
    constexpr std::size_t most_extrema = 6;
    for (const double part : {1e-11, 1e-9, 1e-7, 1e-5, 1e-4}) {
        const std::vector<Candidate> high = extrema_of(1.0, part);
        const std::vector<Candidate> low = extrema_of(-1.0, part);
        if (high.size() > most_extrema || low.size() > most_extrema) {
            break;
        }
        // All choices of them with at most four together.
        for (unsigned i = 1; i < 1u << high.size(); ++i) {
            for (unsigned k = 1; k < 1u << low.size(); ++k) {
                if (std::popcount(i) + std::popcount(k) > 4) {
                    continue;
                }
                const auto chosen = [](const std::vector<Candidate>& from, unsigned which) {
                    std::vector<Candidate> some;
                    for (std::size_t n = 0; n < from.size(); ++n) {
                        if ((which >> n & 1u) != 0) {
                            some.push_back(from[n]);
                        }
                    }
                    return some;
                };
                if (const auto found = here.range_at_rest(chosen(high, i), chosen(low, k),
                                                          best_at.x(), best_at.y())) {
                    return *found;
                }
            }
        }
    }
    return range(Real50(best_at.x()), Real50(best_at.y()));
}

}  // namespace ravnoves::methods

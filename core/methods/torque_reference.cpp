#include "methods/torque_reference.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numeric>

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

/// Nodes and weights of Gauss-Legendre on 0…1.
std::vector<std::array<Real50, 2>> gauss_rule() {
    using Gauss = boost::math::quadrature::gauss<Real50, 15>;
    std::vector<std::array<Real50, 2>> rule;
    for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
        const Real50& x = Gauss::abscissa()[k];
        rule.push_back({(1 + x) / 2, Gauss::weights()[k] / 2});
        if (x > 0) {
            rule.push_back({(1 - x) / 2, Gauss::weights()[k] / 2});
        }
    }
    return rule;
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
    : amplitude_(cycle.amplitude), size_(cycle.size()), alpha_(Real50(cycle.alpha)) {
    const std::vector<Real50> x(cycle.angle_deg.begin(), cycle.angle_deg.end());
    const std::vector<Real50> y(cycle.moment.begin(), cycle.moment.end());
    const std::size_t n = x.size() - 1;
    const std::vector<Real50> bend = cycle.cubic ? spline_bends(x, y) : std::vector<Real50>(n);
    for (std::size_t i = 0; i < n; ++i) {
        exact_.push_back({x[i], x[i + 1] - x[i], y[i], y[i + 1], bend[i], bend[(i + 1) % n]});
        const Piece<Real50>& piece = exact_.back();
        const auto plain = [](const Real50& value) { return static_cast<double>(value); };
        pieces_.push_back({plain(piece.start), plain(piece.width), plain(piece.y0), plain(piece.y1),
                           plain(piece.bend0), plain(piece.bend1)});
        const Piece<double>& p = pieces_.back();
        const int parts = std::max(static_cast<int>(std::ceil(2.0 * p.width)), 1);
        for (int k = 0; k < parts; ++k) {
            for (const int end : {k, k + 1}) {
                const double t = p.width * end / parts;
                const double angle = (p.start + t) * degree;
                ends_.push_back({i, t, p.value(t), p.slope(t), std::sin(angle), std::cos(angle)});
            }
        }
    }
}

TorqueReference::Means TorqueReference::means() const {
    static const auto rule = gauss_rule();
    const Real50 x = Real50(amplitude_) * sin(alpha_);
    const Real50 y = Real50(amplitude_) * cos(alpha_);
    Means sums{Real50(0), Real50(0), Real50(0), Real50(0)};
    constexpr double longest = 15.0;  // °: with so many nodes, exact to more than 50 digits
    for (const Piece<Real50>& piece : exact_) {
        const int parts = static_cast<int>(std::ceil(static_cast<double>(piece.width) / longest));
        const Real50 width = piece.width / parts;
        for (int part = 0; part < parts; ++part) {
            for (const auto& [place, weight] : rule) {
                const Real50 t = width * (part + place);
                const Real50 angle = (piece.start + t) * exact_degree();
                const Real50 c = cos(angle);
                const Real50 s = sin(angle);
                const Real50 moment = piece.value(t);
                const Real50 sum = moment + x * c + y * s;
                const Real50 w = weight * width / Real50(cycle_deg);
                sums.mean += w * sum;
                sums.rms += w * sum * sum;
                sums.first_cos += 2 * w * moment * c;
                sums.first_sin += 2 * w * moment * s;
            }
        }
    }
    const Real50 variance = sums.rms - sums.mean * sums.mean;
    sums.rms = variance > 0 ? Real50(sqrt(variance)) : Real50(0);
    return sums;
}

std::vector<TorqueReference::Candidate> TorqueReference::candidates(double a, double b,
                                                                    double sign) const {
    const auto height = [&](const End& end) {
        return sign * (end.value + a * end.cosine + b * end.sine);
    };
    const auto slope = [&](std::size_t piece, double t) {
        const double angle = (pieces_[piece].start + t) * degree;
        return sign *
               (pieces_[piece].slope(t) + degree * (b * std::cos(angle) - a * std::sin(angle)));
    };
    double best = -std::numeric_limits<double>::infinity();
    for (const End& end : ends_) {
        best = std::max(best, height(end));
    }
    const double margin = 1e-9 * size_;
    std::vector<Candidate> found;
    for (std::size_t i = 0; i < ends_.size(); i += 2) {
        const End& left = ends_[i];
        const End& right = ends_[i + 1];
        if (left.t == 0.0 && height(left) >= best - margin) {
            found.push_back({left.piece, false, 0.0, height(left)});
        }
        const double rise = sign * (left.slope + degree * (b * left.cosine - a * left.sine));
        const double fall = -sign * (right.slope + degree * (b * right.cosine - a * right.sine));
        if (!(rise >= 0.0 && fall >= 0.0 && rise + fall > 0.0) ||
            std::max(height(left) + rise * (right.t - left.t),
                     height(right) + fall * (right.t - left.t)) < best - margin) {
            continue;
        }
        double from = left.t;
        double to = right.t;
        for (int k = 0; k < 50; ++k) {
            const double t = std::midpoint(from, to);
            (slope(left.piece, t) > 0.0 ? from : to) = t;
        }
        const double angle = (pieces_[left.piece].start + from) * degree;
        const double top =
            sign * (pieces_[left.piece].value(from) + a * std::cos(angle) + b * std::sin(angle));
        found.push_back({left.piece, true, from, top});
        best = std::max(best, top);
    }
    std::erase_if(found, [&](const Candidate& one) { return one.height < best - margin; });
    return found;
}

TorqueReference::Range TorqueReference::range(const Real50& a, const Real50& b) const {
    const Real50& degree = exact_degree();
    Range sum{Real50(0), Real50(0), Real50(0)};
    for (const double sign : {1.0, -1.0}) {
        bool first = true;
        Range best{};
        for (const Candidate& one :
             candidates(static_cast<double>(a), static_cast<double>(b), sign)) {
            const Piece<Real50>& piece = exact_[one.piece];
            Real50 t(one.t);
            constexpr int maximum = 8;
            for (int i = 0; one.interior && i < maximum; ++i) {
                const Real50 angle = (piece.start + t) * degree;
                const Real50 c = cos(angle);
                const Real50 s = sin(angle);
                const Real50 bend = piece.bend(t) - degree * degree * (a * c + b * s);
                const Real50 step =
                    bend == 0 ? Real50(0)
                              : Real50((piece.slope(t) + degree * (b * c - a * s)) / bend);
                t -= step;
                if (abs(step) < Real50("1e-25")) {
                    break;  // the next one would be its square
                }
            }
            const Real50 angle = (piece.start + t) * degree;
            const Real50 c = cos(angle);
            const Real50 s = sin(angle);
            const Real50 value = sign * (piece.value(t) + a * c + b * s);
            if (first || value > best.range) {
                best = {value, sign * c, sign * s};
                first = false;
            }
        }
        sum.range += best.range;
        sum.by_cos += best.by_cos;
        sum.by_sin += best.by_sin;
    }
    return sum;
}

TorqueReference::Range TorqueReference::range(const Real50& alpha) const {
    const Real50 amplitude(amplitude_);
    return range(amplitude * sin(alpha), amplitude * cos(alpha));
}

double TorqueReference::plain_range(double alpha) const {
    double range = 0.0;
    for (const double sign : {1.0, -1.0}) {
        double best = -std::numeric_limits<double>::infinity();
        for (const Candidate& one :
             candidates(amplitude_ * std::sin(alpha), amplitude_ * std::cos(alpha), sign)) {
            best = std::max(best, one.height);
        }
        range += best;
    }
    return range;
}

Real50 TorqueReference::min_range() const {
    constexpr int angles = 1440;
    std::vector<double> scan;
    for (int i = 0; i < angles; ++i) {
        scan.push_back(plain_range(two_pi * i / angles));
    }
    const double steepest = 2.0 * std::abs(amplitude_) * two_pi / angles;  // over one step
    const double best = *std::min_element(scan.begin(), scan.end());
    Real50 minimum = range(Real50(0)).range;
    for (int i = 0; i < angles; ++i) {
        const auto at = [&](int k) {
            return scan[static_cast<std::size_t>((k + angles) % angles)];
        };
        // Of equal neighbours the first; where all are equal, any angle is the best.
        if (at(i) >= at(i - 1) || at(i) > at(i + 1) || at(i) - steepest > best) {
            continue;
        }
        // Between the neighbours the slope goes from falling to rising.
        Real50 from(two_pi * (i - 1) / angles);
        Real50 to(two_pi * (i + 1) / angles);
        constexpr int halvings = 100;
        for (int k = 0; k < halvings; ++k) {
            const Real50 alpha = (from + to) / 2;
            const Range here = range(alpha);
            minimum = std::min(minimum, here.range);
            (here.by_cos * cos(alpha) < here.by_sin * sin(alpha) ? from : to) = alpha;
        }
    }
    return minimum;
}

Real50 TorqueReference::min_range_of_all() const {
    // The range is convex in a and b, and no best place is farther than the range without shaft.
    Real50 a(0);
    Real50 b(0);
    Range here = range(a, b);
    Real50 minimum = here.range;
    Real50 aa = here.range * here.range;  // the ellipse's matrix
    Real50 ab(0);
    Real50 bb = aa;
    constexpr int maximum = 1000;
    for (int i = 0; i < maximum; ++i) {
        const Real50 step_a = aa * here.by_cos + ab * here.by_sin;
        const Real50 step_b = ab * here.by_cos + bb * here.by_sin;
        const Real50 square = here.by_cos * step_a + here.by_sin * step_b;
        // No range is below this one less the root.
        if (!(square > Real50("1e-44") * Real50(size_) * Real50(size_))) {
            break;
        }
        const Real50 root = sqrt(square);
        a -= step_a / root / 3;
        b -= step_b / root / 3;
        aa = (4 * aa - 8 * step_a * step_a / square / 3) / 3;
        ab = (4 * ab - 8 * step_a * step_b / square / 3) / 3;
        bb = (4 * bb - 8 * step_b * step_b / square / 3) / 3;
        here = range(a, b);
        minimum = std::min(minimum, here.range);
    }
    return minimum;
}

}  // namespace ravnoves::methods

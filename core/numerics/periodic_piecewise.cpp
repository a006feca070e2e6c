#include "numerics/periodic_piecewise.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace ravnoves {

namespace {

/// ∫ tᵏ cos t dt over (−d, d) for k = 0, 2 and ∫ tᵏ sin t dt for k = 1, 3, by their power series:
/// no cancellation for short pieces, and d ≤ 1 needs few terms.
struct TrigonometricMoments {
    double cos_0, sin_1, cos_2, sin_3;

    explicit TrigonometricMoments(double d) : cos_0(0), sin_1(0), cos_2(0), sin_3(0) {
        double even = 2.0 * d;         // 2 (−1)ʲ d^(2j+1) / (2j)!
        double odd = 2.0 * d * d * d;  // 2 (−1)ʲ d^(2j+3) / (2j+1)!
        for (int j = 0; j < 12; ++j) {
            const int n = 2 * j;
            cos_0 += even / (n + 1);
            cos_2 += even * d * d / (n + 3);
            sin_1 += odd / (n + 3);
            sin_3 += odd * d * d / (n + 5);
            even *= -d * d / ((n + 1) * (n + 2));
            odd *= -d * d / ((n + 2) * (n + 3));
        }
    }
};

}  // namespace

PeriodicPiecewise PeriodicPiecewise::linear(std::span<const double> x, std::span<const double> y) {
    assert(x.size() == y.size() && x.size() >= 2);
    PeriodicPiecewise f;
    f.knots_.assign(x.begin(), x.end());
    f.pieces_.reserve(x.size() - 1);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        f.pieces_.push_back({y[i], (y[i + 1] - y[i]) / (x[i + 1] - x[i]), 0.0, 0.0});
    }
    return f;
}

PeriodicPiecewise PeriodicPiecewise::cubic(std::span<const double> x, std::span<const double> y) {
    assert(x.size() == y.size() && x.size() >= 2);
    const std::size_t n = x.size() - 1;
    // Unknowns: the second derivatives at the knots, in the symmetric, diagonally dominant system
    // of slope continuity; row i couples to its neighbours, the last row to the first.
    using Index = Eigen::Index;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Index>(n));
    for (std::size_t i = 0; i < n; ++i) {
        const double h = x[i + 1] - x[i];
        const double slope = (y[i + 1] - y[i]) / h;
        const auto row = static_cast<int>(i);
        const auto next = static_cast<int>((i + 1) % n);
        entries.emplace_back(row, row, h / 3.0);
        entries.emplace_back(next, next, h / 3.0);
        entries.emplace_back(row, next, h / 6.0);
        entries.emplace_back(next, row, h / 6.0);
        right[row] += slope;
        right[next] -= slope;
    }
    Eigen::SparseMatrix<double> matrix(static_cast<Index>(n), static_cast<Index>(n));
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success) {
        throw std::logic_error("the periodic spline's system is singular");
    }
    const Eigen::VectorXd curvature = solver.solve(right);

    PeriodicPiecewise f;
    f.linear_ = false;
    f.knots_.assign(x.begin(), x.end());
    f.pieces_.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double h = x[i + 1] - x[i];
        const double left = curvature[static_cast<Index>(i)];
        const double next = curvature[static_cast<Index>((i + 1) % n)];
        f.pieces_.push_back({y[i], (y[i + 1] - y[i]) / h - h * (2.0 * left + next) / 6.0,
                             left / 2.0, (next - left) / (6.0 * h)});
    }
    return f;
}

PeriodicPiecewise::Place PeriodicPiecewise::find(double x) const {
    const double first = knots_.front();
    const double last = knots_.back();
    if (!(x >= first && x < last)) {
        x = first + std::fmod(x - first, last - first);
        if (x < first) {
            x += last - first;
        }
        x = std::clamp(x, first, std::nextafter(last, first));
    }
    const auto next = std::upper_bound(knots_.begin(), knots_.end(), x);
    const auto piece =
        std::min(static_cast<std::size_t>(next - knots_.begin()) - 1, pieces_.size() - 1);
    return {piece, x - knots_[piece]};
}

double PeriodicPiecewise::operator()(double x) const {
    const Place place = find(x);
    return pieces_[place.piece].value(place.t);
}

double PeriodicPiecewise::mean() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Cubic& p = pieces_[i];
        const double h = knots_[i + 1] - knots_[i];
        sum += h * (p.y + h * (p.c1 / 2.0 + h * (p.c2 / 3.0 + h * p.c3 / 4.0)));
    }
    return sum / period();
}

double PeriodicPiecewise::variance() const {
    const double centre = mean();
    double sum = 0.0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const double h = knots_[i + 1] - knots_[i];
        // Exact: a square of a cubic has degree 6, the rule integrates degree 13.
        sum += boost::math::quadrature::gauss<double, 7>::integrate(
            [&](double t) {
                const double y = pieces_[i].value(t) - centre;
                return y * y;
            },
            0.0, h);
    }
    return sum / period();
}

FourierPair PeriodicPiecewise::fourier(double angular_frequency) const {
    const double w = angular_frequency;
    FourierPair sum;
    TrigonometricMoments moments(0.0);
    double half_of_moments = 0.0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const double h = knots_[i + 1] - knots_[i];
        const int parts = std::max(1, static_cast<int>(std::ceil(h * w / 2.0)));
        const double half = h / parts / 2.0;
        if (half != half_of_moments) {
            moments = TrigonometricMoments(half * w);
            half_of_moments = half;
        }
        for (int part = 0; part < parts; ++part) {
            const double middle = half * (2 * part + 1);
            const Cubic p = pieces_[i].shifted(middle);
            // With τ = ωt about the middle m: cos(ωm + τ) and sin(ωm + τ) by addition; odd
            // products vanish over (−d, d).
            const double even = (p.y * moments.cos_0 + p.c2 / (w * w) * moments.cos_2) / w;
            const double odd = (p.c1 / w * moments.sin_1 + p.c3 / (w * w * w) * moments.sin_3) / w;
            const double phase = w * (knots_[i] + middle);
            const double c = std::cos(phase);
            const double s = std::sin(phase);
            sum.a += c * even - s * odd;
            sum.b += s * even + c * odd;
        }
    }
    return {2.0 * sum.a / period(), 2.0 * sum.b / period()};
}

}  // namespace ravnoves

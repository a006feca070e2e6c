#include "numerics/periodic_piecewise.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/demand.h"

namespace ravnoves {

namespace {

/// ∫ tᵏ cos t dt over (−d, d) for k = 0, 2 and ∫ tᵏ sin t dt for k = 1, 3, by their power series:
/// no cancellation for short pieces, and d ≤ 1 needs few terms.
struct TrigonometricMoments {
    double cos_0 = 0.0, sin_1 = 0.0, cos_2 = 0.0, sin_3 = 0.0;

    explicit TrigonometricMoments(double d) {
        constexpr int terms = 12;
        const double minimum = std::numeric_limits<double>::epsilon() * d / 1000;
        double even = 2 * d;         // 2 (−1)ʲ d^(2j+1) / (2j)!
        double odd = 2 * d * d * d;  // 2 (−1)ʲ d^(2j+3) / (2j+1)!
        for (int j = 0; j < terms; ++j) {
            const int n = 2 * j;
            cos_0 += even / (n + 1);
            cos_2 += even * d * d / (n + 3);
            sin_1 += odd / (n + 3);
            sin_3 += odd * d * d / (n + 5);
            if (n > 0 && -even < minimum && even < minimum) {
                break;  // short pieces need few terms
            }
            even *= -d * d / ((n + 1) * (n + 2));
            odd *= -d * d / ((n + 2) * (n + 3));
        }
    }
};

}  // namespace

PeriodicPiecewise PeriodicPiecewise::linear(std::span<const double> x, std::span<const double> y) {
    RAVNOVES_DEMAND(x.size() == y.size() && x.size() >= 2, "as many values as knots, two at least");
    PeriodicPiecewise f;
    f.knots_.assign(x.begin(), x.end());
    f.pieces_.reserve(x.size() - 1);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        f.pieces_.push_back({y[i], (y[i + 1] - y[i]) / (x[i + 1] - x[i]), 0.0, 0.0});
    }
    return f;
}

PeriodicPiecewise PeriodicPiecewise::cubic(std::span<const double> x, std::span<const double> y) {
    RAVNOVES_DEMAND(x.size() == y.size() && x.size() >= 2, "as many values as knots, two at least");
    const std::size_t n = x.size() - 1;
    // Unknowns: the second derivatives at the knots, in the symmetric, diagonally dominant system
    // of slope continuity; row i couples to its neighbours, the last row to the first.
    using Index = Eigen::Index;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1>;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * n);
    Vector right = Vector::Zero(static_cast<Index>(n));
    for (std::size_t i = 0; i < n; ++i) {
        const double h = x[i + 1] - x[i];
        const double slope = (y[i + 1] - y[i]) / h;
        const auto row = static_cast<int>(i);
        const auto next = static_cast<int>((i + 1) % n);
        entries.emplace_back(row, row, h / 3);
        entries.emplace_back(next, next, h / 3);
        entries.emplace_back(row, next, h / 6);
        entries.emplace_back(next, row, h / 6);
        right[row] += slope;
        right[next] -= slope;
    }
    Eigen::SparseMatrix<double> matrix(static_cast<Index>(n), static_cast<Index>(n));
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    RAVNOVES_DEMAND(solver.info() == Eigen::Success, "the periodic spline's system is regular");
    const Vector curvature = solver.solve(right);

    PeriodicPiecewise f;
    f.knots_.assign(x.begin(), x.end());
    f.pieces_.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double h = x[i + 1] - x[i];
        const double left = curvature[static_cast<Index>(i)];
        const double next = curvature[static_cast<Index>((i + 1) % n)];
        f.pieces_.push_back({y[i], (y[i + 1] - y[i]) / h - h * (2 * left + next) / 6, left / 2,
                             (next - left) / (6 * h)});
    }
    return f;
}

PeriodicPiecewise PeriodicPiecewise::through(const std::function<double(double)>& f,
                                             std::vector<double> x) {
    RAVNOVES_DEMAND(x.size() >= 2, "two knots at least");
    PeriodicPiecewise result;
    result.knots_ = std::move(x);
    const std::size_t n = result.knots_.size() - 1;
    result.pieces_.reserve(n);
    const double first = f(result.knots_.front());
    double value = first;
    for (std::size_t i = 0; i < n; ++i) {
        double left = result.knots_[i];
        const double h = result.knots_[i + 1] - left;
        const double next = i + 1 < n ? f(result.knots_[i + 1]) : first;
        const double third = f(left + h / 3);
        const double two_thirds = f(left + 2 * h / 3);
        // Newton's forward differences over steps of h/3.
        const double d1 = third - value;
        const double d2 = two_thirds - 2 * third + value;
        const double d3 = next - 3 * two_thirds + 3 * third - value;
        const double per_step = 3 / h;
        result.pieces_.push_back({value, (d1 - d2 / 2 + d3 / 3) * per_step,
                                  (d2 - d3) / 2 * per_step * per_step,
                                  d3 / 6 * per_step * per_step * per_step});
        value = next;
    }
    return result;
}

PeriodicPiecewise PeriodicPiecewise::negated() const {
    PeriodicPiecewise result = *this;
    for (Cubic& piece : result.pieces_) {
        // Not the sign alone: a zero keeps its own.
        piece = {0 - piece.y, 0 - piece.c1, 0 - piece.c2, 0 - piece.c3};
    }
    return result;
}

PeriodicPiecewise PeriodicPiecewise::sum(const PeriodicPiecewise& f, const PeriodicPiecewise& g,
                                         double factor) {
    RAVNOVES_DEMAND(f.knots_ == g.knots_, "both functions have the same knots");
    PeriodicPiecewise result = f;
    for (std::size_t i = 0; i < f.pieces_.size(); ++i) {
        Cubic& piece = result.pieces_[i];
        const Cubic& other = g.pieces_[i];
        piece.y += factor * other.y;
        piece.c1 += factor * other.c1;
        piece.c2 += factor * other.c2;
        piece.c3 += factor * other.c3;
    }
    return result;
}

PeriodicPiecewise::Place PeriodicPiecewise::find(double x) const {
    const double first = knots_.front();
    const double last = knots_.back();
    if (!(x >= first && x < last)) {
        x = first + std::fmod(x - first, last - first);
        if (x < first) {
            x += last - first;
        }
        x = std::clamp(x, first, last);
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
        sum += h * (p.y + h * (p.c1 / 2 + h * (p.c2 / 3 + h * p.c3 / 4)));
    }
    return sum / period();
}

double PeriodicPiecewise::variance() const {
    const double centre = mean();
    double sum = 0.0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const double h = knots_[i + 1] - knots_[i];
        // About the middle, over −d…d, odd powers of the square vanish.
        const Cubic p = pieces_[i].shifted(h / 2);
        const double y = p.y - centre;
        const double square = h * h / 4;
        sum += h * (y * y + square * ((p.c1 * p.c1 + 2 * y * p.c2) / 3 +
                                      square * ((p.c2 * p.c2 + 2 * p.c1 * p.c3) / 5 +
                                                square * p.c3 * p.c3 / 7)));
    }
    return sum / period();
}

FourierPair PeriodicPiecewise::fourier(double angular_frequency) const {
    return fourier_series(angular_frequency, 1).front();
}

std::vector<FourierPair> PeriodicPiecewise::fourier_series(double angular_frequency,
                                                           std::size_t count) const {
    std::vector<FourierPair> sums(count);
    std::vector<TrigonometricMoments> moments;
    double half_of_moments = 0.0;
    const double highest = angular_frequency * static_cast<double>(count);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const double h = knots_[i + 1] - knots_[i];
        const int parts = std::max(1, static_cast<int>(std::ceil(h * highest / 2)));
        const double half = h / parts / 2;
        if (half != half_of_moments) {
            moments.clear();
            for (std::size_t k = 1; k <= count; ++k) {
                moments.emplace_back(half * angular_frequency * static_cast<double>(k));
            }
            half_of_moments = half;
        }
        for (int part = 0; part < parts; ++part) {
            const double middle = half * (2 * part + 1);
            // With τ = ωt about the middle m: cos(ωm + τ) and sin(ωm + τ) by addition;
            // odd products vanish over (−d, d).
            const Cubic p = pieces_[i].shifted(middle);
            const double phase = angular_frequency * (knots_[i] + middle);
            const double c_1 = std::cos(phase);
            const double s_1 = std::sin(phase);
            double c = c_1;
            double s = s_1;
            for (std::size_t k = 0; k < count; ++k) {
                const TrigonometricMoments& m = moments[k];
                const double w = angular_frequency * static_cast<double>(k + 1);
                const double even = (p.y * m.cos_0 + p.c2 / (w * w) * m.cos_2) / w;
                const double odd = (p.c1 / w * m.sin_1 + p.c3 / (w * w * w) * m.sin_3) / w;
                sums[k].a += c * even - s * odd;
                sums[k].b += s * even + c * odd;
                const double next = c * c_1 - s * s_1;
                s = s * c_1 + c * s_1;
                c = next;
            }
        }
    }
    for (auto& sum : sums) {
        sum.a = 2 * sum.a / period();
        sum.b = 2 * sum.b / period();
    }
    return sums;
}

}  // namespace ravnoves

#include "numerics/periodic_piecewise.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/demand.h"
#include "numerics/real50.h"

namespace ravnoves {

namespace {

/// ∫ tᵏ cos t dt over (−d, d) for k = 0, 2 and ∫ tᵏ sin t dt for k = 1, 3, by their power series:
/// no cancellation for short pieces, and d ≤ 1 needs few terms. Straight lines need the first two
/// alone, whose closed forms lose nothing but digits of the line's rise.
template <typename Scalar>
struct TrigonometricMoments {
    Scalar cos_0, sin_1, cos_2, sin_3;

    TrigonometricMoments(const Scalar& d, bool linear) : cos_0(0), sin_1(0), cos_2(0), sin_3(0) {
        if (linear) {
            using std::cos;
            using std::sin;
            const Scalar s = sin(d);
            cos_0 = 2 * s;
            sin_1 = 2 * (s - d * Scalar(cos(d)));
            return;
        }
        constexpr int terms = std::numeric_limits<Scalar>::digits10 > 20 ? 26 : 12;
        const Scalar least = std::numeric_limits<Scalar>::epsilon() * d / 1000;
        Scalar even = 2 * d;         // 2 (−1)ʲ d^(2j+1) / (2j)!
        Scalar odd = 2 * d * d * d;  // 2 (−1)ʲ d^(2j+3) / (2j+1)!
        for (int j = 0; j < terms; ++j) {
            const int n = 2 * j;
            cos_0 += even / (n + 1);
            cos_2 += even * d * d / (n + 3);
            sin_1 += odd / (n + 3);
            sin_3 += odd * d * d / (n + 5);
            if (n > 0 && -even < least && even < least) {
                break;  // short pieces need few terms
            }
            even *= -d * d / ((n + 1) * (n + 2));
            odd *= -d * d / ((n + 2) * (n + 3));
        }
    }
};

}  // namespace

template <typename Scalar>
BasicPeriodicPiecewise<Scalar> BasicPeriodicPiecewise<Scalar>::linear(std::span<const Scalar> x,
                                                                      std::span<const Scalar> y) {
    RAVNOVES_DEMAND(x.size() == y.size() && x.size() >= 2, "as many values as knots, two at least");
    BasicPeriodicPiecewise f;
    f.knots_.assign(x.begin(), x.end());
    f.pieces_.reserve(x.size() - 1);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        f.pieces_.push_back({y[i], (y[i + 1] - y[i]) / (x[i + 1] - x[i]), Scalar(0), Scalar(0)});
    }
    return f;
}

template <typename Scalar>
BasicPeriodicPiecewise<Scalar> BasicPeriodicPiecewise<Scalar>::cubic(std::span<const Scalar> x,
                                                                     std::span<const Scalar> y) {
    RAVNOVES_DEMAND(x.size() == y.size() && x.size() >= 2, "as many values as knots, two at least");
    const std::size_t n = x.size() - 1;
    // Unknowns: the second derivatives at the knots, in the symmetric, diagonally dominant system
    // of slope continuity; row i couples to its neighbours, the last row to the first.
    using Index = Eigen::Index;
    using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    std::vector<Eigen::Triplet<Scalar>> entries;
    entries.reserve(4 * n);
    Vector right = Vector::Zero(static_cast<Index>(n));
    for (std::size_t i = 0; i < n; ++i) {
        const Scalar h = x[i + 1] - x[i];
        const Scalar slope = (y[i + 1] - y[i]) / h;
        const auto row = static_cast<int>(i);
        const auto next = static_cast<int>((i + 1) % n);
        entries.emplace_back(row, row, h / 3);
        entries.emplace_back(next, next, h / 3);
        entries.emplace_back(row, next, h / 6);
        entries.emplace_back(next, row, h / 6);
        right[row] += slope;
        right[next] -= slope;
    }
    Eigen::SparseMatrix<Scalar> matrix(static_cast<Index>(n), static_cast<Index>(n));
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<Scalar>> solver(matrix);
    RAVNOVES_DEMAND(solver.info() == Eigen::Success, "the periodic spline's system is regular");
    const Vector curvature = solver.solve(right);

    BasicPeriodicPiecewise f;
    f.linear_ = false;
    f.knots_.assign(x.begin(), x.end());
    f.pieces_.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Scalar h = x[i + 1] - x[i];
        const Scalar& left = curvature[static_cast<Index>(i)];
        const Scalar& next = curvature[static_cast<Index>((i + 1) % n)];
        f.pieces_.push_back({y[i], (y[i + 1] - y[i]) / h - h * (2 * left + next) / 6, left / 2,
                             (next - left) / (6 * h)});
    }
    return f;
}

template <typename Scalar>
BasicPeriodicPiecewise<Scalar> BasicPeriodicPiecewise<Scalar>::through(
    const std::function<Scalar(const Scalar&)>& f, std::vector<Scalar> x) {
    RAVNOVES_DEMAND(x.size() >= 2, "two knots at least");
    BasicPeriodicPiecewise result;
    result.linear_ = false;
    result.knots_ = std::move(x);
    const std::size_t n = result.knots_.size() - 1;
    result.pieces_.reserve(n);
    const Scalar first = f(result.knots_.front());
    Scalar value = first;
    for (std::size_t i = 0; i < n; ++i) {
        const Scalar& left = result.knots_[i];
        const Scalar h = result.knots_[i + 1] - left;
        const Scalar next = i + 1 < n ? f(result.knots_[i + 1]) : first;
        const Scalar third = f(left + h / 3);
        const Scalar two_thirds = f(left + 2 * h / 3);
        // Newton's forward differences over steps of h/3.
        const Scalar d1 = third - value;
        const Scalar d2 = two_thirds - 2 * third + value;
        const Scalar d3 = next - 3 * two_thirds + 3 * third - value;
        const Scalar per_step = 3 / h;
        result.pieces_.push_back({value, (d1 - d2 / 2 + d3 / 3) * per_step,
                                  (d2 - d3) / 2 * per_step * per_step,
                                  d3 / 6 * per_step * per_step * per_step});
        value = next;
    }
    return result;
}

template <typename Scalar>
BasicPeriodicPiecewise<Scalar> BasicPeriodicPiecewise<Scalar>::negated() const {
    BasicPeriodicPiecewise result = *this;
    for (Cubic& piece : result.pieces_) {
        // Not the sign alone: a zero keeps its own.
        piece = {0 - piece.y, 0 - piece.c1, 0 - piece.c2, 0 - piece.c3};
    }
    return result;
}

template <typename Scalar>
BasicPeriodicPiecewise<Scalar> BasicPeriodicPiecewise<Scalar>::sum(const BasicPeriodicPiecewise& f,
                                                                   const BasicPeriodicPiecewise& g,
                                                                   const Scalar& factor) {
    RAVNOVES_DEMAND(f.knots_ == g.knots_, "both functions have the same knots");
    BasicPeriodicPiecewise result = f;
    result.linear_ = f.linear_ && g.linear_;
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

template <typename Scalar>
BasicPeriodicPiecewise<Scalar> BasicPeriodicPiecewise<Scalar>::refined(
    const Scalar& longest) const {
    using std::ceil;
    BasicPeriodicPiecewise result;
    result.linear_ = linear_;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Scalar h = knots_[i + 1] - knots_[i];
        const int parts = std::max(1, static_cast<int>(ceil(Scalar(h / longest))));
        for (int part = 0; part < parts; ++part) {
            const Scalar t = h * part / parts;
            result.knots_.push_back(knots_[i] + t);
            result.pieces_.push_back(pieces_[i].shifted(t));
        }
    }
    result.knots_.push_back(knots_.back());
    return result;
}

template <typename Scalar>
typename BasicPeriodicPiecewise<Scalar>::Place BasicPeriodicPiecewise<Scalar>::find(
    Scalar x) const {
    const Scalar first = knots_.front();
    const Scalar last = knots_.back();
    if (!(x >= first && x < last)) {
        using std::fmod;
        x = first + fmod(Scalar(x - first), Scalar(last - first));
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

template <typename Scalar>
Scalar BasicPeriodicPiecewise<Scalar>::operator()(const Scalar& x) const {
    const Place place = find(x);
    return pieces_[place.piece].value(place.t);
}

template <typename Scalar>
Scalar BasicPeriodicPiecewise<Scalar>::mean() const {
    Scalar sum(0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Cubic& p = pieces_[i];
        const Scalar h = knots_[i + 1] - knots_[i];
        sum += h * (p.y + h * (p.c1 / 2 + h * (p.c2 / 3 + h * p.c3 / 4)));
    }
    return sum / period();
}

template <typename Scalar>
Scalar BasicPeriodicPiecewise<Scalar>::variance() const {
    const Scalar centre = mean();
    Scalar sum(0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Scalar h = knots_[i + 1] - knots_[i];
        // About the middle, over −d…d, odd powers of the square vanish.
        const Cubic p = pieces_[i].shifted(h / 2);
        const Scalar y = p.y - centre;
        const Scalar square = h * h / 4;
        sum += h * (y * y + square * ((p.c1 * p.c1 + 2 * y * p.c2) / 3 +
                                      square * ((p.c2 * p.c2 + 2 * p.c1 * p.c3) / 5 +
                                                square * p.c3 * p.c3 / 7)));
    }
    return sum / period();
}

template <typename Scalar>
BasicFourierPair<Scalar> BasicPeriodicPiecewise<Scalar>::fourier(
    const Scalar& angular_frequency) const {
    using std::ceil;
    using std::cos;
    using std::sin;
    const Scalar& w = angular_frequency;
    BasicFourierPair<Scalar> sum;
    TrigonometricMoments<Scalar> moments(Scalar(0), linear_);
    Scalar half_of_moments(0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Scalar h = knots_[i + 1] - knots_[i];
        const int parts = std::max(1, static_cast<int>(ceil(Scalar(h * w / 2))));
        const Scalar half = h / parts / 2;
        if (half != half_of_moments) {
            moments = TrigonometricMoments<Scalar>(half * w, linear_);
            half_of_moments = half;
        }
        for (int part = 0; part < parts; ++part) {
            const Scalar middle = half * (2 * part + 1);
            const Cubic p = pieces_[i].shifted(middle);
            // With τ = ωt about the middle m: cos(ωm + τ) and sin(ωm + τ) by addition; odd
            // products vanish over (−d, d).
            const Scalar even = (p.y * moments.cos_0 + p.c2 / (w * w) * moments.cos_2) / w;
            const Scalar odd = (p.c1 / w * moments.sin_1 + p.c3 / (w * w * w) * moments.sin_3) / w;
            const Scalar phase = w * (knots_[i] + middle);
            const Scalar c = cos(phase);
            const Scalar s = sin(phase);
            sum.a += c * even - s * odd;
            sum.b += s * even + c * odd;
        }
    }
    return {2 * sum.a / period(), 2 * sum.b / period()};
}

template <typename Scalar>
std::vector<BasicFourierPair<Scalar>> BasicPeriodicPiecewise<Scalar>::fourier_series(
    const Scalar& angular_frequency, std::size_t count) const {
    using std::ceil;
    using std::cos;
    using std::sin;
    std::vector<BasicFourierPair<Scalar>> sums(count);
    std::vector<TrigonometricMoments<Scalar>> moments;
    Scalar half_of_moments(0);
    const Scalar highest = angular_frequency * static_cast<double>(count);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const Scalar h = knots_[i + 1] - knots_[i];
        const int parts = std::max(1, static_cast<int>(ceil(Scalar(h * highest / 2))));
        const Scalar half = h / parts / 2;
        if (half != half_of_moments) {
            moments.clear();
            for (std::size_t k = 1; k <= count; ++k) {
                moments.emplace_back(half * angular_frequency * static_cast<double>(k), linear_);
            }
            half_of_moments = half;
        }
        for (int part = 0; part < parts; ++part) {
            const Scalar middle = half * (2 * part + 1);
            const Cubic p = pieces_[i].shifted(middle);
            const Scalar phase = angular_frequency * (knots_[i] + middle);
            const Scalar c_1 = cos(phase);
            const Scalar s_1 = sin(phase);
            Scalar c = c_1;
            Scalar s = s_1;
            for (std::size_t k = 0; k < count; ++k) {
                const TrigonometricMoments<Scalar>& m = moments[k];
                const Scalar w = angular_frequency * static_cast<double>(k + 1);
                const Scalar even = (p.y * m.cos_0 + p.c2 / (w * w) * m.cos_2) / w;
                const Scalar odd = (p.c1 / w * m.sin_1 + p.c3 / (w * w * w) * m.sin_3) / w;
                sums[k].a += c * even - s * odd;
                sums[k].b += s * even + c * odd;
                const Scalar next = c * c_1 - s * s_1;
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

template class BasicPeriodicPiecewise<double>;
template class BasicPeriodicPiecewise<Real50>;

}  // namespace ravnoves

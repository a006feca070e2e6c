#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace ravnoves {

/// min c·v over the v with aᵢ·v ≥ bᵢ, while constraints are added: the dual simplex method, which
/// continues from the last vertex. For a few variables and some hundred constraints.
///
/// @tparam N  variables
template <typename Scalar, int N>
class CuttingPlanes {
  public:
    using Vector = Eigen::Matrix<Scalar, N, 1>;

    struct Constraint {
        Vector a;
        Scalar b = Scalar(0);
    };

    /// @param first  N constraints that meet in one point from which c cannot fall: c is a sum of
    ///               their a with factors of at least 0
    /// @param tolerance  what a constraint may be short of
    CuttingPlanes(const Vector& cost, const std::vector<Constraint>& first, const Scalar& tolerance)
        : cost_(cost), planes_(first), tolerance_(tolerance) {
        planes_.reserve(64);
        for (int k = 0; k < N; ++k) {
            basis_[static_cast<std::size_t>(k)] = static_cast<std::size_t>(k);
        }
        meet();
    }

    void add(const Vector& a, const Scalar& b) { planes_.push_back({a, b}); }

    /// @return the best vertex; its cost is a lower bound
    const Vector& solve() {
        const Scalar rounding = 16 * std::numeric_limits<Scalar>::epsilon();
        for (int pivots = 0; pivots < 200; ++pivots) {
            std::size_t entering = planes_.size();
            Scalar worst = tolerance_;
            for (std::size_t i = 0; i < planes_.size(); ++i) {
                const Constraint& plane = planes_[i];
                const Scalar missing = plane.b - plane.a.dot(vertex_);
                if (missing > worst && !is_met(i)) {
                    worst = missing;
                    entering = i;
                }
            }
            if (entering == planes_.size()) {
                break;
            }
            // v stays in the planes but one; that one leaves whose factor falls to 0 first.
            const Vector rates = rows_.transpose().solve(planes_[entering].a);
            int leaving = -1;
            Scalar minimum(0);
            for (int k = 0; k < N; ++k) {
                if (rates[k] > rounding) {
                    const Scalar ratio = factors_[k] / rates[k];
                    if (leaving < 0 || ratio < minimum ||
                        (ratio == minimum && rates[k] > rates[leaving])) {
                        leaving = k;
                        minimum = ratio;
                    }
                }
            }
            if (leaving < 0) {
                break;
            }
            const auto old = basis_[static_cast<std::size_t>(leaving)];
            const Vector before = vertex_;
            basis_[static_cast<std::size_t>(leaving)] = entering;
            meet();
            if (!(cost_.dot(vertex_) >= cost_.dot(before) - 64 * tolerance_)) {  // rounding
                basis_[static_cast<std::size_t>(leaving)] = old;
                meet();
                break;
            }
        }
        return vertex_;
    }

  private:
    bool is_met(std::size_t plane) const {
        return std::find(basis_.begin(), basis_.end(), plane) != basis_.end();
    }

    /// Planes may be nearly parallel: an LU decomposition leaves small residuals all the same.
    void meet() {
        Eigen::Matrix<Scalar, N, N> rows;
        Vector right;
        for (int k = 0; k < N; ++k) {
            const Constraint& plane = planes_[basis_[static_cast<std::size_t>(k)]];
            rows.row(k) = plane.a.transpose();
            right[k] = plane.b;
        }
        rows_.compute(rows);
        vertex_ = rows_.solve(right);
        factors_ = rows_.transpose().solve(cost_);
    }

    Vector cost_;
    std::vector<Constraint> planes_;
    Scalar tolerance_;
    std::array<std::size_t, static_cast<std::size_t>(N)> basis_{};
    Eigen::PartialPivLU<Eigen::Matrix<Scalar, N, N>> rows_;  ///< of the planes in basis_
    Vector vertex_;
    Vector factors_;  ///< of the planes that meet in the vertex, ≥ 0
};

}  // namespace ravnoves

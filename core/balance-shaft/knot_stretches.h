#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace ravnoves::balance_shaft {

/// Thousands of knots in the order of their angles, taken together in stretches: the least and the
/// greatest that a sine can be in a stretch are known without a look at its knots, so that for the
/// extrema of a value and a sine only the stretches near the best are gone through.
class KnotStretches {
  public:
    static constexpr Eigen::Index length = 512;  ///< knots; the last stretch has what is left
    /// So few knots are gone through as fast as stretches are.
    static constexpr std::size_t few = 2048;

    /// @param knots  rad, ascending
    explicit KnotStretches(std::span<const double> knots);
    KnotStretches() = default;

    /// 0 where there are few knots.
    std::size_t size() const { return stretches_.size(); }
    struct Bounds {
        double low;
        double high;
    };
    /// Of a cos φ + b sin φ in a stretch, up to rounding.
    Bounds sine(std::size_t stretch, double a, double b) const;

    /// The greatest and the least value of each stretch; values beyond the last knot are padding.
    std::vector<double> greatest(const Eigen::ArrayXd& values) const;
    std::vector<double> least(const Eigen::ArrayXd& values) const;

  private:
    struct Stretch {
        double cos, sin;            ///< of the middle
        double cos_half, sin_half;  ///< the least cosine and the greatest sine from there
        Eigen::Index first, count;
    };
    std::vector<Stretch> stretches_;
};

}  // namespace ravnoves::balance_shaft

#pragma once

#include <array>
#include <cstddef>

#include "numerics/periodic_piecewise.h"

namespace ravnoves {

/// Up to 12 places on an interval, ascending.
class Places {
  public:
    void push_back(double x) {
        if (count_ < places_.size()) {
            places_[count_++] = x;
        }
    }
    std::size_t size() const { return count_; }
    double operator[](std::size_t i) const { return places_[i]; }
    const double* begin() const { return places_.data(); }
    const double* end() const { return places_.data() + count_; }

  private:
    std::array<double, 12> places_{};
    std::size_t count_ = 0;
};

/// The places in (0, h) where the slope of p(t) + A sin(ωt + φ₀) changes sign, p cubic, to
/// machine accuracy and none left out: the third derivative's zeros are known in closed form,
/// between them the second is monotone, and between the second's zeros the first is.
/// @param h  0 ≤ ωh ≤ 2π, so that there are at most 12 places at each level
Places stationary_points(const PiecewiseCubic& p, double amplitude, double angular_frequency,
                         double phase, double h);

}  // namespace ravnoves

#pragma once

#include <array>
#include <cstddef>

#include "numerics/periodic_piecewise.h"

namespace ravnoves {

/// Up to 12 places on an interval, ascending.
template <typename Scalar>
class BasicPlaces {
  public:
    void push_back(const Scalar& x) {
        if (count_ < places_.size()) {
            places_[count_++] = x;
        }
    }
    std::size_t size() const { return count_; }
    const Scalar& operator[](std::size_t i) const { return places_[i]; }
    const Scalar* begin() const { return places_.data(); }
    const Scalar* end() const { return places_.data() + count_; }

  private:
    std::array<Scalar, 12> places_{};
    std::size_t count_ = 0;
};
using Places = BasicPlaces<double>;

/// The places in (0, h) where the slope of p(t) + A sin(ωt + φ₀) changes sign, p cubic, to machine
/// accuracy and none left out: the third derivative's zeros are known in closed form, between them
/// the second is monotone, and between the second's zeros the first is. Made for double and for
/// Real50.
/// @param h  0 ≤ ωh ≤ 2π, so that there are at most 12 places at each level
template <typename Scalar>
BasicPlaces<Scalar> stationary_points(const PiecewiseCubic<Scalar>& p, const Scalar& amplitude,
                                      const Scalar& angular_frequency, const Scalar& phase,
                                      const Scalar& h);

}  // namespace ravnoves

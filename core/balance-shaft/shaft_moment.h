#pragma once

#include <Eigen/Core>
#include <cmath>

namespace ravnoves::balance_shaft {

/// Between the place of the shaft's axis in the front view and its moment M_s = a cos φ + b sin φ =
/// P₁ l sin(α + φ + phase): a turn by the phase and P₁ as the scale. Place (x, y) in m, moment
/// (a, b) in N·m, or of anything that is in proportion to P₁.
class ShaftMoment {
  public:
    ShaftMoment() = default;
    /// @param force  P₁, N
    /// @param phase  Solver::shaft_phase(), rad
    ShaftMoment(double force, double phase)
        : force_(force), cos_(std::cos(phase)), sin_(std::sin(phase)) {}

    double force() const { return force_; }
    Eigen::Vector2d at(const Eigen::Vector2d& place) const {
        return force_ * Eigen::Vector2d(place.x() * cos_ + place.y() * sin_,
                                        place.y() * cos_ - place.x() * sin_);
    }
    /// The force must not be 0.
    Eigen::Vector2d place(const Eigen::Vector2d& moment) const { return turned(moment) / force_; }
    /// The gradient of a criterion by the place, from that by the moment.
    Eigen::Vector2d by_place(const Eigen::Vector2d& by_moment) const {
        return force_ * turned(by_moment);
    }

  private:
    Eigen::Vector2d turned(const Eigen::Vector2d& of) const {
        return {of.x() * cos_ - of.y() * sin_, of.x() * sin_ + of.y() * cos_};
    }

    double force_ = 0.0;
    double cos_ = 1.0;
    double sin_ = 0.0;
};

}  // namespace ravnoves::balance_shaft

#pragma once

#include <Eigen/Core>
#include <optional>

#include "balance-shaft/envelope.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

/// All that the rod's centre line covers over a turn: the segments between crankpin and piston pin.
class RodSweep {
  public:
    explicit RodSweep(const FrontView& view);

    struct Nearest {
        double distance = 0.0;  ///< m
        double x = 0.0;         ///< the place on the rod, m
        double y = 0.0;
    };
    /// To any of the segments, to rounding.
    Nearest nearest(double x, double y) const;
    double distance(double x, double y) const { return nearest(x, y).distance; }
    /// nearest(x, y) where its distance is less than `needed`, mostly for the price of a comparison
    /// where it is not.
    std::optional<Nearest> nearer_than(double x, double y, double needed) const;

  private:
    /// The rod at one crank angle.
    struct Rod {
        double x = 0.0, y = 0.0;              ///< crankpin, m
        double along_x = 0.0, along_y = 0.0;  ///< to the piston pin, m
    };
    static constexpr Eigen::Index samples = 96;
    static constexpr double step = two_pi / samples;
    using Column = Eigen::Array<double, samples, 1>;

    Rod rod_at(double theta) const;
    /// Of the distance from one rod, m².
    double square(const Rod& rod, double x, double y) const;
    Rod lowest_beside(Eigen::Index sample, double x, double y) const;
    /// Squares of the distances of all samples; returns the smallest.
    double squares(double x, double y, Column& out) const;

    SliderCrank<double> crank_;
    double per_length2_ = 0.0;  ///< 1/L², 0 for no rod
    double motion_ = 0.0;       ///< most that a place of the rod moves in one step, m
    Column x_, y_, along_x_, along_y_;
};

}  // namespace ravnoves::balance_shaft

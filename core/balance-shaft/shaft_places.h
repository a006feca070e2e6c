#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <optional>
#include <vector>

#include "balance-shaft/clearance.h"
#include "balance-shaft/envelope.h"
#include "case-file/message.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

/// All that the rod's centre line covers over a turn: the segments between crankpin and piston pin.
class RodSweep {
  public:
    explicit RodSweep(const FrontView& view);

    struct Nearest {
        double distance = 0.0;  ///< to any of the segments, to rounding, m
        Eigen::Vector2d place;  ///< on the rod, m
    };
    /// The nearest place where its distance is less than `needed`, mostly for the price of a
    /// comparison where it is not.
    std::optional<Nearest> nearer_than(const Eigen::Vector2d& place, double needed) const;
    double distance(const Eigen::Vector2d& place) const;

  private:
    static constexpr Eigen::Index samples = 96;
    static constexpr double step = two_pi / samples;
    using Column = Eigen::Array<double, samples, 1>;

    /// The place of the rod at a crank angle that is nearest to another, m.
    Eigen::Vector2d on_rod(double theta, const Eigen::Vector2d& place) const;

    SliderCrank<double> crank_;
    double per_length2_ = 0.0;  ///< 1/L², 0 for no rod
    double motion_ = 0.0;       ///< most that a place of the rod moves in one step, m
    Column x_, y_;              ///< crankpin, m
    Column along_x_, along_y_;  ///< from there to the piston pin, m
};

/// The places v with normal · v ≥ minimum.
struct HalfPlane {
    Eigen::Vector2d normal;
    double minimum = 0.0;
};

/// A convex polygon of few corners, counted round.
class PlacePolygon {
  public:
    explicit PlacePolygon(const Eigen::AlignedBox2d& rectangle);
    /// What would leave more corners than it has room for cuts nothing.
    void cut(const HalfPlane& by);
    /// About it, where it has corners.
    Eigen::AlignedBox2d box() const;
    std::size_t size() const { return corners_.size(); }
    const Eigen::Vector2d& operator[](std::size_t i) const { return corners_[i]; }
    auto begin() const { return corners_.begin(); }
    auto end() const { return corners_.end(); }

  private:
    static constexpr std::size_t maximum = 16;
    boost::container::static_vector<Eigen::Vector2d, 2 * maximum> corners_;
};

/// Where the shaft's axis can be, as BuildableAngles says of a circle, and within the limits given.
class ShaftPlaces {
  public:
    ShaftPlaces(const FrontView& view, const PlaceLimits& limits);

    /// @param x, y  m
    Obstacle obstacle(double x, double y) const;
    /// Of those that depend on the centre distance l alone, m.
    Obstacle obstacle_at_distance(double l) const;
    /// By how much a place clears cylinder and rod, up to rounding, and is within the limits, m.
    double spare(double x, double y) const;
    Message reason(Obstacle obstacle, double l) const;  ///< a sentence; empty: none

    const FrontView& view() const { return view_; }

    /// The feasible part of a rectangle, bounded by lines. Obstacles are round outwards or corners
    /// of round ones: seen from the rectangle's middle the nearest place q of each requires
    /// |v − q| ≥ D, and |v − q| is below its tangent plane by at most r²/(2 |middle − q|). Nothing
    /// where nothing fits.
    struct Cuts {
        std::vector<HalfPlane> outer;  ///< all feasible places are in these
        std::vector<HalfPlane> inner;  ///< places in these are mostly feasible
    };
    std::optional<Cuts> find_cuts(const Eigen::AlignedBox2d& rectangle) const;
    /// Moves a place that lacks no more than a distance to a feasible one, where it finds one.
    bool make_feasible(Eigen::Vector2d& place, double within) const;
    /// A rectangle around all feasible places within a distance of the crank's axis, m.
    Eigen::AlignedBox2d region(double distance) const;
    /// The largest centre distance that gears and limits allow; infinite where they do not.
    double farthest() const;
    /// What the sizes and limits together span, m.
    double extent() const;

  private:
    double nearest_allowed() const;
    /// The place of the cylinder with its wall that is nearest to one outside.
    Eigen::Vector2d on_cylinder(const Eigen::Vector2d& place) const;

    FrontView view_;
    PlaceLimits limits_;
    RodSweep rods_;
    double needed_ = 0.0;        ///< from cylinder, m
    double needed_rod_ = 0.0;    ///< from the rod's centre line
    double needed_crank_ = 0.0;  ///< from the crank's axis
    double gears_min_ = 0.0;     ///< l at which the gears mesh, m
    double gears_max_ = 0.0;
    double rounding_ = 0.0;  ///< m
};

}  // namespace ravnoves::balance_shaft

#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "balance-shaft/moment_plane.h"
#include "balance-shaft/shaft_places.h"

namespace ravnoves::balance_shaft {

/// A criterion at a place with a bound under it: value + gradient · δ − bend |δ|² everywhere. A
/// convex criterion has no bend.
struct PlaceValue {
    double value = 0.0;
    Eigen::Vector2d gradient{0.0, 0.0};
    double bend = 0.0;
};
using PlaceCriterion = std::function<PlaceValue(const Eigen::Vector2d&)>;

/// Another criterion that a place must not exceed, up to one part in 10⁹.
struct PlaceLimit {
    PlaceCriterion criterion;
    double maximum = 0.0;
};

/// What a search needs also.
struct PlaceQuestion {
    PlaceCriterion criterion;
    double growth = 0.0;     ///< the criterion at a distance l of the crank's axis is at least
    double at_crank = 0.0;   ///< growth × l − at_crank
    double tolerance = 0.0;  ///< wanted of the gap
    std::vector<PlaceLimit> limits;
    std::optional<Eigen::Vector2d> start;  ///< a feasible place, where known
};

/// The feasible place with the smallest value.
struct PlaceFound {
    Eigen::Vector2d place;
    double value = 0.0;
    double gap = 0.0;  ///< none is better by more than this
};

/// By branch and bound over polygons of the front view: lines bound the feasible part of a polygon
/// (ShaftPlaces::find_cuts) and its tangent plane the criterion, both to the second order in the
/// polygon's size. So the rest of a polygon after these lines and the best value shrinks
/// quadratically about the best place. Empty where nothing fits.
std::optional<PlaceFound> search_places(const ShaftPlaces& places, const PlaceQuestion& question);

/// The smallest range over all moments of the shaft, N·m; the place is that moment. By cutting
/// planes: the tangent plane at the middle of the moments left cuts off those that are no better,
/// and its smallest value over the others is a lower bound. The gap is a few roundings, or what 500
/// planes leave.
PlaceFound minimise_range(const MomentPlane& plane);

}  // namespace ravnoves::balance_shaft

#include "balance-shaft/place_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ravnoves::balance_shaft {

namespace {

using Place = Eigen::Vector2d;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double limit_rounding = 1e-9;

/// A part of the plane that is left to be searched.
struct Part {
    PlacePolygon where;
    double bound;  ///< of the criterion in it
    double size;   ///< of the polygon's box, half its diagonal, m
    /// The one of the smallest bound is searched first, of equals the smallest.
    bool operator<(const Part& other) const {
        return bound != other.bound ? bound > other.bound : size > other.size;
    }
};

struct Tangent {
    Place from;
    PlaceValue at;
    double operator()(const Place& place) const { return at.value + at.gradient.dot(place - from); }
    /// Where it is at most a value.
    HalfPlane below(double value) const {
        return {-at.gradient, at.value - value - at.gradient.dot(from)};
    }
};

Place lowest(const PlacePolygon& polygon, const Tangent& tangent) {
    return *std::ranges::min_element(polygon, {}, tangent);
}

class Search {
  public:
    Search(const ShaftPlaces& places, const PlaceQuestion& question)
        : places_(places), question_(question) {
        if (question.start) {
            offer(*question.start, 0.0);
        }
    }

    std::optional<PlaceFound> run() {
        const double start = best_.value < infinite ? enough() : 400.0 * places_.extent();
        const double distance = std::min(places_.farthest(), start);
        search(distance);
        // Where the best is not known to lie within, it does within what the best found leaves.
        if (best_.value < infinite && std::min(places_.farthest(), enough()) > distance) {
            search(std::min(places_.farthest(), enough()));
        }
        return best_.value < infinite ? std::optional(best_) : std::nullopt;
    }

  private:
    /// No place farther than this is better than the best one found.
    double enough() const {
        return (best_.value + question_.at_crank) / question_.growth * (1.0 + 1e-9);
    }

    /// @param size  of the part that it is from: lines about it miss by a small part of that
    void offer(Place place, double size) {
        constexpr double missed = 0.05;
        if (!places_.make_feasible(place, missed * size) ||
            std::ranges::any_of(question_.limits, [&](const PlaceLimit& limit) {
                return limit.criterion(place).value > limit.maximum * (1.0 + limit_rounding);
            })) {
            return;
        }
        const double value = question_.criterion(place).value;
        if (value < best_.value) {
            best_.place = place;
            best_.value = value;
        }
    }

    /// The lines that the limits draw; false where the whole rectangle exceeds one.
    bool cut_by_limits(const Place& middle, double r, ShaftPlaces::Cuts& cuts) const {
        for (const PlaceLimit& limit : question_.limits) {
            const Tangent here{middle, limit.criterion(middle)};
            const double maximum = limit.maximum * (1.0 + limit_rounding);
            const double bend = here.at.bend * r * r;
            if (here.at.value - here.at.gradient.norm() * r - bend > maximum) {
                return false;
            }
            cuts.outer.push_back(here.below(maximum + bend));
            cuts.inner.push_back(here.below(limit.maximum));
        }
        return true;
    }

    void search(double distance) {
        best_.gap = 0.0;
        const Eigen::AlignedBox2d region = places_.region(distance);
        if (region.isEmpty()) {
            return;
        }
        std::vector<Part> open;
        const auto add = [&](const PlacePolygon& where, double bound) {
            if (where.size() > 0) {
                open.push_back({where, bound, where.box().sizes().norm() / 2.0});
                std::push_heap(open.begin(), open.end());
            }
        };
        add(PlacePolygon(region), -infinite);
        const double smallest = std::max(1e-14 * distance, 1e-12 * places_.extent());
        // Where the best is all along an obstacle, parts along it never end: then less is asked
        // for, step by step.
        double tolerance = question_.tolerance;
        constexpr int many_parts = 2000;
        constexpr int max_parts = 60'000;
        for (int count = 0; !open.empty(); ++count) {
            if (count >= many_parts && count % 250 == 0) {
                tolerance *= 4.0;
            }
            std::pop_heap(open.begin(), open.end());
            const Part part = open.back();
            open.pop_back();
            if (part.bound >= best_.value - tolerance) {
                best_.gap = std::max(best_.gap, best_.value - part.bound);
                break;  // of the others too
            }
            const double r = part.size;
            if (count >= max_parts || r < smallest) {
                if (best_.value < infinite) {
                    best_.gap = std::max(best_.gap, best_.value - part.bound);
                }
                if (count >= max_parts) {
                    break;
                }
                continue;
            }
            const Eigen::AlignedBox2d box = part.where.box();
            const Place centre = box.center();
            auto cuts = places_.find_cuts(box);
            if (!cuts || !cut_by_limits(centre, r, *cuts)) {
                continue;
            }
            PlacePolygon all = part.where;
            for (const HalfPlane& line : cuts->outer) {
                all.cut(line);
            }
            if (all.size() == 0) {
                continue;
            }
            const Tangent here{centre, question_.criterion(centre)};
            const double bend = here.at.bend * r * r;
            const double bound = std::max(part.bound, here(lowest(all, here)) - bend);
            PlacePolygon surely = part.where;
            for (const HalfPlane& line : cuts->inner) {
                surely.cut(line);
            }
            offer(lowest(surely.size() > 0 ? surely : all, here), r);
            if (here.at.value < best_.value) {
                offer(centre, r);
            }
            // Where a tangent plane lies above the best value, no place is better.
            const double better = best_.value - tolerance;
            all.cut(here.below(better + bend));
            best_.gap = std::max(best_.gap, std::min(tolerance, best_.value - bound));
            if (all.size() == 0 || bound >= better) {
                continue;
            }
            // What the lines leave is searched, halved across its longer side where it is large.
            const Eigen::AlignedBox2d left = all.box();
            const Place sides = left.sizes();
            if (sides.norm() < r) {
                add(all, bound);
                continue;
            }
            const Place across = sides.x() >= sides.y() ? Place(1.0, 0.0) : Place(0.0, 1.0);
            for (const double side : {-1.0, 1.0}) {
                PlacePolygon part_of = all;
                part_of.cut({side * across, side * across.dot(left.center())});
                add(part_of, bound);
            }
        }
    }

    const ShaftPlaces& places_;
    const PlaceQuestion& question_;
    PlaceFound best_{{0.0, 0.0}, infinite, 0.0};
};

/// The centroid of the triangles from its first corner.
Place middle_of(const PlacePolygon& polygon) {
    Place sum(0.0, 0.0);
    double areas = 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const Place one = polygon[i - 1] - polygon[0];
        const Place other = polygon[i] - polygon[0];
        const double area = one.x() * other.y() - one.y() * other.x();
        sum += area * (one + other) / 3.0;
        areas += area;
    }
    return areas > 0.0 ? Place(polygon[0] + sum / areas) : polygon.box().center();
}

}  // namespace

std::optional<PlaceFound> search_places(const ShaftPlaces& places, const PlaceQuestion& question) {
    return Search(places, question).run();
}

PlaceFound minimise_range(const MomentPlane& plane) {
    PlaceFound best{{0.0, 0.0}, infinite, 0.0};
    const auto look = [&](const Place& at) {
        const MomentPlane::Extrema here = plane(at);
        if (here.range() < best.value) {
            best = {at, here.range(), 0.0};
        }
        return Tangent{at, {here.range(), here.slope()}};
    };
    // At a moment m the range is at least 2 |m| less what it is without: the box holds every moment
    // that is no worse.
    look({0.0, 0.0});
    const Place reach = Place(1.0, 1.0) * best.value * (1.0 + 1e-9);
    PlacePolygon left({-reach, reach});
    constexpr double exact = 5e-14;
    constexpr int max_rounds = 500;
    for (int round = 0; round < max_rounds && left.size() > 2; ++round) {
        const Tangent tangent = look(middle_of(left));
        best.gap = std::max(0.0, best.value - tangent(lowest(left, tangent)));
        if (best.gap <= exact * best.value) {
            break;
        }
        left.cut(tangent.below(best.value));
    }
    return best;
}

}  // namespace ravnoves::balance_shaft

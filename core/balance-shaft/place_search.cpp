#include "balance-shaft/place_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

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

class Search {
  public:
    Search(const ShaftPlaces& places, const PlaceQuestion& question)
        : places_(places), question_(question) {
        if (question.start) {
            offer(*question.start);
        }
    }

    std::optional<PlaceFound> run() {
        double distance = std::min(places_.farthest(), 4.0 * places_.extent());
        if (best_.value < infinite) {
            distance = std::min(places_.farthest(), enough());
        }
        search(distance);
        // Where the best is not known to lie within, it does within what the best found leaves.
        if (best_.value == infinite && distance < places_.farthest()) {
            distance = std::min(places_.farthest(), 400.0 * places_.extent());
            search(distance);
        }
        if (best_.value < infinite && std::min(places_.farthest(), enough()) > distance) {
            search(std::min(places_.farthest(), enough()));
        }
        if (best_.value == infinite) {
            return std::nullopt;
        }
        return best_;
    }

  private:
    /// No place farther than this is better than the best one found.
    double enough() const {
        return (best_.value + question_.at_crank) / question_.growth * (1.0 + 1e-9);
    }

    const PlaceLimit* exceeded(const Place& place) const {
        const auto found = std::ranges::find_if(question_.limits, [&](const PlaceLimit& limit) {
            return limit.criterion(place).value > limit.maximum * (1.0 + limit_rounding);
        });
        return found != question_.limits.end() ? &*found : nullptr;
    }

    /// @param known  the criterion at the place, where it has been asked for
    void offer(Place place, const PlaceValue* known = nullptr) {
        const Place wanted = place;
        if (!places_.make_feasible(place) || exceeded(place) != nullptr) {
            return;
        }
        const double value =
            known && place == wanted ? known->value : question_.criterion(place).value;
        if (value < best_.value) {
            best_.place = place;
            best_.value = value;
        }
    }

    struct Tangent {
        Place from;
        PlaceValue at;
        double operator()(const Place& place) const {
            return at.value + at.gradient.dot(place - from);
        }
        /// Where it is at most a value.
        HalfPlane below(double value) const {
            return {-at.gradient, at.value - value - at.gradient.dot(from)};
        }
    };

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

    static Place lowest(const PlacePolygon& polygon, const Tangent& tangent) {
        std::size_t minimum = 0;
        for (std::size_t i = 1; i < polygon.size(); ++i) {
            if (tangent(polygon[i]) < tangent(polygon[minimum])) {
                minimum = i;
            }
        }
        return polygon[minimum];
    }

    /// The lowest of the corners; what exceeds a limit by its curvature is cut off.
    Place lowest_allowed(PlacePolygon polygon, const Tangent& tangent) const {
        Place place = lowest(polygon, tangent);
        constexpr int tries = 3;
        for (int i = 0; i < tries; ++i) {
            const PlaceLimit* limit = exceeded(place);
            if (limit == nullptr) {
                break;
            }
            polygon.cut(Tangent{place, limit->criterion(place)}.below(limit->maximum));
            if (polygon.size() == 0) {
                break;
            }
            place = lowest(polygon, tangent);
        }
        return place;
    }

    static double min_of_larger(const PlacePolygon& polygon, const Tangent& one,
                                const Tangent& two) {
        const Place difference = two.at.gradient - one.at.gradient;
        // two − one ≥ 0
        const HalfPlane beyond{difference,
                               difference.dot(one.from) - (two(one.from) - one.at.value)};
        PlacePolygon above = polygon;
        above.cut(beyond);
        PlacePolygon below = polygon;
        below.cut({-beyond.normal, -beyond.minimum});
        return std::min(above.size() > 0 ? two(lowest(above, two)) : infinite,
                        below.size() > 0 ? one(lowest(below, one)) : infinite);
    }

    void search(double distance) {
        best_.gap = 0.0;
        const std::array<double, 4> region = places_.region(distance);
        const Place lowest_corner(region[0], region[1]);
        const Place highest_corner(region[2], region[3]);
        if (!(region[0] <= region[2] && region[1] <= region[3])) {
            return;
        }
        std::vector<Part> open;
        const auto add = [&](const PlacePolygon& where, double bound) {
            if (where.size() > 0) {
                open.push_back({where, bound, where.box().half.norm()});
                std::push_heap(open.begin(), open.end());
            }
        };
        add(PlacePolygon(
                {(lowest_corner + highest_corner) / 2.0, (highest_corner - lowest_corner) / 2.0}),
            -infinite);
        const double smallest = 1e-12 * std::max(distance, places_.extent());
        const double small = 1e-2 * places_.extent();
        ShaftPlaces::Cuts cuts;
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
            const PlaceRectangle box = part.where.box();
            places_.find_cuts(box, cuts);
            if (cuts.is_empty || places_.is_blocked(part.where, cuts) ||
                !cut_by_limits(box.middle, r, cuts)) {
                continue;
            }
            PlacePolygon all = part.where;
            for (const HalfPlane& line : cuts.outer) {
                all.cut(line);
            }
            if (all.size() == 0) {
                continue;
            }
            const Tangent here{box.middle, question_.criterion(box.middle)};
            double bound = std::max(part.bound, here(lowest(all, here)) - here.at.bend * r * r);
            if (bound >= best_.value - tolerance) {
                best_.gap = std::max(best_.gap, best_.value - bound);
                continue;
            }
            // Where a tangent plane lies above the best value, no place is better.
            const double better = best_.value - tolerance;
            all.cut(here.below(better + here.at.bend * r * r));
            best_.gap = std::max(best_.gap, tolerance);
            if (all.size() == 0 || places_.is_blocked(all, cuts)) {
                continue;
            }
            PlacePolygon surely = part.where;
            for (const HalfPlane& line : cuts.inner) {
                surely.cut(line);
            }
            const Place candidate = lowest_allowed(surely.size() > 0 ? surely : all, here);
            const Tangent there{candidate, question_.criterion(candidate)};
            // What is better by the tangent plane alone can mostly not be built.
            const double before = best_.value;
            if (there.at.value < before && (surely.size() > 0 || before == infinite || r < small)) {
                offer(candidate, &there.at);
            }
            if (cuts.outer.empty() && here.at.value < best_.value) {
                offer(box.middle, &here.at);
            }
            if (here.at.bend == 0.0) {
                // The larger of the two tangent planes, as it is on both sides of a kink.
                bound = std::max(bound, min_of_larger(all, here, there));
            }
            if (bound >= best_.value - tolerance) {
                best_.gap = std::max(best_.gap, best_.value - bound);
                continue;
            }
            all.cut(there.below(best_.value - tolerance + 4.0 * there.at.bend * r * r));
            if (all.size() == 0 || places_.is_blocked(all, cuts)) {
                continue;
            }
            // What the lines leave is searched, halved across its longer side where it is large.
            const auto& [middle, half] = all.box();
            if (half.norm() < r / 2.0) {
                add(all, bound);
                continue;
            }
            const Place across = half.x() >= half.y() ? Place(1.0, 0.0) : Place(0.0, 1.0);
            for (const double side : {-1.0, 1.0}) {
                PlacePolygon part_of = all;
                part_of.cut({side * across, side * across.dot(middle)});
                add(part_of, bound);
            }
        }
    }

    const ShaftPlaces& places_;
    const PlaceQuestion& question_;
    PlaceFound best_{{0.0, 0.0}, infinite, 0.0};
};

/// min c·v over the v with aᵢ·v ≥ bᵢ, while constraints are added: the dual simplex method, which
/// continues from the last vertex. For some hundred constraints.
class CuttingPlanes {
  public:
    using Vector = Eigen::Vector3d;

    struct Constraint {
        Vector a;
        double b;
    };

    /// @param first  three constraints that meet in one point from which c cannot fall: c is a sum
    ///               of their a with factors of at least 0
    /// @param tolerance  what a constraint may be short of
    CuttingPlanes(const Vector& cost, const std::vector<Constraint>& first, double tolerance)
        : cost_(cost), planes_(first), tolerance_(tolerance) {
        planes_.reserve(64);
        meet();
    }

    void add(const Constraint& plane) { planes_.push_back(plane); }

    /// @return the best vertex; its cost is a lower bound
    const Vector& solve() {
        const double rounding = 16 * std::numeric_limits<double>::epsilon();
        for (int pivots = 0; pivots < 200; ++pivots) {
            std::size_t entering = planes_.size();
            double worst = tolerance_;
            for (std::size_t i = 0; i < planes_.size(); ++i) {
                const Constraint& plane = planes_[i];
                const double missing = plane.b - plane.a.dot(vertex_);
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
            double minimum = 0.0;
            for (int k = 0; k < 3; ++k) {
                if (rates[k] > rounding) {
                    const double ratio = factors_[k] / rates[k];
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
        Eigen::Matrix3d rows;
        Vector right;
        for (int k = 0; k < 3; ++k) {
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
    double tolerance_;
    std::array<std::size_t, 3> basis_{0, 1, 2};
    Eigen::PartialPivLU<Eigen::Matrix3d> rows_;  ///< of the planes in basis_
    Vector vertex_;
    Vector factors_;  ///< of the planes that meet in the vertex, ≥ 0
};

}  // namespace

std::optional<PlaceFound> search_places(const ShaftPlaces& places, const PlaceQuestion& question) {
    return Search(places, question).run();
}

PlaceFound minimise_range(const MomentPlane& plane) {
    const MomentPlane::Extrema without = plane({0.0, 0.0});
    PlaceFound best{{0.0, 0.0}, without.range(), 0.0};
    // At a moment m the range is at least 2 |m| less what it is without: the box holds every moment
    // that is no worse. Its half side is the unit.
    const double reach = best.value * (1.0 + 1e-9);
    if (!(reach > 0.0)) {  // nothing moves
        return best;
    }
    const auto cut = [&](const MomentPlane::Extrema& here, const Place& at) {
        const Place gradient = here.slope() * reach;
        return CuttingPlanes::Constraint{{-gradient.x(), -gradient.y(), 1.0},
                                         here.range() - gradient.dot(at)};
    };
    const double x = without.slope().x() < 0.0 ? -1.0 : 1.0;
    const double y = without.slope().y() < 0.0 ? -1.0 : 1.0;
    const double rounding =
        16.0 * std::numeric_limits<double>::epsilon() * std::max(best.value, 1e-300);
    CuttingPlanes planes({0.0, 0.0, 1.0},
                         {cut(without, {0.0, 0.0}), {{x, 0.0, 0.0}, -1.0}, {{0.0, y, 0.0}, -1.0}},
                         rounding);
    planes.add({{-x, 0.0, 0.0}, -1.0});
    planes.add({{0.0, -y, 0.0}, -1.0});
    constexpr double exact = 5e-14;
    constexpr int max_rounds = 500;
    Place at(0.0, 0.0);
    for (int round = 0; round < max_rounds; ++round) {
        const CuttingPlanes::Vector vertex = planes.solve();
        best.gap = std::max(0.0, best.value - vertex.z());
        if (best.gap <= exact * best.value || (round > 0 && at == vertex.head<2>())) {
            break;
        }
        at = vertex.head<2>();
        const MomentPlane::Extrema here = plane(at * reach);
        if (here.range() < best.value) {
            best.value = here.range();
            best.place = at * reach;
        }
        planes.add(cut(here, at));
    }
    return best;
}

}  // namespace ravnoves::balance_shaft

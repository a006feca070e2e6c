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

    void offer(Place place) {
        if (!places_.make_feasible(place) ||
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
            offer(lowest(surely.size() > 0 ? surely : all, here));
            if (here.at.value < best_.value) {
                offer(centre);
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

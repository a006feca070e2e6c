#include "balance-shaft/position_study.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

#include "balance-shaft/clearance.h"
#include "balance-shaft/moment_plane.h"
#include "numerics/angle.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

PositionStudy::PositionStudy(const Solver& solver)
    : solver_(solver),
      places_(solver.front_view(), solver.input().place_limits),
      force_(solver.moments().forces.counterweight_force),
      turn_(Eigen::Rotation2Dd(-solver.moments().phase)) {
    const MomentPlane::Extrema found = plane()({0.0, 0.0});
    range_without_ = found.range();
    rms_without_ = plane().rms({0.0, 0.0});
    size_ = std::max(std::abs(found.max.value), std::abs(found.min.value));
}

PositionCriteria PositionStudy::at(const ShaftPosition& position) const {
    const Moment m = moment({position.x, position.y});
    return {plane().range(m), plane().rms(m),
            envelope(places_.view(), {position.x, position.y}).area()};
}

PlaceQuestion PositionStudy::question_of_sum(double weight) const {
    PlaceQuestion question;
    question.criterion = [this, weight](const Eigen::Vector2d& at) -> PlaceValue {
        const Moment m = moment(at);
        PlaceValue answer;
        Moment gradient(0.0, 0.0);
        if (weight > 0.0) {
            const MomentPlane::Extrema extrema = plane()(m);
            answer.value = weight * extrema.range();
            gradient = weight * extrema.slope();
        }
        if (weight < 1.0) {
            const double here = plane().rms(m);
            answer.value += (1.0 - weight) * here;
            if (here > 0.0) {
                gradient += (1.0 - weight) / (2.0 * here) * (m - plane().opposed());
            }
        }
        answer.gradient = force_ * (turn_.transpose() * gradient);
        return answer;
    };
    // Both are norms: that of the sum is at least the difference.
    question.growth = force_ * (2.0 * weight + (1.0 - weight) / std::numbers::sqrt2);
    question.at_crank = weight * range_without_ + (1.0 - weight) * rms_without_;
    question.tolerance = 1e-12 * (question.at_crank + question.growth * places_.extent());
    return question;
}

PlaceQuestion PositionStudy::question_of_size() const {
    PlaceQuestion question;
    question.criterion = [this](const Eigen::Vector2d& at) -> PlaceValue {
        const Envelope box = envelope(places_.view(), at);
        return {box.area(), box.by_area(), box.by_width.norm() * box.by_height.norm()};
    };
    // Crank and shaft side by side, l and the crank's radius wide, the crank's diameter high.
    const double radius = places_.view().crank_swing_radius;
    question.growth = radius;
    question.at_crank = 0.0;
    question.tolerance = 1e-9 * places_.extent() * places_.extent();
    return question;
}

BestPosition PositionStudy::judged(const PlaceFound& found) const {
    BestPosition best;
    best.position = {found.place.x(), found.place.y()};
    best.criteria = at(best.position);
    best.gap = found.gap;
    return best;
}

std::optional<BestPosition> PositionStudy::best_built(double weight,
                                                      const BestPosition& free) const {
    if (places_.obstacle(free.position.x, free.position.y) == Obstacle::none) {
        return free;
    }
    const std::optional<PlaceFound> place = search_places(places_, question_of_sum(weight));
    return place ? std::optional(judged(*place)) : std::nullopt;
}

ShaftPosition ShaftPosition::at(double centre_distance, double shaft_angle) {
    return {centre_distance * std::sin(shaft_angle), centre_distance * std::cos(shaft_angle)};
}

double ShaftPosition::centre_distance() const {
    return std::hypot(x, y);
}

double ShaftPosition::shaft_angle() const {
    return wrap_turn(std::atan2(x, y));
}

BestPositions PositionStudy::best() const {
    BestPositions answer;
    if (force_ == 0.0) {
        answer.reason = Text::tr("The shaft has no moment: its place has no effect.");
        return answer;
    }
    if (is_constant()) {
        BestPosition at_crank;
        at_crank.criteria = at({});
        answer.range = answer.rms = at_crank;
        answer.reason = Text::tr(
            "The tipping moment is constant: a shaft away from the crank axis only adds to it.");
        return answer;
    }
    PlaceFound lowest = minimise_range(plane());
    lowest.place = place_of(lowest.place);
    answer.range = judged(lowest);
    const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * rms_without_;
    answer.rms = judged({place_of(plane().opposed()), 0.0, rounding});
    return answer;
}

BestPosition PositionStudy::smallest_buildable(const BestPosition& best, bool by_range) const {
    const PlaceCriterion own = question_of_sum(by_range ? 1.0 : 0.0).criterion;
    const Eigen::Vector2d start(best.position.x, best.position.y);
    const PlaceLimit good_enough{own, 1.01 * own(start).value};
    constexpr double noticed = 1e-3;
    PlaceQuestion of_size = question_of_size();
    of_size.tolerance = noticed * best.criteria.size;
    of_size.limits = {good_enough};
    of_size.start = start;
    const PlaceFound smallest = search_places(places_, of_size).value();
    // Much of the plane can be as small: beside the cylinder, say.
    PlaceQuestion other = question_of_sum(by_range ? 0.0 : 1.0);
    other.tolerance = noticed * other.at_crank;
    other.limits = {good_enough, {of_size.criterion, (1.0 + noticed) * smallest.value}};
    other.start = smallest.place;
    BestPosition found = judged(search_places(places_, other).value());
    found.gap = found.criteria.size - (smallest.value - smallest.gap);
    return found;
}

int sign_as_shown(double change) {
    return std::abs(change) < 5e-4 ? 0 : change < 0.0 ? -1 : 1;
}

Message trade_off(const PositionCriteria& from, const PositionCriteria& to) {
    const auto part = [](double before, double after, Text smaller, Text larger, Text same) {
        const double change = before > 0.0 ? relative_change(before, after) : 0.0;
        const int sign = sign_as_shown(change);
        return sign == 0 ? Message(same)
                         : Message(sign > 0 ? larger : smaller, in_percent(std::abs(change)));
    };
    const Message moments = joined(part(from.range, to.range, Text::tr("range %1 smaller"),
                                        Text::tr("range %1 larger"), Text::tr("range unchanged")),
                                   part(from.rms, to.rms, Text::tr("RMS %1 smaller"),
                                        Text::tr("RMS %1 larger"), Text::tr("RMS unchanged")));
    return from.size > 0.0
               ? joined(moments, part(from.size, to.size, Text::tr("box %1 smaller"),
                                      Text::tr("box %1 larger"), Text::tr("box unchanged")))
               : moments;
}

Obstacle PositionStudy::obstacle(const ShaftPosition& position) const {
    return places_.obstacle(position.x, position.y);
}

Message PositionStudy::obstacle_reason(const ShaftPosition& position) const {
    return places_.reason(obstacle(position), position.centre_distance());
}

BestPositions PositionStudy::best_buildable() const {
    BestPositions answer = best();
    if (!answer.range || !answer.rms) {
        return answer;
    }
    answer.range = best_built(1.0, *answer.range);
    answer.rms = best_built(0.0, *answer.rms);
    if (!answer.range || !answer.rms) {
        answer = {};
        answer.reason = contradiction(solver_.input().place_limits);
        if (answer.reason.empty()) {
            answer.reason = Text::tr(
                "No place within the limits clears crank, cylinder and rod with the gears in "
                "mesh.");
        }
    }
    return answer;
}

std::vector<BestPosition> PositionStudy::front(const BestPositions& best) const {
    std::vector<BestPosition> front;
    if (!best.range || !best.rms) {
        return front;
    }
    const PlaceQuestion of_size = question_of_size();
    const std::optional<PlaceFound> smallest = search_places(places_, of_size);
    if (!smallest) {
        return front;
    }
    const auto add = [&](const PlaceFound& found) {
        const BestPosition one = judged(found);
        if (std::isfinite(one.criteria.range + one.criteria.rms + one.criteria.size)) {
            front.push_back(one);
        }
    };
    // Range and RMS as parts of what they are without a shaft.
    const double by_range = 1.0 / std::max(range_without_, rounding_share);
    const double by_rms = 1.0 / std::max(rms_without_, rounding_share);
    constexpr int sizes = 10;
    constexpr double same = front_gap;
    constexpr int weights = 5;
    for (int i = 0; i < weights; ++i) {
        const double part = i / (weights - 1.0);
        const double weight = part * by_range / (part * by_range + (1.0 - part) * by_rms);
        PlaceQuestion question = question_of_sum(weight);
        question.tolerance *= 5e3;
        std::optional<PlaceFound> largest;
        if (i == 0 || i == weights - 1) {
            const ShaftPosition& end = i == 0 ? best.rms->position : best.range->position;
            const Eigen::Vector2d place(end.x, end.y);
            largest = PlaceFound{place, question.criterion(place).value};
        } else {
            largest = search_places(places_, question);
        }
        if (!largest) {
            continue;
        }
        add(*largest);
        const double size = envelope(places_.view(), largest->place).area();
        // The criterion falls most beside the smallest box, so sizes are nearest to one another
        // there.
        question.start = smallest->place;
        for (int k = 0; k < sizes && size > smallest->value * (1.0 + same); ++k) {
            const double part_of = static_cast<double>(k) / sizes;
            question.limits = {
                {of_size.criterion, std::max(std::lerp(smallest->value, size, part_of * part_of),
                                             smallest->value * (1.0 + same))}};
            const auto found = search_places(places_, question);
            if (!found) {
                break;
            }
            add(*found);
            question.start = found->place;
        }
    }
    // What another beats, or equals within rounding, is left out.
    std::stable_sort(front.begin(), front.end(), [](const auto& a, const auto& b) {
        return a.criteria.size < b.criteria.size;
    });
    std::vector<BestPosition> efficient;
    for (std::size_t i = 0; i < front.size(); ++i) {
        const PositionCriteria& one = front[i].criteria;
        const auto beats = [&](const BestPosition& other) {
            const PositionCriteria& two = other.criteria;
            return two.range <= one.range * (1.0 + same) && two.rms <= one.rms * (1.0 + same) &&
                   two.size <= one.size * (1.0 + same);
        };
        const auto later = front.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        const bool is_beaten = std::any_of(efficient.begin(), efficient.end(), beats) ||
                               std::any_of(later, front.end(), [&](const BestPosition& other) {
                                   return beats(other) && !(other.criteria.range > one.range ||
                                                            other.criteria.rms > one.rms);
                               });
        if (!is_beaten) {
            efficient.push_back(front[i]);
        }
    }
    return efficient;
}

PositionMap PositionStudy::map(double left, double right, double bottom, double top,
                               std::size_t columns, std::size_t rows) const {
    PositionMap map{left, right, bottom, top, columns, rows, {}, {}};
    const auto step = [](double from, double to, std::size_t count) {
        return count > 1 ? (to - from) / static_cast<double>(count - 1) : 0.0;
    };
    const Moment origin = moment({left, bottom});
    const Moment along = moment({step(left, right, columns), 0.0});
    const Moment across = moment({0.0, step(bottom, top, rows)});
    map.range.resize(columns * rows);
    map.rms.resize(columns * rows);
    constexpr std::size_t side = 8;  // of a tile, whose places are near each other
    std::vector<Moment> shafts;
    std::array<double, side * side> range;
    for (std::size_t row = 0; row < rows; row += side) {
        for (std::size_t column = 0; column < columns; column += side) {
            const std::size_t wide = std::min(side, columns - column);
            const std::size_t high = std::min(side, rows - row);
            shafts.clear();
            for (std::size_t i = 0; i < wide * high; ++i) {
                const std::size_t up = i / wide;
                shafts.push_back(origin + static_cast<double>(column + i % wide) * along +
                                 static_cast<double>(row + up) * across);
            }
            plane().ranges(shafts, std::span(range).first(shafts.size()));
            for (std::size_t i = 0; i < shafts.size(); ++i) {
                const std::size_t element = (row + i / wide) * columns + column + i % wide;
                map.range[element] = range[i];
                map.rms[element] = plane().rms(shafts[i]);
            }
        }
    }
    return map;
}

EnvelopeStudy envelope_study(const Solver& solver) {
    constexpr std::size_t angles = 720;
    EnvelopeStudy study;
    for (std::size_t i = 0; i < angles; ++i) {
        const double angle = 360.0 * static_cast<double>(i) / static_cast<double>(angles);
        const Envelope box = envelope(solver.front_view(), angle * degree);
        study.shaft_angle_deg.push_back(angle);
        study.width.push_back(box.width());
        study.height.push_back(box.height());
        study.area.push_back(box.area());
        study.range.push_back(solver.range(angle * degree));
        study.buildable.push_back(solver.buildable().contains(angle * degree));
    }
    // Walk from the smallest box up: an angle is efficient where its range beats all before it, and
    // takes the place of the last one where their boxes are equal.
    std::vector<std::size_t> order(angles);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return study.area[a] < study.area[b]; });
    study.efficient.assign(angles, false);
    std::optional<std::size_t> last;
    for (const std::size_t i : order) {
        if (!study.buildable[i] ||
            (last && !(study.range[i] < study.range[*last] * (1.0 - rounding_share)))) {
            continue;
        }
        if (last && study.area[i] <= study.area[*last] * (1.0 + rounding_share)) {
            study.efficient[*last] = false;
        }
        study.efficient[i] = true;
        last = i;
    }
    return study;
}

}  // namespace ravnoves::balance_shaft

#include "balance-shaft/speed_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "balance-shaft/best_range.h"
#include "balance-shaft/engine_torque.h"
#include "balance-shaft/offset_cylinder.h"
#include "balance-shaft/position_study.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "numerics/angle.h"

namespace ravnoves::balance_shaft {

namespace {

/// Ratios nearer than this are the same.
constexpr double exact = 1e-11;

double rms_of(double variance) {
    return std::sqrt(std::max(variance, 0.0));
}

double squared(double x) {
    return x * x;
}

/// The speeds of a band that a search for its worst begins with. In N·m the criterion is convex in
/// ω²: the worst speed is an end of the band. Of the ratio a few are enough to begin with, each
/// round adds the worst of the whole band.
std::vector<std::size_t> first_speeds(std::size_t count, SpeedStudy::Measure measure) {
    const std::size_t intervals =
        std::min<std::size_t>(count - 1, measure == SpeedStudy::Measure::absolute ? 1 : 12);
    std::vector<std::size_t> speeds{0};
    for (std::size_t k = 1; k <= intervals; ++k) {
        speeds.push_back(k * (count - 1) / intervals);
    }
    return speeds;
}

}  // namespace

void SpeedStudy::turn(std::vector<AngleStretch>& stretches) const {
    for (AngleStretch& stretch : stretches) {
        stretch.from += phase_;
        stretch.to += phase_;
    }
}

SpeedStudy::SpeedStudy(const Input& input, const SpeedBand& band, const Progress& progress) {
    check_input(input);
    check_speed_band(band);
    const auto gas = cylinder_gas(input);
    std::optional<TorqueParts> parts;
    if (gas) {
        parts = torque_parts(input, *gas);
    } else {
        const InertiaCheck check = check_inertia(input);
        parts = torque_parts(input, check);
        if (!parts) {
            reason_ = check.fitted
                          ? Message(CORE_TEXT("balance-shaft",
                                              "The torque does not belong to the masses and the "
                                              "speed entered, so it cannot be taken to other "
                                              "speeds. %1"),
                                    check.text)
                          : check.text;
            return;
        }
    }
    const SliderCrank<double> crank = slider_crank(input);
    phase_ = crank.top_dead_centre() - piston_first_order(crank).lag;
    buildable_ = buildable_angles(front_view(input), input.place_limits);
    std::vector<AngleStretch> within = buildable_.stretches;
    turn(within);
    gas_ = with_offset_term(parts->gas.negated(), crank, 0.0);
    inertia_ = with_offset_term(parts->unit_inertia.negated(), crank, input.reciprocating_mass());
    gas_order_ = gas_.fourier(degree);
    inertia_order_ = inertia_.fourier(degree);
    const double unit_force =
        input.counterweight_mass.value_or(input.reciprocating_mass() * input.crank_radius /
                                          (2.0 * input.counterweight_radius)) *
        input.counterweight_radius;
    unit_amplitude_ = unit_force * input.centre_distance;
    unit_ = ShaftMoment(unit_force, phase_);
    places_.emplace(front_view(input), input.place_limits);
    points_.reserve(static_cast<std::size_t>(band.speeds));
    speeds_.reserve(static_cast<std::size_t>(band.speeds));
    for (int k = 0; k < band.speeds; ++k) {
        if (progress && !progress(static_cast<double>(k) / band.speeds)) {
            return;
        }
        Point point;
        point.angular_speed = k + 1 == band.speeds ? band.to
                                                   : band.from + (band.to - band.from) * k /
                                                                     std::max(band.speeds - 1, 1);
        speeds_.push_back(speed_at(point.angular_speed));
        const Speed& speed = speeds_.back();
        point.moment_amplitude = speed.amplitude;
        point.range_without = speed.without.max.value - speed.without.min.value;
        point.rms_without = rms_of(speed.variance);
        const BestRange best = minimise_range(speed.extrema);
        point.best_range_angle = wrap_turn(best.shaft_angle - phase_);
        point.best_range = best.range;
        // M_s opposes the first order.
        const double opposed = std::atan2(-speed.order_1.a, -speed.order_1.b);
        point.best_rms_angle = wrap_turn(opposed - phase_);
        const double first = std::hypot(speed.order_1.a, speed.order_1.b);
        point.best_rms = rms_of(speed.variance + speed.amplitude * (speed.amplitude / 2.0 - first));
        if (!within.empty()) {
            point.buildable_range_angle =
                buildable_.contains(point.best_range_angle)
                    ? point.best_range_angle
                    : wrap_turn(minimise_range(speed.extrema, within).shaft_angle - phase_);
            point.buildable_rms_angle = wrap_turn(nearest_angle(within, opposed) - phase_);
        }
        points_.push_back(point);
    }
    complete_ = true;
    if (progress) {
        progress(1.0);
    }
}

std::optional<SpeedStudy::Map> SpeedStudy::map(std::size_t angles, const Progress& progress) const {
    Map map;
    map.shaft_angle_deg.reserve(angles);
    for (std::size_t i = 0; i < angles; ++i) {
        map.shaft_angle_deg.push_back(360.0 * static_cast<double>(i) / static_cast<double>(angles));
    }
    std::vector<double> turned;
    turned.reserve(angles);
    for (const double angle : map.shaft_angle_deg) {
        turned.push_back(angle * degree + phase_);
    }
    map.range.resize(speeds_.size() * angles);
    map.rms.reserve(speeds_.size() * angles);
    for (std::size_t k = 0; k < speeds_.size(); ++k) {
        if (progress && !progress(static_cast<double>(k) / static_cast<double>(speeds_.size()))) {
            return std::nullopt;
        }
        const Speed& speed = speeds_[k];
        const double amplitude = points_[k].moment_amplitude;
        speed.extrema.ranges(turned, std::span(map.range).subspan(k * angles, angles));
        for (const double alpha : turned) {
            map.rms.push_back(rms_of(
                speed.variance + amplitude * (amplitude / 2.0 + std::sin(alpha) * speed.order_1.a +
                                              std::cos(alpha) * speed.order_1.b)));
        }
    }
    if (progress) {
        progress(1.0);
    }
    return map;
}

SpeedStudy::Speed SpeedStudy::speed_at(double angular_speed) const {
    const double square = angular_speed * angular_speed;
    const auto moment = PeriodicPiecewise::sum(gas_, inertia_, square);
    const double amplitude = unit_amplitude_ * square;
    return {angular_speed,
            amplitude,
            CycleExtrema(moment, amplitude),
            CycleExtrema(moment, 0.0)(0.0),
            moment.variance(),
            {gas_order_.a + square * inertia_order_.a, gas_order_.b + square * inertia_order_.b}};
}

namespace {

/// A value is over this: itself, or what it is without a shaft.
double divisor_of(double without, bool is_relative) {
    return is_relative && without > 0.0 ? without : 1.0;
}

}  // namespace

double SpeedStudy::divisor(const Speed& speed, Criterion criterion, Measure measure) {
    return divisor_of(criterion == Criterion::range
                          ? speed.without.max.value - speed.without.min.value
                          : speed.variance,
                      measure == Measure::relative);
}

/// The criterion (of the RMS its square) over its divisor, with a sinusoid of α that bounds it.
Cut<double> SpeedStudy::cut(const Speed& speed, Criterion criterion, Measure measure,
                            double alpha) {
    const double over = divisor(speed, criterion, measure);
    Cut<double> cut;
    if (criterion == Criterion::range) {
        cut = range_cut(speed.extrema, alpha);
        cut.value /= over;
        cut.bound = {cut.bound.constant / over, cut.bound.p / over, cut.bound.q / over};
    } else {
        cut.bound = {(speed.variance + speed.amplitude * speed.amplitude / 2.0) / over,
                     speed.amplitude * speed.order_1.b / over,
                     speed.amplitude * speed.order_1.a / over};
        cut.value = cut.bound(alpha);
    }
    cut.alpha = alpha;
    return cut;
}

/// At every α the largest of these speeds.
SpeedStudy::AtSpeeds SpeedStudy::least_bad_of(const std::vector<const Speed*>& speeds,
                                              Criterion criterion, Measure measure,
                                              const std::vector<AngleStretch>& within) {
    const bool by_range = criterion == Criterion::range;
    double steepest = 0.0;
    double size = 0.0;
    for (const Speed* speed : speeds) {
        const double over = divisor(*speed, criterion, measure);
        const double first = std::hypot(speed->order_1.a, speed->order_1.b);
        steepest = std::max(steepest, (by_range ? 2.0 : first) * speed->amplitude / over);
        size =
            std::max(size, (by_range ? 1.0 : speed->amplitude + first) * speed->amplitude / over);
    }
    std::size_t worst = 0;
    const auto evaluate = [&](double alpha) {
        double highest = -1.0;
        for (std::size_t k = 0; k < speeds.size(); ++k) {
            const double value =
                by_range ? speeds[k]->extrema.range(alpha) / divisor(*speeds[k], criterion, measure)
                         : cut(*speeds[k], criterion, measure, alpha).value;
            if (value > highest) {
                highest = value;
                worst = k;
            }
        }
        return cut(*speeds[worst], criterion, measure, alpha);
    };
    const auto best = minimise_over_angle<double>(evaluate, steepest, size, within);
    evaluate(best.alpha);
    return {best.alpha, best.value, best.gap, speeds[worst]->angular_speed};
}

/// The speed of the band at which the RMS over that without a shaft is largest: a quotient of
/// squares, both quadratic in ω².
double SpeedStudy::worst_rms_speed(double a_cos, double b_sin) const {
    const double gas = gas_.variance();
    const double inertia = inertia_.variance();
    const double both = PeriodicPiecewise::sum(gas_, inertia_, 1.0).variance() - gas - inertia;
    const auto first = [&](const FourierPair& order) { return a_cos * order.a + b_sin * order.b; };
    const std::array<double, 3> with{
        gas, both + first(gas_order_),
        inertia + (a_cos * a_cos + b_sin * b_sin) / 2.0 + first(inertia_order_)};
    const std::array<double, 3> without{gas, both, inertia};
    const auto ratio = [&](double q) {
        return (with[0] + q * (with[1] + q * with[2])) /
               (without[0] + q * (without[1] + q * without[2]));
    };
    // The derivative's numerator, a + 2 b q + c q².
    const double a = with[1] * without[0] - with[0] * without[1];
    const double b = with[2] * without[0] - with[0] * without[2];
    const double c = with[2] * without[1] - with[1] * without[2];
    const double low = squared(speeds_.front().angular_speed);
    const double high = squared(speeds_.back().angular_speed);
    double worst = ratio(low) > ratio(high) ? low : high;
    const double root = b * b - a * c;
    if (root >= 0.0) {
        const double sum = -(b + std::copysign(std::sqrt(root), b));
        for (const double q : {sum / c, a / sum}) {
            if (q > low && q < high && ratio(q) > ratio(worst)) {
                worst = q;
            }
        }
    }
    return std::sqrt(worst);
}

/// The speed of the band at which the range over that without a shaft is largest, by branch
/// and bound over q = ω²: both ranges are convex in q (the largest of differences that are linear
/// in it), so between two speeds the one with the shaft lies under its chord, the one without over
/// its tangents.
std::optional<SpeedStudy::Speed> SpeedStudy::worst_range_speed(
    const std::vector<const Speed*>& speeds,
    const std::function<double(const Speed&)>& range) const {
    struct End {
        double q = 0.0;  ///< ω²
        double with = 0.0;
        double without = 0.0;
        double slope = 0.0;  ///< of the range without a shaft by q
        double ratio() const { return with / divisor_of(without, true); }
    };
    const auto end_of = [&](const Speed& speed) -> End {
        return {squared(speed.angular_speed), range(speed),
                speed.without.max.value - speed.without.min.value,
                inertia_(speed.without.max.angle_deg) - inertia_(speed.without.min.angle_deg)};
    };
    const auto most_between = [](const End& left, const End& right) {
        const double at_ends = std::max(left.ratio(), right.ratio());
        // Where the two tangents meet, from the left end.
        const double width = right.q - left.q;
        const double bend = right.slope - left.slope;
        if (!(bend > 0.0)) {
            return at_ends;  // a straight line: both are, or the chord over it is monotone
        }
        const double t =
            std::clamp((left.without - right.without + right.slope * width) / bend, 0.0, width);
        const double tangent = left.without + left.slope * t;
        const double chord = left.with + (right.with - left.with) * t / width;
        return tangent > 0.0 ? std::max(at_ends, chord / tangent)
                             : std::numeric_limits<double>::infinity();
    };
    std::vector<End> ends;
    ends.reserve(speeds.size());
    for (const Speed* speed : speeds) {
        ends.push_back(end_of(*speed));
    }
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.q < b.q; });
    End worst = *std::max_element(ends.begin(), ends.end(),
                                  [](const End& a, const End& b) { return a.ratio() < b.ratio(); });
    std::optional<Speed> found;
    using Interval = std::array<End, 2>;
    std::vector<Interval> open;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        open.push_back({ends[i], ends[i + 1]});
    }
    constexpr int most_evaluations = 2000;
    for (int evaluations = 0; !open.empty() && evaluations < most_evaluations;) {
        const Interval interval = open.back();
        open.pop_back();
        const double width = interval[1].q - interval[0].q;
        if (width <= exact * interval[1].q ||
            most_between(interval[0], interval[1]) <= worst.ratio() * (1.0 + exact)) {
            continue;
        }
        const Speed speed = speed_at(std::sqrt(interval[0].q + width / 2.0));
        ++evaluations;
        const End middle = end_of(speed);
        if (middle.ratio() > worst.ratio()) {
            worst = middle;
            found = speed;
        }
        open.push_back({middle, interval[1]});
        open.push_back({interval[0], middle});
    }
    return found;
}

SpeedStudy::LeastBad SpeedStudy::least_bad_angle(Criterion criterion, Measure measure,
                                                 std::vector<AngleStretch> within) const {
    if (speeds_.empty()) {
        return {};
    }
    turn(within);
    const bool by_range = criterion == Criterion::range;
    // The best angle for some speeds, the worst speed for that angle, which joins them: so the best
    // for some becomes the best for the band.
    std::vector<const Speed*> speeds;
    for (const std::size_t k : first_speeds(speeds_.size(), measure)) {
        speeds.push_back(&speeds_[k]);
    }
    std::deque<Speed> added;
    AtSpeeds best;
    double worst = 0.0;
    double worst_speed = 0.0;
    constexpr int most_rounds = 60;
    for (int round = 0; round < most_rounds; ++round) {
        best = least_bad_of(speeds, criterion, measure, within);
        worst = best.value;
        worst_speed = best.worst_speed;
        // In N·m the criterion is convex in ω²: the worst speed is an end of the band.
        if (measure == Measure::absolute) {
            break;
        }
        std::optional<Speed> other =
            by_range
                ? worst_range_speed(
                      speeds, [&](const Speed& speed) { return speed.extrema.range(best.alpha); })
                : speed_at(worst_rms_speed(unit_amplitude_ * std::sin(best.alpha),
                                           unit_amplitude_ * std::cos(best.alpha)));
        if (!other) {
            break;
        }
        const double value = cut(*other, criterion, measure, best.alpha).value;
        if (value > worst) {
            worst = value;
            worst_speed = other->angular_speed;
        }
        if (value <= best.value * (1.0 + exact)) {
            break;
        }
        speeds.push_back(&added.emplace_back(*std::move(other)));
    }
    const double bound = best.value - best.gap;
    LeastBad answer;
    answer.shaft_angle = wrap_turn(best.alpha - phase_);
    answer.value = by_range ? worst : rms_of(worst);
    answer.gap = answer.value - (by_range ? bound : rms_of(bound));
    answer.worst_speed = worst_speed;
    return answer;
}

SpeedStudy::SpeedPlane SpeedStudy::speed_plane(double angular_speed, Criterion criterion,
                                               Measure measure) const {
    const double square = squared(angular_speed);
    const auto moment = PeriodicPiecewise::sum(gas_, inertia_, square);
    SpeedPlane speed{
        square,
        1.0,
        0.0,
        MomentPlane(moment),
        moment.variance(),
        {gas_order_.a + square * inertia_order_.a, gas_order_.b + square * inertia_order_.b}};
    speed.without =
        criterion == Criterion::range ? speed.plane(0.0, 0.0).range() : rms_of(speed.variance);
    speed.over = divisor_of(speed.without, measure == Measure::relative);
    return speed;
}

SpeedStudy::Worst SpeedStudy::worst_of(const std::vector<SpeedPlane>& planes, Criterion criterion,
                                       const Eigen::Vector2d& unit) {
    Worst worst;
    worst.value = -1.0;
    for (const SpeedPlane& speed : planes) {
        const Eigen::Vector2d m = speed.square * unit;
        if (criterion == Criterion::range) {
            const MomentPlane::Extrema found = speed.plane(m.x(), m.y());
            if (found.range() / speed.over > worst.value) {
                worst = {found.range() / speed.over,
                         speed.square / speed.over *
                             Eigen::Vector2d(found.max.cos - found.min.cos,
                                             found.max.sin - found.min.sin),
                         speed.square};
            }
            continue;
        }
        const Eigen::Vector2d order(speed.order_1.a, speed.order_1.b);
        const double rms =
            rms_of(speed.variance - order.squaredNorm() / 2.0 + (m + order).squaredNorm() / 2.0);
        if (rms / speed.over > worst.value) {
            worst = {rms / speed.over,
                     rms > 0.0
                         ? Eigen::Vector2d(speed.square / (2.0 * rms * speed.over) * (m + order))
                         : Eigen::Vector2d(0.0, 0.0),
                     speed.square};
        }
    }
    return worst;
}

/// The best place for some speeds, the worst speed there, which joins them, as least_bad_angle().
std::optional<SpeedStudy::LeastBadPlace> SpeedStudy::least_bad_place(
    Criterion criterion, Measure measure, const PlaceOfPlanes& find) const {
    if (speeds_.empty() || unit_.force() == 0.0) {
        return std::nullopt;
    }
    std::vector<SpeedPlane> planes;
    std::vector<const Speed*> speeds;
    for (const std::size_t k : first_speeds(speeds_.size(), measure)) {
        planes.push_back(speed_plane(speeds_[k].angular_speed, criterion, measure));
        speeds.push_back(&speeds_[k]);
    }
    std::deque<Speed> added;
    LeastBadPlace answer;
    constexpr int most_rounds = 20;
    for (int round = 0; round < most_rounds; ++round) {
        const std::optional<PlaceFound> best = find(planes);
        if (!best) {
            return std::nullopt;
        }
        const Eigen::Vector2d unit = unit_.at(best->place);
        Worst worst = worst_of(planes, criterion, unit);
        answer = {best->place.x(), best->place.y(), worst.value, std::sqrt(worst.square),
                  worst.value - (best->value - best->gap)};
        if (measure == Measure::absolute) {
            break;
        }
        // On the crank's axis the shaft changes nothing at any speed.
        if (unit.isZero()) {
            break;
        }
        std::optional<Speed> other;
        if (criterion == Criterion::range) {
            other = worst_range_speed(speeds, [&](const Speed& speed) {
                const auto known = std::find(speeds.begin(), speeds.end(), &speed);
                if (known != speeds.end()) {
                    const SpeedPlane& there =
                        planes[static_cast<std::size_t>(known - speeds.begin())];
                    return there.plane(there.square * unit.x(), there.square * unit.y()).range();
                }
                const double square = squared(speed.angular_speed);
                const MomentPlane plane(PeriodicPiecewise::sum(gas_, inertia_, square));
                return plane(square * unit.x(), square * unit.y()).range();
            });
        } else {
            other = speed_at(worst_rms_speed(unit.x(), unit.y()));
        }
        if (!other) {
            break;
        }
        planes.push_back(speed_plane(other->angular_speed, criterion, measure));
        worst = worst_of({planes.back()}, criterion, unit);
        speeds.push_back(&added.emplace_back(*std::move(other)));
        if (worst.value > answer.value) {
            answer.gap += worst.value - answer.value;
            answer.value = worst.value;
            answer.worst_speed = std::sqrt(worst.square);
        }
        if (worst.value <= best->value * (1.0 + exact)) {
            break;
        }
    }
    return answer;
}

/// The question of the worst of some speeds, whose planes must live as long.
PlaceQuestion SpeedStudy::question_of(const std::vector<SpeedPlane>& planes,
                                      Criterion criterion) const {
    PlaceQuestion question;
    question.criterion = [this, &planes, criterion](const Eigen::Vector2d& at) -> PlaceValue {
        const Worst here = worst_of(planes, criterion, unit_.at(at));
        return {here.value, unit_.by_place(here.gradient)};
    };
    const double growth = criterion == Criterion::range ? 2.0 : std::numbers::sqrt2 / 2.0;
    const SpeedPlane& speed = planes.back();
    question.growth = growth * unit_.force() * speed.square / speed.over;
    question.at_crank = speed.without / speed.over;
    question.tolerance = 1e-11 * (question.at_crank + question.growth * places_->extent());
    return question;
}

std::optional<SpeedStudy::LeastBadPlace> SpeedStudy::least_bad_place(Criterion criterion,
                                                                     Measure measure) const {
    return least_bad_place(criterion, measure, [&](const std::vector<SpeedPlane>& planes) {
        return std::optional(lowest_place(question_of(planes, criterion)));
    });
}

std::optional<SpeedStudy::LeastBadPlace> SpeedStudy::least_bad_place_buildable(
    Criterion criterion, Measure measure, const std::optional<LeastBadPlace>& free) const {
    if (!free || places_->obstacle(free->x, free->y) == Obstacle::none) {
        return free;
    }
    std::optional<Eigen::Vector2d> start;
    return least_bad_place(criterion, measure, [&](const std::vector<SpeedPlane>& planes) {
        PlaceQuestion question = question_of(planes, criterion);
        question.start = start;
        auto found = search_places(*places_, question);
        if (found) {
            start = found->place;
        }
        return found;
    });
}

Json write_speed_study(const SpeedStudy& study, const std::optional<SpeedStudy::Map>& map) {
    if (!study.reason().empty()) {
        return {{"feasible", false}, {"reason", study.reason().english()}};
    }
    Json json = {{"feasible", true}};
    const auto put = [&](const char* key, double SpeedStudy::Point::*member, double factor) {
        Json& column = json[key] = Json::array();
        for (const SpeedStudy::Point& point : study.points()) {
            column.push_back(point.*member * factor);
        }
    };
    using Point = SpeedStudy::Point;
    put("speed_rpm", &Point::angular_speed, 1.0 / units::rpm);
    put("moment_amplitude_Nm", &Point::moment_amplitude, 1.0);
    put("range_without_shaft_Nm", &Point::range_without, 1.0);
    put("rms_without_shaft_Nm", &Point::rms_without, 1.0);
    put("best_range_shaft_angle_deg", &Point::best_range_angle, 1.0 / degree);
    put("best_range_Nm", &Point::best_range, 1.0);
    put("best_rms_shaft_angle_deg", &Point::best_rms_angle, 1.0 / degree);
    put("best_rms_Nm", &Point::best_rms, 1.0);
    using Criterion = SpeedStudy::Criterion;
    using Measure = SpeedStudy::Measure;
    const auto least_bad = [&](const std::vector<AngleStretch>& within) -> Json {
        const auto one = [&](Criterion criterion, Measure measure, const char* key) -> Json {
            const SpeedStudy::LeastBad found = study.least_bad_angle(criterion, measure, within);
            return {{"shaft_angle_deg", found.shaft_angle / degree},
                    {key, found.value},
                    {"worst_speed_rpm", found.worst_speed / units::rpm}};
        };
        return {{"range", one(Criterion::range, Measure::absolute, "range_Nm")},
                {"range_relative", one(Criterion::range, Measure::relative, "ratio")},
                {"rms", one(Criterion::rms, Measure::absolute, "rms_Nm")},
                {"rms_relative", one(Criterion::rms, Measure::relative, "ratio")}};
    };
    json["least_bad"] = least_bad(whole_turn());
    const BuildableAngles& buildable = study.buildable();
    json["least_bad_buildable"] = buildable.stretches.empty()
                                      ? Json{{"reason", buildable.reason.english()}}
                                      : least_bad(buildable.stretches);
    Json free_places = Json::object();
    Json places = Json::object();
    const auto put_places = [&](const char* name, Criterion criterion, Measure measure,
                                const char* key) {
        const auto write = [&](const std::optional<SpeedStudy::LeastBadPlace>& found) -> Json {
            if (!found) {
                return nullptr;
            }
            const ShaftPosition at{found->x, found->y};
            return {{"centre_distance_mm", at.centre_distance() / units::mm},
                    {"shaft_angle_deg", at.shaft_angle() / degree},
                    {key, found->value},
                    {"worst_speed_rpm", found->worst_speed / units::rpm},
                    {"gap", found->gap}};
        };
        const auto free = study.least_bad_place(criterion, measure);
        free_places[name] = write(free);
        places[name] = write(study.least_bad_place_buildable(criterion, measure, free));
    };
    put_places("range", Criterion::range, Measure::absolute, "range_Nm");
    put_places("range_relative", Criterion::range, Measure::relative, "ratio");
    put_places("rms", Criterion::rms, Measure::absolute, "rms_Nm");
    put_places("rms_relative", Criterion::rms, Measure::relative, "ratio");
    for (Json* const each : {&free_places, &places}) {
        if (each->at("range").is_null()) {
            (*each)["reason"] =
                (study.makes_moment() ? ShaftPlaces::reason_for_none() : no_moment()).english();
        }
    }
    json["least_bad_place"] = std::move(free_places);
    json["least_bad_place_buildable"] = std::move(places);
    if (map) {
        const std::size_t angles = map->shaft_angle_deg.size();
        Json ranges = Json::array();
        Json rms = Json::array();
        for (std::size_t k = 0; k < study.points().size(); ++k) {
            const auto from = static_cast<std::ptrdiff_t>(k * angles);
            const auto to = static_cast<std::ptrdiff_t>((k + 1) * angles);
            ranges.push_back(
                std::vector<double>(map->range.begin() + from, map->range.begin() + to));
            rms.push_back(std::vector<double>(map->rms.begin() + from, map->rms.begin() + to));
        }
        json["map"] = {{"shaft_angle_deg", map->shaft_angle_deg},
                       {"range_Nm", std::move(ranges)},
                       {"rms_Nm", std::move(rms)}};
    }
    return json;
}

}  // namespace ravnoves::balance_shaft

#include "balance-shaft/speed_study.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "balance-shaft/best_range.h"
#include "balance-shaft/engine_torque.h"
#include "balance-shaft/offset_cylinder.h"
#include "case-file/input_error.h"
#include "case-file/json.h"

namespace ravnoves::balance_shaft {

namespace {

double rms_of(double variance) {
    return std::sqrt(std::max(variance, 0.0));
}

double wrapped(double angle) {
    return angle - two_pi * std::floor(angle / two_pi);
}

/// The angle itself or the end of a stretch that is next to it round the turn.
double nearest(const std::vector<AngleStretch>& stretches, double angle) {
    double found = angle;
    double least = std::numeric_limits<double>::infinity();
    for (const AngleStretch& stretch : stretches) {
        if (wrapped(angle - stretch.from) <= stretch.to - stretch.from) {
            return angle;
        }
        for (const double end : {stretch.from, stretch.to}) {
            const double away = std::abs(std::remainder(end - angle, two_pi));
            if (away < least) {
                least = away;
                found = end;
            }
        }
    }
    return found;
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
        const InertiaCheck check = check_inertia(input.torque.table, input);
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
    buildable_ = buildable_angles(front_view(input));
    std::vector<AngleStretch> within = buildable_.stretches;
    turn(within);
    const auto gas_moment = with_offset_term(
        tipping_moment(parts->crank_angle_deg, parts->gas, input.interpolation), crank, 0.0);
    const auto inertia_moment = with_offset_term(
        tipping_moment(parts->crank_angle_deg, parts->unit_inertia, input.interpolation), crank,
        input.reciprocating_mass());
    const FourierPair gas_order = gas_moment.fourier(degree);
    const FourierPair inertia_order = inertia_moment.fourier(degree);
    // P₁ l for ω = 1.
    const double unit_amplitude =
        input.counterweight_mass.value_or(input.reciprocating_mass() * input.crank_radius /
                                          (2.0 * input.counterweight_radius)) *
        input.counterweight_radius * input.centre_distance;
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
        const double square = point.angular_speed * point.angular_speed;
        const double amplitude = unit_amplitude * square;
        const auto moment = PeriodicPiecewise::sum(gas_moment, inertia_moment, square);
        const FourierPair order{gas_order.a + square * inertia_order.a,
                                gas_order.b + square * inertia_order.b};
        const double variance = moment.variance();
        point.moment_amplitude = amplitude;
        point.range_without = CycleExtrema(moment, 0.0).range(0.0);
        point.rms_without = rms_of(variance);
        speeds_.push_back({CycleExtrema(moment, amplitude), variance, order});
        const BestRange best = minimise_range(speeds_.back().extrema);
        point.best_range_angle = wrapped(best.shaft_angle - phase_);
        point.best_range = best.range;
        // M_s opposes the first order.
        const double opposed = std::atan2(-order.a, -order.b);
        point.best_rms_angle = wrapped(opposed - phase_);
        if (!within.empty()) {
            point.buildable_range_angle =
                buildable_.contains(point.best_range_angle)
                    ? point.best_range_angle
                    : wrapped(minimise_range(speeds_.back().extrema, within).shaft_angle - phase_);
            point.buildable_rms_angle = wrapped(nearest(within, opposed) - phase_);
        }
        const double first = std::hypot(order.a, order.b);
        point.best_rms = rms_of(variance + amplitude * (amplitude / 2.0 - first));
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
    map.range.reserve(speeds_.size() * angles);
    map.rms.reserve(speeds_.size() * angles);
    for (std::size_t k = 0; k < speeds_.size(); ++k) {
        if (progress && !progress(static_cast<double>(k) / static_cast<double>(speeds_.size()))) {
            return std::nullopt;
        }
        const Speed& speed = speeds_[k];
        const double amplitude = points_[k].moment_amplitude;
        for (const double angle : map.shaft_angle_deg) {
            const double alpha = angle * degree + phase_;
            map.range.push_back(speed.extrema.range(alpha));
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

SpeedStudy::LeastBad SpeedStudy::least_bad_angle(Criterion criterion, Measure measure,
                                                 std::vector<AngleStretch> within) const {
    LeastBad answer;
    turn(within);
    if (speeds_.empty()) {
        return answer;
    }
    const bool by_range = criterion == Criterion::range;
    // For the RMS the variance is minimised, a sinusoid of α at each speed; its divisor is squared.
    std::vector<double> divisors;
    double steepest = 0.0;
    double size = 0.0;
    for (std::size_t k = 0; k < speeds_.size(); ++k) {
        const double without = by_range ? points_[k].range_without : points_[k].rms_without;
        double divisor = measure == Measure::relative && without > 0.0 ? without : 1.0;
        const double amplitude = points_[k].moment_amplitude;
        const double first = std::hypot(speeds_[k].order_1.a, speeds_[k].order_1.b);
        divisor = by_range ? divisor : divisor * divisor;
        divisors.push_back(divisor);
        steepest = std::max(steepest, (by_range ? 2.0 : first) * amplitude / divisor);
        size = std::max(size, (by_range ? amplitude : amplitude * (amplitude + first)) / divisor);
    }
    std::size_t worst = 0;
    const auto evaluate = [&](double alpha) {
        Cut<double> highest;
        highest.value = -1.0;
        for (std::size_t k = 0; k < speeds_.size(); ++k) {
            Cut<double> cut;
            if (by_range) {
                cut.value = speeds_[k].extrema.range(alpha) / divisors[k];
            } else {
                const double amplitude = points_[k].moment_amplitude;
                cut.bound = {(speeds_[k].variance + amplitude * amplitude / 2.0) / divisors[k],
                             amplitude * speeds_[k].order_1.b / divisors[k],
                             amplitude * speeds_[k].order_1.a / divisors[k]};
                cut.value = cut.bound(alpha);
            }
            if (cut.value > highest.value) {
                highest = cut;
                worst = k;
            }
        }
        if (by_range) {
            highest = range_cut(speeds_[worst].extrema, alpha);
            highest.value /= divisors[worst];
            highest.bound.constant /= divisors[worst];
            highest.bound.p /= divisors[worst];
            highest.bound.q /= divisors[worst];
        }
        highest.alpha = alpha;
        return highest;
    };
    const auto best = minimise_over_angle<double>(evaluate, steepest, size, within);
    evaluate(best.alpha);
    answer.shaft_angle = wrapped(best.alpha - phase_);
    answer.value = by_range ? best.value : rms_of(best.value);
    answer.gap = by_range ? best.gap : answer.value - rms_of(best.value - best.gap);
    answer.worst_speed = points_[worst].angular_speed;
    return answer;
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
    put("speed_rpm", &Point::angular_speed, 1.0 / rpm);
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
                    {"worst_speed_rpm", found.worst_speed / rpm}};
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

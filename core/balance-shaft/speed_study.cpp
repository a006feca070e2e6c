#include "balance-shaft/speed_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <span>
#include <utility>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/engine_torque.h"
#include "case-file/input_error.h"
#include "numerics/angle.h"

namespace ravnoves::balance_shaft {

namespace {

/// Ratios nearer than this are the same.
constexpr double exact = 1e-11;

double squared(double x) {
    return x * x;
}

}  // namespace

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
                          ? Message(Text::tr("The torque does not match masses and speed, so "
                                             "other speeds cannot be computed. %1"),
                                    check.text)
                          : check.text;
            return;
        }
    }
    const SliderCrank<double> crank = slider_crank(input);
    phase_ = crank.top_dead_centre() - piston_first_order(crank).lag;
    buildable_ = buildable_angles(front_view(input), input.place_limits);
    const std::vector<AngleStretch> within = turned(buildable_.stretches, phase_);
    gas_ = with_offset_term(parts->gas.negated(), crank, 0.0);
    inertia_ = with_offset_term(parts->unit_inertia.negated(), crank, input.reciprocating_mass());
    inertia_variance_ = inertia_.variance();
    twice_covariance_ = PeriodicPiecewise::sum(gas_, inertia_, 1.0).variance() - gas_.variance() -
                        inertia_variance_;
    unit_amplitude_ = input.unbalance() * input.centre_distance;
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
        point.range_without = speed.without.range();
        point.rms_without = speed.plane.rms({0.0, 0.0});
        const AngleMinimum best = minimise_range(speed.plane, speed.amplitude);
        point.best_range_angle = wrap_turn(best.alpha - phase_);
        point.best_range = best.value;
        const double opposed = std::atan2(speed.plane.opposed().x(), speed.plane.opposed().y());
        point.best_rms_angle = wrap_turn(opposed - phase_);
        point.best_rms = speed.plane.rms(shaft_at(speed.amplitude, opposed));
        if (!within.empty()) {
            point.buildable_range_angle =
                buildable_.contains(point.best_range_angle)
                    ? point.best_range_angle
                    : wrap_turn(minimise_range(speed.plane, speed.amplitude, within).alpha -
                                phase_);
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
    map.rms.resize(speeds_.size() * angles);
    for (std::size_t k = 0; k < speeds_.size(); ++k) {
        if (progress && !progress(static_cast<double>(k) / static_cast<double>(speeds_.size()))) {
            return std::nullopt;
        }
        const Speed& speed = speeds_[k];
        sweep(speed.plane, speed.amplitude, turned,
              std::span(map.range).subspan(k * angles, angles),
              std::span(map.rms).subspan(k * angles, angles));
    }
    if (progress) {
        progress(1.0);
    }
    return map;
}

SpeedStudy::Speed SpeedStudy::speed_at(double angular_speed) const {
    const double square = angular_speed * angular_speed;
    MomentPlane plane(PeriodicPiecewise::sum(gas_, inertia_, square));
    const MomentPlane::Extrema without = plane({0.0, 0.0});
    return {angular_speed, unit_amplitude_ * square, std::move(plane), without};
}

double SpeedStudy::Speed::without_shaft(Criterion criterion) const {
    return criterion == Criterion::range ? without.range() : plane.variance({0.0, 0.0});
}

double SpeedStudy::Speed::divisor(Criterion criterion, Measure measure) const {
    const double value = without_shaft(criterion);
    return measure == Measure::relative && value > 0.0 ? value : 1.0;
}

Cut SpeedStudy::Speed::cut(Criterion criterion, Measure measure, double alpha) const {
    const MomentPlane::Moment& opposed = plane.opposed();
    Cut cut = criterion == Criterion::range
                  ? range_cut(plane, amplitude, alpha)
                  : Cut{alpha,
                        plane.variance(shaft_at(amplitude, alpha)),
                        {without_shaft(criterion) + squared(amplitude) / 2.0,
                         -amplitude * opposed.y(), -amplitude * opposed.x()}};
    for (double* const part : {&cut.value, &cut.bound.constant, &cut.bound.p, &cut.bound.q}) {
        *part /= divisor(criterion, measure);
    }
    return cut;
}

/// At every α the largest of these speeds.
SpeedStudy::BestCompromise SpeedStudy::best_compromise_of(const std::vector<const Speed*>& speeds,
                                                          Criterion criterion, Measure measure,
                                                          const std::vector<AngleStretch>& within) {
    const bool by_range = criterion == Criterion::range;
    double size = 0.0;
    for (const Speed* speed : speeds) {
        const double amplitude = speed->amplitude / speed->divisor(criterion, measure);
        const double first = speed->plane.opposed().norm();
        size = std::max(size, (by_range ? 1.0 : speed->amplitude + first) * amplitude);
    }
    const Speed* worst = nullptr;
    const auto evaluate = [&](double alpha) {
        Cut highest;
        highest.value = -1.0;
        for (const Speed* speed : speeds) {
            const Cut cut = speed->cut(criterion, measure, alpha);
            if (cut.value > highest.value) {
                highest = cut;
                worst = speed;
            }
        }
        return highest;
    };
    const AngleMinimum best = minimise_over_angle(evaluate, size, within);
    evaluate(best.alpha);
    return {best.alpha, best.value, worst->angular_speed, best.gap};
}

/// The speed of the band at which the range, or the mean square, over that without a shaft is
/// largest, by branch and bound over q = ω²: both are convex in q (the largest of differences that
/// are linear in it; a square), so between two speeds that with the shaft lies under its chord,
/// that without over its tangents.
std::optional<SpeedStudy::Speed> SpeedStudy::worst_speed_of(const std::vector<const Speed*>& speeds,
                                                            Criterion criterion,
                                                            double alpha) const {
    struct End {
        double q = 0.0;  ///< ω²
        double with = 0.0;
        double without = 0.0;
        double slope = 0.0;  ///< of the value without a shaft by q
        double ratio = 0.0;
    };
    const auto end_of = [&](const Speed& speed) -> End {
        const double q = squared(speed.angular_speed);
        const double slope =
            criterion == Criterion::range
                ? inertia_(speed.without.max.angle_deg) - inertia_(speed.without.min.angle_deg)
                : twice_covariance_ + 2.0 * q * inertia_variance_;
        const double ratio = speed.cut(criterion, Measure::relative, alpha).value;
        return {q, ratio * speed.divisor(criterion, Measure::relative),
                speed.without_shaft(criterion), slope, ratio};
    };
    const auto max_between = [](const End& left, const End& right) {
        const double at_ends = std::max(left.ratio, right.ratio);
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
                                  [](const End& a, const End& b) { return a.ratio < b.ratio; });
    std::optional<Speed> found;
    using Interval = std::array<End, 2>;
    std::vector<Interval> open;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        open.push_back({ends[i], ends[i + 1]});
    }
    constexpr int max_evaluations = 2000;
    for (int evaluations = 0; !open.empty() && evaluations < max_evaluations;) {
        const Interval interval = open.back();
        open.pop_back();
        const double width = interval[1].q - interval[0].q;
        if (width <= exact * interval[1].q ||
            max_between(interval[0], interval[1]) <= worst.ratio * (1.0 + exact)) {
            continue;
        }
        const Speed speed = speed_at(std::sqrt(interval[0].q + width / 2.0));
        ++evaluations;
        const End middle = end_of(speed);
        if (middle.ratio > worst.ratio) {
            worst = middle;
            found = speed;
        }
        open.push_back({middle, interval[1]});
        open.push_back({interval[0], middle});
    }
    return found;
}

SpeedStudy::BestCompromise SpeedStudy::best_compromise_angle(
    Criterion criterion, Measure measure, const std::vector<AngleStretch>& within) const {
    if (speeds_.empty()) {
        return {};
    }
    // The best angle for some speeds, the worst speed for that angle, which joins them: so the best
    // for some becomes the best for the band.
    // In N·m the criterion is convex in ω²: the worst speed is an end of the band. Of the ratio a
    // few are enough to begin with.
    const std::size_t last = speeds_.size() - 1;
    const std::size_t intervals =
        std::min<std::size_t>(last, measure == Measure::absolute ? 1 : 12);
    std::vector<const Speed*> speeds{&speeds_.front()};
    for (std::size_t k = 1; k <= intervals; ++k) {
        speeds.push_back(&speeds_[k * last / intervals]);
    }
    const std::vector<AngleStretch> stretches = turned(within, phase_);
    std::deque<Speed> added;
    BestCompromise best;
    double bound = 0.0;
    constexpr int max_rounds = 60;
    for (int round = 0; round < max_rounds; ++round) {
        best = best_compromise_of(speeds, criterion, measure, stretches);
        bound = best.value - best.gap;
        if (measure == Measure::absolute) {
            break;
        }
        std::optional<Speed> other = worst_speed_of(speeds, criterion, best.shaft_angle);
        if (!other) {
            break;
        }
        const double value = other->cut(criterion, measure, best.shaft_angle).value;
        const bool is_same = value <= best.value * (1.0 + exact);
        if (value > best.value) {
            best.value = value;
            best.worst_speed = other->angular_speed;
        }
        if (is_same) {
            break;
        }
        speeds.push_back(&added.emplace_back(*std::move(other)));
    }
    if (criterion == Criterion::rms) {
        best.value = std::sqrt(std::max(best.value, 0.0));
        bound = std::sqrt(std::max(bound, 0.0));
    }
    best.gap = best.value - bound;
    best.shaft_angle = wrap_turn(best.shaft_angle - phase_);
    return best;
}

}  // namespace ravnoves::balance_shaft

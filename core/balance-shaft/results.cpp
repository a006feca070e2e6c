#include "balance-shaft/results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "balance-shaft/crank_balance.h"
#include "balance-shaft/dead_centre.h"
#include "balance-shaft/envelope_study.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/moments.h"
#include "balance-shaft/position_study.h"
#include "balance-shaft/result_fields.h"
#include "balance-shaft/speed_study.h"
#include "case-file/decimal.h"

namespace ravnoves::balance_shaft {

namespace {

namespace key = result_field;
using ravnoves::result_field::feasible;
using ravnoves::result_field::note;
using ravnoves::result_field::notes;
using ravnoves::result_field::reason;
using ravnoves::result_field::text;

void visit_metrics(ResultVisitor& visitor, const ResultField& field, const MomentMetrics& metrics) {
    visitor.object(field, [&] {
        visitor.number(key::mean, metrics.mean);
        visitor.number(key::max, metrics.max);
        visitor.number(key::min, metrics.min);
        visitor.number(key::range, metrics.range);
        visitor.number(key::rms, metrics.rms);
        visitor.number(key::max_crank_angle, metrics.max_angle);
        visitor.number(key::min_crank_angle, metrics.min_angle);
    });
}

void visit_optimum(ResultVisitor& visitor, const ResultField& field, const Optimum& optimum,
                   const ResultField& value) {
    visitor.object(field, [&] {
        visitor.number(key::shaft_angle, optimum.shaft_angle);
        visitor.number(value, optimum.value);
        if (!optimum.note.empty()) {
            visitor.text(note, optimum.note);
        }
    });
}

void visit_optima(ResultVisitor& visitor, const Optimum& range, const Optimum& rms) {
    visit_optimum(visitor, key::optimum_range, range, key::range);
    visit_optimum(visitor, key::optimum_rms, rms, key::rms);
}

/// What Moments::fill() gives.
void visit_moments(ResultVisitor& visitor, const Result& result) {
    visitor.number(key::angular_speed, result.angular_speed);
    visitor.number(key::reciprocating_mass, result.reciprocating_mass);
    visitor.number(key::inertia_force_1_max, result.inertia_force_1_max);
    visitor.number(key::counterweight_mass, result.counterweight_mass);
    visitor.number(key::counterweight_force, result.counterweight_force);
    // The force on the shaft's own counterweight has no other support.
    visitor.number(key::shaft_bearing_load, result.counterweight_force);
    visitor.number(key::moment_amplitude, result.moment_amplitude);
    visitor.number(key::shaft_angle, result.shaft_angle);
    visitor.object(key::metrics, [&] {
        visit_metrics(visitor, key::M_up, result.M_up);
        visit_metrics(visitor, key::M_s, result.M_s);
        visit_metrics(visitor, key::M_ups, result.M_ups);
    });
    visitor.object(key::change_without_shaft, [&] {
        visitor.number(key::range_percent, result.range_change);
        visitor.number(key::rms_percent, result.rms_change);
    });
    visitor.object(key::optimum,
                   [&] { visit_optima(visitor, result.best_range, result.best_rms); });
}

/// What neither visit_moments() nor RepeatedResults gives by themselves.
constexpr std::array needs_solver{&ravnoves::result_field::verdict,
                                  &ravnoves::result_field::notes,
                                  &key::printed_mean,
                                  &key::optimum_buildable,
                                  &key::order_1,
                                  &key::dead_centre,
                                  &key::counterweight_lag,
                                  &key::envelope,
                                  &key::inertia_check,
                                  &key::spectrum,
                                  &key::flywheel,
                                  &key::indicated,
                                  &key::curves,
                                  &key::sweep,
                                  &key::clearances,
                                  &key::crank_only,
                                  &key::envelope_study,
                                  &key::best_position,
                                  &key::best_position_buildable,
                                  &key::gear_error,
                                  &key::relieved_shaft,
                                  &key::speed_band};

void visit_feasible_angles(ResultVisitor& visitor, const BuildableAngles& buildable, double alpha) {
    visitor.object(key::buildable, [&] {
        std::vector<double> ends;
        for (const AngleStretch& stretch : buildable.stretches) {
            ends.push_back(stretch.from / degree);
            ends.push_back(stretch.to / degree);
        }
        visitor.rows(key::buildable_angles, ends, 2);
        visitor.flag(key::at_shaft_angle, buildable.contains(alpha));
        if (!buildable.reason.empty()) {
            visitor.text(reason, buildable.reason);
        }
    });
}

void visit_buildable(ResultVisitor& visitor, const Result& result) {
    // Of what can be built; null, with the reason, where nothing can.
    visitor.object(key::optimum_buildable, [&] {
        if (result.buildable.stretches.empty()) {
            visitor.nothing(key::optimum_range);
            visitor.nothing(key::optimum_rms);
            visitor.text(reason, result.buildable.reason);
        } else {
            visit_optima(visitor, result.best_range_buildable, result.best_rms_buildable);
        }
    });
    visit_feasible_angles(visitor, result.buildable, result.shaft_angle);
}

void visit_inertia_check(ResultVisitor& visitor, const InertiaCheck& check) {
    visitor.object(key::inertia_check, [&] {
        visitor.number(key::fitted, check.fitted);
        visitor.number(key::entered, check.entered);
        visitor.number(key::fitted_lambda,
                       check.fitted ? std::optional(check.fitted_lambda) : std::nullopt);
        visitor.flag(key::consistent, check.consistent);
        if (check.fitted) {
            visitor.number(key::residual_rms, check.residual_rms);
            visitor.number(key::matching_speed, check.matching_speed);
            visitor.number(key::matching_mass, check.matching_mass);
            visitor.flag(key::lambda_is_given, !check.lambda_fitted);
        }
        if (!check.consistent) {
            visitor.text(reason, check.text);
        }
        visitor.text(text, check.text);
    });
}

void visit_spectrum(ResultVisitor& visitor, const Result& result) {
    visitor.object(key::spectrum, [&] {
        const auto column = [&](const ResultField& field, const std::vector<OrderLine>& lines,
                                double OrderLine::*member) {
            std::vector<double> values;
            for (const OrderLine& line : lines) {
                values.push_back(line.*member);
            }
            visitor.numbers(field, values);
        };
        column(key::orders, result.spectrum_M_up, &OrderLine::order);
        column(key::M_up_amplitude, result.spectrum_M_up, &OrderLine::amplitude);
        column(key::M_up_phase, result.spectrum_M_up, &OrderLine::phase);
        column(key::M_ups_amplitude, result.spectrum_M_ups, &OrderLine::amplitude);
        column(key::M_ups_phase, result.spectrum_M_ups, &OrderLine::phase);
    });
}

void visit_flywheel(ResultVisitor& visitor, const Flywheel& flywheel) {
    visitor.object(key::flywheel, [&] {
        visitor.number(key::excess_work, flywheel.excess_work);
        visitor.number(key::fluctuation, flywheel.fluctuation);
        visitor.number(key::inertia, flywheel.inertia);
        visitor.number(key::max_energy, flywheel.max_energy);
        visitor.number(key::max_crank_angle, flywheel.max_angle);
        visitor.number(key::min_energy, flywheel.min_energy);
        visitor.number(key::min_crank_angle, flywheel.min_angle);
    });
}

void visit_indicated(ResultVisitor& visitor, const IndicatedCycle& indicated, double power,
                     double angular_speed) {
    visitor.object(key::indicated, [&] {
        visitor.number(key::displacement, indicated.displacement);
        visitor.number(key::clearance_volume, indicated.clearance);
        visitor.number(key::heat, indicated.heat);
        visitor.number(key::work, indicated.work);
        visitor.number(key::mean_effective_pressure, indicated.imep);
        visitor.number(key::power, power);
        visitor.number(key::mean_torque, power / angular_speed);
        visitor.number(key::peak_pressure, indicated.peak_pressure);
        visitor.number(key::peak_pressure_crank_angle, indicated.peak_pressure_angle);
    });
}

void visit_curves(ResultVisitor& visitor, const Result& result) {
    visitor.object(key::curves, [&] {
        const MomentCurves& curves = result.curves;
        visitor.numbers(key::crank_angles, curves.crank_angle_deg);
        visitor.numbers(key::M_up_curve, curves.M_up);
        visitor.numbers(key::M_s_curve, curves.M_s);
        visitor.numbers(key::M_ups_curve, curves.M_ups);
        visitor.numbers(key::excess_energy, result.flywheel.energy);
        if (result.indicated) {
            visitor.numbers(key::M_gas, curves.M_gas);
            visitor.numbers(key::M_inertia, curves.M_inertia);
            visitor.numbers(key::M_offset, curves.M_offset);
            visitor.numbers(key::pressure, curves.pressure);
            visitor.numbers(key::volume, curves.volume);
        }
    });
    visitor.object(key::sweep, [&] {
        const AngleSweep& sweep = result.sweep;
        visitor.numbers(key::shaft_angles, sweep.shaft_angle_deg);
        visitor.numbers(key::range, sweep.range);
        visitor.numbers(key::rms, sweep.rms);
        visitor.numbers(key::mean_M_s, sweep.mean_M_s);
        visitor.numbers(key::mean_M_ups, sweep.mean_M_ups);
        visitor.numbers(key::printed_mean_M_s, sweep.printed_mean_M_s);
        visitor.numbers(key::printed_mean_M_ups, sweep.printed_mean_M_ups);
    });
}

/// Free space at the shaft's angle and the sizes that it comes from.
void visit_clearances(ResultVisitor& visitor, const FrontView& view, double shaft_angle) {
    visitor.object(key::clearances, [&] {
        const ShaftClearance free = shaft_clearance(view, shaft_angle);
        visitor.number(key::crank_clearance, free.crank);
        visitor.number(key::cylinder_clearance, free.cylinder);
        visitor.number(key::rod_clearance, free.rod);
        visitor.number(key::min_allowed, view.clearance);
        visitor.number(key::shaft_swing_radius, view.shaft_swing_radius);
        visitor.number(key::crank_swing_radius, view.crank_swing_radius);
        visitor.number(key::rod_width, view.rod_width);
        visitor.number(key::cylinder_bore, view.cylinder_bore);
        visitor.number(key::cylinder_wall, view.cylinder_wall);
        visitor.number(key::cylinder_bottom, view.cylinder_bottom);
        visitor.number(key::cylinder_top, view.cylinder_top);
        visitor.number(key::gear_tip_radius, view.gear_tip_radius);
    });
}

void visit_crank_balance(ResultVisitor& visitor, const Solver& solver) {
    visitor.object(key::crank_only, [&] {
        const CrankBalance balance = crank_balance(solver);
        visitor.number(key::share, balance.share);
        visitor.number(key::first_order, balance.first_order);
        visitor.number(key::along_cylinder, balance.along);
        visitor.number(key::across_cylinder, balance.across);
        visitor.number(key::largest, balance.largest);
        visitor.number(key::counterweight_moment, balance.counterweight_moment);
        visitor.number(key::with_shaft, balance.with_shaft);
        visitor.number(key::second_order, balance.second_order);
    });
}

void visit_envelope_study(ResultVisitor& visitor, const Solver& solver) {
    visitor.object(key::envelope_study, [&] {
        const EnvelopeStudy study = envelope_study(solver);
        std::vector<std::size_t> efficient;
        for (std::size_t i = 0; i < study.efficient.size(); ++i) {
            if (study.efficient[i]) {
                efficient.push_back(i);
            }
        }
        visitor.list(key::efficient, efficient.size(), [&](std::size_t i) {
            visitor.number(key::shaft_angle, study.shaft_angle_deg[efficient[i]] * degree);
            visitor.number(key::width, study.width[efficient[i]]);
            visitor.number(key::height, study.height[efficient[i]]);
            visitor.number(key::range, study.range[efficient[i]]);
        });
    });
}

void visit_place(ResultVisitor& visitor, const ShaftPosition& place,
                 const PositionCriteria& criteria) {
    visitor.number(key::centre_distance, place.centre_distance());
    visitor.number(key::shaft_angle, place.shaft_angle());
    visitor.number(key::range, criteria.range);
    visitor.number(key::rms, criteria.rms);
}

void visit_best(ResultVisitor& visitor, const BestPositions& best) {
    const auto visit = [&](const ResultField& field, const std::optional<BestPosition>& one) {
        visitor.object_or_null(field, one.has_value(), [&] {
            visit_place(visitor, one->position, one->criteria);
            visitor.number(key::gap, one->gap);
        });
    };
    visit(key::optimum_range, best.range);
    visit(key::optimum_rms, best.rms);
    if (!best.reason.empty()) {
        visitor.text(reason, best.reason);
    }
}

void visit_places(ResultVisitor& visitor, const Solver& solver) {
    if (!visitor.wants(key::best_position.key) &&
        !visitor.wants(key::best_position_buildable.key)) {
        return;
    }
    const PositionStudy study(solver);
    visitor.object(key::best_position, [&] { visit_best(visitor, study.best()); });
    visitor.object(key::best_position_buildable, [&] {
        const BestPositions best = study.best_buildable();
        visit_best(visitor, best);
        if (visitor.wants(key::front.key)) {
            const std::vector<FrontPosition> front = study.front(best);
            visitor.list(key::front, front.size(), [&](std::size_t i) {
                visit_place(visitor, front[i].position, front[i].criteria);
                visitor.number(key::size, front[i].criteria.size);
            });
        }
        visitor.number(key::front_gap, PositionStudy::front_gap);
    });
}

void visit_gear_error(ResultVisitor& visitor, const Solver& solver, double shaft_angle) {
    visitor.object(key::gear_error, [&] {
        const GearError error = gear_error(solver, shaft_angle);
        visitor.number(key::phase_error, error.phase_error);
        visitor.number(key::residual_force, error.residual_force);
        visitor.number(key::range, error.range);
        visitor.number(key::rms, error.rms);
        visitor.number(key::play, error.play);
        visitor.number(key::play_force, error.play_force);
        visitor.number(key::play_range_low, error.play_range_low);
        visitor.number(key::play_range_high, error.play_range_high);
    });
}

void visit_relieved_shaft(ResultVisitor& visitor, const RelievedShaft& shaft) {
    visitor.object(key::relieved_shaft, [&] {
        visitor.flag(feasible, shaft.feasible);
        if (!shaft.feasible) {
            visitor.text(reason, shaft.reason);
        }
        const auto put = [&](const ResultField& field, double value) {
            if (shaft.feasible || value > 0.0) {
                visitor.number(field, value);
            }
        };
        put(key::required_unbalance, shaft.required);
        put(key::unbalance, shaft.unbalance);
        put(key::diameter, shaft.diameter);
        put(key::depth, shaft.depth);
        put(key::length, shaft.length);
        put(key::flat_width, 2.0 * shaft.half_width);
        put(key::removed_mass, shaft.removed_mass);
        put(key::relieved_part_mass, shaft.mass);
        put(key::centre_of_mass_radius, shaft.centre_of_mass_radius);
        put(key::critical_radius, shaft.critical_radius);
        put(key::critical_length, shaft.critical_length);
        if (!shaft.note.empty()) {
            visitor.text(note, shaft.note);
        }
    });
}

void visit_compromise(ResultVisitor& visitor, const ResultField& field, const SpeedStudy& study,
                      const std::vector<AngleStretch>& within) {
    visitor.object(field, [&] {
        if (within.empty()) {
            visitor.text(reason, study.buildable().reason);
            return;
        }
        using Criterion = SpeedStudy::Criterion;
        using Measure = SpeedStudy::Measure;
        const auto one = [&](const ResultField& name, Criterion criterion, Measure measure,
                             const ResultField& value) {
            visitor.object(name, [&] {
                const auto found = study.best_compromise_angle(criterion, measure, within);
                visitor.number(key::shaft_angle, found.shaft_angle);
                visitor.number(value, found.value);
                visitor.number(key::worst_speed, found.worst_speed);
            });
        };
        one(key::optimum_range, Criterion::range, Measure::absolute, key::range);
        one(key::range_relative, Criterion::range, Measure::relative, key::ratio);
        one(key::optimum_rms, Criterion::rms, Measure::absolute, key::rms);
        one(key::rms_relative, Criterion::rms, Measure::relative, key::ratio);
    });
}

void visit_speed_band(ResultVisitor& visitor, const Input& input, const SpeedBand& band) {
    visitor.object(key::speed_band, [&] {
        const SpeedStudy study(input, band);
        visitor.flag(feasible, study.reason().empty());
        if (!study.reason().empty()) {
            visitor.text(reason, study.reason());
            return;
        }
        using Point = SpeedStudy::Point;
        const auto column = [&](const ResultField& field, double Point::*member) {
            std::vector<double> values;
            for (const Point& point : study.points()) {
                values.push_back(point.*member);
            }
            visitor.numbers(field, values);
        };
        column(key::speeds, &Point::angular_speed);
        column(key::moment_amplitude, &Point::moment_amplitude);
        column(key::range_without_shaft, &Point::range_without);
        column(key::rms_without_shaft, &Point::rms_without);
        column(key::best_range_angle, &Point::best_range_angle);
        column(key::best_range, &Point::best_range);
        column(key::best_rms_angle, &Point::best_rms_angle);
        column(key::best_rms, &Point::best_rms);
        visit_compromise(visitor, key::best_compromise, study, whole_turn());
        visit_compromise(visitor, key::best_compromise_feasible, study,
                         study.buildable().stretches);
        if (band.map) {
            visitor.object(key::map, [&] {
                constexpr std::size_t angles = 360;
                const auto map = study.map(angles);
                visitor.numbers(key::shaft_angles, map->shaft_angle_deg);
                visitor.rows(key::range, map->range, angles);
                visitor.rows(key::rms, map->rms, angles);
            });
        }
    });
}

std::vector<Message> notes_of(const Input& input, const Result& result) {
    std::vector<Message> said = result.doubts;
    if (Message note = dead_centre_note(input, find_dead_centre(input)); !note.empty()) {
        said.push_back(std::move(note));
    }
    said.insert(said.end(), result.notes.begin(), result.notes.end());
    if (!result.assumed_sizes.empty()) {
        said.push_back(result.assumed_sizes);
    }
    return said;
}

}  // namespace

void visit_results(ResultVisitor& visitor, const Solver& solver, const Result& result) {
    visit_verdict(visitor, [&] { return verdict(result); });
    visit_moments(visitor, result);
    visitor.object(key::printed_mean, [&] {
        visitor.number(key::M_s_25_nodes, result.printed_mean_M_s);
        visitor.number(key::M_up_nodes, result.printed_mean_M_up);
        visitor.number(key::M_ups_nodes, result.printed_mean_M_ups);
    });
    visit_buildable(visitor, result);
    visitor.object(key::order_1, [&] {
        visitor.number(key::amplitude, result.order_1_amplitude);
        visitor.number(key::phase, result.order_1_phase);
        visitor.number(key::share_of_variance, result.order_1_share);
    });
    visitor.number(key::dead_centre, result.dead_centre);
    visitor.number(key::counterweight_lag, result.counterweight_lag);
    visitor.object(key::envelope, [&] {
        visitor.number(key::width, result.envelope.width());
        visitor.number(key::height, result.envelope.height());
    });
    visitor.texts(notes, [&] { return notes_of(solver.input(), result); });
    visit_inertia_check(visitor, result.inertia_check);
    visit_spectrum(visitor, result);
    visit_flywheel(visitor, result.flywheel);
    if (result.indicated) {
        visit_indicated(visitor, *result.indicated, result.indicated_power, result.angular_speed);
    }
    visit_curves(visitor, result);
    visit_clearances(visitor, solver.front_view(), result.shaft_angle);
    visit_crank_balance(visitor, solver);
    visit_envelope_study(visitor, solver);
    visit_places(visitor, solver);
    visit_gear_error(visitor, solver, result.shaft_angle);
    if (solver.input().relieved_shaft) {
        visit_relieved_shaft(visitor, result.relieved_shaft);
    }
    if (const auto& band = solver.input().speed_band) {
        visit_speed_band(visitor, solver.input(), *band);
    }
}

void visit_results(ResultVisitor& visitor, const Input& input) {
    RepeatedResults({}).visit(visitor, input);
}

RepeatedResults::RepeatedResults(std::span<const std::string> varied)
    : keeps_torque_(std::none_of(varied.begin(), varied.end(), [](const std::string& pointer) {
          return pointer.starts_with("/torque") || pointer == "/cylinder/offset_mm";
      })) {}

const Moments& RepeatedResults::moments_of(const Input& input) {
    if (!moments_ || !keeps_torque_ || !moments_->follow(input)) {
        moments_.emplace(input);
    }
    return *moments_;
}

const BuildableAngles& RepeatedResults::buildable_of(const Input& input) {
    const FrontView view = front_view(input);
    if (view_ != view || limits_ != input.place_limits) {
        buildable_ = buildable_angles(view, input.place_limits);
        view_ = view;
        limits_ = input.place_limits;
    }
    return buildable_;
}

void RepeatedResults::visit(ResultVisitor& visitor, const Input& input) {
    if (std::any_of(needs_solver.begin(), needs_solver.end(),
                    [&](const ResultField* field) { return visitor.wants(field->key); })) {
        const Solver solver(input);
        visit_results(visitor, solver, solver.result());
        return;
    }
    Result result;
    moments_of(input).fill(input, visitor.wants(key::optimum.key), result);
    visit_moments(visitor, result);
    if (visitor.wants(key::buildable.key)) {
        visit_feasible_angles(visitor, buildable_of(input), result.shaft_angle);
    }
}

namespace {

/// At some α the shaft fits, so crank and gears let it: these are of the place.
Text what_is_met(Obstacle obstacle) {
    switch (obstacle) {
        case Obstacle::rod:
            return CORE_TEXT("balance-shaft", "Does not fit: at this α the shaft meets the rod.");
        case Obstacle::limits:
            return CORE_TEXT("balance-shaft",
                             "Does not fit: at this α the shaft is outside the limits.");
        default:
            return CORE_TEXT("balance-shaft",
                             "Does not fit: at this α the shaft meets the cylinder.");
    }
}

/// Of the shaft alone, without warnings about the input.
Verdict shaft_verdict(const Result& result) {
    const auto percent = [](double share) {
        return Number{100.0 * std::abs(share), units::percent, -1};
    };
    const std::string_view best =
        !result.buildable.stretches.empty() && result.best_range_buildable.shaft_angle
            ? best_range_act
            : "";
    if (!result.is_buildable) {
        return {Severity::error,
                result.buildable.stretches.empty()
                    ? Message(CORE_TEXT("balance-shaft", "Does not fit at any α. %1"),
                              result.buildable.reason)
                    : Message(what_is_met(result.obstacle)),
                best};
    }
    if (!result.range_change || !result.rms_change) {
        return {Severity::note,
                Message(CORE_TEXT("balance-shaft", "The torque is constant: no shaft required."))};
    }
    const int range = sign_as_shown(*result.range_change);
    const int rms = sign_as_shown(*result.rms_change);
    const Message of_range =
        range < 0   ? Message(CORE_TEXT("balance-shaft",
                                        "Fits: the range is %1 smaller than without shaft."),
                              percent(*result.range_change))
        : range > 0 ? Message(CORE_TEXT("balance-shaft",
                                        "Fits, but the range is %1 larger than without shaft."),
                              percent(*result.range_change))
                    : Message(CORE_TEXT("balance-shaft", "Fits, but does not change the range."));
    const Message of_rms = rms < 0 ? Message(CORE_TEXT("balance-shaft", "The RMS is %1 smaller."),
                                             percent(*result.rms_change))
                           : rms > 0
                               ? Message(CORE_TEXT("balance-shaft", "The RMS is %1 larger."),
                                         percent(*result.rms_change))
                               : Message(CORE_TEXT("balance-shaft", "The RMS does not change."));
    return {range > 0               ? Severity::warning
            : range < 0 && rms <= 0 ? Severity::good
                                    : Severity::note,
            Message(Text{"", "%1 %2"}, of_range, of_rms), range < 0 ? "" : best};
}

/// Where no feasible α is better than no shaft.
Message useless(const Result& result) {
    if (result.buildable.stretches.empty() || result.moment_amplitude == 0.0) {
        return {};
    }
    const bool range = result.best_range_buildable.value >= result.M_up.range;
    const bool rms = result.best_rms_buildable.value >= result.M_up.rms;
    return range && rms ? CORE_TEXT("balance-shaft",
                                    "At every feasible α, range and RMS are larger than without "
                                    "shaft.")
           : range      ? CORE_TEXT("balance-shaft",
                                    "At every feasible α, the range is larger than without shaft.")
           : rms        ? CORE_TEXT("balance-shaft",
                                    "At every feasible α, the RMS is larger than without shaft.")
                        : Message();
}

}  // namespace

Verdict verdict(const Result& result) {
    Verdict verdict = shaft_verdict(result);
    if (const Message none_helps = useless(result); !none_helps.empty()) {
        verdict.text = Message(Text{"", "%1 %2"}, verdict.text, none_helps);
    }
    for (const Message& doubt : result.doubts) {
        verdict.warn(doubt);
    }
    // The notes say how that is known.
    const InertiaCheck& check = result.inertia_check;
    if (check.consistent == false && check.is_of_other_rod) {
        verdict.warn(CORE_TEXT("balance-shaft", "Torque and rod do not match."));
    } else if (check.consistent == false) {
        verdict.warn({CORE_TEXT("balance-shaft",
                                "Torque and masses do not match: the torque fits %1 or %2."),
                      Number{rounded_to_digits(check.matching_speed / units::rpm, 4), units::rpm},
                      Number{rounded_to_digits(check.matching_mass, 3), units::kg}});
    }
    if (result.trace_is_a_turn_off) {
        verdict.act = move_trace_act;
    }
    return verdict;
}

}  // namespace ravnoves::balance_shaft

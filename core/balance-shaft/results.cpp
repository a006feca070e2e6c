#include "balance-shaft/results.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "balance-shaft/clearance.h"
#include "balance-shaft/crank_balance.h"
#include "balance-shaft/dead_centre.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/position_study.h"
#include "balance-shaft/result_fields.h"
#include "balance-shaft/shaft_places.h"
#include "balance-shaft/speed_study.h"
#include "case-file/decimal.h"

namespace ravnoves::balance_shaft {

namespace {

namespace key {
using namespace result_field;
constexpr ResultField shaft_angle{"shaft_angle_deg", Text::tr("α"), 2};
constexpr ResultField optimum{"optimum", Text::tr("Best α")};
constexpr ResultField optimum_range{"range", Text::tr("minimum range")};
constexpr ResultField optimum_rms{"rms", Text::tr("minimum RMS")};
constexpr ResultField range{"range_Nm", Text::tr("range"), 2,
                            Text::tr("Maximum minus minimum over the cycle.")};
constexpr ResultField rms{"rms_Nm", Text::tr("RMS"), 2,
                          Text::tr("About the mean, over the cycle.")};
constexpr ResultField max_crank_angle =
    ResultField{"max_crank_angle_deg", Text::tr("φ of the maximum"), 1}.with(Period::cycle);
constexpr ResultField min_crank_angle =
    ResultField{"min_crank_angle_deg", Text::tr("φ of the minimum"), 1}.with(Period::cycle);
constexpr ResultField width{"width_mm", Text::tr("width"), 1};
constexpr ResultField height{"height_mm", Text::tr("height"), 1};
constexpr ResultField shaft_angles{"shaft_angle_deg", Text::tr("α"), 1, {}, units::none};
constexpr ResultField front{"front", Text::tr("Pareto-optimal places")};
constexpr ResultField ratio{"ratio", Text::tr("over its value without shaft"), 4};
}  // namespace key
using ravnoves::result_field::feasible;
using ravnoves::result_field::note;
using ravnoves::result_field::notes;
using ravnoves::result_field::reason;
using ravnoves::result_field::text;

void visit_metrics(ResultVisitor& visitor, const ResultField& field, const MomentMetrics& metrics) {
    visitor.object(field, [&] {
        visitor.number({"mean_Nm", Text::tr("mean"), 2}, metrics.mean);
        visitor.number({"max_Nm", Text::tr("maximum"), 2}, metrics.max);
        visitor.number({"min_Nm", Text::tr("minimum"), 2}, metrics.min);
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
    visitor.number({"angular_speed_rad_s", Text::tr("Angular speed ω"), 2}, result.angular_speed);
    visitor.number({"reciprocating_mass_kg", Text::tr("Reciprocating mass mⱼ"), 4},
                   result.reciprocating_mass);
    visitor.number(key::inertia_force_1_max, result.inertia_force_1_max);
    visitor.number(key::counterweight_mass, result.counterweight_mass);
    visitor.number(key::counterweight_force, result.counterweight_force);
    // The force on the shaft's own counterweight has no other support.
    visitor.number(key::shaft_bearing_load, result.counterweight_force);
    visitor.number(key::moment_amplitude, result.moment_amplitude);
    visitor.number(key::shaft_angle, result.shaft_angle);
    visitor.object({"metrics"}, [&] {
        visit_metrics(visitor, {"M_up", Text::tr("Mᵤₚ")}, result.M_up);
        visit_metrics(visitor, {"M_s", Text::tr("Mₛ")}, result.M_s);
        visit_metrics(visitor, {"M_ups", Text::tr("Mᵤₚₛ")}, result.M_ups);
    });
    visitor.object({"change_without_shaft", Text::tr("Change vs. no shaft")}, [&] {
        visitor.number({"range_percent", Text::tr("range"), 1}, result.range_change);
        visitor.number({"rms_percent", Text::tr("RMS"), 1}, result.rms_change);
    });
    visitor.object(key::optimum,
                   [&] { visit_optima(visitor, result.best_range, result.best_rms); });
}

void visit_best_buildable(ResultVisitor& visitor, const Result& result) {
    if (result.buildable.stretches.empty()) {
        visitor.nothing(key::optimum_range);
        visitor.nothing(key::optimum_rms);
        visitor.text(reason, result.buildable.reason);
    } else {
        visit_optima(visitor, result.best_range_buildable, result.best_rms_buildable);
    }
}

/// Whether the shaft fits at an angle, which may have been rounded before.
bool fits_at(const Input& input, double alpha) {
    const FrontView view = front_view(input);
    const ShaftPlaces places(view, input.place_limits);
    const double l = view.centre_distance;
    constexpr double rounding = 1e-9;  // m
    return places.obstacle_at_distance(l) == Obstacle::none &&
           places.spare(l * std::sin(alpha), l * std::cos(alpha)) >= -rounding;
}

void visit_feasible_angles(ResultVisitor& visitor, const BuildableAngles& buildable, bool fits) {
    std::vector<double> ends;
    for (const AngleStretch& stretch : buildable.stretches) {
        ends.push_back(stretch.from / degree);
        ends.push_back(stretch.to / degree);
    }
    visitor.rows({"shaft_angles_deg", Text::tr("Feasible α"), 3, {}, units::none}, ends, 2);
    visitor.flag({"at_shaft_angle", Text::tr("Feasible at this α"), 0}, fits);
    if (!buildable.reason.empty()) {
        visitor.text(reason, buildable.reason);
    }
}

void visit_inertia_check(ResultVisitor& visitor, const InertiaCheck& check) {
    visitor.number({"fitted_m_r2_w2_Nm", Text::tr("m r² ω² fitted"), 2}, check.fitted);
    visitor.number({"entered_m_r2_w2_Nm", Text::tr("m r² ω² entered"), 2}, check.entered);
    visitor.number({"fitted_lambda", Text::tr("λ fitted"), 4},
                   check.fitted ? std::optional(check.fitted_lambda) : std::nullopt);
    visitor.flag({"consistent", Text::tr("consistent"), 0}, check.consistent);
    if (check.fitted) {
        visitor.number({"residual_rms_Nm", Text::tr("residual RMS"), 2}, check.residual_rms);
        visitor.number({"matching_speed_rpm", Text::tr("speed that fits"), 0},
                       check.matching_speed);
        visitor.number({"matching_mass_kg", Text::tr("mass that fits"), 4}, check.matching_mass);
        visitor.flag({"lambda_is_given", Text::tr("λ is given"), 0}, !check.lambda_fitted);
    }
    if (!check.consistent) {
        visitor.text(reason, check.text);
    }
    visitor.text(text, check.text);
}

/// One member of each row.
template <typename Row>
void visit_column(ResultVisitor& visitor, const ResultField& field, const std::vector<Row>& rows,
                  double Row::*member) {
    std::vector<double> values;
    for (const Row& row : rows) {
        values.push_back(row.*member);
    }
    visitor.numbers(field, values);
}

void visit_spectrum(ResultVisitor& visitor, const Result& result) {
    const auto column = [&](const ResultField& field, const std::vector<OrderLine>& lines,
                            double OrderLine::*member) {
        visit_column(visitor, field, lines, member);
    };
    column({"order", Text::tr("order"), 1}, result.spectrum_M_up, &OrderLine::order);
    column({"M_up_amplitude_Nm", Text::tr("Mᵤₚ, amplitude"), 2}, result.spectrum_M_up,
           &OrderLine::amplitude);
    column({"M_up_phase_deg", Text::tr("Mᵤₚ, phase"), 1}, result.spectrum_M_up, &OrderLine::phase);
    column({"M_ups_amplitude_Nm", Text::tr("Mᵤₚₛ, amplitude"), 2}, result.spectrum_M_ups,
           &OrderLine::amplitude);
    column({"M_ups_phase_deg", Text::tr("Mᵤₚₛ, phase"), 1}, result.spectrum_M_ups,
           &OrderLine::phase);
}

void visit_flywheel(ResultVisitor& visitor, const Flywheel& flywheel) {
    visitor.number(key::excess_work, flywheel.excess_work);
    visitor.number(key::fluctuation, flywheel.fluctuation);
    visitor.number(key::inertia, flywheel.inertia);
    visitor.number({"max_energy_J", Text::tr("maximum energy"), 1}, flywheel.max_energy);
    visitor.number(key::max_crank_angle, flywheel.max_angle);
    visitor.number({"min_energy_J", Text::tr("minimum energy"), 1}, flywheel.min_energy);
    visitor.number(key::min_crank_angle, flywheel.min_angle);
}

void visit_indicated(ResultVisitor& visitor, const IndicatedCycle& indicated, double power,
                     double angular_speed) {
    visitor.number(key::displacement, indicated.displacement);
    visitor.number(key::clearance_volume, indicated.clearance);
    visitor.number(key::heat, indicated.heat);
    visitor.number(key::work, indicated.work);
    visitor.number(key::mean_effective_pressure, indicated.imep);
    visitor.number(key::power, power);
    visitor.number(key::mean_torque, power / angular_speed);
    visitor.number(key::peak_pressure, indicated.peak_pressure);
    visitor.number(key::peak_pressure_crank_angle, indicated.peak_pressure_angle);
}

void visit_curves(ResultVisitor& visitor, const Result& result) {
    const MomentCurves& curves = result.curves;
    visitor.numbers({"crank_angle_deg", Text::tr("Crank angle φ"), 1, {}, units::none},
                    curves.crank_angle_deg);
    visitor.numbers({"M_up_Nm", Text::tr("Mᵤₚ"), 2}, curves.M_up);
    visitor.numbers({"M_s_Nm", Text::tr("Mₛ"), 2}, curves.M_s);
    visitor.numbers({"M_ups_Nm", Text::tr("Mᵤₚₛ"), 2}, curves.M_ups);
    visitor.numbers({"excess_energy_J", Text::tr("excess energy"), 1}, result.flywheel.energy);
    if (result.indicated) {
        visitor.numbers({"M_gas_Nm", Text::tr("gas torque"), 2}, curves.M_gas);
        visitor.numbers({"M_inertia_Nm", Text::tr("inertia torque"), 2}, curves.M_inertia);
        visitor.numbers({"M_offset_Nm", Text::tr("moment of the offset"), 2}, curves.M_offset);
        visitor.numbers({"pressure_bar", Text::tr("pressure"), 2}, curves.pressure);
        visitor.numbers({"volume_cm3", Text::tr("volume"), 2}, curves.volume);
    }
}

void visit_sweep(ResultVisitor& visitor, const AngleSweep& sweep) {
    visitor.numbers(key::shaft_angles, sweep.shaft_angle_deg);
    visitor.numbers(key::range, sweep.range);
    visitor.numbers(key::rms, sweep.rms);
    visitor.numbers({"mean_M_s_Nm", Text::tr("mean of Mₛ"), 2}, sweep.mean_M_s);
    visitor.numbers({"mean_M_ups_Nm", Text::tr("mean of Mᵤₚₛ"), 2}, sweep.mean_M_ups);
    visitor.numbers({"printed_mean_M_s_25_nodes_Nm", Text::tr("mean of 25 rows of Mₛ"), 2},
                    sweep.printed_mean_M_s);
    visitor.numbers({"printed_mean_M_ups_nodes_Nm", Text::tr("mean of table rows of Mᵤₚₛ"), 2},
                    sweep.printed_mean_M_ups);
}

/// Free space at the shaft's angle and the sizes that it comes from.
void visit_clearances(ResultVisitor& visitor, const FrontView& view, double shaft_angle) {
    const ShaftClearance free = shaft_clearance(view, shaft_angle);
    visitor.number({"crank_mm", Text::tr("to the crank"), 1}, free.crank);
    visitor.number({"cylinder_mm", Text::tr("to the cylinder"), 1}, free.cylinder);
    visitor.number({"rod_mm", Text::tr("to the rod"), 1}, free.rod);
    visitor.number({"least_allowed_mm", Text::tr("minimum allowed"), 1}, view.clearance);
    visitor.number({"shaft_swing_radius_mm", Text::tr("swing radius of the shaft"), 1},
                   view.shaft_swing_radius);
    visitor.number({"crank_swing_radius_mm", Text::tr("swing radius of the crank"), 1},
                   view.crank_swing_radius);
    visitor.number({"rod_width_mm", Text::tr("width of the rod"), 1}, view.rod_width);
    visitor.number({"cylinder_bore_mm", Text::tr("cylinder bore"), 1}, view.cylinder_bore);
    visitor.number({"cylinder_wall_mm", Text::tr("cylinder wall"), 1}, view.cylinder_wall);
    visitor.number({"cylinder_bottom_mm", Text::tr("bottom of the cylinder"), 1},
                   view.cylinder_bottom);
    visitor.number({"cylinder_top_mm", Text::tr("top of the cylinder"), 1}, view.cylinder_top);
    visitor.number({"gear_tip_radius_mm", Text::tr("tip radius of the gear"), 1},
                   view.gear_tip_radius);
}

void visit_crank_balance(ResultVisitor& visitor, const Solver& solver) {
    const CrankBalance balance = crank_balance(solver);
    visitor.number({"share", Text::tr("share balanced on the crank")}, balance.share);
    visitor.number(key::first_order, balance.first_order);
    visitor.number(key::along_cylinder, balance.along);
    visitor.number(key::across_cylinder, balance.across);
    visitor.number({"largest_N", Text::tr("maximum"), 1}, balance.largest);
    visitor.number(
        {"counterweight_moment_kg_m", Text::tr("unbalance of the crank's counterweight"), 5},
        balance.counterweight_moment);
    visitor.number(key::with_shaft, balance.with_shaft);
    visitor.number(key::second_order, balance.second_order);
}

void visit_envelope_study(ResultVisitor& visitor, const Solver& solver) {
    const EnvelopeStudy study = envelope_study(solver);
    std::vector<std::size_t> efficient;
    for (std::size_t i = 0; i < study.efficient.size(); ++i) {
        if (study.efficient[i]) {
            efficient.push_back(i);
        }
    }
    visitor.list({"efficient", Text::tr("Pareto-optimal")}, efficient.size(), [&](std::size_t i) {
        visitor.number(key::shaft_angle, study.shaft_angle_deg[efficient[i]] * degree);
        visitor.number(key::width, study.width[efficient[i]]);
        visitor.number(key::height, study.height[efficient[i]]);
        visitor.number(key::range, study.range[efficient[i]]);
    });
}

void visit_place(ResultVisitor& visitor, const ShaftPosition& place,
                 const PositionCriteria& criteria) {
    visitor.number({"centre_distance_mm", Text::tr("centre distance l"), 2},
                   place.centre_distance());
    visitor.number(key::shaft_angle, place.shaft_angle());
    visitor.number(key::range, criteria.range);
    visitor.number(key::rms, criteria.rms);
}

void visit_best(ResultVisitor& visitor, const BestPositions& best) {
    const auto visit = [&](const ResultField& field, const std::optional<BestPosition>& one) {
        visitor.object_or_null(field, one.has_value(), [&] {
            visit_place(visitor, one->position, one->criteria);
            visitor.number({"gap_Nm", Text::tr("certified gap"), 6}, one->gap);
        });
    };
    visit(key::optimum_range, best.range);
    visit(key::optimum_rms, best.rms);
    if (!best.reason.empty()) {
        visitor.text(reason, best.reason);
    }
}

void visit_front(ResultVisitor& visitor, const PositionStudy& study) {
    const BestPositions best = study.best_buildable();
    visit_best(visitor, best);
    if (visitor.wants(key::front.key)) {
        const std::vector<BestPosition> front = study.front(best);
        visitor.list(key::front, front.size(), [&](std::size_t i) {
            visit_place(visitor, front[i].position, front[i].criteria);
            visitor.number({"size_m2", Text::tr("size"), 4}, front[i].criteria.size);
        });
    }
    visitor.number({"front_gap", Text::tr("certified gap of the places"), 6},
                   PositionStudy::front_gap);
}

void visit_gear_error(ResultVisitor& visitor, const Solver& solver, double shaft_angle) {
    const GearError error = gear_error(solver, shaft_angle);
    visitor.number({"phase_error_deg", Text::tr("phase error")}, error.phase_error);
    visitor.number(key::residual_force, error.residual_force);
    visitor.number(key::range, error.range);
    visitor.number(key::rms, error.rms);
    visitor.number({"play_deg", Text::tr("play")}, error.play);
    visitor.number({"play_force_N", Text::tr("force from the play"), 1}, error.play_force);
    visitor.number({"play_range_low_Nm", Text::tr("minimum range over the play"), 2},
                   error.play_range_low);
    visitor.number({"play_range_high_Nm", Text::tr("maximum range over the play"), 2},
                   error.play_range_high);
}

void visit_relieved_shaft(ResultVisitor& visitor, const RelievedShaft& shaft) {
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
    put({"diameter_mm", Text::tr("diameter"), 2}, shaft.diameter);
    put({"depth_mm", Text::tr("depth of the relief")}, shaft.depth);
    put({"length_mm", Text::tr("length of the relief"), 2}, shaft.length);
    put(key::flat_width, 2.0 * shaft.half_width);
    put(key::removed_mass, shaft.removed_mass);
    put(key::relieved_part_mass, shaft.mass);
    put(key::centre_of_mass_radius, shaft.centre_of_mass_radius);
    put(key::critical_radius, shaft.critical_radius);
    put(key::critical_length, shaft.critical_length);
    if (!shaft.note.empty()) {
        visitor.text(note, shaft.note);
    }
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
                visitor.number({"worst_speed_rpm", Text::tr("worst speed"), 0}, found.worst_speed);
            });
        };
        one(key::optimum_range, Criterion::range, Measure::absolute, key::range);
        one({"range_relative", Text::tr("range, relative")}, Criterion::range, Measure::relative,
            key::ratio);
        one(key::optimum_rms, Criterion::rms, Measure::absolute, key::rms);
        one({"rms_relative", Text::tr("RMS, relative")}, Criterion::rms, Measure::relative,
            key::ratio);
    });
}

void visit_speed_band(ResultVisitor& visitor, const Input& input, const SpeedBand& band) {
    const SpeedStudy study(input, band);
    visitor.flag(feasible, study.reason().empty());
    if (!study.reason().empty()) {
        visitor.text(reason, study.reason());
        return;
    }
    using Point = SpeedStudy::Point;
    const auto column = [&](const ResultField& field, double Point::*member) {
        visit_column(visitor, field, study.points(), member);
    };
    column({"speed_rpm", Text::tr("speed"), 0}, &Point::angular_speed);
    column(key::moment_amplitude, &Point::moment_amplitude);
    column({"range_without_shaft_Nm", Text::tr("range without shaft"), 2}, &Point::range_without);
    column({"rms_without_shaft_Nm", Text::tr("RMS without shaft"), 2}, &Point::rms_without);
    column({"best_range_shaft_angle_deg", Text::tr("α of the minimum range"), 2},
           &Point::best_range_angle);
    column({"best_range_Nm", Text::tr("minimum range"), 2}, &Point::best_range);
    column({"best_rms_shaft_angle_deg", Text::tr("α of the minimum RMS"), 2},
           &Point::best_rms_angle);
    column({"best_rms_Nm", Text::tr("minimum RMS"), 2}, &Point::best_rms);
    visit_compromise(visitor, {"least_bad", Text::tr("Best compromise")}, study, whole_turn());
    visit_compromise(visitor, {"least_bad_buildable", Text::tr("Best feasible compromise")}, study,
                     study.buildable().stretches);
    if (band.map) {
        visitor.object({"map", Text::tr("Map over speed and α")}, [&] {
            constexpr std::size_t angles = 360;
            const auto map = study.map(angles);
            visitor.numbers(key::shaft_angles, map->shaft_angle_deg);
            visitor.rows(key::range, map->range, angles);
            visitor.rows(key::rms, map->rms, angles);
        });
    }
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

void RepeatedResults::visit(ResultVisitor& visitor, const Input& input) {
    std::optional<Solver> solved;
    Result result;
    const auto solver = [&]() -> const Solver& {
        if (!solved) {
            solved.emplace(input);
            result = solved->result();
        }
        return *solved;
    };
    const auto whole = [&]() -> const Result& {
        solver();
        return result;
    };
    visitor.set_turns_of_cycle(input.strokes / 2);
    visit_verdict(visitor, [&] { return verdict(whole()); });
    if (!solved) {
        moments_of(input).fill(input, visitor.wants(key::optimum.key), result);
    }
    visit_moments(visitor, result);
    visitor.object({"printed_mean", Text::tr("Mean of table rows (paper)")}, [&] {
        visitor.number({"M_s_25_nodes_Nm", Text::tr("Mₛ, 25 rows"), 2}, whole().printed_mean_M_s);
        visitor.number({"M_up_nodes_Nm", Text::tr("Mᵤₚ, table rows"), 2},
                       whole().printed_mean_M_up);
        visitor.number({"M_ups_nodes_Nm", Text::tr("Mᵤₚₛ, table rows"), 2},
                       whole().printed_mean_M_ups);
    });
    visitor.object({"optimum_buildable", Text::tr("Best feasible α")},
                   [&] { visit_best_buildable(visitor, whole()); });
    visitor.object({"buildable", Text::tr("Feasible positions")}, [&] {
        // A study asks for the present angle alone.
        const bool wants_all = visitor.wants("shaft_angles_deg") || visitor.wants("reason");
        visit_feasible_angles(
            visitor,
            wants_all ? buildable_angles(front_view(input), input.place_limits) : BuildableAngles(),
            fits_at(input, result.shaft_angle));
    });
    visitor.object({"order_1", Text::tr("First order of Mᵤₚ")}, [&] {
        visitor.number({"amplitude_Nm", Text::tr("amplitude"), 2}, result.order_1_amplitude);
        visitor.number({"phase_deg", Text::tr("phase"), 1}, result.order_1_phase);
        visitor.number({"share_of_variance", Text::tr("share of the variance")},
                       result.order_1_share);
    });
    visitor.number({"dead_centre_deg", Text::tr("Crank angle at TDC")}, result.dead_centre);
    visitor.number({"counterweight_lag_deg", Text::tr("Lag of the counterweights")},
                   result.counterweight_lag);
    visitor.object({"envelope", Text::tr("Envelope")}, [&] {
        visitor.number(key::width, whole().envelope.width());
        visitor.number(key::height, whole().envelope.height());
    });
    visitor.texts(notes, [&] { return notes_of(input, whole()); });
    visitor.object({"inertia_check", Text::tr("Check of the inertia torque")},
                   [&] { visit_inertia_check(visitor, whole().inertia_check); });
    visitor.object({"spectrum", Text::tr("Order spectrum")},
                   [&] { visit_spectrum(visitor, whole()); });
    visitor.object({"flywheel", Text::tr("Flywheel")},
                   [&] { visit_flywheel(visitor, whole().flywheel); });
    if (input.torque.is_computed()) {
        visitor.object({"indicated", Text::tr("Indicated cycle")}, [&] {
            const Result& all = whole();
            visit_indicated(visitor, *all.indicated, all.indicated_power, all.angular_speed);
        });
    }
    visitor.object({"curves", Text::tr("Curves")}, [&] { visit_curves(visitor, whole()); });
    visitor.object({"sweep", Text::tr("Sweep over α")},
                   [&] { visit_sweep(visitor, whole().sweep); });
    visitor.object({"clearances", Text::tr("Clearances")},
                   [&] { visit_clearances(visitor, solver().front_view(), result.shaft_angle); });
    visitor.object({"crank_only", Text::tr("Without shaft")},
                   [&] { visit_crank_balance(visitor, solver()); });
    visitor.object({"envelope_study", Text::tr("Range and size")},
                   [&] { visit_envelope_study(visitor, solver()); });
    visitor.object({"best_position", Text::tr("Optimum ignoring clearance")},
                   [&] { visit_best(visitor, PositionStudy(solver()).best()); });
    visitor.object({"best_position_buildable", Text::tr("Best feasible place")},
                   [&] { visit_front(visitor, PositionStudy(solver())); });
    visitor.object({"gear_error", Text::tr("Gears")},
                   [&] { visit_gear_error(visitor, solver(), result.shaft_angle); });
    if (input.relieved_shaft) {
        visitor.object({"relieved_shaft", Text::tr("Relieved shaft")},
                       [&] { visit_relieved_shaft(visitor, whole().relieved_shaft); });
    }
    if (const auto& band = input.speed_band) {
        visitor.object({"speed_band", Text::tr("Speed band")},
                       [&] { visit_speed_band(visitor, input, *band); });
    }
}

void visit_results(ResultVisitor& visitor, const Input& input) {
    RepeatedResults().visit(visitor, input);
}

const Moments& RepeatedResults::moments_of(const Input& input) {
    if (moments_ && have_same_tipping_moment(moments_of_, input)) {
        moments_->follow(input);
    } else {
        moments_.emplace(input);
        moments_of_ = input;
    }
    return *moments_;
}

namespace {

/// At some α the shaft fits, so crank and gears let it: these are of the place.
Text what_is_met(Obstacle obstacle) {
    switch (obstacle) {
        case Obstacle::rod:
            return Text::tr("Does not fit: at this α the shaft meets the rod.");
        case Obstacle::limits:
            return Text::tr("Does not fit: at this α the shaft is outside the limits.");
        default:
            return Text::tr("Does not fit: at this α the shaft meets the cylinder.");
    }
}

/// Whether some α is feasible, yet none has a smaller range than no shaft.
bool is_useless_for_range(const Result& result) {
    return !result.buildable.stretches.empty() && result.moment_amplitude != 0.0 &&
           result.best_range_buildable.value >= result.M_up.range;
}

/// Of the shaft alone, without warnings about the input.
Verdict shaft_verdict(const Result& result) {
    const auto percent = [](double share) { return in_percent(std::abs(share)); };
    const std::string_view best =
        !result.buildable.stretches.empty() && result.best_range_buildable.shaft_angle
            ? (is_useless_for_range(result) ? best_place_act : best_range_act)
            : "";
    if (!result.is_buildable) {
        return {Severity::error,
                result.buildable.stretches.empty()
                    ? Message(Text::tr("Does not fit at any α. %1"), result.buildable.reason)
                    : Message(what_is_met(result.obstacle)),
                best};
    }
    if (!result.range_change || !result.rms_change) {
        return {Severity::note, Message(Text::tr("The torque is constant: no shaft required."))};
    }
    const int range = sign_as_shown(*result.range_change);
    const int rms = sign_as_shown(*result.rms_change);
    const Message of_range =
        range < 0   ? Message(Text::tr("Fits: the range is %1 smaller than without shaft."),
                              percent(*result.range_change))
        : range > 0 ? Message(Text::tr("Fits, but the range is %1 larger than without shaft."),
                              percent(*result.range_change))
                    : Message(Text::tr("Fits, but does not change the range."));
    const Message of_rms =
        rms < 0   ? Message(Text::tr("The RMS is %1 smaller."), percent(*result.rms_change))
        : rms > 0 ? Message(Text::tr("The RMS is %1 larger."), percent(*result.rms_change))
                  : Message(Text::tr("The RMS does not change."));
    return {range > 0               ? Severity::warning
            : range < 0 && rms <= 0 ? Severity::good
                                    : Severity::note,
            Message(Text{"%1 %2"}, of_range, of_rms), range < 0 ? "" : best};
}

/// Where no feasible α is better than no shaft.
Message useless(const Result& result) {
    if (result.buildable.stretches.empty() || result.moment_amplitude == 0.0) {
        return {};
    }
    const bool range = is_useless_for_range(result);
    const bool rms = result.best_rms_buildable.value >= result.M_up.rms;
    return range && rms ? Text::tr(
                              "At every feasible α, range and RMS are larger than without "
                              "shaft.")
           : range ? Text::tr("At every feasible α, the range is larger than without shaft.")
           : rms   ? Text::tr("At every feasible α, the RMS is larger than without shaft.")
                   : Message();
}

}  // namespace

Verdict verdict(const Result& result) {
    Verdict verdict = shaft_verdict(result);
    if (const Message none_helps = useless(result); !none_helps.empty()) {
        verdict.text = Message(Text{"%1 %2"}, verdict.text, none_helps);
    }
    for (const Message& doubt : result.doubts) {
        verdict.warn(doubt);
    }
    verdict.warn(result.inertia_check.warning);  // the notes say how that is known
    if (result.trace_is_a_turn_off) {
        verdict.act = move_trace_act;
    }
    return verdict;
}

}  // namespace ravnoves::balance_shaft

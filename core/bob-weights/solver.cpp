#include "bob-weights/solver.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "bob-weights/fields.h"
#include "bob-weights/matching.h"
#include "bob-weights/plane_plan.h"
#include "case-file/input_error.h"
#include "shop/balance_grade.h"
#include "shop/kilograms.h"

namespace ravnoves::bob_weights {

namespace {

using Vector = std::complex<double>;

std::optional<double> permissible_of_rotor(const Tolerance& tolerance) {
    if (!tolerance.grade || !tolerance.rotor_mass || !tolerance.service_speed) {
        return std::nullopt;
    }
    return shop::permissible_unbalance(*tolerance.rotor_mass, *tolerance.grade,
                                       *tolerance.service_speed);
}

/// Shares of two places in what acts at `centre`, as the standard keeps them.
std::array<double, 2> shares(const std::array<double, 2>& places, double centre) {
    const double first = std::clamp((places[1] - centre) / (places[1] - places[0]), 0.3, 0.7);
    return {first, 1.0 - first};
}

/// How many times the part counts.
double factor_of(const PartField& part, const Engine& engine, double factor) {
    switch (part.kind) {
        case PartKind::reciprocating:
            return engine.rods_on_crankpin() * factor;
        case PartKind::rotating:
            return engine.rods_on_crankpin();
        case PartKind::crankpin:
            return 1.0;
    }
    return 0.0;
}

void solve_bob_weight(const Input& input, double factor, Result& result) {
    const std::vector<const Field*> missing = missing_for_bob_weight(input);
    const bool known = missing.empty();
    double reciprocating = 0.0;
    double rotating = 0.0;
    double sum = 0.0;
    for (const PartField& part : part_fields()) {
        const auto mass = mass_of(input, part);
        if (!mass) {
            if (std::find(missing.begin(), missing.end(), &part.field) == missing.end()) {
                result.not_given.push_back(&part);
            }
            continue;
        }
        const Line line{{{part.field.key, part.field.label},
                         factor_of(part, input.engine, factor),
                         *mass,
                         part.kind == PartKind::reciprocating},
                        &part};
        result.lines.push_back(line);
        sum += line.product();
        reciprocating += part.kind == PartKind::reciprocating ? *mass : 0.0;
        rotating += part.kind == PartKind::rotating ? *mass : 0.0;
    }
    if (known) {
        result.reciprocating = reciprocating;
        result.rotating = rotating;
        result.bob_weight = sum;
    }
}

/// Masses that would be grams if they were typed in kilograms.
void look_for_kilograms(const Input& input, Result& result) {
    constexpr double min_other = 0.05 * units::gram;  // of locks and oil
    for (const PartField& part : part_fields()) {
        const auto& typed = input.parts.*part.member;
        std::optional<double> found;
        if (!part.column) {
            found = typed && *typed > 0.0 && *typed < min_other ? typed : std::nullopt;
        } else {
            const shop::Weighed alone[] = {typed};
            found = shop::mass_in_kilograms(*part.column, std::nullopt, alone);
            if (!found && input.weigh_in) {
                const auto& column = (*input.weigh_in)[*part.column];
                found = shop::mass_in_kilograms(*part.column, column.nominal, column.mass);
            }
        }
        if (found) {
            result.in_kilograms.emplace_back(&part, *found);
        }
    }
}

/// Planes and drills with all that a plan needs; false while something is missing.
bool can_drill(const Correction& correction) {
    return std::all_of(correction.planes.begin(), correction.planes.end(),
                       [](const Plane& plane) { return plane.radius.has_value(); }) &&
           !correction.drill.diameters_mm.empty() && correction.drill.maximum_depth;
}

std::optional<bool> both(const std::optional<bool>& first, const std::optional<bool>& second) {
    return first && second ? std::optional(*first && *second) : std::nullopt;
}

/// Where the machine reads, and where it is corrected; nothing while that is not known.
struct Places {
    std::array<double, 2> from;
    std::array<double, 2> to;
};
std::optional<Places> places_of(const Input& input) {
    const auto planes = plane_positions(input);
    if (!planes || input.correction->readings.size() != 2) {
        return std::nullopt;
    }
    Places places{*planes, *planes};
    for (std::size_t i = 0; i < 2; ++i) {
        places.from[i] = input.correction->readings[i].position.value_or(places.to[i]);
    }
    const bool are_apart = places.from[0] != places.from[1] && places.to[0] != places.to[1];
    return are_apart ? std::optional(places) : std::nullopt;
}

/// The two vectors of a run.
std::optional<std::array<Vector, 2>> vectors_of(const std::vector<Reading>& readings) {
    std::array<Vector, 2> read;
    for (std::size_t i = 0; i < 2; ++i) {
        if (readings.size() != 2 || !is_read(readings[i])) {
            return std::nullopt;
        }
        read[i] = std::polar(*readings[i].unbalance, readings[i].angle.value_or(0.0));
    }
    return read;
}

Vector vector_of(const RunResult::InPlane& read) {
    return std::polar(read.unbalance, read.angle.value());
}

/// Whether the run after says that what was drilled did something else than it was to: by more than
/// the limit, or without one by a tenth of that; by more than 0.35 it is large. A plane that was to
/// be within the limit, and is, is as meant. Where nothing was drilled, no more than that of what
/// was there changes.
/// @param drilled  after the run at `since` and before the one after
std::array<std::optional<OtherEffect>, 2> other_effects(
    const std::vector<RunResult>& runs, std::size_t since, const std::array<Metal, 2>& drilled,
    const RunResult& after, const std::optional<std::array<double, 2>>& permissible) {
    std::array<std::optional<OtherEffect>, 2> found;
    const RunResult& before = runs[since];
    if (!before.holds() || !after.holds()) {
        return found;
    }
    const std::array<Vector, 2> meant{effect_of(drilled[0]), effect_of(drilled[1])};
    const double maximum = std::max(std::abs(meant[0]), std::abs(meant[1]));
    bool is_in_other_plane = true;
    for (std::size_t i = 0; i < 2; ++i) {
        const Vector was = vector_of(*before.planes[i]);
        const Vector is = vector_of(*after.planes[i]);
        const double limit = permissible ? (*permissible)[i] : 0.0;
        is_in_other_plane = is_in_other_plane &&
                            std::abs(is - was - meant[1 - i]) <= std::max(0.5 * maximum, limit);
        const Vector expected = was + meant[i];
        const bool is_drilled = meant[i] != 0.0;
        const double whole = std::abs(is_drilled ? meant[i] : was);
        const double off = std::abs(is - expected);
        const bool is_as_meant = is_drilled && std::abs(is) <= limit && std::abs(expected) <= limit;
        if (is_as_meant || off <= (permissible ? limit : 0.1 * whole)) {
            continue;
        }
        const bool is_large = off > std::max(0.35 * whole, limit);
        const bool is_turned = is_drilled && std::real((is - was) / meant[i]) < -0.5;
        const bool is_grown = std::abs(is) > std::abs(was);
        found[i] = {
            std::abs(expected),    turn_of(std::arg(expected)),        since, is_drilled, is_large,
            is_turned && is_grown, is_turned && !is_grown && is_large, false};
    }
    for (auto& each : found) {
        if (each && each->is_large) {
            each->is_in_other_plane = is_in_other_plane && !each->is_opposite;
        }
    }
    return found;
}

void join(Metal& all, const Metal& more) {
    all.holes.insert(all.holes.end(), more.holes.begin(), more.holes.end());
    all.slugs.insert(all.slugs.end(), more.slugs.begin(), more.slugs.end());
}

void solve_correction(const Input& input, Result& result) {
    if (!input.correction) {
        return;
    }
    const Correction& correction = *input.correction;
    const auto places = places_of(input);
    const auto limit = [&](std::size_t i) {
        return result.permissible ? std::optional((*result.permissible)[i]) : std::nullopt;
    };
    std::optional<std::size_t> whole;  // the last run that was read whole
    std::array<Metal, 2> since;        // drilled after it
    std::array<Metal, 2> before;
    const auto add_run = [&](const std::vector<Reading>& readings, const DrillingRecord& record) {
        RunResult run;
        const auto read = [&](std::size_t i, double unbalance, const std::optional<double>& angle) {
            run.planes[i] = {unbalance, angle, shop::is_within(unbalance, limit(i))};
        };
        if (const auto vectors = places ? vectors_of(readings) : std::nullopt) {
            const auto there = carried_over(*vectors, places->from, places->to);
            for (std::size_t i = 0; i < there.size(); ++i) {
                read(i, std::abs(there[i]), turn_of(std::arg(there[i])));
            }
        } else if (reads_in_planes(input)) {
            for (std::size_t i = 0; i < std::min<std::size_t>(readings.size(), 2); ++i) {
                if (readings[i].unbalance) {
                    read(i, *readings[i].unbalance, std::nullopt);
                }
            }
        }
        for (const auto& reading : readings) {
            if (!reading.unbalance) {
                continue;
            }
            if (!run.read_with &&
                shop::is_other_bob_weight(reading.bob_weight, result.bob_weight)) {
                run.read_with = reading.bob_weight;
            }
            if (!run.read_on) {
                run.read_on = shop::other_shaft(reading.shaft, input.job);
            }
        }
        if (run.has_vectors()) {
            if (whole) {
                run.other_effect =
                    other_effects(result.runs, *whole, since, run, result.permissible);
            }
            whole = result.runs.size();
            since = {};
        }
        // Holes of another crankshaft are not in this one; after readings of another bob weight
        // those alone that were drilled before it changed.
        if (record.drilled && !run.read_on && correction.planes.size() == 2) {
            run.is_recorded = true;
            run.drilled = recorded(*record.drilled, correction, result.runs.size(), before);
        }
        result.runs.push_back(std::move(run));
    };
    const auto in_plane = [&](const RunResult& run, std::size_t i) {
        return plan_plane(vector_of(*run.planes[i]), correction.planes[i], correction, limit(i),
                          before[i]);
    };
    for (const EarlierRun& earlier : correction.earlier_runs) {
        add_run(earlier.readings, earlier);
        for (std::size_t i = 0; i < 2; ++i) {
            join(before[i], result.runs.back().drilled[i]);
            join(since[i], result.runs.back().drilled[i]);
        }
    }
    add_run(correction.readings, correction.record);
    if (!places) {
        return;
    }
    double worst = 0.0;
    for (std::size_t plane = 0; plane < 2; ++plane) {
        // Errors of unit size at the worst phases.
        double sum = 0.0;
        for (const double at : places->from) {
            const double share = (at - places->to[0]) / (places->to[1] - places->to[0]);
            sum += std::abs(plane == 0 ? 1.0 - share : share);
        }
        worst = std::max(worst, sum);
    }
    result.amplification = worst;
    const RunResult& newest = result.runs.back();
    if (newest.has_vectors() && can_drill(correction)) {
        result.correction = {in_plane(newest, 0), in_plane(newest, 1)};
    }
}

/// Where engine and factor contradict each other there is no bob weight, nor what needs one.
void leave_out_contradictory(const Input& input, Result& result) {
    try {
        check_bob_weight(input);
    } catch (const InputError&) {
        result.lines.clear();
        result.bob_weight.reset();
        result.first_order.reset();
        result.first_order_bare.reset();
        result.crankpins.clear();
        result.correction.reset();
        for (auto& run : result.runs) {
            run.read_with.reset();  // there is no weight that it could be compared with
        }
    }
}

}  // namespace

std::array<std::optional<double>, 2> RunResult::unbalances() const {
    std::array<std::optional<double>, 2> list;
    for (std::size_t i = 0; i < 2; ++i) {
        if (planes[i]) {
            list[i] = planes[i]->unbalance;
        }
    }
    return list;
}

bool reads_in_planes(const Input& input) {
    const auto places = places_of(input);
    return !places || places->from == places->to;
}

std::optional<bool> RunResult::within(std::size_t plane) const {
    const auto& read = planes.at(plane);
    // What one plane reads may fail, and passes with the other alone.
    const bool counts = read && (planes.at(1 - plane) || read->within_tolerance == false);
    return counts ? read->within_tolerance : std::nullopt;
}

std::optional<bool> RunResult::passes() const {
    return within(0) == false || within(1) == false ? std::optional(false)
                                                    : both(within(0), within(1));
}

std::optional<bool> Result::passes_after() const {
    return correction && newest()->acted_as_meant()
               ? both((*correction)[0].within_tolerance, (*correction)[1].within_tolerance)
               : std::nullopt;
}

double rounding_squares(const Input& input, const Result& result) {
    double sum = 0.0;
    for (const Line& line : result.lines) {
        if (line.part->kind != PartKind::crankpin && line.mass != 0.0) {
            sum += line.factor * line.factor /
                   (is_weighed(input, *line.part) ? input.engine.cylinders : 1);
        }
    }
    return sum;
}

std::vector<const Field*> missing_for_bob_weight(const Input& input) {
    std::vector<const Field*> missing;
    if (input.engine.type == EngineType::v && !input.engine.bank_angle) {
        missing.push_back(&field::bank_angle);
    }
    for (const PartField& part : part_fields()) {
        if (part.is_needed() && !mass_of(input, part)) {
            missing.push_back(&part.field);
        }
    }
    return missing;
}

std::optional<std::array<double, 2>> plane_limits(
    const Tolerance& tolerance, const std::optional<std::array<double, 2>>& positions) {
    if (!tolerance.by_grade) {
        return tolerance.plane ? std::optional(std::array{*tolerance.plane, *tolerance.plane})
                               : std::nullopt;
    }
    const auto whole = permissible_of_rotor(tolerance);
    if (!whole) {
        return std::nullopt;
    }
    const bool has_bearings = tolerance.front_bearing && tolerance.rear_bearing &&
                              *tolerance.front_bearing != *tolerance.rear_bearing;
    if (!positions || (*positions)[0] == (*positions)[1] ||
        (!has_bearings && !tolerance.centre_of_mass)) {
        return std::array{tolerance.front_share * *whole, (1.0 - tolerance.front_share) * *whole};
    }
    const auto& [first, second] = *positions;
    const std::array<double, 2> bearings{tolerance.front_bearing.value_or(first),
                                         tolerance.rear_bearing.value_or(second)};
    const double centre = tolerance.centre_of_mass.value_or(
        has_bearings ? 0.5 * (bearings[0] + bearings[1]) : 0.5 * (first + second));
    const std::array<double, 2> share = shares(*positions, centre);
    if (!has_bearings) {
        return std::array{*whole * share[0], *whole * share[1]};
    }
    const std::array<double, 2> at_bearing = shares(bearings, centre);
    double scale = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 2; ++i) {
        // What a unit in each plane is at this bearing, at the worst phase.
        double worst = 0.0;
        for (std::size_t k = 0; k < 2; ++k) {
            const double far = ((*positions)[k] - bearings[0]) / (bearings[1] - bearings[0]);
            worst += share[k] * std::abs(i == 0 ? 1.0 - far : far);
        }
        scale = std::min(scale, at_bearing[i] / worst);
    }
    return std::array{*whole * share[0] * scale, *whole * share[1] * scale};
}

Result solve(const Input& given, bool places_parts, const OtherWeight& other) {
    const Input input = fitted(given);
    Result result;
    result.theory_factor = theory_factor(input.engine);
    result.factor = input.factor.reciprocating.value_or(result.theory_factor);
    const double factor = result.factor + input.factor.overbalance;
    if (other) {
        other(input, result);
    } else {
        solve_bob_weight(input, factor, result);
        if (places_parts) {
            place_parts(input, weighed_factors(input, factor), result);
        }
    }
    if (const auto& reciprocating = result.reciprocating) {
        result.first_order = first_order(input.engine, factor, *reciprocating);
        result.first_order_bare = first_order(input.engine, 0.0, *reciprocating);
    }
    look_for_kilograms(input, result);
    if (input.tolerance) {
        if (input.tolerance->by_grade) {
            result.permissible_whole = permissible_of_rotor(*input.tolerance);
        }
        result.permissible = plane_limits(*input.tolerance, plane_positions(input));
    }
    solve_correction(input, result);
    leave_out_contradictory(input, result);
    return result;
}

std::optional<Remaining> what_if(const Input& input, const Result& result, PlaneName plane,
                                 double diameter, double depth, double angle) {
    const auto i = static_cast<std::size_t>(plane);
    const RunResult* newest = result.newest();
    if (newest == nullptr || !newest->has_vectors() || !input.correction ||
        i >= input.correction->planes.size() || !input.correction->planes[i].radius) {
        return std::nullopt;
    }
    const Plane& there = input.correction->planes[i];
    const Drill& drill = input.correction->drill;
    const Cut cut{*there.radius, drill.density, drill.point_angle};
    Metal before;
    for (const RunResult& run : result.runs) {
        join(before, run.drilled[i]);
    }
    const TriedRoom room =
        room_for({diameter, depth, angle, 0.0, 0.0}, there, *input.correction, before);
    const double before_it =
        room.from_depth > 0.0 ? cut.removed(diameter, room.from_depth).unbalance : 0.0;
    const double taken = cut.removed(diameter, depth).unbalance - before_it;
    const Vector left = vector_of(*newest->planes[i]) - std::polar(taken, room.angle);
    return Remaining{
        std::abs(left), turn_of(std::arg(left)),
        shop::is_within(std::abs(left), result.permissible ? std::optional((*result.permissible)[i])
                                                           : std::nullopt),
        room};
}

}  // namespace ravnoves::bob_weights

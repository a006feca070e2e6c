#include "workshop/doubts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "bob-weights/drilled.h"
#include "bob-weights/factor_theory.h"
#include "bob-weights/fields.h"
#include "bob-weights/solver.h"
#include "shop/balance_grade.h"
#include "shop/kilograms.h"
#include "shop/results.h"
#include "shop/sentences.h"
#include "v8-plugs/results.h"
#include "v8-plugs/shift.h"
#include "workshop/result.h"

namespace ravnoves::workshop {

namespace {

using shop::in_gram_millimetres;
using shop::in_grams;
using shop::Part;

/// A mass that is typed again differs by rounding, not by a tenth.
constexpr double same_mass = 1.1;
/// New parts are no quarter heavier than those that they replace.
constexpr double same_part = 1.25;

constexpr std::size_t planes[] = {0, 1};

Number millimetres(double length) {
    return {length / units::mm, units::mm, -1};
}

Number in_degrees(double angle) {
    return {bob_weights::turn_of(angle) / units::degree, units::degree, -1};
}

bool differ(double a, double b, double times) {
    return a > 0.0 && b > 0.0 && std::abs(std::log(a / b)) > std::log(times);
}

/// "1, 2, 5"
void add_to(Message& list, const Message& each) {
    list = list.empty() ? each : joined(list, each);
}
Message cylinders(const std::vector<std::size_t>& list) {
    Message text;
    for (const std::size_t cylinder : list) {
        add_to(text, Number{static_cast<double>(cylinder + 1)});
    }
    return text;
}

}  // namespace

/// The job that the rules look at, and what they have found.
struct DoubtSearch {
    const Input& input;
    const bob_weights::Result& shaft;
    const std::optional<v8_plugs::Input>& plugs_input;
    const std::optional<v8_plugs::Result>& plugs;
    const DoubtRule* rule = nullptr;  ///< that looks now
    std::vector<Doubt> found{};

    /// A doubt of the rule, with what to do.
    Doubt& say(auto&&... text) {
        return found.emplace_back(Doubt{rule, Message(std::forward<decltype(text)>(text)...), {}});
    }
    bool has_said(std::string_view word) const {
        return std::ranges::any_of(found,
                                   [&](const Doubt& each) { return each.rule->word == word; });
    }

    /// As the machine shows it.
    Message reading(double unbalance, double heavy_spot) const {
        return {Text{"%1 ∠ %2"}, in_gram_millimetres(unbalance),
                Number{input.machine.shown(heavy_spot) / units::degree, units::degree, -1}};
    }
    Message plane_name(std::size_t plane) const {
        return shop::plane_title(input.machine.planes, plane);
    }
    /// "Run 1, Front plane"
    Message at_run(std::size_t run, std::size_t plane) const {
        const std::size_t first = bob_weights::first_run(input.correction);
        return {run < first    ? Text::tr("Older holes, %1")
                : run == first ? Text::tr("Before, %1")
                               : Text::tr("Run %2, %1"),
                plane_name(plane), Number{static_cast<double>(run) - static_cast<double>(first)}};
    }
    /// Of the rim that is drilled.
    std::optional<double> radius(std::size_t plane) const {
        return input.correction && plane < input.correction->planes.size()
                   ? input.correction->planes[plane].radius
                   : std::nullopt;
    }
    std::optional<double> crank_radius() const {
        return plugs_input      ? plugs_input->engine.crank_radius
               : input.weigh_in ? input.weigh_in->matching.crank_radius
                                : std::nullopt;
    }
    /// A value of the tolerance that counts for a grade alone.
    std::optional<double> graded(std::optional<double> bob_weights::Tolerance::*value) const {
        return input.tolerance && input.tolerance->by_grade ? *input.tolerance.*value
                                                            : std::nullopt;
    }
    /// Calls `visit` with each column of the sheet that is begun.
    void for_columns(const auto& visit) const {
        if (!input.weigh_in) {
            return;
        }
        for (const Part part : shop::all_parts) {
            const shop::PartColumn& column = (*input.weigh_in)[part];
            if (!column.is_empty()) {
                visit(part, column);
            }
        }
    }
};

namespace {

// ----------------------------------------------------------------------------------- masses

void kilograms(DoubtSearch& job) {
    const auto add = [&](Text name, double mass) {
        job.say(Text::tr("%1: %2 looks like kilograms. Enter grams."), name,
                Number{mass / units::gram, units::gram, 3});
    };
    for (const auto& [part, mass] : job.shaft.in_kilograms) {
        add(part->column                                 ? shop::part_word(*part->column).label
            : part->member == &bob_weights::Parts::locks ? Text::tr("Locks")
                                                         : Text::tr("Oil"),
            mass);
    }
    constexpr double minimum = 20 * units::gram;  // the sums of parts that weigh 5 g and more
    const auto check = [&](Text name, const std::optional<double>& mass) {
        if (mass && *mass < minimum) {
            add(name, *mass);
        }
    };
    if (job.plugs_input) {
        check(Text::tr("Reciprocating mass"), job.plugs_input->engine.reciprocating_mass);
        check(Text::tr("Rotating mass"), job.plugs_input->engine.rotating_mass);
    }
}

void odd_mass(DoubtSearch& job) {
    job.for_columns([&](Part part, const shop::PartColumn& column) {
        const auto odd = shop::odd_mass(column);
        if (!odd || shop::mass_in_kilograms(part, column)) {
            return;
        }
        const Text text =
            !odd->also.empty()
                ? Text::tr(
                      "%1: cylinders %2 differ from the others (%3, others %4). Weigh them "
                      "again or match the parts.")
            : odd->score > shop::max_score
                ? Text::tr(
                      "%1: cylinder %2 weighs %3, the others about %4; the deviation is more "
                      "than %5 times their scatter. Weigh it again or match the parts.")
                : Text::tr("%1: cylinder %2 weighs %3, the others about %4. Weigh it again.");
        const Message said{text,
                           shop::part_word(part).label,
                           cylinders(odd->cylinders()),
                           in_grams(odd->mass),
                           in_grams(odd->usual),
                           shop::max_score};
        if (odd->may_be_permitted) {
            job.say(shop::two_sentences(
                said, Text::tr("If the difference is permitted, enter the “permitted range” of the "
                               "column.")));
        } else {
            job.say(said);
        }
    });
}

void swapped_ends(DoubtSearch& job) {
    if (job.input.weigh_in) {
        const shop::WeighIn& sheet = *job.input.weigh_in;
        const auto swapped =
            shop::swapped_rod_ends(sheet[Part::rod_big_end].mass, sheet[Part::rod_small_end].mass);
        if (!swapped.empty()) {
            job.say(Text::tr("Rods of cylinders %1: the big end weighs less than the small end. "
                             "Swap the columns or weigh the rods again."),
                    cylinders(swapped));
            return;
        }
    }
    const shop::Weighed big[] = {job.input.parts.big_end};
    const shop::Weighed small[] = {job.input.parts.small_end};
    if (!shop::swapped_rod_ends(big, small).empty()) {
        job.say(
            Text::tr("The big end of the rod, %1, weighs less than its small end, %2. Swap both "
                     "or weigh the rod again."),
            in_grams(**big), in_grams(**small));
    }
}

void typed_against_weighed(DoubtSearch& job) {
    for (const bob_weights::PartField& part : bob_weights::part_fields()) {
        if (contradicts_scale(job.input, part)) {
            const auto weighed = shop::statistics((*job.input.weigh_in)[*part.column]);
            job.say(Text::tr("%1: %2 entered, but %3 weighed. Correct the wrong value."),
                    shop::part_word(*part.column).label, in_grams(*(job.input.parts.*part.member)),
                    in_grams(weighed->mean));
        }
    }
}

void nominal_against_weighed(DoubtSearch& job) {
    job.for_columns([&](Part part, const shop::PartColumn& column) {
        const double mean = shop::statistics(column)->mean;
        if (column.nominal && !shop::mass_in_kilograms(part, column) &&
            differ(*column.nominal, mean, same_part)) {
            job.say(Text::tr("%1: nominal %2, but %3 weighed. Correct the wrong value."),
                    shop::part_word(part).label, in_grams(*column.nominal), in_grams(mean));
        }
    });
}

/// 0.5 for 50 % is 0.5 %.
void share_of_one(DoubtSearch& job) {
    const double share = job.input.factor.reciprocating.value_or(0.0);
    if (share > 0.0 && share <= 0.01) {
        job.say(
            Text::tr(
                "A balance factor of %1 looks like a fraction. Enter percent: 50 for one half."),
            Number{share / units::percent, units::percent, -2});
    }
}

void gear_against_parts(DoubtSearch& job) {
    if (!job.plugs_input || !job.plugs_input->weigh_in) {
        return;
    }
    const auto check = [&](Text name, const std::optional<double>& typed,
                           const std::optional<double>& parts) {
        // Bob weights are hung to a tenth of a gram.
        if (typed && parts && std::abs(*typed - *parts) >= 0.1 * units::gram) {
            job.say(
                Text::tr(
                    "%1: %2 entered, but the nominal parts add up to %3. Correct the wrong value."),
                name, in_grams(*typed), in_grams(*parts));
        }
    };
    const shop::WeighIn& sheet = *job.plugs_input->weigh_in;
    check(Text::tr("Reciprocating mass"), job.plugs_input->engine.reciprocating_mass,
          v8_plugs::nominal_reciprocating(sheet));
    check(Text::tr("Rotating mass"), job.plugs_input->engine.rotating_mass,
          v8_plugs::nominal_rotating(sheet));
}

// ------------------------------------------------------------------------------------ plugs

template <bool certain>
void plug_doubt(DoubtSearch& job) {
    if (job.plugs) {
        const v8_plugs::PlugDoubt doubt = v8_plugs::plug_doubt(*job.plugs_input, *job.plugs);
        if (!doubt.text.empty() && doubt.is_certain == certain) {
            job.say(doubt.text);
        }
    }
}

void paper_limits(DoubtSearch& job) {
    if (job.plugs) {
        for (const Message& text : v8_plugs::paper_limits(*job.plugs_input, *job.plugs)) {
            job.say(text);
        }
    }
}

/// A sludge trap is in a crankpin, whose axis is at the crank radius.
void plug_radius(DoubtSearch& job) {
    constexpr double nearest = 0.5;
    constexpr double farthest = 2.0;
    using v8_plugs::Engine;
    if (!job.plugs_input || !job.plugs_input->engine.crank_radius) {
        return;
    }
    const double crank = *job.plugs_input->engine.crank_radius;
    for (const v8_plugs::EngineField& each : v8_plugs::engine_fields()) {
        const bool is_of_plug =
            each.member == &Engine::plug_radius || each.member == &Engine::new_plug_radius;
        const auto& radius = job.plugs_input->engine.*each.member;
        if (is_of_plug && radius && (*radius < nearest * crank || *radius > farthest * crank)) {
            job.say(
                Text::tr("%1: %2 does not match a crank radius of %3. Correct the wrong value."),
                each.field.label, millimetres(*radius), millimetres(crank));
        }
    }
}

/// Whether the plugs are answered by weights, and this part counts by its nominal mass as long as
/// not all of it is weighed.
bool is_nominal(const DoubtSearch& job, Part part) {
    if (!job.plugs_input || !job.plugs_input->changes_from_weigh_in ||
        !job.plugs_input->changes_known() || (*job.plugs_input->weigh_in)[part].is_weighed()) {
        return false;
    }
    const auto change = v8_plugs::change_of(part, job.plugs_input->process);
    return !job.plugs_input->takes_typed(change) || job.plugs_input->changes().*change == 0.0;
}

void half_weighed(DoubtSearch& job) {
    job.for_columns([&](Part part, const shop::PartColumn& column) {
        if (is_nominal(job, part)) {
            job.say(Text::tr("%1: %2 of 8 weighed. Weigh all of them, or clear the column."),
                    shop::part_word(part).label, shop::statistics(column)->count);
        }
    });
}

void taken_as_nominal(DoubtSearch& job) {
    Message names;
    for (const Part part : shop::all_parts) {
        if (is_nominal(job, part)) {
            add_to(names, shop::part_word(part).label);
        }
    }
    if (!names.empty()) {
        job.say(Text::tr("Provisional: not weighed and taken as nominal: %1. Weigh them before "
                         "machining."),
                names);
    }
}

void plug_shift(DoubtSearch& job) {
    if (const auto* shift = job.plugs ? job.plugs->shift_that_matters() : nullptr) {
        job.say(describe(*shift, job.plugs_input->tolerance));
    }
}

void unequal_crankpins(DoubtSearch& job) {
    if (!job.plugs || !job.shaft.placing || !job.plugs_input->changes_from_weigh_in) {
        return;
    }
    const shop::Placed& placed = job.shaft.placing->before;
    const double radius = job.plugs_input->engine.crank_radius.value_or(0.0);
    if (0.5 * placed.spread * radius > job.plugs_input->tolerance) {
        const auto [minimum, maximum] = std::ranges::minmax(placed.crankpins);
        const double mean = job.plugs->weighed_excess.value();
        job.say(Text::tr("The crankpins are unequal: their excess is %1 to %2, and the plugs are "
                         "for the mean. Move the sets or match the parts first."),
                in_grams(mean + minimum), in_grams(mean + maximum));
    }
}

/// Parts of one engine are matched to less than this part of their mass.
constexpr double usual_spread = 0.01;

void spread_of_parts(DoubtSearch& job) {
    job.for_columns([&](Part part, const shop::PartColumn& column) {
        const auto found = shop::statistics(column);
        if (shop::odd_mass(column)) {
            return;  // which is said by itself
        }
        if (!found->within_permitted) {
            job.say(Text::tr("%1: range %2, permitted %3 (heaviest: cylinder %4, lightest: %5)."),
                    shop::part_word(part).label, in_grams(found->spread),
                    in_grams(*column.permitted_spread), found->heaviest + 1, found->lightest + 1);
        } else if (!column.permitted_spread &&
                   found->spread > std::max(usual_spread * found->mean, 1.0 * units::gram)) {
            job.say(Text::tr("%1: range %2 (heaviest: cylinder %3, lightest: %4). Weigh them again "
                             "or match the parts."),
                    shop::part_word(part).label, in_grams(found->spread), found->heaviest + 1,
                    found->lightest + 1);
        }
    });
}

/// How heavy a part is beside another one of its cylinder in any engine.
void unlike_parts(DoubtSearch& job) {
    struct Rule {
        std::string_view part;
        std::string_view beside;
        double minimum;
        double maximum;
    };
    static constexpr Rule rules[] = {{"pin", "piston", 0.05, 1.0},
                                     {"rings", "piston", 0.01, 0.5},
                                     {"locks", "pin", 0.0, 0.3},
                                     {"small_end", "big_end", 0.1, 2.0},
                                     {"shells", "big_end", 0.02, 0.5}};
    const auto line_of = [&](std::string_view part) -> const shop::WeightLine* {
        const auto found = std::ranges::find_if(job.shaft.lines, [&](const auto& line) {
            return line.part != nullptr && line.name.word == part && line.mass > 0.0;
        });
        return found != job.shaft.lines.end() ? &*found : nullptr;
    };
    for (const auto& [part, beside, minimum, maximum] : rules) {
        const auto* one = line_of(part);
        const auto* other = line_of(beside);
        if (one != nullptr && other != nullptr &&
            (one->mass < minimum * other->mass || one->mass > maximum * other->mass)) {
            job.say(Text::tr("%1 of %2 beside %3 of %4 is implausible. Correct the wrong value."),
                    one->name.label, in_grams(one->mass), other->name.label, in_grams(other->mass));
        }
    }
}

/// The oil of a crankpin is a few per cent of the bob weight.
void much_oil(DoubtSearch& job) {
    constexpr double maximum = 0.06;
    const auto oil = job.plugs && job.plugs->before ? std::optional(job.plugs->before->oil)
                                                    : job.input.parts.oil;
    if (oil && job.shaft.bob_weight && *oil > maximum * *job.shaft.bob_weight) {
        job.say(Text::tr("Oil of %1 in a crankpin is implausible for a bob weight of %2. Correct "
                         "the oil."),
                in_grams(*oil), in_grams(*job.shaft.bob_weight));
    }
}

/// What reciprocates in an engine weighs about twice what turns; far from that a mass is mistyped.
void unlike_halves(DoubtSearch& job) {
    const double reciprocating = job.shaft.reciprocating.value_or(0.0);
    const double rotating = job.shaft.rotating.value_or(0.0);
    constexpr double minimum = 0.3;
    constexpr double maximum = 5.0;
    if (rotating > 0.0 && reciprocating > 0.0 &&
        (reciprocating < minimum * rotating || reciprocating > maximum * rotating)) {
        job.say(Text::tr("Reciprocating mass %1 and rotating mass %2 of a cylinder are "
                         "inconsistent. Check the masses of the parts."),
                in_grams(reciprocating), in_grams(rotating));
    }
}

// ---------------------------------------------------------------------------------- machine

/// By how much the holes that were planned after a run would lengthen what it reads in a plane now,
/// kg·m. What was measured is elsewhere than planned, and says nothing of it.
double lengthened(const bob_weights::RunResult& run, const bob_weights::EarlierRun& earlier,
                  std::size_t plane) {
    bob_weights::Metal planned = run.drilled[plane];
    for (auto* metal : {&planned.holes, &planned.slugs}) {
        for (bob_weights::Hole& hole : *metal) {
            const auto state = (*earlier.drilled)[hole.deepens->hole].state;
            hole.unbalance = state == bob_weights::HoleState::measured ? 0.0 : hole.unbalance;
            hole.angle += state == bob_weights::HoleState::wrong_side ? pi : 0.0;
        }
    }
    return std::real(effect_of(planned) * std::polar(1.0, -*run.planes[plane]->angle));
}

/// Calls `visit` with what runs read of the drilling before them, where it did something else.
void for_other_effects(const DoubtSearch& job, std::size_t plane, const auto& visit) {
    for (std::size_t run = 0; run < job.shaft.runs.size(); ++run) {
        if (const auto& other = job.shaft.runs[run].other_effect[plane]) {
            visit(run, *other);
        }
    }
}

/// A run that says nothing of the holes before it and after it lets them be drilled twice.
void incomplete_run(DoubtSearch& job) {
    const bob_weights::RunResult* newest = job.shaft.newest();
    if (newest == nullptr || !newest->has_vectors()) {
        return;
    }
    for (std::size_t at = 0; at + 1 < job.shaft.runs.size(); ++at) {
        const auto& readings = job.input.correction->earlier_runs[at].readings;
        for (std::size_t i = 0; job.shaft.runs[at].holds() && i < readings.size(); ++i) {
            if (!is_read(readings[i])) {
                job.say(readings[i].unbalance ? Text::tr("%1: enter the angle.")
                                              : Text::tr("%1: enter the unbalance."),
                        job.at_run(at, i));
            }
        }
    }
}

/// Beside runs that were read with angles, a pass that lacks one angle was not read to its end.
/// Where it does not pass, the missing values are asked for anyway.
void missing_angle(DoubtSearch& job) {
    const auto& runs = job.shaft.runs;
    if (runs.empty() || !runs.back().holds() || runs.back().passes() != true ||
        std::ranges::none_of(runs, &bob_weights::RunResult::has_vectors)) {
        return;
    }
    const auto& readings = job.input.correction->readings;
    for (const std::size_t i : planes) {
        if (is_read(readings[1 - i]) && !is_read(readings[i])) {
            job.say(Text::tr("%1: enter the angle."), job.at_run(runs.size() - 1, i));
        }
    }
}

/// Place of the first hole recorded after a run that is such a one.
std::optional<bob_weights::Hole::Place> first_hole(const DoubtSearch& job, std::size_t run,
                                                   const auto& is_such) {
    for (const auto& [place, hole] : recorded_holes(job.input.correction)) {
        if (place.run == run && is_such(*hole)) {
            return place;
        }
    }
    return std::nullopt;
}

/// What was drilled after the newest run is in no reading: what that run asks for may be there.
void drilled_unread(DoubtSearch& job) {
    const auto& correction = job.input.correction;
    if (!correction || !correction->record.is_drilled() || job.shaft.newest()->read_on) {
        return;
    }
    const std::size_t runs = correction->earlier_runs.size();
    const std::size_t run = runs - bob_weights::first_run(correction);
    job.say(run == 0
                ? Text::tr("Holes are recorded after “Before”: enter the readings of Run 1, or "
                           "mark the holes as not drilled.")
                : Text::tr("Holes are recorded after Run %1: enter the readings of Run %2, or "
                           "mark the holes as not drilled."),
            run, run + 1)
        .hole = first_hole(job, runs, [](const bob_weights::DrilledHole& hole) {
        return hole.state != bob_weights::HoleState::not_drilled;
    });
}

/// The shop drills by the card: its holes may be there, and the present plan goes without them.
void other_plan(DoubtSearch& job) {
    if (!job.input.correction || !bob_weights::is_other_plan(*job.input.correction, job.shaft)) {
        return;
    }
    Message holes;
    for (const bob_weights::DrilledHole& hole : *job.input.correction->planned.drilled) {
        add_to(holes,
               {Text{"%1 ⌀ %2 × %3 ∠ %4"}, job.plane_name(static_cast<std::size_t>(hole.plane)),
                millimetres(hole.diameter), millimetres(hole.depth), in_degrees(hole.angle)});
    }
    job.say(Text::tr("The plan has changed since it was printed or put aside: %1. If these holes "
                     "were drilled, enter the readings of the next run; if none was, use the "
                     "present plan."),
            holes);
}

/// A hole that was deepened to less than its depth before took off nothing that is known.
void shallower_hole(DoubtSearch& job) {
    for (const auto& recorded : recorded_holes(job.input.correction)) {
        const bob_weights::Hole::Place& place = recorded.first;
        const bob_weights::DrilledHole& hole = *recorded.second;
        const bob_weights::RunResult& run = job.shaft.runs[place.run];
        const auto plane = static_cast<std::size_t>(hole.plane);
        const auto is_it = [&](const bob_weights::Hole& each) { return each.deepens == place; };
        if (run.is_recorded && hole.state != bob_weights::HoleState::not_drilled &&
            std::ranges::none_of(run.drilled[plane].holes, is_it) &&
            std::ranges::none_of(run.drilled[plane].slugs, is_it)) {
            job.say(Text::tr("%1: the hole of ⌀ %2 at %3 is %4 deep after deepening, which is not "
                             "deeper than before. Correct its depth."),
                    job.at_run(place.run, plane), millimetres(hole.diameter),
                    in_degrees(hole.turned(hole.angle)), millimetres(hole.depth))
                .hole = place;
        }
    }
}

/// Holes are planned at the heavy spot: where they are opposite it now, what the machine shows has
/// been changed since. Where they were measured there, the next run tells.
void drilled_at_light_spot(DoubtSearch& job) {
    for (std::size_t at = 0; at + 1 < job.shaft.runs.size(); ++at) {
        const bob_weights::RunResult& run = job.shaft.runs[at];
        const bob_weights::EarlierRun& earlier = job.input.correction->earlier_runs[at];
        for (std::size_t i = 0; run.has_vectors() && i < 2; ++i) {
            // What was planned from another reading is no witness.
            bool is_opposite = earlier.drilled_by.empty() && lengthened(run, earlier, i) > 0.0;
            for_other_effects(job, i, [&](std::size_t, const bob_weights::OtherEffect& other) {
                is_opposite = is_opposite || (other.since == at && other.is_at_light_spot);
            });
            if (is_opposite) {
                const auto& read = *run.planes[i];
                job.say(Text::tr("%1: the holes drilled after %2 are opposite this heavy spot. "
                                 "Check their angles, and whether the machine shows the heavy or "
                                 "the light spot."),
                        job.at_run(at, i), job.reading(read.unbalance, *read.angle));
            }
        }
    }
}

/// But for the side: nothing of it was measured.
bool is_as_planned(const bob_weights::DrilledHole& hole) {
    return hole.state == bob_weights::HoleState::as_planned ||
           hole.state == bob_weights::HoleState::wrong_side;
}

/// Angles of the holes are in the machine's sense of counting, which has been changed since. What
/// was measured is where it was found.
void drilled_counting_otherwise(DoubtSearch& job) {
    for (std::size_t at = 0; at + 1 < job.shaft.runs.size(); ++at) {
        const auto first = first_hole(job, at, is_as_planned);
        if (job.input.correction->earlier_runs[at].counted_otherwise &&
            job.shaft.runs[at].is_drilled() && first) {
            job.say(
                   Text::tr("The holes were drilled while the machine counted degrees in the other "
                            "direction. Check the direction, or enter the angles as measured."))
                .hole = first;
            return;
        }
    }
}

/// What a hole takes off follows from radius, density and drill point: where they have been changed
/// since it was planned, the record is wrong now, or the next holes would be. It is said of the
/// first hole.
void drilled_by_other_values(DoubtSearch& job) {
    constexpr double same = 1.01;
    const auto holes = recorded_holes(job.input.correction);
    for (const std::size_t i : planes) {
        const auto now = [&, plane = i](const bob_weights::DrilledHole& hole) {
            const bob_weights::Drill& drill = job.input.correction->drill;
            const bob_weights::Cut cut{*job.radius(plane), drill.density, drill.point_angle};
            const double before =
                hole.from_depth > 0.0 ? cut.removed(hole.diameter, hole.from_depth).unbalance : 0.0;
            return cut.removed(hole.diameter, hole.depth).unbalance - before;
        };
        const auto found = std::ranges::find_if(holes, [&, plane = i](const auto& recorded) {
            const bob_weights::DrilledHole& hole = *recorded.second;
            // What was to be deepened is whole on the wrong side, and no plan was of all of it.
            const bool is_of_plan = hole.from_depth > 0.0
                                        ? hole.state == bob_weights::HoleState::as_planned
                                        : is_as_planned(hole);
            return static_cast<std::size_t>(hole.plane) == plane && is_of_plan && hole.unbalance &&
                   job.radius(plane) && job.shaft.runs[recorded.first.run].is_recorded &&
                   differ(now(hole), *hole.unbalance, same);
        });
        if (found != holes.end() && job.shaft.newest()->within(i) != true) {
            const auto& [place, hole] = *found;
            job.say(Text::tr("%1: the hole at %2 was planned to take off %3; with the present "
                             "radius, density and drill point it takes off %4. Check them, or "
                             "record the hole as measured."),
                    job.at_run(place.run, i), in_degrees(hole->turned(hole->angle)),
                    in_gram_millimetres(*hole->unbalance), in_gram_millimetres(now(*hole)))
                .hole = place;
        }
    }
}

/// Whether the plan deepens a hole that a run has shown the effect of.
bool deepens_before(const DoubtSearch& job, std::size_t run, std::size_t plane) {
    const auto& planned = job.shaft.correction;
    return planned && std::ranges::any_of((*planned)[plane].holes, [&](const auto& hole) {
               return hole.from_depth > 0.0 && hole.deepens->run < run;
           });
}

/// Where it is not so much that the plan is wrong, a hole of another depth would be drilled twice:
/// it matters while the newest run is not within its limit, and before such a hole is deepened.
/// Else the record alone is contradicted, which no pass hides.
template <Severity severity>
void drilled_otherwise(DoubtSearch& job) {
    for (const std::size_t i : planes) {
        for_other_effects(job, i, [&](std::size_t run, const bob_weights::OtherEffect& other) {
            const bool is_newest = run + 1 == job.shaft.runs.size();
            const bool matters =
                (is_newest && job.shaft.runs[run].within(i) != true) || deepens_before(job, run, i);
            const Severity of_other = other.is_large ? Severity::error
                                      : matters      ? Severity::warning
                                                     : Severity::note;
            if (of_other != severity || other.is_at_light_spot ||
                (!other.is_large && !other.is_drilled)) {
                return;
            }
            const Text text =
                !other.is_large
                    ? Text::tr(
                          "%1: residual %2 after drilling instead of %3. Check the actual "
                          "angle and depth of the holes before drilling again.")
                : other.is_in_other_plane
                    ? Text::tr(
                          "%1: residual %2 after drilling instead of %3, as if the holes were "
                          "in the other plane. Enter the actual plane of each hole.")
                : other.is_opposite
                    ? Text::tr(
                          "%1: drilling increased the unbalance to %2 instead of %3. Mark "
                          "holes on the wrong side, or check whether the machine shows the "
                          "light spot.")
                : !other.is_drilled
                    ? Text::tr(
                          "%1: %2 instead of %3, but no hole is recorded. Enter the holes "
                          "drilled, or check crankshaft and machine.")
                    : Text::tr(
                          "%1: residual %2 after drilling instead of %3. Check the actual "
                          "holes: angle, depth, zero mark and direction of degrees.");
            const auto& read = *job.shaft.runs[run].planes[i];
            job.say(text, job.at_run(run, i), job.reading(read.unbalance, *read.angle),
                    job.reading(other.expected, other.expected_angle))
                .hole = first_hole(job, other.since, [&](const bob_weights::DrilledHole& hole) {
                return static_cast<std::size_t>(hole.plane) == i;
            });
        });
    }
}

/// What the holes do not explain may be their depth: deepened by the record they would take off too
/// much, and that cannot be undone.
void deepens_unmeasured(DoubtSearch& job) {
    const auto& planned = job.shaft.correction;
    for (std::size_t i = 0; planned && job.shaft.permissible && i < 2; ++i) {
        for (const bob_weights::Hole& hole : (*planned)[i].holes) {
            if (hole.from_depth == 0.0 ||
                (*job.input.correction->earlier_runs[hole.deepens->run].drilled)[hole.deepens->hole]
                        .state == bob_weights::HoleState::measured) {
                continue;
            }
            std::optional<std::size_t> unexplained;
            for_other_effects(job, i, [&](std::size_t run, const bob_weights::OtherEffect&) {
                unexplained = run > hole.deepens->run ? std::optional(run) : unexplained;
            });
            if (unexplained) {
                const bob_weights::RunResult& run = job.shaft.runs[*unexplained];
                const auto& read = *run.planes[i];
                const auto& other = *run.other_effect[i];
                job.say(Text::tr("%1: residual %2 after drilling instead of %3. Measure the depth "
                                 "of the hole at %4 before deepening it, and record it as "
                                 "measured."),
                        job.at_run(*unexplained, i), job.reading(read.unbalance, *read.angle),
                        job.reading(other.expected, other.expected_angle), in_degrees(hole.angle))
                    .hole = hole.deepens;
            }
        }
    }
}

/// Deeper than any hole may be drilled: a slip of the keyboard where by half and more.
template <bool implausible>
void drilled_too_deep(DoubtSearch& job) {
    constexpr double slip = 1.5;
    constexpr double rounding = 1e-9;
    const auto& correction = job.input.correction;
    if (!correction || !correction->drill.maximum_depth) {
        return;
    }
    const double maximum = *correction->drill.maximum_depth;
    std::array<std::pair<double, bob_weights::Hole::Place>, 2> deepest{};
    for (const auto& [place, hole] : recorded_holes(correction)) {
        auto& plane = deepest[static_cast<std::size_t>(hole->plane)];
        if (hole->state != bob_weights::HoleState::not_drilled && hole->depth > plane.first) {
            plane = {hole->depth, place};
        }
    }
    for (const std::size_t i : planes) {
        const double depth = deepest[i].first;
        if (depth > maximum + rounding && (depth > slip * maximum) == implausible) {
            job.say(Text::tr("%1: a recorded hole is %2 deep, the maximum depth is %3. Correct the "
                             "wrong value."),
                    job.plane_name(i), millimetres(depth), millimetres(maximum))
                .hole = deepest[i].second;
        }
    }
}

/// Names of the ends exchanged. Left may be either end, depending on how the crankshaft lies.
template <bool certain>
void swapped_planes(DoubtSearch& job) {
    struct Ends {
        std::string_view front;
        std::string_view rear;
        bool is_certain;
    };
    static constexpr Ends pairs[] = {{"Front", "Rear", true},      {"Front", "Back", true},
                                     {"Pulley", "Flywheel", true}, {"Перед", "Зад", true},
                                     {"Шкив", "Маховик", true},    {"Left", "Right", false},
                                     {"Лев", "Прав", false}};
    const Message names[] = {job.plane_name(0), job.plane_name(1)};
    const std::string front = names[0].english();
    const std::string rear = names[1].english();
    const bool is_swapped = std::ranges::any_of(pairs,
                                                [&](const Ends& ends) {
                                                    return ends.is_certain == certain &&
                                                           (front.starts_with(ends.rear) ||
                                                            rear.starts_with(ends.front));
                                                }) ||
                            (certain ? front == rear : front == "R" || rear == "L");
    if (job.input.correction && is_swapped) {
        job.say(certain
                    ? Text::tr("The front plane is named “%1”, the rear plane “%2”. Correct the "
                               "names.")
                    : Text::tr("The front plane is named “%1”, the rear plane “%2”. Check that "
                               "the readings are entered in this order."),
                names[0], names[1]);
    }
}

template <bool shaft>
void other_readings(DoubtSearch& job) {
    const bob_weights::RunResult* newest = job.shaft.newest();
    if (newest != nullptr && newest->read_on.has_value() == shaft && (shaft || newest->read_with)) {
        job.say(shop::other_readings(newest->read_with, newest->read_on, job.shaft.bob_weight));
    }
}

/// What was read with bob weights of an unknown mass says nothing of the crankshaft.
void unknown_bob_weight(DoubtSearch& job) {
    const bob_weights::RunResult* newest = job.shaft.newest();
    if (newest != nullptr && newest->is_read() && !job.shaft.bob_weight &&
        !bob_weights::balances_itself(job.input.engine)) {
        job.say(Text::tr("The readings need a known bob weight. Complete engine and parts."));
    }
}

/// What is read elsewhere is another unbalance in the planes, which takes its direction to know.
void beside_planes(DoubtSearch& job) {
    const auto& correction = job.input.correction;
    if (correction && !bob_weights::reads_in_planes(job.input) &&
        std::ranges::any_of(correction->readings, [](const auto& reading) {
            return reading.unbalance && !bob_weights::is_read(reading);
        })) {
        job.say(Text::tr("The readings are not in the planes. Enter their angles."));
    }
}

/// With the weights on it a crankshaft weighs three to six times as much as they do, with flywheel
/// and clutch up to ten times; of those with one rod on a crankpin the weights are lighter, onto
/// one of one or two cylinders flywheels may be pressed.
double heaviest_rotor(const bob_weights::Engine& engine) {
    return engine.cylinders <= 2 || bob_weights::balances_itself(engine) ? 100.0
           : bob_weights::is_pair(engine)                                ? 14.0
                                                                         : 25.0;
}

void rotor_mass(DoubtSearch& job) {
    constexpr double heaviest = 2000.0;  // kg, of cars, trucks and locomotives
    const auto mass = job.graded(&bob_weights::Tolerance::rotor_mass);
    if (!mass) {
        return;
    }
    const bob_weights::Engine& engine = job.input.engine;
    const double weights = job.shaft.bob_weight.value_or(0.0) * engine.crankpins();
    const Number shown{*mass, units::kg, 0};
    if (*mass > heaviest || (weights > 0.0 && *mass > heaviest_rotor(engine) * weights)) {
        job.say(Text::tr("A crankshaft of %1 is too heavy for this engine. Correct its mass in "
                         "kilograms, or enter the limit in g·mm."),
                shown);
    } else if (*mass < weights) {
        job.say(Text::tr("The crankshaft with its bob weights, %1, weighs less than the bob "
                         "weights, %2. Correct its mass."),
                shown, Number{weights, units::kg, -2});
    }
}

/// No crankshaft has its centre of mass that far off its axis.
void great_reading(DoubtSearch& job) {
    constexpr double maximum = 1.0 * units::mm;
    const auto mass = job.graded(&bob_weights::Tolerance::rotor_mass);
    const bob_weights::RunResult* newest = job.shaft.newest();
    for (std::size_t i = 0; mass && newest != nullptr && i < 2; ++i) {
        const auto& read = newest->planes[i];
        if (read && read->unbalance > maximum * *mass) {
            job.say(Text::tr("%1: %2 is implausible for a crankshaft of %3. Check the unit of the "
                             "reading and the calibration of the machine."),
                    job.plane_name(i), in_gram_millimetres(read->unbalance),
                    Number{*mass, units::kg, 0});
        }
    }
}

void grade(DoubtSearch& job) {
    const auto grade = job.graded(&bob_weights::Tolerance::grade);
    if (grade && !shop::is_plausible_grade(*grade, job.input.tolerance->rotor_mass)) {
        job.say(Text::tr("A balance grade of G %1 is implausible for this crankshaft. Correct it, "
                         "or enter the limit in g·mm."),
                Number{*grade / units::mm_per_s, units::none, -1});
    }
}

/// A counterweight reaches about as far as the crankpin, and never three times as far.
constexpr double nearest_plane = 0.8;
constexpr double farthest_plane = 3.0;

/// At its highest speed the pistons of an engine run at 4 to 28 m/s in the mean. Without a crank
/// radius it is one that the planes allow.
void service_speed(DoubtSearch& job) {
    constexpr double slowest = 2.5;
    constexpr double fastest = 40.0;
    const auto speed = bob_weights::service_speed(job.input);
    if (!speed) {
        return;
    }
    const auto crank = job.crank_radius();
    const auto plane = job.radius(0);
    const double strokes = 2.0 * *speed / std::numbers::pi;  // 4 n, with n = ω / 2π
    if (*speed < 30.0 * units::rpm || *speed > 30'000.0 * units::rpm ||
        ((crank || plane) && (strokes * (crank ? *crank : *plane / nearest_plane) < slowest ||
                              strokes * (crank ? *crank : *plane / farthest_plane) > fastest))) {
        job.say(Text::tr("A service speed of %1 is implausible. Correct the speed."),
                Number{*speed / units::rpm, units::rpm, 0});
    }
}

void bearings(DoubtSearch& job) {
    const auto places = bob_weights::places_of_bearings(job.input);
    if (places == bob_weights::BearingPlaces::reversed) {
        job.say(
            Text::tr("The bearings are in reverse order to the planes. Measure all positions "
                     "from one point in one direction."));
    } else if (places == bob_weights::BearingPlaces::centre_beyond) {
        job.say(
            Text::tr("The centre of mass is not between the bearings (or planes). Correct its "
                     "position."));
    }
}

void plane_radius(DoubtSearch& job) {
    const auto crank = job.crank_radius();
    for (const std::size_t i : planes) {
        const auto radius = job.radius(i);
        if (crank && radius &&
            (*radius < nearest_plane * *crank || *radius > farthest_plane * *crank)) {
            job.say(Text::tr("%1: a drilling radius of %2 does not match a crank radius of %3. "
                             "Enter the radius, not the diameter."),
                    job.plane_name(i), millimetres(*radius), millimetres(*crank));
        }
    }
}

/// No counterweight of an engine with light parts reaches far, though a flywheel may.
template <bool implausible>
void far_radius(DoubtSearch& job) {
    constexpr double light = 5.0 * units::kg;
    constexpr double near = 20.0 * units::mm;
    constexpr double far = 120.0 * units::mm;
    constexpr double beyond = 200.0 * units::mm;
    if (job.crank_radius() || job.shaft.bob_weight.value_or(light) >= light) {
        return;
    }
    for (const std::size_t i : planes) {
        const auto radius = job.radius(i);
        if (radius && (implausible ? *radius < near || *radius > beyond
                                   : *radius > far && *radius <= beyond)) {
            job.say(Text::tr("%1: a drilling radius of %2 is unusual for such a bob weight. Enter "
                             "the radius, not the diameter."),
                    job.plane_name(i), millimetres(*radius));
        }
    }
}

/// No hole goes as deep as the journals, and no slug is as thick.
void deep_holes(DoubtSearch& job) {
    constexpr double maximum = 0.6;  // of the drilling radius
    const double radius = std::max(job.radius(0).value_or(0.0), job.radius(1).value_or(0.0));
    const auto check = [&](const Field& field, const std::optional<double>& size) {
        if (size && radius > 0.0 && *size > maximum * radius) {
            job.say(Text::tr("%1: %2 is implausible at a drilling radius of %3. Correct the wrong "
                             "value."),
                    field.label, millimetres(*size), millimetres(radius));
        }
    };
    if (const auto& correction = job.input.correction) {
        check(bob_weights::field::maximum_depth, correction->drill.maximum_depth);
        check(bob_weights::field::slug_diameter,
              correction->slug ? correction->slug->diameter : std::nullopt);
    }
}

/// Shorter than its radius a slug tilts while it is pressed in.
void short_slugs(DoubtSearch& job) {
    constexpr double minimum = 0.5;  // of the diameter
    constexpr double rounding = 1e-9;
    const auto& planned = job.shaft.correction;
    for (std::size_t i = 0; planned && i < 2; ++i) {
        const auto& slugs = (*planned)[i].slugs;
        const auto shortest = std::ranges::min_element(slugs, {}, &bob_weights::Hole::depth);
        if (shortest != slugs.end() && shortest->depth < minimum * shortest->diameter - rounding) {
            job.say(Text::tr("%1: a slug of ⌀ %2 that is %3 long tilts when pressed in; it should "
                             "be at least %4 long. Use a smaller slug diameter."),
                    job.plane_name(i), millimetres(shortest->diameter),
                    millimetres(shortest->depth), millimetres(minimum * shortest->diameter));
        }
    }
}

/// Of two counterweights neither reaches twice as far as the other.
void unlike_radii(DoubtSearch& job) {
    constexpr double maximum = 1.8;
    const double front = job.radius(0).value_or(0.0);
    const double rear = job.radius(1).value_or(0.0);
    if (differ(front, rear, maximum) && !job.has_said("plane-radius") &&
        !job.has_said("implausible-radius") && !job.has_said("far-radius")) {
        job.say(Text::tr("Drilling radii of %1 and %2: one looks like a diameter. Check both."),
                millimetres(front), millimetres(rear));
    }
}

void plane_order(DoubtSearch& job) {
    const auto positions = bob_weights::plane_positions(job.input);
    if (!positions) {
        return;
    }
    const auto& [front, rear] = *positions;
    if (front >= rear) {
        job.say(Text::tr("%1 at %2 is not before %3 at %4. Correct the positions of the planes."),
                job.plane_name(0), millimetres(front), job.plane_name(1), millimetres(rear));
        return;
    }
    const auto& readings = job.input.correction->readings;
    if (readings.size() != 2 || (!readings[0].position && !readings[1].position)) {
        return;
    }
    // Readings in the reverse order swap the ends; so close together they tell no ends apart.
    constexpr double nearest = 0.1;
    const double first = readings[0].position.value_or(front);
    const double second = readings[1].position.value_or(rear);
    if (second - first <= nearest * (rear - front)) {
        job.say(Text::tr("The first reading is at %1, the second at %2, but the planes are at %3 "
                         "and %4. Correct the positions of the readings."),
                millimetres(first), millimetres(second), millimetres(front), millimetres(rear));
    }
}

/// A machine may show grams at the drilling radius: such a number is far below a limit in g·mm.
void reading_in_grams(DoubtSearch& job) {
    constexpr double far_below = 0.25;
    const auto& limits = job.shaft.permissible;
    if (!limits || job.shaft.runs.size() != 1 || job.input.correction->readings.size() != 2) {
        return;
    }
    bool fails_as_grams = false;
    for (const std::size_t i : planes) {
        const auto& read = job.input.correction->readings[i].unbalance;
        const auto radius = job.radius(i);
        if (!radius || !read || *read > far_below * (*limits)[i]) {
            return;
        }
        const double as_grams = *read / units::gram_mm * units::gram * *radius;
        fails_as_grams = fails_as_grams || as_grams > (*limits)[i];
    }
    if (fails_as_grams) {
        job.say(
            Text::tr("The first readings are far below the limit. If the machine shows grams, "
                     "enter them with their unit: %1."),
            Number{*job.input.correction->readings[0].unbalance / units::gram_mm, units::gram, 0});
    }
}

void amplification(DoubtSearch& job) {
    constexpr double maximum = 1.5;
    if (job.shaft.amplification.value_or(0.0) > maximum) {
        job.say(Text::tr("The machine reads far outside the planes: errors may be %1 times as "
                         "large in the planes. Measure nearer to the planes."),
                Number{*job.shaft.amplification, units::none, -1});
    }
}

void drill_size(DoubtSearch& job) {
    const auto& correction = job.input.correction;
    for (std::size_t i = 0; correction && i < correction->drill.diameters_mm.size(); ++i) {
        const double size = correction->drill.diameters_mm[i];
        if (!bob_weights::is_usual_drill(size * units::mm)) {
            job.say(Text::tr("A drill of %1 is unusual. Separate several sizes by semicolons."),
                    Number{size, units::mm, -2});
        }
    }
}

void beyond_sector(DoubtSearch& job) {
    const auto& planned = job.shaft.correction;
    for (std::size_t i = 0; planned && i < 2; ++i) {
        if ((*planned)[i].beyond_sector > 0.0) {
            job.say(Text::tr("%1: the edge of a hole is %2 beyond the drilling sector. Check that "
                             "there is enough metal."),
                    job.plane_name(i),
                    Number{(*planned)[i].beyond_sector / units::mm, units::mm, -2});
        }
    }
}

/// A recorded hole where none may be has another angle, or the sector is another.
void outside_sector(DoubtSearch& job) {
    for (std::size_t at = 0; at + 1 < job.shaft.runs.size(); ++at) {
        for (const std::size_t i : planes) {
            const bob_weights::Metal& metal = job.shaft.runs[at].drilled[i];
            bob_weights::HoleLimits limits{};
            limits.sector = job.input.correction->planes[i].sector();
            const auto check = [&](const bob_weights::Hole& hole) {
                // A deepened one was there before.
                if (hole.from_depth == 0.0 && !limits.allows(hole.angle)) {
                    job.say(Text::tr("%1: the recorded hole at %2 is outside the drilling sector. "
                                     "Check both."),
                            job.at_run(at, i), in_degrees(hole.angle));
                }
            };
            std::ranges::for_each(metal.holes, check);
            std::ranges::for_each(metal.slugs, check);
        }
    }
}

/// Of half a sector nobody knows which half is meant.
void half_sector(DoubtSearch& job) {
    const auto& planned = job.shaft.correction;
    for (std::size_t i = 0; planned && i < 2; ++i) {
        const bob_weights::Plane& plane = job.input.correction->planes[i];
        if (plane.has_half_sector() && (*planned)[i].is_planned()) {
            job.say(
                Text::tr("%1: enter “%2”, the other end of the drilling sector."),
                job.plane_name(i),
                (plane.from_angle ? bob_weights::field::to_angle : bob_weights::field::from_angle)
                    .label);
        }
    }
}

/// A rim that is whole is said to be so.
void all_round(DoubtSearch& job) {
    const auto& planned = job.shaft.correction;
    for (std::size_t i = 0; planned && i < 2; ++i) {
        const bob_weights::Plane& plane = job.input.correction->planes[i];
        if (!plane.from_angle && !plane.to_angle && !(*planned)[i].holes.empty()) {
            job.say(Text::tr("%1: enter the drilling sector, or 0 to 360° for a whole rim."),
                    job.plane_name(i));
        }
    }
}

}  // namespace

bool contradicts_scale(const Input& input, const bob_weights::PartField& part) {
    const auto& typed = input.parts.*part.member;
    if (!typed || !part.column || !input.weigh_in) {
        return false;
    }
    const auto weighed = shop::statistics((*input.weigh_in)[*part.column]);
    return weighed && differ(*typed, weighed->mean, same_mass);
}

std::span<const DoubtRule> doubt_rules() {
    constexpr Severity error = Severity::error;
    constexpr Severity warning = Severity::warning;
    constexpr Severity note = Severity::note;
    // A bob weight that is wrong makes wrong readings, and these wrong holes and a wrong verdict.
    constexpr Withheld all{true, true, true};
    constexpr Withheld judged{false, true, true};
    constexpr Withheld limited{false, true, true, true};
    constexpr Withheld verdict_alone{false, false, true};
    constexpr Withheld holes_alone{false, true, false};
    constexpr Withheld nothing{};
    static constexpr DoubtRule rules[] = {
        {"swapped-ends", error, all, swap_ends_act, swapped_ends},
        {"kilograms", error, all, "", kilograms},
        {"odd-mass", error, all, "", odd_mass},
        {"typed-against-weighed", error, all, "", typed_against_weighed},
        {"nominal-against-weighed", error, all, "", nominal_against_weighed},
        {"unlike-halves", error, all, "", unlike_halves},
        {"unlike-parts", error, all, "", unlike_parts},
        {"much-oil", error, all, "", much_oil},
        {"share-of-one", error, all, "", share_of_one},
        {"plug-mass", error, all, "", plug_doubt<true>},
        {"plug-radius", error, all, "", plug_radius},
        {"half-weighed", error, all, "", half_weighed},
        {"unknown-bob-weight", error, judged, "", unknown_bob_weight},
        {"other-crankshaft", error, judged, "", other_readings<true>},
        {"other-bob-weight", error, judged, "", other_readings<false>},
        {"beside-planes", error, verdict_alone, "", beside_planes},
        {"rotor-mass", error, limited, "", rotor_mass},
        {"plane-radius", error, limited, "", plane_radius},
        {"implausible-radius", error, limited, "", far_radius<true>},
        {"plane-order", error, limited, "", plane_order},
        {"deep-holes", error, limited, "", deep_holes},
        {"grade", error, limited, "", grade},
        {"great-reading", error, limited, "", great_reading},
        {"service-speed", error, limited, "", service_speed},
        {"bearings", error, limited, "", bearings},
        {"drilled-unread", error, judged, drilled_act, drilled_unread},
        {"other-plan", error, holes_alone, present_plan_act, other_plan},
        {"incomplete-run", error, judged, "", incomplete_run},
        {"half-sector", error, judged, "", half_sector},
        {"shallower-hole", error, judged, drilled_act, shallower_hole},
        {"drilled-at-light-spot", error, judged, "", drilled_at_light_spot},
        {"drilled-counting-otherwise", error, judged, drilled_act, drilled_counting_otherwise},
        {"drilled-too-deep", error, judged, drilled_act, drilled_too_deep<true>},
        {"swapped-planes", error, limited, "", swapped_planes<true>},
        {"drilled-otherwise", error, judged, drilled_act, drilled_otherwise<error>},
        {"deepens-unmeasured", error, judged, drilled_act, deepens_unmeasured},
        {"missing-angle", warning, nothing, "", missing_angle},
        {"drilled-beside-plan", warning, nothing, "", drilled_otherwise<warning>},
        {"drilled-by-other-values", warning, nothing, "", drilled_by_other_values},
        {"taken-as-nominal", warning, nothing, "", taken_as_nominal, true},
        {"paper-plug", warning, nothing, "", plug_doubt<false>},
        {"paper-limit", warning, nothing, "", paper_limits},
        {"gear-against-parts", warning, nothing, "", gear_against_parts},
        {"plug-shift", warning, nothing, "", plug_shift},
        {"unequal-crankpins", warning, nothing, "", unequal_crankpins},
        {"spread", warning, nothing, "", spread_of_parts},
        {"far-radius", warning, nothing, "", far_radius<false>},
        {"unlike-radii", warning, nothing, "", unlike_radii},
        {"amplification", warning, nothing, "", amplification},
        {"reading-in-grams", warning, nothing, "", reading_in_grams},
        {"drill-size", warning, nothing, "", drill_size},
        {"drilled-deep", warning, nothing, "", drilled_too_deep<false>},
        {"left-and-right", warning, nothing, "", swapped_planes<false>},
        {"beyond-sector", warning, nothing, "", beyond_sector},
        {"outside-sector", warning, nothing, "", outside_sector},
        {"short-slug", warning, nothing, "", short_slugs},
        {"all-round", warning, nothing, "", all_round},
        {"drilled-unlike-record", note, nothing, "", drilled_otherwise<note>},
    };
    return rules;
}

std::vector<Doubt> find_doubts(const Input& input, const Result& result) {
    DoubtSearch job{input, result.shaft, result.plugs_input, result.plugs};
    for (const DoubtRule& rule : doubt_rules()) {
        job.rule = &rule;
        rule.find(job);
    }
    return std::move(job.found);
}

}  // namespace ravnoves::workshop

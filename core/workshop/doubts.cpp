#include "workshop/doubts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "bob-weights/factor_theory.h"
#include "bob-weights/fields.h"
#include "bob-weights/solver.h"
#include "shop/balance_grade.h"
#include "shop/kilograms.h"
#include "shop/results.h"
#include "shop/sentences.h"
#include "v8-plugs/results.h"
#include "v8-plugs/shift.h"

namespace ravnoves::workshop {

namespace {

using Messages = std::vector<Message>;
using shop::in_gram_millimetres;
using shop::in_grams;
using shop::Part;

/// A mass that is typed again differs by rounding, not by a tenth.
constexpr double same_mass = 1.1;
/// New parts are no quarter heavier than those that they replace.
constexpr double same_part = 1.25;

Number millimetres(double length) {
    return {length / units::mm, units::mm, -1};
}

Message at_angle(double unbalance, double angle) {
    return {Text{"%1 ∠ %2"}, in_gram_millimetres(unbalance),
            Number{angle / units::degree, units::degree, -1}};
}

Message plane_name(const DoubtCase& job, std::size_t plane) {
    return shop::plane_title(job.input.machine.planes, plane);
}

/// What each plane has to be said of it.
Messages of_planes(const auto& message_of) {
    Messages list;
    for (std::size_t i = 0; i < 2; ++i) {
        if (Message message = message_of(i); !message.empty()) {
            list.push_back(std::move(message));
        }
    }
    return list;
}

std::optional<double> radius_of(const DoubtCase& job, std::size_t plane) {
    const auto& correction = job.input.correction;
    return correction && plane < correction->planes.size() ? correction->planes[plane].radius
                                                           : std::nullopt;
}

/// A value of the tolerance that counts for a grade alone.
std::optional<double> graded(const DoubtCase& job,
                             std::optional<double> bob_weights::Tolerance::*value) {
    const auto& tolerance = job.input.tolerance;
    return tolerance && tolerance->by_grade ? *tolerance.*value : std::nullopt;
}

bool differ(double a, double b, double times) {
    return a > 0.0 && b > 0.0 && std::abs(std::log(a / b)) > std::log(times);
}

/// "1, 2, 5"
Message cylinders(const std::vector<std::size_t>& list) {
    Message text;
    for (const std::size_t cylinder : list) {
        const Message number = Number{static_cast<double>(cylinder + 1)};
        text = text.empty() ? number : joined(text, number);
    }
    return text;
}

/// Calls `visit` with each column of the sheet that is begun.
void for_columns(const DoubtCase& job, const auto& visit) {
    if (job.input.weigh_in) {
        for (const Part part : shop::all_parts) {
            const shop::PartColumn& column = (*job.input.weigh_in)[part];
            if (!column.is_empty()) {
                visit(part, column);
            }
        }
    }
}

bool is_in_kilograms(Part part, const shop::PartColumn& column) {
    return shop::mass_in_kilograms(part, column).has_value();
}

// ----------------------------------------------------------------------------------- masses

Messages kilograms(const DoubtCase& job) {
    Messages list;
    const auto add = [&](Text name, double mass) {
        list.emplace_back(Text::tr("%1: %2 looks like kilograms. Enter grams."), name,
                          Number{mass / units::gram, units::gram, 3});
    };
    for (const auto& [part, mass] : job.shaft.in_kilograms) {
        add(part->column                                 ? shop::part_word(*part->column).label
            : part->member == &bob_weights::Parts::locks ? Text::tr("Locks")
                                                         : Text::tr("Oil"),
            mass);
    }
    if (job.plugs_input != nullptr) {
        constexpr double minimum = 20 * units::gram;  // the sums of parts that weigh 5 g and more
        const v8_plugs::Engine& engine = job.plugs_input->engine;
        for (const auto member :
             {&v8_plugs::Engine::reciprocating_mass, &v8_plugs::Engine::rotating_mass}) {
            if (engine.*member && *(engine.*member) < minimum) {
                add(member == &v8_plugs::Engine::rotating_mass ? Text::tr("Rotating mass")
                                                               : Text::tr("Reciprocating mass"),
                    *(engine.*member));
            }
        }
    }
    return list;
}

Messages odd_mass(const DoubtCase& job) {
    Messages list;
    for_columns(job, [&](Part part, const shop::PartColumn& column) {
        const auto odd = shop::odd_mass(column);
        if (!odd || is_in_kilograms(part, column)) {
            return;
        }
        const Text name = shop::part_word(part).label;
        constexpr double maximum = 10.0;
        Message text =
            !odd->also.empty()
                ? Message(Text::tr("%1: cylinders %2 differ from the others (%3, others %4). "
                                   "Weigh them again or match the parts."),
                          name, cylinders(odd->cylinders()), in_grams(odd->mass),
                          in_grams(odd->usual))
            : odd->score
                ? Message(
                      *odd->score > maximum
                          ? Text::tr(
                                "%1: cylinder %2 weighs %3, the others about %4; the deviation is "
                                "more than %5 times their scatter. Weigh it again or match the "
                                "parts.")
                          : Text::tr(
                                "%1: cylinder %2 weighs %3, the others about %4; the deviation is "
                                "%5 times their scatter. Weigh it again or match the parts."),
                      name, odd->cylinder + 1, in_grams(odd->mass), in_grams(odd->usual),
                      Number{std::min(*odd->score, maximum), units::none, -1, false, true})
                : Message(Text::tr("%1: cylinder %2 weighs %3, the others about %4. Weigh it "
                                   "again."),
                          name, odd->cylinder + 1, in_grams(odd->mass), in_grams(odd->usual));
        list.push_back(odd->may_be_permitted
                           ? shop::two_sentences(
                                 std::move(text),
                                 Text::tr("If the difference is permitted, enter the “permitted "
                                          "range” of the column."))
                           : std::move(text));
    });
    return list;
}

Messages swapped_ends(const DoubtCase& job) {
    if (job.input.weigh_in) {
        const shop::WeighIn& sheet = *job.input.weigh_in;
        const auto swapped =
            shop::swapped_rod_ends(sheet[Part::rod_big_end].mass, sheet[Part::rod_small_end].mass);
        if (!swapped.empty()) {
            return {{Text::tr("Rods of cylinders %1: the big end weighs less than the small end. "
                              "Swap the columns or weigh the rods again."),
                     cylinders(swapped)}};
        }
    }
    const shop::Weighed big[] = {job.input.parts.big_end};
    const shop::Weighed small[] = {job.input.parts.small_end};
    if (shop::swapped_rod_ends(big, small).empty()) {
        return {};
    }
    return {{Text::tr("The big end of the rod, %1, weighs less than its small end, %2. Swap both "
                      "or weigh the rod again."),
             in_grams(**big), in_grams(**small)}};
}

Messages typed_against_weighed(const DoubtCase& job) {
    Messages list;
    for (const bob_weights::PartField& part : bob_weights::part_fields()) {
        if (contradicts_scale(job.input, part)) {
            const auto weighed = shop::statistics((*job.input.weigh_in)[*part.column]);
            list.emplace_back(Text::tr("%1: %2 entered, but %3 weighed. Correct the wrong value."),
                              shop::part_word(*part.column).label,
                              in_grams(*(job.input.parts.*part.member)), in_grams(weighed->mean));
        }
    }
    return list;
}

Messages nominal_against_weighed(const DoubtCase& job) {
    Messages list;
    for_columns(job, [&](Part part, const shop::PartColumn& column) {
        const double mean = shop::statistics(column)->mean;
        if (column.nominal && !is_in_kilograms(part, column) &&
            differ(*column.nominal, mean, same_part)) {
            list.emplace_back(Text::tr("%1: nominal %2, but %3 weighed. Correct the wrong value."),
                              shop::part_word(part).label, in_grams(*column.nominal),
                              in_grams(mean));
        }
    });
    return list;
}

/// 0.5 for 50 % is 0.5 %.
Messages share_of_one(const DoubtCase& job) {
    const double share = job.input.factor.reciprocating.value_or(0.0);
    if (share <= 0.0 || share > 0.01) {
        return {};
    }
    return {
        {Text::tr("A balance factor of %1 looks like a fraction. Enter percent: 50 for one half."),
         Number{share / units::percent, units::percent, -2}}};
}

Messages gear_against_parts(const DoubtCase& job) {
    Messages list;
    if (job.plugs_input == nullptr || !job.plugs_input->weigh_in) {
        return list;
    }
    const shop::WeighIn& sheet = *job.plugs_input->weigh_in;
    const auto check = [&](Text name, const std::optional<double>& typed,
                           const std::optional<double>& parts) {
        // Bob weights are hung to a tenth of a gram.
        if (typed && parts && std::abs(*typed - *parts) >= 0.1 * units::gram) {
            list.emplace_back(
                Text::tr(
                    "%1: %2 entered, but the nominal parts add up to %3. Correct the wrong value."),
                name, in_grams(*typed), in_grams(*parts));
        }
    };
    check(Text::tr("Reciprocating mass"), job.plugs_input->engine.reciprocating_mass,
          v8_plugs::nominal_reciprocating(sheet));
    check(Text::tr("Rotating mass"), job.plugs_input->engine.rotating_mass,
          v8_plugs::nominal_rotating(sheet));
    return list;
}

// ------------------------------------------------------------------------------------ plugs

template <bool certain>
Messages plug_doubt(const DoubtCase& job) {
    if (job.plugs == nullptr) {
        return {};
    }
    const v8_plugs::PlugDoubt doubt = v8_plugs::plug_doubt(*job.plugs_input, *job.plugs);
    return doubt.text.empty() || doubt.is_certain != certain ? Messages() : Messages{doubt.text};
}

Messages paper_limits(const DoubtCase& job) {
    return job.plugs != nullptr ? v8_plugs::paper_limits(*job.plugs_input, *job.plugs) : Messages();
}

/// A sludge trap is in a crankpin, whose axis is at the crank radius.
Messages plug_radius(const DoubtCase& job) {
    constexpr double nearest = 0.5;
    constexpr double farthest = 2.0;
    using v8_plugs::Engine;
    Messages list;
    const auto crank =
        job.plugs_input != nullptr ? job.plugs_input->engine.crank_radius : std::nullopt;
    for (const v8_plugs::EngineField& each : v8_plugs::engine_fields()) {
        const bool is_of_plug =
            each.member == &Engine::plug_radius || each.member == &Engine::new_plug_radius;
        const auto radius =
            crank && is_of_plug ? job.plugs_input->engine.*each.member : std::nullopt;
        if (radius && (*radius < nearest * *crank || *radius > farthest * *crank)) {
            list.emplace_back(Text::tr("%1: %2 does not match a crank radius of %3. Correct the "
                                       "wrong value."),
                              each.field.label, millimetres(*radius), millimetres(*crank));
        }
    }
    return list;
}

/// Whether the plugs are answered by weights, and this part counts by its nominal mass as long as
/// not all of it is weighed.
bool is_nominal(const DoubtCase& job, Part part) {
    if (job.plugs_input == nullptr || !job.plugs_input->changes_from_weigh_in ||
        !job.plugs_input->changes_known() || (*job.plugs_input->weigh_in)[part].is_weighed()) {
        return false;
    }
    const auto change = v8_plugs::change_of(part, job.plugs_input->process);
    return !job.plugs_input->takes_typed(change) || job.plugs_input->changes().*change == 0.0;
}

Messages half_weighed(const DoubtCase& job) {
    Messages list;
    for_columns(job, [&](Part part, const shop::PartColumn& column) {
        if (is_nominal(job, part)) {
            list.emplace_back(Text::tr("%1: %2 of 8 weighed. Weigh all of them, or clear the "
                                       "column."),
                              shop::part_word(part).label, shop::statistics(column)->count);
        }
    });
    return list;
}

Messages taken_as_nominal(const DoubtCase& job) {
    Message names;
    for (const Part part : shop::all_parts) {
        if (is_nominal(job, part)) {
            const Message name = shop::part_word(part).label;
            names = names.empty() ? name : joined(names, name);
        }
    }
    return names.empty() ? Messages()
                         : Messages{{Text::tr("Provisional: not weighed and taken as nominal: %1. "
                                              "Weigh them before machining."),
                                     names}};
}

Messages plug_shift(const DoubtCase& job) {
    const v8_plugs::ShiftEffect* shift =
        job.plugs != nullptr ? job.plugs->shift_that_matters() : nullptr;
    return shift != nullptr ? Messages{describe(*shift, job.plugs_input->tolerance)} : Messages();
}

Messages unequal_crankpins(const DoubtCase& job) {
    if (job.plugs == nullptr || !job.shaft.placing || !job.plugs_input->changes_from_weigh_in) {
        return {};
    }
    const shop::Placed& placed = job.shaft.placing->before;
    const double radius = job.plugs_input->engine.crank_radius.value_or(0.0);
    if (0.5 * placed.spread * radius <= job.plugs_input->tolerance) {
        return {};
    }
    const auto [minimum, maximum] = std::ranges::minmax(placed.crankpins);
    const double mean = job.plugs->weighed_excess.value();
    return {{Text::tr("The crankpins are unequal: their excess is %1 to %2, and the plugs are for "
                      "the mean. Move the sets or match the parts first."),
             in_grams(mean + minimum), in_grams(mean + maximum)}};
}

/// Parts of one engine are matched to less than this part of their mass.
constexpr double usual_spread = 0.01;

Messages spread_of_parts(const DoubtCase& job) {
    Messages list;
    for_columns(job, [&](Part part, const shop::PartColumn& column) {
        const auto found = shop::statistics(column);
        if (shop::odd_mass(column)) {
            return;  // which is said by itself
        }
        if (!found->within_permitted) {
            list.emplace_back(
                Text::tr("%1: range %2, permitted %3 (heaviest: cylinder %4, lightest: %5)."),
                shop::part_word(part).label, in_grams(found->spread),
                in_grams(*column.permitted_spread), found->heaviest + 1, found->lightest + 1);
        } else if (!column.permitted_spread &&
                   found->spread > std::max(usual_spread * found->mean, 1.0 * units::gram)) {
            list.emplace_back(Text::tr("%1: range %2 (heaviest: cylinder %3, lightest: %4). Weigh "
                                       "them again or match the parts."),
                              shop::part_word(part).label, in_grams(found->spread),
                              found->heaviest + 1, found->lightest + 1);
        }
    });
    return list;
}

/// How heavy a part is beside another one of its cylinder in any engine.
Messages unlike_parts(const DoubtCase& job) {
    using Parts = bob_weights::Parts;
    struct Rule {
        std::optional<double> Parts::*part;
        std::optional<double> Parts::*beside;
        double minimum;
        double maximum;
    };
    static constexpr Rule rules[] = {{&Parts::pin, &Parts::piston, 0.05, 1.0},
                                     {&Parts::rings, &Parts::piston, 0.01, 0.5},
                                     {&Parts::locks, &Parts::pin, 0.0, 0.3},
                                     {&Parts::small_end, &Parts::big_end, 0.1, 2.0},
                                     {&Parts::shells, &Parts::big_end, 0.02, 0.5}};
    const auto line_of = [&](std::optional<double> Parts::*member) {
        const auto found = std::find_if(
            job.shaft.lines.begin(), job.shaft.lines.end(),
            [&](const auto& line) { return line.part != nullptr && line.part->member == member; });
        return found != job.shaft.lines.end() && found->mass > 0.0 ? &*found : nullptr;
    };
    Messages list;
    for (const auto& [part, beside, minimum, maximum] : rules) {
        const auto* one = line_of(part);
        const auto* other = line_of(beside);
        if (one != nullptr && other != nullptr &&
            (one->mass < minimum * other->mass || one->mass > maximum * other->mass)) {
            list.emplace_back(
                Text::tr("%1 of %2 beside %3 of %4 is implausible. Correct the wrong value."),
                one->name.label, in_grams(one->mass), other->name.label, in_grams(other->mass));
        }
    }
    return list;
}

/// The oil of a crankpin is a few per cent of the bob weight.
Messages much_oil(const DoubtCase& job) {
    constexpr double maximum = 0.06;
    const auto oil = job.plugs != nullptr && job.plugs->before
                         ? std::optional(job.plugs->before->oil)
                         : job.input.parts.oil;
    if (!oil || !job.shaft.bob_weight || !(*oil > maximum * *job.shaft.bob_weight)) {
        return {};
    }
    return {{Text::tr("Oil of %1 in a crankpin is implausible for a bob weight of %2. Correct the "
                      "oil."),
             in_grams(*oil), in_grams(*job.shaft.bob_weight)}};
}

/// What reciprocates in an engine weighs about twice what turns; far from that a mass is mistyped.
Messages unlike_halves(const DoubtCase& job) {
    const auto& reciprocating = job.shaft.reciprocating;
    const auto& rotating = job.shaft.rotating;
    constexpr double minimum = 0.3;
    constexpr double maximum = 5.0;
    if (!reciprocating || !rotating || !(*rotating > 0.0) || !(*reciprocating > 0.0)) {
        return {};
    }
    const double ratio = *reciprocating / *rotating;
    if (ratio >= minimum && ratio <= maximum) {
        return {};
    }
    return {{Text::tr("Reciprocating mass %1 and rotating mass %2 of a cylinder are inconsistent. "
                      "Check the masses of the parts."),
             in_grams(*reciprocating), in_grams(*rotating)}};
}

// ---------------------------------------------------------------------------------- machine

/// By how much the holes that were planned after a run would lengthen what it reads in a plane now,
/// kg·m. What was measured is elsewhere than planned, and says nothing of it.
double lengthened(const bob_weights::RunResult& run, const bob_weights::EarlierRun& earlier,
                  std::size_t plane) {
    double sum = 0.0;
    const auto add = [&](const std::vector<bob_weights::Hole>& holes, double sign) {
        for (const bob_weights::Hole& hole : holes) {
            const auto state = (*earlier.drilled)[hole.deepens->hole].state;
            const double side = state == bob_weights::HoleState::wrong_side ? -1.0 : 1.0;
            if (state != bob_weights::HoleState::measured) {
                sum +=
                    sign * side * hole.unbalance * std::cos(hole.angle - *run.planes[plane]->angle);
            }
        }
    };
    add(run.drilled[plane].holes, -1.0);
    add(run.drilled[plane].slugs, 1.0);
    return sum;
}

/// Holes are planned at the heavy spot: where they are opposite it now, what the machine shows has
/// been changed since.
Messages drilled_at_light_spot(const DoubtCase& job) {
    Messages list;
    for (std::size_t at = 0; at + 1 < job.shaft.runs.size(); ++at) {
        const bob_weights::RunResult& run = job.shaft.runs[at];
        const bob_weights::EarlierRun& earlier = job.input.correction->earlier_runs[at];
        // What was planned from another reading is no witness.
        for (std::size_t i = 0; run.has_vectors() && earlier.drilled_by.empty() && i < 2; ++i) {
            if (lengthened(run, earlier, i) > 0.0) {
                const auto& read = *run.planes[i];
                list.emplace_back(
                    Text::tr("%1: the holes drilled after %2 are opposite this heavy spot. Check "
                             "whether the machine shows the heavy or the light spot."),
                    plane_name(job, i), at_angle(read.unbalance, *read.angle));
            }
        }
    }
    return list;
}

/// Angles of the holes are in the machine's sense of counting, which has been changed since. What
/// was measured is where it was found.
Messages drilled_counting_otherwise(const DoubtCase& job) {
    const auto is_as_counted = [](const bob_weights::DrilledHole& hole) {
        return hole.state == bob_weights::HoleState::as_planned ||
               hole.state == bob_weights::HoleState::wrong_side;
    };
    for (std::size_t at = 0; at + 1 < job.shaft.runs.size(); ++at) {
        const bob_weights::EarlierRun& earlier = job.input.correction->earlier_runs[at];
        if (earlier.counted_otherwise && job.shaft.runs[at].is_drilled() &&
            std::any_of(earlier.drilled->begin(), earlier.drilled->end(), is_as_counted)) {
            return {
                {Text::tr("The holes were drilled while the machine counted degrees in the "
                          "other direction. Check the direction, or enter the angles as "
                          "measured.")}};
        }
    }
    return {};
}

Messages drilled_otherwise(const DoubtCase& job) {
    const auto& runs = job.shaft.runs;
    return of_planes([&](std::size_t i) -> Message {
        if (runs.size() < 2 || !runs.back().contradicts(i)) {
            return {};
        }
        const auto& other = runs.back().other_effect[i];
        const auto& now = *runs.back().planes[i];
        return {other->is_in_other_plane
                    ? Text::tr("%1: residual %2 after drilling instead of %3, as if the holes "
                               "were in the other plane. Enter the actual plane of each hole.")
                : other->is_opposite
                    ? Text::tr(
                          "%1: drilling increased the unbalance to %2 instead of %3. Mark holes on "
                          "the wrong side, or check whether the machine shows the light spot.")
                : runs[runs.size() - 2].drilled[i].empty()
                    ? Text::tr("%1: %2 instead of %3, but no hole is recorded. Enter the holes "
                               "drilled, or check crankshaft and machine.")
                    : Text::tr("%1: residual %2 after drilling instead of %3. Check the actual "
                               "holes: angle, depth, zero mark and direction of degrees."),
                plane_name(job, i), at_angle(now.unbalance, *now.angle),
                at_angle(other->expected, other->expected_angle)};
    });
}

/// Not so much that the plan is wrong, but a hole of another depth would be drilled twice.
Messages drilled_beside_plan(const DoubtCase& job) {
    return of_planes([&](std::size_t i) -> Message {
        const auto& runs = job.shaft.runs;
        if (runs.size() < 2 || !runs.back().other_effect[i] || runs.back().contradicts(i)) {
            return {};
        }
        const auto& now = *runs.back().planes[i];
        const auto& other = *runs.back().other_effect[i];
        return {Text::tr("%1: residual %2 after drilling instead of %3. Check the actual depth of "
                         "the holes before drilling again."),
                plane_name(job, i), at_angle(now.unbalance, *now.angle),
                at_angle(other.expected, other.expected_angle)};
    });
}

/// Deeper than any hole may be drilled: a slip of the keyboard where by half and more.
template <bool implausible>
Messages drilled_too_deep(const DoubtCase& job) {
    constexpr double slip = 1.5;
    constexpr double rounding = 1e-9;
    const auto& correction = job.input.correction;
    const auto maximum = correction ? correction->drill.maximum_depth : std::nullopt;
    return of_planes([&](std::size_t i) -> Message {
        double deepest = 0.0;
        for (std::size_t run = 0; maximum && run < correction->earlier_runs.size(); ++run) {
            const auto& drilled = correction->earlier_runs[run].drilled;
            for (std::size_t at = 0; drilled && at < drilled->size(); ++at) {
                const bob_weights::DrilledHole& hole = (*drilled)[at];
                if (static_cast<std::size_t>(hole.plane) == i &&
                    hole.state != bob_weights::HoleState::not_drilled) {
                    deepest = std::max(deepest, hole.depth);
                }
            }
        }
        if (!maximum || deepest <= *maximum + rounding ||
            (deepest > slip * *maximum) != implausible) {
            return {};
        }
        return {Text::tr("%1: a recorded hole is %2 deep, the maximum depth is %3. Correct the "
                         "wrong value."),
                plane_name(job, i), millimetres(deepest), millimetres(*maximum)};
    });
}

/// Names of the ends exchanged. Left may be either end, depending on how the crankshaft lies.
template <bool certain>
Messages swapped_planes(const DoubtCase& job) {
    struct Ends {
        std::string_view front;
        std::string_view rear;
        bool is_certain;
    };
    static constexpr Ends pairs[] = {{"Front", "Rear", true},      {"Front", "Back", true},
                                     {"Pulley", "Flywheel", true}, {"Перед", "Зад", true},
                                     {"Шкив", "Маховик", true},    {"Left", "Right", false},
                                     {"Лев", "Прав", false}};
    const Message names[] = {plane_name(job, 0), plane_name(job, 1)};
    const std::string front = names[0].english();
    const std::string rear = names[1].english();
    const bool is_swapped = std::ranges::any_of(pairs,
                                                [&](const Ends& ends) {
                                                    return ends.is_certain == certain &&
                                                           (front.starts_with(ends.rear) ||
                                                            rear.starts_with(ends.front));
                                                }) ||
                            (certain ? front == rear : front == "R" || rear == "L");
    if (!job.input.correction || !is_swapped) {
        return {};
    }
    return {{certain ? Text::tr("The front plane is named “%1”, the rear plane “%2”. Correct the "
                                "names.")
                     : Text::tr("The front plane is named “%1”, the rear plane “%2”. Check that "
                                "the readings are entered in this order."),
             names[0], names[1]}};
}

template <bool shaft>
Messages other_readings(const DoubtCase& job) {
    const bob_weights::RunResult* newest = job.shaft.newest();
    if (newest == nullptr || (shaft ? !newest->read_on : newest->read_on || !newest->read_with)) {
        return {};
    }
    return {shop::other_readings(newest->read_with, newest->read_on, job.shaft.bob_weight)};
}

/// What was read with bob weights of an unknown mass says nothing of the crankshaft.
Messages unknown_bob_weight(const DoubtCase& job) {
    const bob_weights::RunResult* newest = job.shaft.newest();
    if (newest == nullptr || !newest->is_read() || job.shaft.bob_weight ||
        bob_weights::balances_itself(job.input.engine)) {
        return {};
    }
    return {{Text::tr("The readings need a known bob weight. Complete engine and parts.")}};
}

/// What is read elsewhere is another unbalance in the planes, which takes its direction to know.
Messages beside_planes(const DoubtCase& job) {
    const auto& correction = job.input.correction;
    if (!correction || bob_weights::reads_in_planes(job.input) ||
        std::all_of(correction->readings.begin(), correction->readings.end(),
                    [](const auto& reading) {
                        return !reading.unbalance || bob_weights::is_read(reading);
                    })) {
        return {};
    }
    return {{Text::tr("The readings are not in the planes. Enter their angles.")}};
}

/// All that hang on the crankshaft, kg.
double bob_weights_of(const DoubtCase& job) {
    return job.shaft.bob_weight.value_or(0.0) * job.input.engine.crankpins();
}

/// With the weights on it a crankshaft weighs three to six times as much as they do, with flywheel
/// and clutch up to ten times; of those with one rod on a crankpin the weights are lighter, onto
/// one of one or two cylinders flywheels may be pressed.
double heaviest_rotor(const DoubtCase& job) {
    const bob_weights::Engine& engine = job.input.engine;
    const double times = engine.cylinders <= 2 || bob_weights::balances_itself(engine) ? 100.0
                         : bob_weights::is_pair(engine)                                ? 14.0
                                                                                       : 25.0;
    return times * bob_weights_of(job);
}

Messages rotor_mass(const DoubtCase& job) {
    constexpr double heaviest = 2000.0;  // kg, of cars, trucks and locomotives
    const auto mass = graded(job, &bob_weights::Tolerance::rotor_mass);
    if (!mass) {
        return {};
    }
    const double weights = bob_weights_of(job);
    const Number shown{*mass, units::kg, 0};
    if (*mass > heaviest || (weights > 0.0 && *mass > heaviest_rotor(job))) {
        return {{Text::tr("A crankshaft of %1 is too heavy for this engine. Correct its mass in "
                          "kilograms, or enter the limit in g·mm."),
                 shown}};
    }
    if (*mass < weights) {
        return {{Text::tr("The crankshaft with its bob weights, %1, weighs less than the bob "
                          "weights, %2. Correct its mass."),
                 shown, Number{weights, units::kg, -2}}};
    }
    return {};
}

/// No crankshaft has its centre of mass that far off its axis.
Messages great_reading(const DoubtCase& job) {
    constexpr double maximum = 1.0 * units::mm;
    const auto mass = graded(job, &bob_weights::Tolerance::rotor_mass);
    return of_planes([&](std::size_t i) -> Message {
        const bob_weights::RunResult* newest = job.shaft.newest();
        const auto unbalance = newest != nullptr ? newest->unbalances()[i] : std::nullopt;
        if (!mass || !unbalance || *unbalance <= maximum * *mass) {
            return {};
        }
        return {Text::tr("%1: %2 is implausible for a crankshaft of %3. Check the "
                         "unit of the reading and the calibration of the machine."),
                plane_name(job, i), in_gram_millimetres(*unbalance), Number{*mass, units::kg, 0}};
    });
}

std::optional<double> crank_radius(const DoubtCase& job) {
    return job.plugs_input != nullptr ? job.plugs_input->engine.crank_radius
           : job.input.weigh_in       ? job.input.weigh_in->matching.crank_radius
                                      : std::nullopt;
}

Messages grade(const DoubtCase& job) {
    const auto grade = graded(job, &bob_weights::Tolerance::grade);
    if (!grade || shop::is_plausible_grade(*grade, job.input.tolerance->rotor_mass)) {
        return {};
    }
    return {{Text::tr("A balance grade of G %1 is implausible for this crankshaft. Correct it, or "
                      "enter the limit in g·mm."),
             Number{*grade / units::mm_per_s, units::none, -1}}};
}

/// The crank radius, or the smallest and the largest that the planes allow: a counterweight reaches
/// about as far as the crankpin, and never three times as far.
constexpr double nearest_plane = 0.8;
constexpr double farthest_plane = 3.0;
std::optional<std::array<double, 2>> crank_radii(const DoubtCase& job) {
    if (const auto radius = crank_radius(job)) {
        return {{*radius, *radius}};
    }
    const auto radius = radius_of(job, 0);
    return radius ? std::optional(std::array{*radius / farthest_plane, *radius / nearest_plane})
                  : std::nullopt;
}

/// At its highest speed the pistons of an engine run at 4 to 28 m/s in the mean.
bool is_implausible_speed(const DoubtCase& job, double speed) {
    constexpr double slowest = 2.5;
    constexpr double fastest = 40.0;
    const auto radii = crank_radii(job);
    const double strokes = 2.0 * speed / std::numbers::pi;  // 4 n, with n = ω / 2π
    return speed < 30.0 * units::rpm || speed > 30'000.0 * units::rpm ||
           (radii && (strokes * (*radii)[1] < slowest || strokes * (*radii)[0] > fastest));
}

Messages service_speed(const DoubtCase& job) {
    const auto speed = bob_weights::service_speed(job.input);
    if (!speed || !is_implausible_speed(job, *speed)) {
        return {};
    }
    return {{Text::tr("A service speed of %1 is implausible. Correct the speed."),
             Number{*speed / units::rpm, units::rpm, 0}}};
}

Messages bearings(const DoubtCase& job) {
    switch (bob_weights::places_of_bearings(job.input)) {
        case bob_weights::BearingPlaces::reversed:
            return {
                Text::tr("The bearings are in reverse order to the planes. Measure all "
                         "positions from one point in one direction.")};
        case bob_weights::BearingPlaces::centre_beyond:
            return {
                Text::tr("The centre of mass is not between the bearings (or planes). Correct its "
                         "position.")};
        case bob_weights::BearingPlaces::plausible:
            break;
    }
    return {};
}

Messages plane_radius(const DoubtCase& job) {
    const auto crank = crank_radius(job);
    return of_planes([&](std::size_t i) -> Message {
        const auto radius = radius_of(job, i);
        if (!crank || !radius ||
            (*radius >= nearest_plane * *crank && *radius <= farthest_plane * *crank)) {
            return {};
        }
        return {Text::tr("%1: a drilling radius of %2 does not match a crank radius "
                         "of %3. Enter the radius, not the diameter."),
                plane_name(job, i), millimetres(*radius), millimetres(*crank)};
    });
}

/// No counterweight of an engine with light parts reaches far, though a flywheel may.
template <bool implausible>
Messages far_radius(const DoubtCase& job) {
    constexpr double light = 5.0 * units::kg;
    constexpr double near = 20.0 * units::mm;
    constexpr double far = 120.0 * units::mm;
    constexpr double beyond = 200.0 * units::mm;
    if (crank_radius(job) || job.shaft.bob_weight.value_or(light) >= light) {
        return {};
    }
    return of_planes([&](std::size_t i) -> Message {
        const auto radius = radius_of(job, i);
        if (!radius || !(implausible ? *radius < near || *radius > beyond
                                     : *radius > far && *radius <= beyond)) {
            return {};
        }
        return {Text::tr("%1: a drilling radius of %2 is unusual for such a bob "
                         "weight. Enter the radius, not the diameter."),
                plane_name(job, i), millimetres(*radius)};
    });
}

/// No hole goes as deep as the journals, and no slug is as thick.
Messages deep_holes(const DoubtCase& job) {
    constexpr double maximum = 0.6;  // of the drilling radius
    Messages list;
    if (!job.input.correction) {
        return list;
    }
    const bob_weights::Correction& correction = *job.input.correction;
    const double radius =
        std::max(radius_of(job, 0).value_or(0.0), radius_of(job, 1).value_or(0.0));
    const auto check = [&](const Field& field, const std::optional<double>& size) {
        if (size && radius > 0.0 && *size > maximum * radius) {
            list.emplace_back(Text::tr("%1: %2 is implausible at a drilling radius of %3. Correct "
                                       "the wrong value."),
                              field.label, millimetres(*size), millimetres(radius));
        }
    };
    check(bob_weights::field::maximum_depth, correction.drill.maximum_depth);
    if (correction.slug) {
        check(bob_weights::field::slug_diameter, correction.slug->diameter);
    }
    return list;
}

/// Shorter than its radius a slug tilts while it is pressed in.
Messages short_slugs(const DoubtCase& job) {
    constexpr double minimum = 0.5;  // of the diameter
    constexpr double rounding = 1e-9;
    const auto& planned = job.shaft.correction;
    return of_planes([&](std::size_t i) -> Message {
        const bob_weights::Hole* shortest = nullptr;
        for (std::size_t k = 0; planned && k < (*planned)[i].slugs.size(); ++k) {
            const bob_weights::Hole& slug = (*planned)[i].slugs[k];
            if (slug.depth < minimum * slug.diameter - rounding &&
                (shortest == nullptr || slug.depth < shortest->depth)) {
                shortest = &slug;
            }
        }
        if (shortest == nullptr) {
            return {};
        }
        return {Text::tr("%1: a slug of ⌀ %2 that is %3 long tilts when pressed in; it should be "
                         "at least %4 long. Use a smaller slug diameter."),
                plane_name(job, i), millimetres(shortest->diameter), millimetres(shortest->depth),
                millimetres(minimum * shortest->diameter)};
    });
}

/// Of two counterweights neither reaches twice as far as the other.
Messages unlike_radii(const DoubtCase& job) {
    constexpr double maximum = 1.8;
    const double front = radius_of(job, 0).value_or(0.0);
    const double rear = radius_of(job, 1).value_or(0.0);
    if (!differ(front, rear, maximum) || !plane_radius(job).empty() ||
        !far_radius<true>(job).empty() || !far_radius<false>(job).empty()) {
        return {};
    }
    return {{Text::tr("Drilling radii of %1 and %2: one looks like a diameter. Check both."),
             millimetres(front), millimetres(rear)}};
}

Messages plane_order(const DoubtCase& job) {
    const auto planes = bob_weights::plane_positions(job.input);
    if (!planes) {
        return {};
    }
    const auto& [front, rear] = *planes;
    if (front >= rear) {
        return {{Text::tr("%1 at %2 is not before %3 at %4. Correct the positions of the planes."),
                 plane_name(job, 0), millimetres(front), plane_name(job, 1), millimetres(rear)}};
    }
    const auto& readings = job.input.correction->readings;
    if (readings.size() != 2 || (!readings[0].position && !readings[1].position)) {
        return {};
    }
    // Readings in the reverse order swap the ends; so close together they tell no ends apart.
    constexpr double nearest = 0.1;
    const double first = readings[0].position.value_or(front);
    const double second = readings[1].position.value_or(rear);
    if (second - first > nearest * (rear - front)) {
        return {};
    }
    return {{Text::tr("The first reading is at %1, the second at %2, but the planes are at %3 and "
                      "%4. Correct the positions of the readings."),
             millimetres(first), millimetres(second), millimetres(front), millimetres(rear)}};
}

/// A machine may show grams at the drilling radius: such a number is far below a limit in g·mm.
Messages reading_in_grams(const DoubtCase& job) {
    constexpr double far_below = 0.25;
    const auto& limits = job.shaft.permissible;
    if (!limits || job.shaft.runs.size() != 1 || job.input.correction->readings.size() != 2) {
        return {};
    }
    bool fails_as_grams = false;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& read = job.input.correction->readings[i].unbalance;
        const auto radius = radius_of(job, i);
        if (!radius || !read || *read > far_below * (*limits)[i]) {
            return {};
        }
        const double as_grams = *read / units::gram_mm * units::gram * *radius;
        fails_as_grams = fails_as_grams || as_grams > (*limits)[i];
    }
    if (!fails_as_grams) {
        return {};
    }
    return {
        {Text::tr("The first readings are far below the limit. If the machine shows grams, "
                  "enter them with their unit: %1."),
         Number{*job.input.correction->readings[0].unbalance / units::gram_mm, units::gram, 0}}};
}

Messages amplification(const DoubtCase& job) {
    const auto& times = job.shaft.amplification;
    if (!times || *times <= bob_weights::max_amplification) {
        return {};
    }
    return {{Text::tr("The machine reads far outside the planes: errors may be %1 times as large "
                      "in the planes. Measure nearer to the planes."),
             Number{*times, units::none, -1}}};
}

Messages drill_size(const DoubtCase& job) {
    Messages list;
    for (const double size :
         job.input.correction ? job.input.correction->drill.diameters_mm : std::vector<double>()) {
        if (!bob_weights::is_usual_drill(size * units::mm)) {
            list.emplace_back(Text::tr("A drill of %1 is unusual. Separate several sizes by "
                                       "semicolons."),
                              Number{size, units::mm, -2});
        }
    }
    return list;
}

Messages beyond_sector(const DoubtCase& job) {
    const auto& planned = job.shaft.correction;
    return of_planes([&](std::size_t i) -> Message {
        const double beyond = planned ? (*planned)[i].beyond_sector : 0.0;
        if (beyond <= 0.0) {
            return {};
        }
        return {Text::tr("%1: the edge of a hole is %2 beyond the drilling sector. "
                         "Check that there is enough metal."),
                plane_name(job, i), Number{beyond / units::mm, units::mm, -2}};
    });
}

/// A rim that is whole is said to be so.
Messages all_round(const DoubtCase& job) {
    const auto& planned = job.shaft.correction;
    return of_planes([&](std::size_t i) -> Message {
        if (!planned || job.input.correction->planes[i].from_angle || (*planned)[i].holes.empty()) {
            return {};
        }
        return {Text::tr("%1: enter the drilling sector, or 0 to 360° for a whole rim."),
                plane_name(job, i)};
    });
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
    // A bob weight that is wrong makes wrong readings, and these wrong holes and a wrong verdict.
    constexpr Withheld all{true, true, true};
    constexpr Withheld judged{false, true, true};
    constexpr Withheld verdict_alone{false, false, true};
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
        {"rotor-mass", error, judged, "", rotor_mass},
        {"plane-radius", error, judged, "", plane_radius},
        {"implausible-radius", error, judged, "", far_radius<true>},
        {"plane-order", error, judged, "", plane_order},
        {"deep-holes", error, judged, "", deep_holes},
        {"grade", error, judged, "", grade},
        {"great-reading", error, judged, "", great_reading},
        {"service-speed", error, judged, "", service_speed},
        {"bearings", error, judged, "", bearings},
        {"drilled-at-light-spot", error, judged, "", drilled_at_light_spot},
        {"drilled-counting-otherwise", error, judged, drilled_act, drilled_counting_otherwise},
        {"drilled-too-deep", error, judged, drilled_act, drilled_too_deep<true>},
        {"swapped-planes", error, judged, "", swapped_planes<true>},
        {"drilled-otherwise", error, judged, drilled_act, drilled_otherwise},
        {"drilled-beside-plan", warning, nothing, drilled_act, drilled_beside_plan},
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
        {"short-slug", warning, nothing, "", short_slugs},
        {"all-round", warning, nothing, "", all_round},
    };
    return rules;
}

std::vector<Doubt> find_doubts(const DoubtCase& job) {
    std::vector<Doubt> list;
    for (const DoubtRule& rule : doubt_rules()) {
        for (Message& text : rule.find(job)) {
            list.push_back({&rule, std::move(text)});
        }
    }
    return list;
}

}  // namespace ravnoves::workshop

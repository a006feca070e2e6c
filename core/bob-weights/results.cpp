#include "bob-weights/results.h"

#include "bob-weights/fields.h"
#include "bob-weights/result_fields.h"
#include "bob-weights/solver.h"
#include "numerics/demand.h"
#include "shop/results.h"

namespace ravnoves::bob_weights {

namespace {

using ravnoves::result_field::feasible;
using ravnoves::result_field::reason;
namespace key = result_field;

void visit_hole(ResultVisitor& visitor, const Hole& hole, bool added) {
    // A slug takes off less than nothing: so every line counts in the same sense.
    const double sign = added ? -1.0 : 1.0;
    visitor.number(key::diameter, hole.diameter);
    visitor.number(key::depth, hole.depth);
    visitor.number(key::hole_angle, hole.angle);
    visitor.number(key::removed, sign * hole.mass);
    visitor.number(key::removed_unbalance, sign * hole.unbalance);
    if (added) {
        visitor.number(key::added, hole.mass);
        visitor.number(key::added_unbalance, hole.unbalance);
        if (hole.slug > 0.0) {
            visitor.number(key::slug_mass, hole.slug);
        }
    }
}

void visit_holes(ResultVisitor& visitor, const ResultField& field, const std::vector<Hole>& holes,
                 bool added) {
    visitor.list(field, holes.size(), [&](std::size_t i) { visit_hole(visitor, holes[i], added); });
}

void visit_plane(ResultVisitor& visitor, const PlaneResult& plane) {
    visitor.number(key::unbalance, plane.unbalance);
    visitor.number(key::angle, plane.angle);
    visitor.number(key::grams_at_radius, plane.grams_at_radius);
    visit_holes(visitor, key::holes, plane.holes, false);
    visit_holes(visitor, key::slugs, plane.slugs, true);
    visitor.number(key::remaining, plane.remaining);
    visitor.number(key::remaining_angle, plane.remaining_angle);
    visitor.flag(key::within_as_measured, plane.measured_within);
    visitor.flag(key::within, plane.within_tolerance);
    visitor.flag(feasible, plane.reason.empty());
    if (plane.beyond_sector > 0.0) {
        visitor.number(key::beyond_sector, plane.beyond_sector);
    }
    if (!plane.reason.empty()) {
        visitor.text(reason, plane.reason);
    }
}

void visit_run(ResultVisitor& visitor, const RunResult& run, bool is_newest) {
    visitor.list(key::planes, 2, [&](std::size_t i) {
        const RunResult::InPlane& plane = run.planes.value()[i];
        visitor.number(key::unbalance, plane.unbalance);
        visitor.number(key::angle, plane.angle);
        visitor.flag(key::within, plane.within_tolerance);
        if (const auto& other = run.other_effect[i]) {
            visitor.object(key::expected, [&] {
                visitor.number(key::unbalance, other->expected);
                visitor.number(key::angle, other->expected_angle);
                visitor.flag(key::acted_opposite, other->is_opposite);
            });
        }
        if (!is_newest) {
            visit_holes(visitor, key::drilled_holes, run.drilled[i].holes, false);
            visit_holes(visitor, key::drilled_slugs, run.drilled[i].slugs, true);
        }
    });
    visitor.flag(key::within, run.passes());
    shop::visit_other(visitor, run.read_with, run.read_on);
}

void visit_weigh_in(ResultVisitor& visitor, const Input& input, const Result& result) {
    for (const Matching& each : result.matching) {
        const auto& column = (*input.weigh_in)[*each.part->column];
        shop::visit_column(visitor, *each.part->column, each.statistics, column.mass,
                           column.nominal);
    }
    visitor.numbers(key::crankpins, result.crankpins);
    if (result.placing) {
        visitor.object(shop::result_field::assignment, [&] {
            shop::visit_matched(visitor, *result.placing, input.weigh_in->matching.crank_radius,
                                service_speed(input));
            visitor.numbers(key::crankpins, result.placed_crankpins);
        });
    }
}

void visit_theory(ResultVisitor& visitor, const Input& input, const Result& result) {
    const FirstOrder& left = *result.first_order;
    visitor.number(key::reciprocating_percent, result.theory_factor);
    visitor.text(reason, factor_reason(input.engine));
    visitor.text(key::effect,
                 factor_effect(input.engine, result.factor + input.factor.overbalance));
    visitor.integer(key::cylinders, is_pair(input.engine) ? 2 : 1);
    visitor.number(key::forward, left.forward);
    visitor.number(key::backward, left.backward);
    visitor.number(key::upright, left.upright());
    visitor.number(key::across, left.across());
}

std::vector<Message> keys_of(const auto& parts, const auto& part_of) {
    std::vector<Message> keys;
    for (const auto& each : parts) {
        keys.emplace_back(part_of(each)->field.key);
    }
    return keys;
}

}  // namespace

void visit_results(ResultVisitor& visitor, const Input& input, const Result& result) {
    RAVNOVES_DEMAND(
        result.first_order && result.reciprocating && result.rotating && result.bob_weight,
        "what is written is the result of a whole input");
    if (visitor.wants(ravnoves::result_field::verdict.key)) {
        visit_verdict(visitor, verdict(input, result));
    }
    visitor.number(key::reciprocating, result.reciprocating);
    visitor.number(key::rotating, result.rotating);
    visitor.number(key::reciprocating_percent, result.factor);
    visitor.number(key::bob_weight, result.bob_weight);
    visitor.integer(key::bob_weights, input.engine.crankpins());
    shop::visit_lines(visitor, result.lines.size(), [&](std::size_t i) {
        const Line& line = result.lines[i];
        return shop::CardLine{line.part->field.key, line.factor, line.mass};
    });
    visitor.object(key::theory, [&] { visit_theory(visitor, input, result); });
    visitor.texts(key::not_given,
                  keys_of(result.not_given, [](const PartField* part) { return part; }));
    if (visitor.wants(key::not_counted.key)) {
        visitor.texts(key::not_counted, not_counted(input));
    }
    visitor.texts(key::looks_like_kilograms,
                  keys_of(result.in_kilograms, [](const auto& each) { return each.first; }));
    if (input.weigh_in) {
        visitor.object(shop::result_field::weigh_in,
                       [&] { visit_weigh_in(visitor, input, result); });
    }
    if (result.permissible) {
        visitor.numbers(key::permissible, {(*result.permissible)[0], (*result.permissible)[1]});
    }
    if (result.permissible_whole) {
        visitor.number(key::permissible_rotor, result.permissible_whole);
    }
    if (result.correction) {
        visitor.object(key::correction, [&] {
            visitor.list(key::planes, 2,
                         [&](std::size_t i) { visit_plane(visitor, (*result.correction)[i]); });
            visitor.list(key::runs, result.runs.size(), [&](std::size_t i) {
                visit_run(visitor, result.runs[i], i + 1 == result.runs.size());
            });
            visitor.number(key::amplification, result.amplification);
            shop::visit_other(visitor, result.newest()->read_with, result.newest()->read_on);
        });
    }
}

void visit_results(ResultVisitor& visitor, const Input& input) {
    visit_results(visitor, input, solve(input, visitor.wants(shop::result_field::weigh_in.key)));
}

Verdict verdict(const Input& input, const Result& result) {
    Verdict verdict{
        Severity::note,
        {input.engine.crankpins() == 1
             ? CORE_TEXT("bob-weights", "Hang a bob weight of %1 on the crankpin.")
             : CORE_TEXT("bob-weights", "Hang bob weights of %1 on the %2 crankpins."),
         Number{*result.bob_weight / units::gram, units::gram, -1}, input.engine.crankpins()}};
    if (result.correction && result.holds()) {
        const auto& planes = *result.correction;
        verdict = {Severity::good, {}};
        shop::add_machine_verdict(verdict, {planes[0].unbalance, planes[1].unbalance},
                                  result.permissible);
        if (result.newest()->passes() != true) {
            const auto after = result.passes_after();
            const Number left[] = {{planes[0].remaining / units::gram_mm, units::gram_mm, -1},
                                   {planes[1].remaining / units::gram_mm, units::gram_mm, -1}};
            const Message planned{
                CORE_TEXT("bob-weights", "After the planned correction: %1 front, %2 rear."),
                left[0], left[1]};
            verdict.severity = after == true ? Severity::warning : Severity::error;
            verdict.text =
                verdict.text.empty() ? planned : Message(Text{"", "%1 %2"}, verdict.text, planned);
        }
        if (!result.newest()->acted_as_meant()) {
            verdict.warn(CORE_TEXT("bob-weights",
                                   "The last drilling did not act as planned: find out why before "
                                   "drilling again."));
        }
    } else if (!result.holds()) {
        verdict.warn(shop::other_readings(result.newest()->read_with, result.newest()->read_on,
                                          result.bob_weight));
    }
    for (const auto& [part, mass] : result.in_kilograms) {
        verdict.warn({CORE_TEXT("bob-weights", "A mass of %1 looks like kilograms."),
                      Number{mass / units::gram, units::gram, 3}});
    }
    return verdict;
}

}  // namespace ravnoves::bob_weights

#include "workshop/solver.h"

#include <algorithm>

#include "bob-weights/matching.h"
#include "bob-weights/solver.h"
#include "v8-plugs/solver.h"

namespace ravnoves::workshop {

namespace {

/// What is hung on a crankpin by the plugs' method, as far as known.
void take_weight(const v8_plugs::Input& plugs, const v8_plugs::Result& result,
                 bob_weights::Result& shaft) {
    const v8_plugs::BobWeight* weight = result.hung_weight();
    if (weight == nullptr) {
        return;
    }
    const v8_plugs::MassChanges& changes = result.changes;
    shaft.reciprocating =
        plugs.engine.reciprocating_mass.value() + changes.piston + changes.repair_piston_and_rings;
    shaft.rotating =
        plugs.engine.rotating_mass.value() + changes.rod_big_end + 0.5 * changes.repair_bearing;
    shaft.bob_weight = weight->sum();
    for (const shop::WeightLine& line : weight->lines) {
        shaft.lines.push_back({line});
    }
}

}  // namespace

Result solve_undoubted(const Input& input, bool absent_is_zero, bool places_parts) {
    Result result;
    result.plugs_input = whole_plugs(input);
    const auto& plugs = result.plugs_input;
    bob_weights::OtherWeight other;
    if (plugs) {
        result.plugs = v8_plugs::solve(*plugs, absent_is_zero || plugs->changes_known());
        other = [&](const bob_weights::Input& job, bob_weights::Result& shaft) {
            take_weight(*plugs, *result.plugs, shaft);
            if (places_parts && result.plugs->weighed_excess && may_have_plugs(job.engine)) {
                place_parts(job,
                            v8_plugs::excess_factors(*plugs->weigh_in, *plugs->rod_coefficient()),
                            shaft);
            }
            if (!plugs->changes_from_weigh_in) {
                shaft.crankpins.clear();
                shaft.placed_crankpins.clear();
            }
        };
    }
    result.shaft = bob_weights::solve(input, places_parts, other);
    return result;
}

Result solve(const Input& given, bool absent_is_zero, bool places_parts) {
    const Input input = with_heavy_spots(given);
    Result result = solve_undoubted(input, absent_is_zero, places_parts);
    result.doubts = find_doubts(input, result);
    return result;
}

Input before_run(const Input& input, std::size_t runs) {
    Input then = input;
    bob_weights::Correction& correction = *then.correction;
    correction.readings =
        at_places_of(correction.readings, correction.earlier_runs.at(runs - 1).readings);
    correction.earlier_runs.resize(runs - 1);
    correction.record = {};
    return then;
}

Withheld Result::withheld() const {
    Withheld all;
    for (const Doubt& doubt : doubts) {
        all.bob_weight = all.bob_weight || doubt.rule->blocks.bob_weight;
        all.holes = all.holes || doubt.rule->blocks.holes;
        all.verdict = all.verdict || doubt.rule->blocks.verdict;
        all.limits = all.limits || doubt.rule->blocks.limits;
    }
    return all;
}

bool Result::is_provisional() const {
    return (shaft.bob_weight && !shaft.not_given.empty()) ||
           std::any_of(doubts.begin(), doubts.end(),
                       [](const Doubt& doubt) { return doubt.rule->is_provisional; });
}

Result allowed(Result result) {
    const Withheld withheld = result.withheld();
    bob_weights::Result& shaft = result.shaft;
    if (withheld.bob_weight) {
        shaft.lines.clear();
        shaft.bob_weight.reset();
        shaft.first_order.reset();
        shaft.crankpins.clear();
        shaft.placed_crankpins.clear();
    }
    if (withheld.bob_weight && result.plugs) {
        v8_plugs::Result& plugs = *result.plugs;
        plugs.options = {};
        plugs.advice.reset();
        plugs.nominal.reset();
        plugs.before.reset();
    }
    if (withheld.holes) {
        shaft.correction.reset();
    }
    // No verdict is beside a STOP, whatever that is for.
    if (withheld.any()) {
        for (bob_weights::RunResult& run : shaft.runs) {
            for (std::size_t i = 0; i < 2; ++i) {
                if (run.planes[i]) {
                    run.planes[i]->within_tolerance.reset();
                }
            }
        }
        for (std::size_t i = 0; shaft.correction && i < 2; ++i) {
            (*shaft.correction)[i].within_tolerance.reset();
        }
    }
    return result;
}

}  // namespace ravnoves::workshop

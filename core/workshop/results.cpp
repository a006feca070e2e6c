#include "workshop/results.h"

#include <algorithm>

#include "bob-weights/factor_theory.h"
#include "bob-weights/results.h"
#include "bob-weights/solver.h"
#include "shop/results.h"
#include "shop/sentences.h"
#include "v8-plugs/results.h"
#include "workshop/solver.h"

namespace ravnoves::workshop {

namespace {

namespace key {
constexpr ResultField planes[] = {{"front", Text::tr("Front plane")},
                                  {"rear", Text::tr("Rear plane")}};
constexpr ResultField permissible{"permissible_g_mm", Text::tr("Permissible"), 1};
}  // namespace key

std::vector<Message> words_of(const Withheld& blocks) {
    std::vector<Message> words;
    const std::pair<bool, const char*> all[] = {
        {blocks.bob_weight, "bobweight"}, {blocks.holes, "holes"}, {blocks.verdict, "verdict"}};
    for (const auto& [blocked, word] : all) {
        if (blocked) {
            words.emplace_back(word);
        }
    }
    return words;
}

/// Whatever is doubted.
Verdict undoubted(const Input& input, const Result& result) {
    Verdict verdict = bob_weights::verdict(input, result.shaft, input.machine.planes);
    if (result.plugs) {
        const Verdict plugs = v8_plugs::verdict_of_plugs(*result.plugs_input, *result.plugs);
        const bool fails = plugs.severity == Severity::error;
        verdict.text = shop::two_sentences(fails ? plugs.text : verdict.text,
                                           fails ? verdict.text : plugs.text);
        if (fails) {
            verdict.severity = Severity::error;
        }
    }
    return verdict;
}

/// Whether engine and parts are known.
bool is_known(const Input& input, const Result& result) {
    return result.plugs ? result.shaft.bob_weight && result.plugs->advice
                        : result.shaft.bob_weight || bob_weights::balances_itself(input.engine);
}

Verdict unwarned(const Input& input, const Result& result) {
    if (result.withheld().any()) {
        const Doubt& first = result.doubts.front();  // what blocks comes before warnings
        return {Severity::error, {Text::tr("STOP. %1"), first.text}, first.rule->act};
    }
    if (!is_known(input, result)) {
        return {Severity::note, Text::tr("Enter the missing values of engine and parts.")};
    }
    Verdict verdict = undoubted(input, result);
    if (result.is_provisional() && !bob_weights::balances_itself(input.engine)) {
        verdict.text = {Text::tr("Provisional. %1"), verdict.text};
        verdict.severity = std::max(verdict.severity, Severity::warning);
    }
    return verdict;
}

/// What is said beside an answer; nothing where there is none.
std::vector<const Doubt*> warnings(const Input& input, const Result& result) {
    std::vector<const Doubt*> list;
    for (const Doubt& doubt : result.doubts) {
        if (doubt.rule->severity == Severity::warning && !result.withheld().any() &&
            is_known(input, result)) {
            list.push_back(&doubt);
        }
    }
    return list;
}

/// Limits and readings in the planes, where a grade is shared between them.
void visit_balancing(ResultVisitor& visitor, const Input& input, const bob_weights::Result& shaft) {
    const auto& tolerance = input.tolerance;
    if (!shaft.permissible_whole || tolerance->centre_of_mass || tolerance->front_bearing) {
        return;
    }
    visitor.object({"balancing", Text::tr("Balancing machine")}, [&] {
        visitor.word({"limit"}, "iso-21940-11");
        const bob_weights::RunResult* newest =
            reads_in_planes(input) && shaft.newest() != nullptr && shaft.newest()->is_read()
                ? shaft.newest()
                : nullptr;
        for (std::size_t i = 0; i < 2; ++i) {
            visitor.object(key::planes[i], [&] {
                visitor.number(key::permissible, (*shaft.permissible)[i]);
                if (newest != nullptr && newest->planes[i]) {
                    visitor.number({"reading_g_mm", Text::tr("Reading"), 1},
                                   newest->planes[i]->unbalance);
                    visitor.flag({"passes", Text::tr("Passes")}, newest->within(i));
                }
            });
        }
        if (newest != nullptr) {
            shop::visit_other(visitor, newest->read_with, newest->read_on);
        }
        visitor.number(key::permissible, shaft.permissible_whole);
    });
}

}  // namespace

void visit_plugs(ResultVisitor& visitor, const Input& input, const Result& result) {
    v8_plugs::visit_plugs(visitor, *result.plugs_input, *result.plugs, result.shaft.placing,
                          service_speed(input));
    visit_balancing(visitor, input, result.shaft);
}

Verdict verdict(const Input& input, const Result& result) {
    Verdict verdict = unwarned(input, result);
    for (const Doubt* doubt : warnings(input, result)) {
        verdict.warn(doubt->text);
    }
    return verdict;
}

Verdict short_verdict(const Input& input, const Result& result) {
    Verdict verdict = unwarned(input, result);
    if (!warnings(input, result).empty()) {
        verdict.warn(Text::tr("See the warnings."));
    }
    return verdict;
}

void visit_results(ResultVisitor& visitor, const Input& input, const Result& result) {
    const Withheld withheld = result.withheld();
    visit_verdict(visitor, [&] { return verdict(input, result); });
    visitor.list({"doubts", Text::tr("Doubts")}, result.doubts.size(), [&](std::size_t i) {
        const DoubtRule& rule = *result.doubts[i].rule;
        visitor.word({"kind"}, rule.word);
        visitor.word(ravnoves::result_field::severity, severity_word(rule.severity));
        visitor.text(ravnoves::result_field::text, result.doubts[i].text);
        visitor.texts({"blocks"}, words_of(rule.blocks));
    });
    const auto visit_object = [&](const Result& shown) {
        if (shown.plugs) {
            visitor.object({"plugs", Text::tr("Plugs")},
                           [&] { visit_plugs(visitor, input, shown); });
        }
    };
    const Result shown = allowed(result);
    visit_job(visitor, input, shown.shaft);
    visit_object(shown);
    visitor.object_or_null({"doubtful", Text::tr("Doubtful")}, withheld.any(), [&] {
        visit_verdict(visitor, [&] { return undoubted(input, result); });
        if (withheld.bob_weight) {
            visit_bob_weight(visitor, input, result.shaft);
        }
        visit_planes(visitor, input, result.shaft);
        if (withheld.bob_weight) {
            visit_object(result);
        }
    });
}

void visit_results(ResultVisitor& visitor, const Input& input) {
    const bool places_parts =
        visitor.wants(shop::result_field::weigh_in.key) || visitor.wants("plugs/weigh_in");
    visit_results(visitor, input, solve(input, true, places_parts));
}

}  // namespace ravnoves::workshop

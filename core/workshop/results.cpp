#include "workshop/results.h"

#include <algorithm>

#include "bob-weights/factor_theory.h"
#include "bob-weights/results.h"
#include "shop/results.h"
#include "shop/sentences.h"
#include "v8-plugs/results.h"
#include "workshop/solver.h"

namespace ravnoves::workshop {

namespace {

namespace key {
constexpr ResultField plugs{.key = "plugs", .label = CORE_TEXT("workshop", "Plugs")};
constexpr ResultField doubts{.key = "doubts", .label = CORE_TEXT("workshop", "Doubts")};
constexpr ResultField kind{.key = "kind"};
constexpr ResultField blocks{.key = "blocks"};
constexpr ResultField doubtful{.key = "doubtful", .label = CORE_TEXT("workshop", "Doubtful")};
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
        const Verdict plugs = v8_plugs::verdict_of_plugs(*whole_plugs(input), *result.plugs);
        const bool fails = plugs.severity == Severity::error;
        verdict.text = shop::two_sentences(fails ? plugs.text : verdict.text,
                                           fails ? verdict.text : plugs.text);
        if (fails) {
            verdict.severity = Severity::error;
        }
    }
    return verdict;
}

}  // namespace

Verdict verdict(const Input& input, const Result& result) {
    const auto blocking = std::find_if(result.doubts.begin(), result.doubts.end(),
                                       [](const Doubt& each) { return each.rule->blocks.any(); });
    if (blocking != result.doubts.end()) {
        return {Severity::error,
                {CORE_TEXT("workshop", "STOP. %1"), blocking->text},
                blocking->rule->act};
    }
    const bool is_known =
        result.shaft.bob_weight || (!input.plugs && bob_weights::balances_itself(input.engine));
    if (!is_known || (result.plugs && !result.plugs->advice)) {
        return {Severity::note,
                CORE_TEXT("workshop", "Enter the missing values of engine and parts.")};
    }
    Verdict verdict = undoubted(input, result);
    for (const Doubt& doubt : result.doubts) {
        if (doubt.rule->severity == Severity::warning) {
            verdict.warn(doubt.text);
        }
    }
    return verdict;
}

void visit_results(ResultVisitor& visitor, const Input& input, const Result& result) {
    const Withheld withheld = result.withheld();
    if (visitor.wants(ravnoves::result_field::verdict.key)) {
        visit_verdict(visitor, verdict(input, result));
    }
    visitor.list(key::doubts, result.doubts.size(), [&](std::size_t i) {
        const DoubtRule& rule = *result.doubts[i].rule;
        visitor.word(key::kind, rule.word);
        visitor.word(ravnoves::result_field::severity, severity_word(rule.severity));
        visitor.text(ravnoves::result_field::text, result.doubts[i].text);
        visitor.texts(key::blocks, words_of(rule.blocks));
    });
    const auto plugs_input = whole_plugs(input);
    const auto visit_plugs = [&](const Result& shown) {
        if (shown.plugs) {
            visitor.object(key::plugs,
                           [&] { v8_plugs::visit_plugs(visitor, *plugs_input, *shown.plugs); });
        }
    };
    const Result shown = allowed(result);
    visit_job(visitor, input, shown.shaft);
    visit_plugs(shown);
    visitor.object_or_null(key::doubtful, withheld.any(), [&] {
        visit_verdict(visitor, undoubted(input, result));
        if (withheld.bob_weight) {
            visit_bob_weight(visitor, input, result.shaft);
        }
        visit_planes(visitor, input, result.shaft);
        if (withheld.bob_weight) {
            visit_plugs(result);
        }
    });
}

void visit_results(ResultVisitor& visitor, const Input& input) {
    const bool places_parts =
        visitor.wants(shop::result_field::weigh_in.key) || visitor.wants("plugs/weigh_in");
    visit_results(visitor, input, solve(input, true, places_parts));
}

}  // namespace ravnoves::workshop

#include "workshop/results.h"

#include <algorithm>

#include "shop/results.h"
#include "v8-plugs/results.h"
#include "workshop/solver.h"

namespace ravnoves::workshop {

namespace {

using bob_weights::Withheld;

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

/// Without what the doubts block.
void visit_undoubted(ResultVisitor& visitor, const Input& input, v8_plugs::Result plugs,
                     const Withheld& withheld) {
    if (withheld.verdict) {
        for (v8_plugs::PlaneVerdict& plane : plugs.planes) {
            plane.passes.reset();
        }
    }
    v8_plugs::visit_plugs(visitor, *whole_plugs(input), plugs, withheld.bob_weight);
}

/// Whatever is doubted.
Verdict undoubted(const Input& input, const Result& result) {
    Verdict verdict = bob_weights::verdict(input, result.shaft, input.machine.planes);
    if (result.plugs) {
        const Verdict plugs = v8_plugs::verdict_of_plugs(*whole_plugs(input), *result.plugs);
        const bool fails = plugs.severity == Severity::error;
        verdict.text = {Text{"", "%1 %2"}, fails ? plugs.text : verdict.text,
                        fails ? verdict.text : plugs.text};
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
    if (!result.shaft.bob_weight || (result.plugs && !result.plugs->advice)) {
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
    visit_job(visitor, input, result.shaft, withheld);
    if (result.plugs) {
        visitor.object(key::plugs,
                       [&] { visit_undoubted(visitor, input, *result.plugs, withheld); });
    }
    visitor.object_or_null(key::doubtful, withheld.any(), [&] {
        if (withheld.verdict) {
            visit_verdict(visitor, undoubted(input, result));
        }
        visit_withheld(visitor, input, result.shaft, withheld);
        if (result.plugs && withheld.bob_weight) {
            visitor.object(key::plugs, [&] {
                v8_plugs::visit_plugs(visitor, *whole_plugs(input), *result.plugs);
            });
        }
    });
}

void visit_results(ResultVisitor& visitor, const Input& input) {
    const bool places_parts =
        visitor.wants(shop::result_field::weigh_in.key) || visitor.wants("plugs/weigh_in");
    visit_results(visitor, input, solve(input, true, places_parts));
}

}  // namespace ravnoves::workshop

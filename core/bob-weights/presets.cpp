#include "bob-weights/presets.h"

#include <utility>

namespace ravnoves::bob_weights {

std::vector<Preset<Input>> presets() {
    static constexpr std::pair<Text, Engine> engines[] = {
        {CORE_TEXT("bob-weights", "V-6, 90°, even firing (crankpins split by 30°)"),
         {EngineType::v, 6, 90 * degree, 2, 30 * degree}},
        {CORE_TEXT("bob-weights", "V-6, 60°, even firing (crankpins split by 60°)"),
         {EngineType::v, 6, 60 * degree, 2, 60 * degree}},
        {CORE_TEXT("bob-weights", "V-6, 90°, odd firing"), {EngineType::v, 6, 90 * degree, 2, 0.0}},
        {CORE_TEXT("bob-weights", "V-10, 72°"), {EngineType::v, 10, 72 * degree, 2, 0.0}},
        {CORE_TEXT("bob-weights", "V-12, 60°"), {EngineType::v, 12, 60 * degree, 2, 0.0}},
        {CORE_TEXT("bob-weights", "V-twin, 45°"), {EngineType::v, 2, 45 * degree, 2, 0.0}},
        {CORE_TEXT("bob-weights", "Flat twin, a crankpin for each rod"),
         {EngineType::boxer, 2, std::nullopt, 1, 0.0}},
        {CORE_TEXT("bob-weights", "Four in line"), {EngineType::in_line, 4, std::nullopt, 1, 0.0}},
        {CORE_TEXT("bob-weights", "One cylinder"), {EngineType::in_line, 1, std::nullopt, 1, 0.0}}};
    std::vector<Preset<Input>> list;
    for (const auto& [name, engine] : engines) {
        Input input;
        input.engine = engine;
        list.push_back({name, std::move(input)});
    }
    return list;
}

}  // namespace ravnoves::bob_weights

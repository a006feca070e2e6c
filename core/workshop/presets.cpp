#include "workshop/presets.h"

#include <string>
#include <utility>

#include "v8-plugs/presets.h"

namespace ravnoves::workshop {

std::vector<Preset<Input>> presets() {
    std::vector<Preset<Input>> list;
    for (const v8_plugs::Engine& engine : v8_plugs::engine_presets()) {
        Input input;
        input.engine.bank_angle = 90.0 * degree;
        v8_plugs::Input& plugs = input.plugs.emplace();
        plugs.preset = engine.name;
        plugs.engine = engine;
        if (const auto printed = v8_plugs::printed_plug(engine.name);
            printed != v8_plugs::PlugSheet{}) {
            plugs.plug = printed;
        }
        const double litres = std::stod(engine.name);
        list.push_back({{Text::tr("V-8 of %1 litres"), litres}, std::move(input)});
    }
    static constexpr std::pair<Text, bob_weights::Engine> engines[] = {
        {Text::tr("V-6, 90°, even firing (crankpins split by 30°)"),
         {bob_weights::EngineType::v, 6, 90 * degree, 2, 30 * degree}},
        {Text::tr("V-6, 60°, even firing (crankpins split by 60°)"),
         {bob_weights::EngineType::v, 6, 60 * degree, 2, 60 * degree}},
        {Text::tr("V-6, 90°, odd firing"), {bob_weights::EngineType::v, 6, 90 * degree, 2, 0.0}},
        {Text::tr("V-10, 72°"), {bob_weights::EngineType::v, 10, 72 * degree, 2, 0.0}},
        {Text::tr("V-12, 60°"), {bob_weights::EngineType::v, 12, 60 * degree, 2, 0.0}},
        {Text::tr("V-twin, 45°"), {bob_weights::EngineType::v, 2, 45 * degree, 2, 0.0}},
        {Text::tr("Flat twin, a crankpin for each rod"),
         {bob_weights::EngineType::boxer, 2, std::nullopt, 1, 0.0}},
        {Text::tr("Four in line"), {bob_weights::EngineType::in_line, 4, std::nullopt, 1, 0.0}},
        {Text::tr("Six in line"), {bob_weights::EngineType::in_line, 6, std::nullopt, 1, 0.0}},
        {Text::tr("One cylinder"), {bob_weights::EngineType::in_line, 1, std::nullopt, 1, 0.0}}};
    for (const auto& [name, engine] : engines) {
        Input input;
        input.engine = engine;
        list.push_back({name, std::move(input)});
    }
    return list;
}

}  // namespace ravnoves::workshop

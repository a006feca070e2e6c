#include "v8-plugs/presets.h"

#include <string>
#include <utility>
#include <vector>

namespace ravnoves::v8_plugs {

using units::mm;

std::span<const Engine> engine_presets() {
    static const std::vector<Engine> presets = [] {
        // Tables 1 to 3, the values in the order of engine_fields(): both columns, the right one
        // of two engines with the same crankshaft; of the others the text gives the crank radius.
        const std::vector<double> left{40,   47.2,  49.3,  2.79,  0.954,
                                       3.45, 1.179, 1.951, 0.684, 0.445};
        const std::vector<double> right{47.5, 61.5,  63.2,  4.03,  1.377,
                                        5.25, 1.794, 2.746, 1.013, 0.414};
        const std::pair<const char*, std::vector<double>> printed[] = {
            {"4.25 l", left},   {"6 l", right},    {"7 l", right},   {"8.32 l", {60}},
            {"8.74 l", {57.5}}, {"10.85 l", {60}}, {"14.86 l", {70}}};
        std::vector<Engine> list;
        for (const auto& [name, values] : printed) {
            Engine& engine = list.emplace_back();
            engine.name = name;
            for (std::size_t i = 0; i < values.size(); ++i) {
                const EngineField& each = engine_fields()[i];
                engine.*each.member = values[i] * each.field.unit;
            }
        }
        return list;
    }();
    return presets;
}

const Engine* find_preset(std::string_view name) {
    for (const Engine& engine : engine_presets()) {
        const std::string_view full = engine.name;
        if (name == full || name == full.substr(0, full.size() - 2)) {
            return &engine;
        }
    }
    return nullptr;
}

PlugSheet printed_plug(std::string_view preset) {
    PlugSheet sheet;
    if (preset == "4.25 l") {
        sheet.thread = Thread{22 * mm, 1.5 * mm};
        sheet.height = 14 * mm;
    } else if (preset == "6 l" || preset == "7 l") {
        sheet.thread = Thread{30 * mm, 1.5 * mm};
        sheet.height = 11 * mm;
    }
    return sheet;
}

bool is_printed(const Input& input, std::optional<double> Engine::*plug_mass) {
    const Engine* preset = find_preset(input.preset);
    if (preset == nullptr || !input.plug) {
        return false;
    }
    const PlugSheet printed = printed_plug(preset->name);
    return input.engine.*plug_mass == preset->*plug_mass && input.plug->thread == printed.thread &&
           input.plug->height == printed.height && !input.plug->bore_diameter &&
           !input.plug->bore_depth;
}

}  // namespace ravnoves::v8_plugs

#include "v8-plugs/presets.h"

#include <array>
#include <utility>

namespace ravnoves::v8_plugs {

namespace {

using units::gram;
using units::mm;

Engine paper_engine(std::string name) {
    Engine engine;
    engine.name = std::move(name);
    return engine;
}

/// Table 2 and Table 3, left columns.
Engine engine_4_25() {
    Engine engine = paper_engine("4.25 l");
    engine.crank_radius = 40 * mm;
    engine.plug_radius = 47.2 * mm;
    engine.new_plug_radius = 49.3 * mm;
    engine.steel_plug_mass = 2.79 * gram;
    engine.aluminium_plug_mass = 0.954 * gram;
    engine.new_steel_plug_mass = 3.45 * gram;
    engine.new_aluminium_plug_mass = 1.179 * gram;
    engine.max_steel_reduction = 1.951 * gram;
    engine.max_aluminium_reduction = 0.684 * gram;
    engine.rod_coefficient = 0.445;
    return engine;
}

/// Table 1, Table 2 and Table 3, right columns: the 6 and 7 l engines share the crankshaft.
Engine engine_6_7(std::string name) {
    Engine engine = paper_engine(std::move(name));
    engine.crank_radius = 47.5 * mm;
    engine.plug_radius = 61.5 * mm;
    engine.new_plug_radius = 63.2 * mm;
    engine.steel_plug_mass = 4.03 * gram;
    engine.aluminium_plug_mass = 1.377 * gram;
    engine.new_steel_plug_mass = 5.25 * gram;
    engine.new_aluminium_plug_mass = 1.794 * gram;
    engine.max_steel_reduction = 2.746 * gram;
    engine.max_aluminium_reduction = 1.013 * gram;
    engine.rod_coefficient = 0.414;
    return engine;
}

/// The engines of which the text gives the crank radius alone.
Engine engine_with_radius(std::string name, double crank_radius_mm) {
    Engine engine = paper_engine(std::move(name));
    engine.crank_radius = crank_radius_mm * mm;
    return engine;
}

}  // namespace

std::span<const Engine> engine_presets() {
    static const std::array<Engine, 7> presets{
        engine_4_25(),
        engine_6_7("6 l"),
        engine_6_7("7 l"),
        engine_with_radius("8.32 l", 60),
        engine_with_radius("8.74 l", 57.5),
        engine_with_radius("10.85 l", 60),
        engine_with_radius("14.86 l", 70),
    };
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

#include "v8-plugs/engine.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "numerics/demand.h"

namespace ravnoves::v8_plugs {

namespace {

constexpr double milli = 1e-3;  // mm to m, g to kg

constexpr Range length_range = Range::between(1, 2000);
constexpr Range plug_mass_range = Range::between(0.001, 10'000);
constexpr Range reduction_range = Range::between(0, 10'000);
constexpr Range coefficient_range = Range::between(0, 100);
constexpr Range oil_range = Range::between(0, 100'000);
constexpr Range gear_mass_range = Range::between(0.001, 1'000'000);

constexpr std::array<EngineField, 14> fields{{
    {{"crank_radius_mm", "mm", length_range, milli}, &Engine::crank_radius, EngineGroup::basic},
    {{"plug_radius_mm", "mm", length_range, milli}, &Engine::plug_radius, EngineGroup::basic},
    {{"new_plug_radius_mm", "mm", length_range, milli},
     &Engine::new_plug_radius,
     EngineGroup::new_plug},
    {{"steel_plug_mass_g", "g", plug_mass_range, milli},
     &Engine::steel_plug_mass,
     EngineGroup::basic},
    {{"aluminium_plug_mass_g", "g", plug_mass_range, milli},
     &Engine::aluminium_plug_mass,
     EngineGroup::aluminium_plug},
    {{"new_steel_plug_mass_g", "g", plug_mass_range, milli},
     &Engine::new_steel_plug_mass,
     EngineGroup::new_plug},
    {{"new_aluminium_plug_mass_g", "g", plug_mass_range, milli},
     &Engine::new_aluminium_plug_mass,
     EngineGroup::new_plug},
    {{"max_steel_reduction_g", "g", reduction_range, milli},
     &Engine::max_steel_reduction,
     EngineGroup::basic},
    {{"max_aluminium_reduction_g", "g", reduction_range, milli},
     &Engine::max_aluminium_reduction,
     EngineGroup::aluminium_plug},
    {{"rod_coefficient", "", coefficient_range, 1.0}, &Engine::rod_coefficient, EngineGroup::basic},
    {{"oil_mass_g", "g", oil_range, milli}, &Engine::oil_mass, EngineGroup::bob_weight},
    {{"oil_coefficient", "", coefficient_range, 1.0},
     &Engine::oil_coefficient,
     EngineGroup::bob_weight},
    {{"reciprocating_mass_g", "g", gear_mass_range, milli},
     &Engine::reciprocating_mass,
     EngineGroup::bob_weight},
    {{"rotating_mass_g", "g", gear_mass_range, milli},
     &Engine::rotating_mass,
     EngineGroup::bob_weight},
}};

}  // namespace

std::span<const EngineField> engine_fields() {
    return fields;
}

const EngineField& engine_field(std::string_view key) {
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const EngineField& field) {
        return field.spec.key == key;
    });
    RAVNOVES_DEMAND(found != fields.end(), "the engine has a field of that key");
    return *found;
}

bool is_inapplicable(const Engine& engine, EngineGroup group) {
    return (group == EngineGroup::aluminium_plug && !engine.has_aluminium_plug) ||
           (group == EngineGroup::new_plug && !engine.has_new_plug);
}

std::vector<const EngineField*> missing_fields(const Engine& engine, bool with_bob_weight) {
    std::vector<const EngineField*> missing;
    for (const EngineField& field : fields) {
        if ((engine.*field.member).has_value() || is_inapplicable(engine, field.group) ||
            (field.group == EngineGroup::bob_weight && !with_bob_weight)) {
            continue;
        }
        missing.push_back(&field);
    }
    return missing;
}

std::vector<EngineConflict> engine_conflicts(const Engine& engine) {
    std::vector<EngineConflict> conflicts;
    const auto check = [&](std::string_view key, const std::optional<double>& reduction,
                           const std::optional<double>& mass) {
        if (reduction && mass && *reduction >= *mass) {
            const FieldSpec& spec = engine_field(key).spec;
            conflicts.push_back(
                {key, "must be less than the plug's mass " + format_number(in_unit(*mass, spec)),
                 in_unit(*reduction, spec)});
        }
    };
    check("max_steel_reduction_g", engine.max_steel_reduction, engine.steel_plug_mass);
    if (engine.has_aluminium_plug) {
        check("max_aluminium_reduction_g", engine.max_aluminium_reduction,
              engine.aluminium_plug_mass);
    }
    return conflicts;
}

double in_unit(double si, const FieldSpec& spec) {
    std::array<char, 40> text{};
    const int length = std::snprintf(text.data(), text.size(), "%.15g", si / spec.to_si);
    // The text has the separator of the C locale in force, so strtod reads what snprintf wrote.
    return length > 0 ? std::strtod(text.data(), nullptr) : si / spec.to_si;
}

}  // namespace ravnoves::v8_plugs

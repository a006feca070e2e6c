#include "v8-plugs/engine.h"

namespace ravnoves::v8_plugs {

namespace {

constexpr Range length_range = Range::between(1, 2000);
constexpr Range plug_mass_range = Range::between(0.001, 10'000);
constexpr Range reduction_range = Range::between(0, 10'000);
constexpr Range coefficient_range = Range::between(0, 100);
constexpr Range oil_range = Range::between(0, 100'000);
constexpr Range gear_mass_range = Range::between(0.001, 1'000'000);

constexpr Field described(std::string_view key, Unit unit, Range range, Text label, Text hint) {
    return {.key = key,
            .unit = unit,
            .range = range,
            .label = label,
            .hint = hint,
            .placeholder = Text::tr("required")};
}

constexpr std::array<EngineField, 14> fields{{
    {described("crank_radius_mm", units::mm, length_range, Text::tr("Crank radius r"),
               Text::tr("Half the stroke.")),
     &Engine::crank_radius, EngineGroup::basic},
    {described("plug_radius_mm", units::mm, length_range, Text::tr("Plug radius rₚ"),
               Text::tr("From the crank axis to the centre of mass of the present plug.")),
     &Engine::plug_radius, EngineGroup::basic},
    {described("new_plug_radius_mm", units::mm, length_range, Text::tr("New plug radius rₚₙ"),
               Text::tr("From the crank axis to the centre of mass of a plug of the new design.")),
     &Engine::new_plug_radius, EngineGroup::new_plug},
    {described("steel_plug_mass_g", units::gram, plug_mass_range, Text::tr("One steel plug mₚ"),
               Text::tr("Mass of one plug by the scale, before machining.")),
     &Engine::steel_plug_mass, EngineGroup::basic},
    {described("aluminium_plug_mass_g", units::gram, plug_mass_range,
               Text::tr("One aluminium plug mₐ"),
               Text::tr("Mass of one plug by the scale, before machining.")),
     &Engine::aluminium_plug_mass, EngineGroup::aluminium_plug},
    {described(
         "new_steel_plug_mass_g", units::gram, plug_mass_range, Text::tr("One new steel plug mₚₙ"),
         Text::tr("Mass of one plug of the new design, for which the counterweights are made.")),
     &Engine::new_steel_plug_mass, EngineGroup::new_plug},
    {described(
         "new_aluminium_plug_mass_g", units::gram, plug_mass_range,
         Text::tr("One new aluminium plug mₐₙ"),
         Text::tr("Mass of one plug of the new design, for which the counterweights are made.")),
     &Engine::new_aluminium_plug_mass, EngineGroup::new_plug},
    {described("max_steel_reduction_g", units::gram, reduction_range,
               Text::tr("Max. off one steel plug Δmₚₘ"),
               Text::tr("Maximum to take off one plug, by the strength of its walls.")),
     &Engine::max_steel_reduction, EngineGroup::basic},
    {described("max_aluminium_reduction_g", units::gram, reduction_range,
               Text::tr("Max. off one aluminium plug Δmₐₘ"),
               Text::tr("Maximum to take off one plug, by the strength of its walls.")),
     &Engine::max_aluminium_reduction, EngineGroup::aluminium_plug},
    {described(
         "rod_coefficient", units::none, coefficient_range, Text::tr("Rod coefficient kᵣ"),
         Text::tr("A heavier big end has the factor (2 + k), unless the small ends are weighed.")),
     &Engine::rod_coefficient, EngineGroup::basic},
    {described("oil_mass_g", units::gram, oil_range, Text::tr("Oil of one crankpin mₘ"),
               Text::tr("Oil in the sludge trap of one crankpin of a running engine.")),
     &Engine::oil_mass, EngineGroup::bob_weight},
    {described("oil_coefficient", units::none, coefficient_range, Text::tr("Oil coefficient kₘ"),
               Text::tr("Factor of the oil mass in the bob weight; 1 if its centre is on the "
                        "crankpin's axis.")),
     &Engine::oil_coefficient, EngineGroup::bob_weight},
    {described("reciprocating_mass_g", units::gram, gear_mass_range,
               Text::tr("Reciprocating, one cylinder mⱼ"),
               Text::tr("Nominal mass of piston, pin, rings and the small-end share of the rod, "
                        "one cylinder.")),
     &Engine::reciprocating_mass, EngineGroup::bob_weight},
    {described("rotating_mass_g", units::gram, gear_mass_range, Text::tr("Rotating, one cylinder"),
               Text::tr("Nominal mass of the rod's big end and its shells, one cylinder.")),
     &Engine::rotating_mass, EngineGroup::bob_weight},
}};

}  // namespace

std::span<const EngineField> engine_fields() {
    return fields;
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

bool has_plug_data(const Engine& engine) {
    return missing_fields(engine, false).empty() && engine_conflicts(engine).empty();
}

bool has_nominal_masses(const Engine& engine) {
    return engine.reciprocating_mass && engine.rotating_mass && engine.oil_mass &&
           engine.oil_coefficient;
}

void set_plugs(Engine& engine, EngineGroup group, bool present) {
    (group == EngineGroup::aluminium_plug ? engine.has_aluminium_plug : engine.has_new_plug) =
        present;
    for (const EngineField& field : fields) {
        if (!present && field.group == group) {
            (engine.*field.member).reset();
        }
    }
}

std::vector<EngineConflict> engine_conflicts(const Engine& engine) {
    std::vector<EngineConflict> conflicts;
    for (const EngineField& field : fields) {
        const auto mass = field.member == &Engine::max_steel_reduction ? engine.steel_plug_mass
                          : field.member == &Engine::max_aluminium_reduction
                              ? engine.aluminium_plug_mass
                              : std::nullopt;
        if (mass && !is_inapplicable(engine, field.group) &&
            engine.*field.member >= mass) {  // nothing is less than any mass
            conflicts.push_back({&field, *mass});
        }
    }
    return conflicts;
}

}  // namespace ravnoves::v8_plugs

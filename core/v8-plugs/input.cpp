#include "v8-plugs/input.h"

#include <array>

namespace ravnoves::v8_plugs {

namespace {

constexpr Field change(std::string_view key, Text label, Text hint) {
    return {.key = key,
            .unit = units::gram,
            .range = Range::between(-100'000, 100'000),
            .label = label,
            .hint = hint,
            .placeholder = {"", "?"}};
}

constexpr std::array<MassChangeField, 4> change_fields{{
    {change("piston", CORE_TEXT("V8", "Improved piston Δmₚᵢ"),
            CORE_TEXT("V8", "Δmₚᵢ: one piston against nominal.")),
     &MassChanges::piston, false},
    {change("rod_big_end", CORE_TEXT("V8", "Rod big end"),
            CORE_TEXT("V8", "One big end against nominal.")),
     &MassChanges::rod_big_end, false},
    {change("repair_piston_and_rings", CORE_TEXT("V8", "Repair piston and rings Δmᵣₚ"),
            CORE_TEXT("V8", "Δmᵣₚ: one repair piston with its rings against nominal.")),
     &MassChanges::repair_piston_and_rings, true},
    {change("repair_bearing", CORE_TEXT("V8", "Repair shells Δmₛₕ"),
            CORE_TEXT("V8", "Δmₛₕ: the repair shells of one crankpin against nominal.")),
     &MassChanges::repair_bearing, true},
}};

}  // namespace

std::span<const MassChangeField> mass_change_fields() {
    return change_fields;
}

std::optional<PlugGeometry> PlugSheet::geometry() const {
    if (!thread || !height) {
        return std::nullopt;
    }
    PlugGeometry plug{*thread, *height};
    if (bore_diameter && bore_depth) {
        plug.bore_diameter = *bore_diameter;
        plug.bore_depth = *bore_depth;
    }
    return plug;
}

std::optional<BoreLimits> PlugSheet::limits() const {
    if (!cutter_diameter) {
        return std::nullopt;
    }
    return BoreLimits{*cutter_diameter, minimum_wall.value_or(0.0), minimum_bottom.value_or(0.0)};
}

std::optional<BalancingCheck> BalancingSheet::check() const {
    if (!grade || !rotor_mass || !service_speed) {
        return std::nullopt;
    }
    return BalancingCheck{*grade,      *rotor_mass,   *service_speed,
                          front_share, front_reading, rear_reading};
}

MassChanges Input::changes() const {
    return changes_from_weigh_in && weigh_in ? mass_changes(*weigh_in, process, typed_changes)
                                             : typed_changes;
}

bool Input::takes_typed(double MassChanges::*change) const {
    return !changes_from_weigh_in || !weigh_in || !is_weighed(*weigh_in, process, change);
}

}  // namespace ravnoves::v8_plugs

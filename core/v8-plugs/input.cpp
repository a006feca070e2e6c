#include "v8-plugs/input.h"

#include <array>

namespace ravnoves::v8_plugs {

namespace {

constexpr Range mass_change_range = Range::between(-100'000, 100'000);

constexpr std::array<MassChangeField, 4> change_fields{{
    {{"piston", "g", mass_change_range, 1e-3}, &MassChanges::piston, false},
    {{"rod_big_end", "g", mass_change_range, 1e-3}, &MassChanges::rod_big_end, false},
    {{"repair_piston_and_rings", "g", mass_change_range, 1e-3},
     &MassChanges::repair_piston_and_rings,
     true},
    {{"repair_bearing", "g", mass_change_range, 1e-3}, &MassChanges::repair_bearing, true},
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
    return changes_from_weigh_in && weigh_in ? mass_changes(*weigh_in, process) : typed_changes;
}

}  // namespace ravnoves::v8_plugs

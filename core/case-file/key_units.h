#pragma once

#include <cstddef>
#include <string_view>

#include "numerics/units.h"

namespace ravnoves {

/// What a key of a case file or a result says of its unit.
struct KeyUnit {
    Unit unit = units::none;
    std::size_t length = 0;  ///< characters at the key's end that say it
};

/// Of "shaft_angle_deg" degrees, said by four characters.
constexpr KeyUnit unit_of_key(std::string_view key) {
    struct Suffix {
        std::string_view text;
        Unit unit;
    };
    // The longer ones first.
    constexpr Suffix suffixes[]{
        {"_m_s2", units::m_per_s2},   {"_g_mm2", units::gram_mm2},  {"_N_m", units::N_per_m},
        {"_Nm", units::N_m},          {"_g_mm", units::gram_mm},    {"_kg_m2", units::kg_m2},
        {"_kg_m3", units::kg_m3},     {"_kg_m", units::kg_m},       {"_mm_s", units::mm_per_s},
        {"_rad_s", units::rad_per_s}, {"_kg", units::kg},           {"_mm", units::mm},
        {"_deg", units::degree},      {"_rad", units::radian},      {"_rpm", units::rpm},
        {"_bar", units::bar},         {"_MPa", units::MPa},         {"_GPa", units::GPa},
        {"_cm2", units::cm2},         {"_cm3", units::cm3},         {"_um", units::micrometre},
        {"_kW", units::kW},           {"_g", units::gram},          {"_N", units::newton},
        {"_J", units::joule},         {"_percent", units::percent}, {"_m", units::metre},
        {"_s", units::second}};
    for (const auto& [suffix, unit] : suffixes) {
        const bool is_symbol = key.size() == suffix.size() + 1 && unit == units::second;  // M_s
        if (key.size() > suffix.size() && !is_symbol && key.ends_with(suffix)) {
            return {unit, suffix.size()};
        }
    }
    return {};
}

/// The unit of the number at a pointer: an element of a list has the unit of the list's key.
inline Unit unit_at(std::string_view pointer) {
    constexpr std::string_view digits = "0123456789";
    std::string_view key = pointer.substr(pointer.rfind('/') + 1);
    while (!key.empty() && key.size() < pointer.size() &&
           key.find_first_not_of(digits) == std::string_view::npos) {
        pointer.remove_suffix(key.size() + 1);
        key = pointer.substr(pointer.rfind('/') + 1);
    }
    return unit_of_key(key).unit;
}

}  // namespace ravnoves

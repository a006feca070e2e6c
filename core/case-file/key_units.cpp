#include "case-file/key_units.h"

#include <algorithm>

namespace ravnoves {

namespace {

struct Suffix {
    std::string_view text;
    const Unit& unit;
};
/// The longer ones first.
constexpr Suffix suffixes[]{
    {"_N_m", units::N_per_m},   {"_Nm", units::N_m},          {"_g_mm", units::gram_mm},
    {"_kg_m2", units::kg_m2},   {"_kg_m3", units::kg_m3},     {"_kg_m", units::kg_m},
    {"_mm_s", units::mm_per_s}, {"_rad_s", units::rad_per_s}, {"_kg", units::kg},
    {"_mm", units::mm},         {"_deg", units::degree},      {"_rad", units::radian},
    {"_rpm", units::rpm},       {"_bar", units::bar},         {"_MPa", units::MPa},
    {"_GPa", units::GPa},       {"_cm2", units::cm2},         {"_um", units::micrometre},
    {"_kW", units::kW},         {"_g", units::gram},          {"_N", units::newton},
    {"_J", units::joule},       {"_percent", units::percent}, {"_m", units::metre},
    {"_s", units::second}};

}  // namespace

KeyUnit unit_of_key(std::string_view key) {
    for (const auto& [suffix, unit] : suffixes) {
        const bool is_symbol = key.size() == suffix.size() + 1 && unit == units::second;  // M_s
        if (key.size() > suffix.size() && !is_symbol && key.ends_with(suffix)) {
            return {unit, suffix.size()};
        }
    }
    return {};
}

Unit unit_at(std::string_view pointer) {
    const auto is_number = [](std::string_view key) {
        return !key.empty() &&
               std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    for (std::size_t slash = pointer.rfind('/'); slash != std::string_view::npos;
         slash = pointer.rfind('/')) {
        const std::string_view key = pointer.substr(slash + 1);
        if (!is_number(key)) {
            return unit_of_key(key).unit;
        }
        pointer = pointer.substr(0, slash);
    }
    return units::none;
}

}  // namespace ravnoves

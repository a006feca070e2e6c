#pragma once

#include <string_view>

#include "numerics/constants.h"

namespace ravnoves {

/// A unit as case files, forms and messages use it: `3 * units::mm` is 3 mm in SI, and
/// `length / units::mm` is the number of millimetres.
struct Unit {
    std::string_view name;  ///< as the user sees it; empty for pure numbers
    double to_si = 1.0;     ///< SI value of one such unit

    bool operator==(const Unit&) const = default;
};

constexpr double operator*(double number, const Unit& unit) {
    return number * unit.to_si;
}
constexpr double operator/(double si, const Unit& unit) {
    return si / unit.to_si;
}

/// The one place for units: every conversion of the project is one of these.
namespace units {
inline constexpr Unit none{"", 1.0};
inline constexpr Unit metre{"m", 1.0};
inline constexpr Unit mm{"mm", 1e-3};
inline constexpr Unit micrometre{"µm", 1e-6};
inline constexpr Unit cm3{"cm³", 1e-6};
inline constexpr Unit kg{"kg", 1.0};
inline constexpr Unit gram{"g", 1e-3};
inline constexpr Unit kg_m{"kg·m", 1.0};
inline constexpr Unit gram_mm{"g·mm", 1e-6};
inline constexpr Unit kg_m2{"kg·m²", 1.0};
inline constexpr Unit kg_m3{"kg/m³", 1.0};
inline constexpr Unit newton{"N", 1.0};
inline constexpr Unit kN{"kN", 1e3};
inline constexpr Unit N_m{"N·m", 1.0};
inline constexpr Unit N_per_m{"N/m", 1.0};
inline constexpr Unit kN_per_m{"kN/m", 1e3};
inline constexpr Unit joule{"J", 1.0};
inline constexpr Unit kW{"kW", 1e3};
inline constexpr Unit pascal{"Pa", 1.0};
inline constexpr Unit kPa{"kPa", 1e3};
inline constexpr Unit bar{"bar", 1e5};
inline constexpr Unit MPa{"MPa", 1e6};
inline constexpr Unit GPa{"GPa", 1e9};
inline constexpr Unit second{"s", 1.0};
inline constexpr Unit mm_per_s{"mm/s", 1e-3};
inline constexpr Unit m_per_s2{"m/s²", 1.0};
inline constexpr Unit radian{"rad", 1.0};
inline constexpr Unit degree{"°", ravnoves::degree};
inline constexpr Unit rad_per_s{"rad/s", 1.0};
inline constexpr Unit rpm{"min⁻¹", ravnoves::rpm};
inline constexpr Unit percent{"%", 1e-2};
}  // namespace units

}  // namespace ravnoves

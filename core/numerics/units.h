#pragma once

#include <string_view>

#include "numerics/constants.h"
#include "numerics/text.h"

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

/// The one place for units: every conversion of the project is one of these. A language may write
/// the marked ones with letters of its own.
namespace units {
inline constexpr Unit none{"", 1.0};
inline constexpr Unit metre{CORE_TEXT("core", "m").english, 1.0};
inline constexpr Unit mm{CORE_TEXT("core", "mm").english, 1e-3};
inline constexpr Unit micrometre{CORE_TEXT("core", "µm").english, 1e-6};
inline constexpr Unit litre{CORE_TEXT("core", "l").english, 1e-3};
inline constexpr Unit cm2{CORE_TEXT("core", "cm²").english, 1e-4};
inline constexpr Unit cm3{CORE_TEXT("core", "cm³").english, 1e-6};
inline constexpr Unit kg{CORE_TEXT("core", "kg").english, 1.0};
inline constexpr Unit gram{CORE_TEXT("core", "g").english, 1e-3};
inline constexpr Unit kg_m{CORE_TEXT("core", "kg·m").english, 1.0};
inline constexpr Unit gram_mm{CORE_TEXT("core", "g·mm").english, 1e-6};
inline constexpr Unit gram_mm2{CORE_TEXT("core", "g·mm²").english, 1e-9};  ///< a couple's
inline constexpr Unit kg_m2{CORE_TEXT("core", "kg·m²").english, 1.0};
inline constexpr Unit kg_m3{CORE_TEXT("core", "kg/m³").english, 1.0};
inline constexpr Unit newton{CORE_TEXT("core", "N").english, 1.0};
inline constexpr Unit kN{CORE_TEXT("core", "kN").english, 1e3};
inline constexpr Unit N_m{CORE_TEXT("core", "N·m").english, 1.0};
inline constexpr Unit N_per_m{CORE_TEXT("core", "N/m").english, 1.0};
inline constexpr Unit kN_per_m{CORE_TEXT("core", "kN/m").english, 1e3};
inline constexpr Unit joule{CORE_TEXT("core", "J").english, 1.0};
inline constexpr Unit kW{CORE_TEXT("core", "kW").english, 1e3};
inline constexpr Unit pascal{CORE_TEXT("core", "Pa").english, 1.0};
inline constexpr Unit kPa{CORE_TEXT("core", "kPa").english, 1e3};
inline constexpr Unit bar{CORE_TEXT("core", "bar").english, 1e5};
inline constexpr Unit MPa{CORE_TEXT("core", "MPa").english, 1e6};
inline constexpr Unit GPa{CORE_TEXT("core", "GPa").english, 1e9};
inline constexpr Unit second{CORE_TEXT("core", "s").english, 1.0};
inline constexpr Unit mm_per_s{CORE_TEXT("core", "mm/s").english, 1e-3};
inline constexpr Unit m_per_s2{CORE_TEXT("core", "m/s²").english, 1.0};
inline constexpr Unit radian{CORE_TEXT("core", "rad").english, 1.0};
inline constexpr Unit degree{"°", ravnoves::degree};
inline constexpr Unit rad_per_s{CORE_TEXT("core", "rad/s").english, 1.0};
inline constexpr Unit rpm{CORE_TEXT("core", "min⁻¹").english, two_pi / 60.0};
inline constexpr Unit percent{"%", 1e-2};
inline constexpr Unit milligram{"mg", 1e-6};
inline constexpr Unit pound{CORE_TEXT("core", "lb").english, 0.45359237};
inline constexpr Unit ounce{CORE_TEXT("core", "oz").english, pound.to_si / 16.0};
inline constexpr Unit pound_force{CORE_TEXT("core", "lbf").english, pound.to_si* standard_gravity};
inline constexpr Unit inch{CORE_TEXT("core", "in").english, 0.0254};
// Of other countries and shops: shown and typed where the user wants them, in no case file.
inline constexpr Unit centimetre{CORE_TEXT("core", "cm").english, 1e-2};
inline constexpr Unit mil{CORE_TEXT("core", "mil").english, 1e-3 * inch.to_si};
inline constexpr Unit foot{CORE_TEXT("core", "ft").english, 12.0 * inch.to_si};
inline constexpr Unit inch2{CORE_TEXT("core", "in²").english, inch.to_si* inch.to_si};
inline constexpr Unit inch3{CORE_TEXT("core", "in³").english, inch2.to_si* inch.to_si};
inline constexpr Unit gram_inch{CORE_TEXT("core", "g·in").english, gram.to_si* inch.to_si};
inline constexpr Unit ounce_inch{CORE_TEXT("core", "oz·in").english, ounce.to_si* inch.to_si};
inline constexpr Unit lb_per_ft3{CORE_TEXT("core", "lb/ft³").english,
                                 pound.to_si / (foot.to_si * foot.to_si * foot.to_si)};
inline constexpr Unit lb_ft2{CORE_TEXT("core", "lb·ft²").english,
                             pound.to_si* foot.to_si* foot.to_si};
inline constexpr Unit lb_ft{CORE_TEXT("core", "lb·ft").english, pound_force.to_si* foot.to_si};
inline constexpr Unit lbf_per_inch{CORE_TEXT("core", "lbf/in").english,
                                   pound_force.to_si / inch.to_si};
// Of tables that others wrote: read, never shown for a number of ours.
inline constexpr Unit psi{"psi", pound_force.to_si / inch2.to_si};
inline constexpr Unit mbar{"mbar", 100.0};
inline constexpr Unit kN_m{CORE_TEXT("core", "kN·m").english, 1e3};
inline constexpr Unit lbf_in{"lbf·in", pound_force.to_si* inch.to_si};
inline constexpr Unit lbf_ft{"lbf·ft", pound_force.to_si* foot.to_si};
}  // namespace units

}  // namespace ravnoves

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
inline constexpr Unit metre{Text::tr("m").english, 1.0};
inline constexpr Unit mm{Text::tr("mm").english, 1e-3};
inline constexpr Unit micrometre{Text::tr("µm").english, 1e-6};
inline constexpr Unit litre{Text::tr("l").english, 1e-3};
inline constexpr Unit cm2{Text::tr("cm²").english, 1e-4};
inline constexpr Unit cm3{Text::tr("cm³").english, 1e-6};
inline constexpr Unit kg{Text::tr("kg").english, 1.0};
inline constexpr Unit gram{Text::tr("g").english, 1e-3};
inline constexpr Unit kg_m{Text::tr("kg·m").english, 1.0};
inline constexpr Unit gram_mm{Text::tr("g·mm").english, 1e-6};
inline constexpr Unit gram_mm2{Text::tr("g·mm²").english, 1e-9};  ///< a couple's
inline constexpr Unit kg_m2{Text::tr("kg·m²").english, 1.0};
inline constexpr Unit kg_m3{Text::tr("kg/m³").english, 1.0};
inline constexpr Unit newton{Text::tr("N").english, 1.0};
inline constexpr Unit kN{Text::tr("kN").english, 1e3};
inline constexpr Unit N_m{Text::tr("N·m").english, 1.0};
inline constexpr Unit N_per_m{Text::tr("N/m").english, 1.0};
inline constexpr Unit kN_per_m{Text::tr("kN/m").english, 1e3};
inline constexpr Unit joule{Text::tr("J").english, 1.0};
inline constexpr Unit kW{Text::tr("kW").english, 1e3};
inline constexpr Unit pascal{Text::tr("Pa").english, 1.0};
inline constexpr Unit kPa{Text::tr("kPa").english, 1e3};
inline constexpr Unit bar{Text::tr("bar").english, 1e5};
inline constexpr Unit MPa{Text::tr("MPa").english, 1e6};
inline constexpr Unit GPa{Text::tr("GPa").english, 1e9};
inline constexpr Unit second{Text::tr("s").english, 1.0};
inline constexpr Unit mm_per_s{Text::tr("mm/s").english, 1e-3};
inline constexpr Unit m_per_s2{Text::tr("m/s²").english, 1.0};
inline constexpr Unit radian{Text::tr("rad").english, 1.0};
inline constexpr Unit degree{"°", ravnoves::degree};
inline constexpr Unit rad_per_s{Text::tr("rad/s").english, 1.0};
inline constexpr Unit rpm{Text::tr("min⁻¹").english, two_pi / 60.0};
inline constexpr Unit percent{"%", 1e-2};
inline constexpr Unit milligram{"mg", 1e-6};
inline constexpr Unit pound{Text::tr("lb").english, 0.45359237};
inline constexpr Unit ounce{Text::tr("oz").english, pound.to_si / 16.0};
inline constexpr Unit pound_force{Text::tr("lbf").english, pound.to_si* standard_gravity};
inline constexpr Unit inch{Text::tr("in").english, 0.0254};
// Of other countries and shops: shown and typed where the user wants them, in no case file.
inline constexpr Unit centimetre{Text::tr("cm").english, 1e-2};
inline constexpr Unit mil{Text::tr("mil").english, 1e-3 * inch.to_si};
inline constexpr Unit foot{Text::tr("ft").english, 12.0 * inch.to_si};
inline constexpr Unit inch2{Text::tr("in²").english, inch.to_si* inch.to_si};
inline constexpr Unit inch3{Text::tr("in³").english, inch2.to_si* inch.to_si};
inline constexpr Unit gram_inch{Text::tr("g·in").english, gram.to_si* inch.to_si};
inline constexpr Unit ounce_inch{Text::tr("oz·in").english, ounce.to_si* inch.to_si};
inline constexpr Unit lb_per_ft3{Text::tr("lb/ft³").english,
                                 pound.to_si / (foot.to_si * foot.to_si * foot.to_si)};
inline constexpr Unit lb_ft2{Text::tr("lb·ft²").english, pound.to_si* foot.to_si* foot.to_si};
inline constexpr Unit lb_ft{Text::tr("lb·ft").english, pound_force.to_si* foot.to_si};
inline constexpr Unit lbf_per_inch{Text::tr("lbf/in").english, pound_force.to_si / inch.to_si};
// Of tables that others wrote: read, never shown for a number of ours.
inline constexpr Unit psi{"psi", pound_force.to_si / inch2.to_si};
inline constexpr Unit mbar{"mbar", 100.0};
inline constexpr Unit kN_m{Text::tr("kN·m").english, 1e3};
inline constexpr Unit lbf_in{"lbf·in", pound_force.to_si* inch.to_si};
inline constexpr Unit lbf_ft{"lbf·ft", pound_force.to_si* foot.to_si};
}  // namespace units

}  // namespace ravnoves

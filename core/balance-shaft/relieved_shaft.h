#pragma once

#include <optional>
#include <string>

#include "case-file/message.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

/// A balance shaft with a relieved middle. Of diameter, depth and length two are given and the
/// third is sized; with all three given the shaft is only checked.
struct RelievedShaftSizes {
    std::optional<double> diameter = std::nullopt;  ///< D, m
    std::optional<double> depth = std::nullopt;     ///< h, m
    std::optional<double> length = std::nullopt;    ///< b, m
    double density = steel_density;                 ///< ρ, kg/m³
    /// The case had sizes of its bending, which no longer count.
    bool had_bending = false;
    bool operator==(const RelievedShaftSizes&) const = default;
};

/// A balance shaft as on the VAZ-11113 ([gots-klevtsov], Fig. 5): a round bar of diameter D with
/// a segment of depth h milled away over the length b.
///
/// The removed segment has the first moment ∫ y dA = (2/3) a³ about the bar's axis, a² = h (D − h)
/// a half the width of the flat; so the rest has the unbalance U = ρ b (2/3) a³, its centre
/// of mass on the other side. It is largest at h = D/2.
struct RelievedShaft {
    bool feasible = false;               ///< it has the unbalance
    Message reason;                      ///< why not, as a sentence; empty where feasible
    double required = 0.0;               ///< m₁ ρ₁, kg·m
    double unbalance = 0.0;              ///< U, kg·m
    double diameter = 0.0;               ///< m
    double depth = 0.0;                  ///< m
    double length = 0.0;                 ///< m
    double half_width = 0.0;             ///< a, m
    double removed_mass = 0.0;           ///< kg
    double mass = 0.0;                   ///< of the relieved part, kg
    double centre_of_mass_radius = 0.0;  ///< U / mass, m
    /// The smallest bar radius that can have the unbalance at this length, (3 U / 2 ρ b)^⅓, m.
    double critical_radius = 0.0;
    /// The smallest relieved length that can have it with this bar, m.
    double critical_length = 0.0;
    Message note;  ///< what a designer should know of a feasible shaft; may be empty
};

/// How long a half disc must be to have an unbalance: of a bar half of which is milled away, m.
/// @param radius     of the bar, m
/// @param unbalance  kg·m
/// @param density    kg/m³
double half_disc_length(double radius, double unbalance, double density = steel_density);

inline constexpr double relieved_shaft_tolerance = 0.01;  ///< of U, where all sizes are given

/// @param required  m₁ ρ₁, kg·m, ≥ 0
/// @throws InputError below /input/relieved_shaft where sizes are out of range or less than two
RelievedShaft design_relieved_shaft(const RelievedShaftSizes& sizes, double required);

/// @throws InputError
void check_relieved_shaft(const RelievedShaftSizes& sizes);

/// Section and side view as a DXF text, real size, mm: outline on the layer SHAFT, the milled-away
/// part on REMOVED, axes on AXIS, sizes on NOTE.
/// @throws InputError where the shaft is not feasible
std::string relieved_shaft_dxf(const RelievedShaft& shaft);

}  // namespace ravnoves::balance_shaft

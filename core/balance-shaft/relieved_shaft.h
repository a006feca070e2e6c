#pragma once

#include <optional>
#include <string>

#include "balance-shaft/shaft_bending.h"
#include "case-file/message.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

/// What is known of a balance shaft with a relieved middle. Of diameter, depth and length two are
/// given and the third is sized; with all three given the shaft is only checked. The values here
/// are what a page shows before sizes are entered.
struct RelievedShaftSizes {
    std::optional<double> diameter = 0.050;  ///< D, m
    std::optional<double> depth;             ///< h, m
    std::optional<double> length = 0.400;    ///< b, m
    double density = steel_density;          ///< ρ, kg/m³
    double elastic_modulus = 210e9;          ///< Pa; steel
    std::optional<double> bearing_span =
        std::nullopt;  ///< L, m; empty: b + D, D/2 whole on both sides
    /// Pa; half the yield strength, 305 MPa, of normalised C45 from 16 to 100 mm [en-10083-2].
    double allowable_stress = 150e6;
    std::optional<double> permitted_sag =
        std::nullopt;           ///< m; empty: L / 1200, see relieved_shaft_sag_ratio
    double speed_margin = 2.0;  ///< whirling speed over speed, at least [shigley]
    std::optional<double> bearing_limit =
        std::nullopt;  ///< load that a bearing bears, N; empty: not judged
    bool operator==(const RelievedShaftSizes&) const = default;
};

/// A balance shaft as on the VAZ-11113 ([gots-klevtsov], Fig. 5): a round bar of diameter D with
/// a segment of depth h milled away over the length b.
///
/// The removed segment has the first moment ∫ y dA = (2/3) a³ about the bar's axis, a² = h (D − h)
/// a half the width of the flat; so the rest has the unbalance U = ρ b (2/3) a³, its centre
/// of mass on the other side. It is largest at h = D/2.
///
/// The relieved length lies in the middle between two bearings L apart, the bar whole on both
/// sides. The shaft bends towards its flat, its weakest way, which is also that of its centrifugal
/// load. It is feasible where it has the unbalance and all of these hold at the speed:
///   whirling speed ≥ margin × speed;  √(σ² + 3 τ²) ≤ allowable stress;
///   deflection ≤ permitted sag;       bearing load ≤ limit, where one is given.
/// Loads are the centrifugal one, grown by the deflection, and the weight in the same direction;
/// not those of the gears. The stress does not know the notches at the ends of the relief.
struct RelievedShaft {
    bool feasible = false;
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
    /// Bending of the relieved part, simply supported, under its own centrifugal load U ω²: sag, m,
    /// and largest stress, Pa.
    double sag = 0.0;
    double bending_stress = 0.0;
    double bearing_span = 0.0;   ///< L, m
    double permitted_sag = 0.0;  ///< m
    double weight = 0.0;         ///< of the whole shaft between the bearings, N
    /// The whole shaft between its bearings; the loads are 0 from the whirling speed on.
    ShaftBending bending;
    Message note;  ///< what a designer should know of a feasible shaft; may be empty
};

inline constexpr double relieved_shaft_tolerance = 0.01;  ///< of U, where all sizes are given
/// Bearing span over the sag that is permitted where none is given. An evenly loaded shaft that
/// sags by L/1200 tilts its journals by 16/5 of that, 0.0027 rad: within the 0.001 to
/// 0.003 rad that deep-groove ball bearings take [shigley], Table 7-2.
inline constexpr double relieved_shaft_sag_ratio = 1200.0;

/// @param required       m₁ ρ₁, kg·m, ≥ 0
/// @param angular_speed  ω, rad/s
/// @throws InputError below /input/relieved_shaft where sizes are out of range or less than two
RelievedShaft design_relieved_shaft(const RelievedShaftSizes& sizes, double required,
                                    double angular_speed);

/// @throws InputError
void check_relieved_shaft(const RelievedShaftSizes& sizes);

/// Section and side view as a DXF text, real size, mm: outline on the layer SHAFT, what is milled
/// away on REMOVED, axes on AXIS, sizes on NOTE.
/// @throws InputError where the shaft is not feasible
std::string relieved_shaft_dxf(const RelievedShaft& shaft, const std::string& title);

}  // namespace ravnoves::balance_shaft

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numerics/constants.h"
#include "numerics/periodic_piecewise.h"
#include "numerics/slider_crank.h"
#include "numerics/units.h"

namespace ravnoves::balance_shaft {

/// A measured cylinder pressure over one cycle, at rows of ascending crank angle; the last row
/// repeats the first 720° later, or 360° later for a two-stroke engine.
struct PressureTrace {
    /// °, from top dead centre: four-stroke, at the start of intake; two-stroke, the firing one.
    std::vector<double> crank_angle_deg;
    std::vector<double> pressure;  ///< Pa, absolute, as many as angles
    Unit unit = units::bar;        ///< that it was read in
    bool unit_named = true;        ///< by its file or case; else it is the likely one
    bool operator==(const PressureTrace&) const = default;
};

/// A plain cycle: constant pressures for the gas exchange, polytropic compression, one Wiebe heat
/// release, polytropic expansion. 360° is the firing top dead centre.
///
/// Four-stroke: 0° begins the intake. Two-stroke: the ports open and close at the same place of the
/// piston; from their opening to bottom dead centre the pressure falls to the exhaust's, by a
/// parabola that meets it level, and is the intake's until they close.
struct GasCycle {
    double compression_ratio = 18.0;       ///< ε
    double intake_pressure = 1e5;          ///< Pa, absolute
    double exhaust_pressure = 1e5;         ///< Pa, absolute
    double polytropic_compression = 1.35;  ///< exponent until combustion begins
    double polytropic_expansion = 1.30;    ///< exponent of combustion and expansion
    std::optional<double> heat;            ///< J per cycle; one of heat and imep
    std::optional<double> imep;            ///< Pa, indicated mean effective pressure
    double combustion_start = 0.0;         ///< rad
    double combustion_duration = 0.0;      ///< rad
    double wiebe_m = 1.0;                  ///< form exponent of Vibe's law
    double ports_open = 110.0 * degree;    ///< of a two-stroke, rad after top dead centre
    bool operator==(const GasCycle&) const = default;
};

/// Work and pressures of one cycle.
struct IndicatedCycle {
    double displacement = 0.0;         ///< V_d, m³
    std::optional<double> clearance;   ///< V_c, m³; empty for a trace (compression ratio unknown)
    double work = 0.0;                 ///< ∮ p dV over the cycle, J
    double imep = 0.0;                 ///< work / V_d, Pa
    std::optional<double> heat;        ///< J, of a GasCycle
    double peak_pressure = 0.0;        ///< Pa
    double peak_pressure_angle = 0.0;  ///< rad, from top dead centre
};

/// Pressure, volume and gas torque of one cylinder over the crank angle θ (from the crank's
/// position along the cylinder axis; equal to top dead centre where the offset is 0). Traces and
/// cycles count from top dead centre, θ − θ_TDC.
///
/// Gas torque M_g = −(p − p₀) A s′(θ), with s the piston pin's distance from the crank axis and A
/// the piston's area; positive in the direction of rotation.
///
/// In a GasCycle, from the start of combustion, p Vⁿ = p_s V_sⁿ + (n − 1) Q ∫ Vⁿ⁻¹ dx, the solution
/// of dp = ((n − 1) dQ − n p dV)/V with Q dx the heat of Vibe's law x = (1 − exp(−a
/// τ^(m+1)))/(1 − exp(−a)), a = ln 1000 (99.9 % burnt at the end, here 100 %).
class CylinderGas {
  public:
    /// @param bore                m
    /// @param crankcase_pressure  p₀, Pa, absolute
    /// @param smooth              reads the trace by the periodic spline, else by straight lines
    CylinderGas(const SliderCrank<double>& crank, double bore, double crankcase_pressure,
                const PressureTrace& trace, bool smooth);
    /// @param strokes  2 or 4
    /// @throws InputError where the imep asked for needs a negative heat
    CylinderGas(const SliderCrank<double>& crank, double bore, double crankcase_pressure,
                const GasCycle& cycle, int strokes = 4);

    double pressure(double theta) const;  ///< Pa; any θ, rad
    /// V = V_c + A (s_max − s), m³; V_c = 0 for a trace.
    double volume(double theta) const;
    double displacement() const { return displacement_; }  ///< m³
    /// Gas torque, N·m. @param motion  the piston's at θ
    double torque(double theta, const PistonMotion<double>& motion) const;
    double torque(double theta) const { return torque(theta, crank_.at(theta)); }
    /// Work and peak of the cycle, computed at each call.
    IndicatedCycle indicated() const;
    double period() const { return period_; }  ///< 4π, or 2π of a two-stroke engine
    double top_dead_centre() const { return top_dead_centre_; }  ///< θ, rad
    /// θ in degrees, ascending from 0 to the period, where the pressure has a kink or a jump.
    std::vector<double> breaks_deg() const;

  private:
    /// Of a cycle, linear in its heat: Pa or J, and the same per J of heat. Of a trace, the first.
    struct Parts {
        double motored = 0.0;
        double per_heat = 0.0;
    };
    CylinderGas(const SliderCrank<double>& crank, double bore, double crankcase_pressure);
    double of(const Parts& parts) const { return parts.motored + heat_ * parts.per_heat; }
    double volume_above(double s) const { return clearance_ + area_ * (longest_ - s); }
    Parts pressure_parts(double angle, double volume) const;
    Parts closed_pressure(double angle, double volume) const;
    double wiebe_integral(double from, double to) const;
    double released_integral(double angle) const;
    double work(const Parts& weight) const;  ///< of the parts so weighted, J

    SliderCrank<double> crank_;
    double crankcase_pressure_ = 0.0;  ///< p₀, Pa
    double area_ = 0.0;
    double period_ = 0.0;
    double top_dead_centre_ = 0.0;  ///< θ, rad
    double bottom_ = 0.0;           ///< bottom dead centre after top dead centre, rad, near π
    double longest_ = 0.0;          ///< s at top dead centre, m
    double displacement_ = 0.0;     ///< m³
    double clearance_ = 0.0;        ///< m³; 0 for a trace
    std::vector<double> breaks_;    ///< angles from TDC where the pressure has a kink or jump, rad

    std::optional<PeriodicPiecewise> trace_;  ///< Pa over degrees

    GasCycle cycle_;
    double ports_close_ = 0.0;  ///< of a two-stroke, rad from TDC
    Parts at_opening_;          ///< of a two-stroke: pressure where the ports open
    double heat_ = 0.0;
    double start_constant_ = 0.0;   ///< p_s V_sⁿ
    double intake_constant_ = 0.0;  ///< p V^n_c of compression
    std::vector<double> integral_;  ///< ∫ Vⁿ⁻¹ dx up to equal steps of the combustion
};

/// Inertia torque M_j = −m_j ω² s′ s″, N·m.
inline double inertia_torque(const PistonMotion<double>& motion, double mass,
                             double angular_speed) {
    return -mass * angular_speed * angular_speed * motion.ds * motion.d2s;
}

}  // namespace ravnoves::balance_shaft

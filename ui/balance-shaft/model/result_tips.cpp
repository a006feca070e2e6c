#include "balance-shaft/model/balance_shaft_model.h"

namespace ravnoves {

ResultTips BalanceShaftModel::criteriaTips() {
    return {
        {tr("Mᵤₚ"), tr("Tipping moment on the engine without a shaft, −Mᵢ")},
        {tr("Mₛ"), tr("Moment of the shaft, P₁ l sin(α + φ)")},
        {tr("Mᵤₚₛ"), tr("Moment on the mounts with the shaft, Mᵤₚ + Mₛ")},
        {tr("change"),
         tr("Mᵤₚₛ against Mᵤₚ, as a share of Mᵤₚ. Better: less range, RMS and maximum, "
            "a minimum nearer to zero.")},
        {tr("range"), tr("Largest less smallest value over the cycle, max − min")},
        {tr("RMS"), tr("Root of the mean square about the mean over the cycle")},
        {tr("mean"), tr("Mean over the cycle; that of the shaft is 0 at every α")},
        {tr("nodes"),
         tr("Mean the way the paper takes it: over the printed rows, with the end of the cycle "
            "counted twice. It shows what the paper's numbers are and says nothing of the shaft.")},
        {tr("max"), tr("Largest value over the cycle")},
        {tr("min"), tr("Smallest value over the cycle; most are negative, and nearer to zero is "
                       "better")},
    };
}

ResultTips BalanceShaftModel::quantityTips() {
    return {
        {tr("Inertia force Pⱼ₁, max"), tr("Of first order, mⱼ r ω²")},
        {tr("Counterweight m₁"),
         tr("Of each of the two counterweights, mⱼ r / (2 ρ₁), eq. (1), or as "
            "entered")},
        {tr("Counterweight force P₁"), tr("m₁ ρ₁ ω²")},
        {tr("Amplitude of Mₛ, P₁ l"), tr("Largest moment of the shaft")},
        {tr("First order's share of Mᵤₚ"), tr("Of the mean square about the mean. It is all that a "
                                              "shaft at crank speed can change.")},
        {tr("Envelope, width × height"),
         tr("Box around cylinder, crank circle, shaft circle, gears and wall in the front view")},
    };
}

ResultTips BalanceShaftModel::cycleTips() {
    return {
        {tr("Indicated mean effective pressure"), tr("Work of a cycle over the displacement")},
        {tr("Indicated work per cycle"), tr("∮ (p − p₀) dV")},
        {tr("Indicated power"), tr("Work of a cycle times cycles a second")},
        {tr("Mean torque"), tr("Work of a cycle over its crank angle")},
        {tr("Peak pressure"), tr("Largest pressure in the cylinder")},
        {tr("at crank angle"), tr("Crank angle of the peak pressure")},
        {tr("Displacement"), tr("Piston area times stroke")},
        {tr("Clearance volume"), tr("Displacement over the compression ratio less 1")},
        {tr("Heat per cycle"),
         tr("Released by the combustion, entered or found for the mean pressure")},
    };
}

ResultTips BalanceShaftModel::flywheelTips() {
    return {
        {tr("Excess work ΔE"), tr("Largest less smallest ∫ (Mᵢ − mean) dφ over the cycle")},
        {tr("Fluctuation δ"), tr("(ω_max − ω_min) / ω = ΔE / (J ω²)")},
        {tr("Moment of inertia J"), tr("Of all that turns evenly, ΔE / (δ ω²)")},
        {tr("Speed swings by ±"), tr("Half of δ n to either side of the mean speed")},
        {tr("Fastest at crank angle"), tr("Where the excess energy is largest")},
        {tr("Slowest at crank angle"), tr("Where the excess energy is smallest")},
    };
}

}  // namespace ravnoves

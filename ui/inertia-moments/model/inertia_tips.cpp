#include "inertia-moments/model/inertia_moments_model.h"

namespace ravnoves {

ResultTips InertiaMomentsModel::orderTips() {
    return {
        {QStringLiteral("%1Fx"), tr("Force to the right, N; the number is its order")},
        {QStringLiteral("%1Fy"), tr("Force upwards, N; the number is its order")},
        {QStringLiteral("%1Mx"), tr("Moment in the horizontal plane, Σ Fx (z − z_ref), N·m")},
        {QStringLiteral("%1My"), tr("Moment in the vertical plane, Σ Fy (z − z_ref), N·m")},
        {QStringLiteral("%1Mz"),
         tr("Roll moment on the engine, of offsets, rods and the reaction of the torque, N·m")},
        {tr("exact"), tr("Amplitude of the order in the exact motion of the pistons")},
        {tr("phase, °"), tr("kφ at which the exact component is largest")},
        {tr("two-term"), tr("Amplitude by the paper's cos θ + K λ sin θ + λ cos 2θ")},
        {tr("diff., %"), tr("Two-term against exact, as a share of exact")},
    };
}

ResultTips InertiaMomentsModel::rotatingTips() {
    return {
        {QStringLiteral("%1F"), tr("Force of the order k = the number, N")},
        {QStringLiteral("%1M"), tr("Moment of the order k = the number, N·m")},
        {tr("+kω"), tr("Part A that turns with the crank: x + iy = A e^{ikφ} + B e^{−ikφ}")},
        {tr("−kω"), tr("Part B that turns against the crank")},
        {tr("at, °"), tr("Direction of the part to the left at φ = 0, counter-clockwise from x")},
    };
}

ResultTips InertiaMomentsModel::shaftTips() {
    return {
        {tr("Shaft"), tr("Order, task and direction; a full dot is switched on")},
        {tr("cancels"), tr("The part of the order that the shaft cancels, N or N·m")},
        {tr("mρ, g·mm"),
         tr("Weight times radius: m ρ (kω)² is the force, m ρ L (kω)² the moment cancelled")},
        {tr("at, °"),
         tr("Direction of its weight (of that towards cylinder 1) at φ = 0, counter-clockwise from "
            "x")},
        {tr("left"), tr("Largest value of the order with this shaft alone, N or N·m")},
    };
}

ResultTips InertiaMomentsModel::weightTips() {
    return {
        {tr("Force, N"), tr("Of the rotating masses, m R ω² |Σ e^{iκ}|")},
        {tr("Moment, N·m"), tr("Of the rotating masses about their middle, m R ω² |Σ z e^{iκ}|")},
        {tr("against the force"), tr("Where a counterweight against the force stands")},
        {tr("against the moment"),
         tr("Where the front one of two opposite counterweights against the moment stands")},
        {tr("On a throw, rods: %1, g"),
         tr("Rotating mass on one crankpin that carries so many rods, at the crank radius")},
        {tr("Front web") + tr(", g·mm"), tr("Mass times radius of the counterweight in front")},
        {tr("Front web") + tr(", g"), tr("Mass of the counterweight in front at its radius")},
        {tr("Rear web") + tr(", g·mm"), tr("Mass times radius of the counterweight at the rear")},
        {tr("Rear web") + tr(", g"), tr("Mass of the counterweight at the rear at its radius")},
        {tr("angle, °"), tr("From crankpin 1, counter-clockwise")},
        {tr("lag, °"), tr("From crankpin 1 against the rotation")},
    };
}

ResultTips InertiaMomentsModel::remainingTips() {
    return {
        {QStringLiteral("%1F"), tr("Force of the order k = the number, N")},
        {QStringLiteral("%1M"), tr("Moment of the order k = the number, N·m")},
        {tr("before"),
         tr("Largest value over a turn, with the rotating masses, without balancing")},
        {tr("left"), tr("Largest value with the counterweights and shafts that are on")},
        {tr("left, %"), tr("What is left as a share of what was there before")},
    };
}

}  // namespace ravnoves

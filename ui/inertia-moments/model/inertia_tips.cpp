#include "inertia-moments/model/inertia_moments_model.h"
#include "text/shown_units.h"

namespace ravnoves {

ResultTips InertiaMomentsModel::orderTips() {
    return {
        {QStringLiteral("%1Fx"), tr("Force to the right; the number is its order")},
        {QStringLiteral("%1Fy"), tr("Force upwards; the number is its order")},
        {QStringLiteral("%1Mx"), tr("Moment in the horizontal plane, Σ Fx (z − z_ref)")},
        {QStringLiteral("%1My"), tr("Moment in the vertical plane, Σ Fy (z − z_ref)")},
        {QStringLiteral("%1Mz"),
         tr("Roll moment on the engine, of offsets, rods and the reaction of the torque")},
        {tr("exact"), tr("Amplitude of the order in the exact motion of the pistons")},
        {tr("phase, °"), tr("kφ at which the exact component is largest")},
        {tr("two-term"), tr("Amplitude by the paper's cos θ + K λ sin θ + λ cos 2θ")},
        {tr("diff., %"), tr("Two-term against exact, as a share of exact")},
    };
}

ResultTips InertiaMomentsModel::rotatingTips() {
    return {
        {QStringLiteral("%1F"), tr("Force of the order k = the number")},
        {QStringLiteral("%1M"), tr("Moment of the order k = the number")},
        {tr("+kω"), tr("Part A that turns with the crank: x + iy = A exp(ikφ) + B exp(−ikφ)")},
        {tr("−kω"), tr("Part B that turns against the crank")},
        {tr("at, °"), tr("Direction of the part to the left at φ = 0, counter-clockwise from x")},
    };
}

ResultTips InertiaMomentsModel::shaftTips() {
    return {
        {shownUnit(units::newton).name + QStringLiteral("; ") + shownUnit(units::N_m).name,
         tr("Order, task and direction; a full dot is switched on")},
        {tr("cancels"), tr("The part of the order that the shaft cancels")},
        {shownTitle(tr("mρ, g·mm")).text,
         tr("Weight times radius: m ρ (kω)² is the force, m ρ L (kω)² the moment cancelled")},
        {tr("at, °"),
         tr("Direction of its weight (of that towards cylinder 1) at φ = 0, counter-clockwise from "
            "x")},
        {tr("left"), tr("Largest value of the order with this shaft alone")},
    };
}

ResultTips InertiaMomentsModel::weightTips() {
    return {
        {shownTitle(tr("Force, N")).text, tr("Of the rotating masses, m R ω² |Σ exp(iκ)|")},
        {shownTitle(tr("Moment, N·m")).text,
         tr("Of the rotating masses about their middle, m R ω² |Σ z exp(iκ)|")},
        {tr("against the force"), tr("Where a counterweight against the force stands")},
        {tr("against the moment"),
         tr("Where the front one of two opposite counterweights against the moment stands")},
        {shownTitle(tr("On a throw, rods: %1, g")).text,
         tr("Rotating mass on one crankpin that carries so many rods, at the crank radius")},
        {shownTitle(tr("Front web") + tr(", g·mm")).text,
         tr("Mass times radius of the counterweight in front")},
        {shownTitle(tr("Front web") + tr(", g")).text,
         tr("Mass of the counterweight in front at its radius")},
        {shownTitle(tr("Rear web") + tr(", g·mm")).text,
         tr("Mass times radius of the counterweight at the rear")},
        {shownTitle(tr("Rear web") + tr(", g")).text,
         tr("Mass of the counterweight at the rear at its radius")},
        {tr("angle, °"), tr("From crankpin 1, counter-clockwise")},
        {tr("lag, °"), tr("From crankpin 1 against the rotation")},
    };
}

ResultTips InertiaMomentsModel::remainingTips() {
    return {
        {QStringLiteral("%1F"), tr("Force of the order k = the number")},
        {QStringLiteral("%1M"), tr("Moment of the order k = the number")},
        {tr("before"),
         tr("Largest value over a turn, with the rotating masses, without balancing")},
        {tr("left"), tr("Largest value with the counterweights and shafts that are on")},
        {tr("left, %"), tr("What is left as a share of what was there before")},
    };
}

}  // namespace ravnoves

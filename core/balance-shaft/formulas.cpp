#include "balance-shaft/results.h"

#include <array>

namespace ravnoves::balance_shaft {

namespace {

constexpr std::string_view gots_klevtsov = "gots-klevtsov";

void add_torque(std::vector<Formula>& list) {
    list.push_back({Text::tr("Torque of the engine"),
                    "M<sub>i</sub> = M<sub>g</sub> + M<sub>j</sub>, "
                    "M<sub>g</sub> = −(p − p<sub>0</sub>) A s′, "
                    "M<sub>j</sub> = −m<sub>j</sub> ω<sup>2</sup> s′ s″",
                    "", "",
                    Text::tr("gas torque and inertia torque; p pressure in the cylinder, p₀ in "
                             "the crankcase, A piston area, s distance of the piston pin from the "
                             "crank axis, ′ by φ")});
}

void add_cycle(std::vector<Formula>& list, int strokes) {
    list.push_back(
        {Text::tr("Volume of the cylinder"),
         "V = V<sub>c</sub> + A (s<sub>max</sub> − s), V<sub>c</sub> = V<sub>d</sub> / (ε − 1)", "",
         "", Text::tr("V_d displacement, ε compression ratio")});
    list.push_back({Text::tr("Pressure of compression"),
                    "p = p<sub>a</sub> (V<sub>a</sub> / V)<sup>n₁</sup>", "", "",
                    strokes == 2
                        ? Text::tr("pₐ intake pressure, Vₐ volume where the ports close, n₁ "
                                   "polytropic exponent")
                        : Text::tr("pₐ intake pressure, Vₐ volume at bottom dead centre, n₁ "
                                   "polytropic exponent")});
    list.push_back({Text::tr("Heat release (Wiebe)"),
                    "x = (1 − exp(−a τ<sup>m+1</sup>)) / (1 − exp(−a)), a = ln 1000", "", "",
                    Text::tr("x burnt share, τ share of the combustion's duration, m form "
                             "exponent; all is burnt at τ = 1")});
    list.push_back(
        {Text::tr("Pressure of combustion and expansion"),
         "p V<sup>n₂</sup> = p<sub>s</sub> V<sub>s</sub><sup>n₂</sup> + (n₂ − 1) Q ∫ "
         "V<sup>n₂−1</sup> dx",
         "", "",
         Text::tr("s at the start of combustion, Q heat of a cycle, n₂ polytropic exponent")});
    if (strokes == 2) {
        list.push_back(
            {Text::tr("Pressure with open ports"),
             "p = p<sub>r</sub> + (p<sub>o</sub> − p<sub>r</sub>) "
             "((φ<sub>b</sub> − φ) / (φ<sub>b</sub> − φ<sub>o</sub>))<sup>2</sup>; "
             "p = p<sub>a</sub>",
             "", "",
             Text::tr("to and from bottom dead centre φ_b; o where the ports open, pᵣ exhaust "
                      "and pₐ intake pressure")});
    } else {
        list.push_back({Text::tr("Pressure of gas exchange"),
                        "p = p<sub>r</sub>; p = p<sub>a</sub>", "", "",
                        Text::tr("pᵣ from bottom to top dead centre, exhaust; pₐ from there to "
                                 "bottom dead centre, intake")});
    }
}

void add_gears(std::vector<Formula>& list, const GearPair& gears) {
    if (gears.shifted_teeth != 0) {
        list.push_back(
            {Text::tr("Shaft fitted k teeth out"),
             "δ = 360° k / z, ΔF = 2 P<sub>1</sub> |sin(δ/2)|", "", "",
             Text::tr("z teeth of each gear; moment as at α + δ; ΔF residual first-order force")});
    }
    if (gears.backlash > 0.0) {
        list.push_back({Text::tr("Play of the gears"), "|Δα| ≤ b / l", "", "",
                        Text::tr("b play at the pitch circle")});
    }
}

}  // namespace

std::vector<Formula> formulas(const Input& input) {
    const bool offset = input.cylinder.offset != 0.0;
    std::vector<Formula> list;
    if (input.reciprocating_masses.size() > 1) {
        list.push_back({Text::tr("Reciprocating mass"), "m<sub>j</sub> = Σ m", gots_klevtsov,
                        "Table 1",
                        Text::tr("piston, pin, rings and the small-end share of the rod")});
    }
    list.push_back({Text::tr("First-order inertia force"),
                    offset ? "P<sub>j1</sub> = m<sub>j</sub> r<sub>1</sub> ω<sup>2</sup> cos(θ − δ)"
                           : "P<sub>j1</sub> = m<sub>j</sub> r ω<sup>2</sup> cos φ",
                    offset ? "" : gots_klevtsov, "",
                    offset ? Text::tr("of the exact s″: −r₁ cos(θ − δ) is its first order; ω "
                                      "angular speed, θ − φ the same at every angle")
                           : Text::tr("r crank radius, ω angular speed, φ crank angle from top "
                                      "dead centre")});
    if (!input.counterweight_mass) {
        list.push_back({Text::tr("Counterweight"),
                        "m<sub>1</sub> = m<sub>j</sub> r / (2 ρ<sub>1</sub>)", gots_klevtsov, "(1)",
                        Text::tr("ρ₁ radius of its centre of mass")});
    }
    list.push_back({Text::tr("Force of a counterweight"),
                    "P<sub>1</sub> = m<sub>1</sub> ρ<sub>1</sub> ω<sup>2</sup>", gots_klevtsov});
    if (input.torque.is_computed()) {
        add_torque(list);
    }
    if (input.torque.kind == TorqueSource::Kind::cycle) {
        add_cycle(list, input.strokes);
    }
    if (input.torque.is_computed() || offset) {
        list.push_back({Text::tr("Piston pin"),
                        "s = r cos θ + √(L<sup>2</sup> − (r sin θ − e)<sup>2</sup>)", "", "",
                        Text::tr("L length of the rod, e offset of the cylinder, θ angle of the "
                                 "crank from the cylinder's direction")});
    }
    list.push_back({Text::tr("Tipping moment"),
                    offset ? "M<sub>up</sub> = −M<sub>i</sub> + e m<sub>j</sub> ω<sup>2</sup> s″"
                           : "M<sub>up</sub> = −M<sub>i</sub>",
                    offset ? "" : gots_klevtsov, "",
                    Text::tr("reaction to the torque Mᵢ of the engine and, for an offset "
                             "cylinder, to the angular momentum of its reciprocating masses")});
    list.push_back({Text::tr("Moment of the shaft"),
                    offset ? "M<sub>s</sub> = P<sub>1</sub> l sin(α + θ − δ)"
                           : "M<sub>s</sub> = P<sub>1</sub> l sin(α + φ)",
                    offset ? "" : gots_klevtsov, offset ? "" : "(2)–(4)",
                    Text::tr("l distance and α angle of the shaft's axis from the crank axis; for "
                             "an offset cylinder δ is the lag of the counterweights")});
    list.push_back({Text::tr("Moment on the mounts"),
                    "M<sub>ups</sub> = M<sub>up</sub> + M<sub>s</sub>", gots_klevtsov, "(5)"});
    list.push_back({Text::tr("Range"), "ΔM = max M<sub>ups</sub> − min M<sub>ups</sub>",
                    gots_klevtsov, "", Text::tr("of the continuous cycle")});
    list.push_back({Text::tr("RMS about the mean"),
                    "√( (1/Φ) ∫ (M<sub>ups</sub> − M<sub>m</sub>)<sup>2</sup> dφ )", "", "",
                    Text::tr("Φ length of the cycle, Mₘ its mean")});
    list.push_back({Text::tr("Place of the minimum RMS"),
                    offset ? "x = (s<sub>1</sub> sin ε − c<sub>1</sub> cos ε) / P<sub>1</sub>, "
                             "y = −(c<sub>1</sub> sin ε + s<sub>1</sub> cos ε) / P<sub>1</sub>, "
                             "ε = θ − δ − φ"
                           : "x = −c<sub>1</sub> / P<sub>1</sub>, y = −s<sub>1</sub> / "
                             "P<sub>1</sub>",
                    "", "",
                    Text::tr("c₁ and s₁ coefficients of cos φ and sin φ in Mᵤₚ; x = l sin α, "
                             "y = l cos α")});
    list.push_back({Text::tr("Crank alone, without a shaft"),
                    offset ? "m<sub>j</sub> (r<sub>1</sub> − κ r) ω<sup>2</sup>, κ m<sub>j</sub> r "
                             "ω<sup>2</sup>"
                           : "(1 − κ) m<sub>j</sub> r ω<sup>2</sup>, κ m<sub>j</sub> r "
                             "ω<sup>2</sup>",
                    "", "",
                    Text::tr("half-axes of the ellipse of the first-order force, along and across "
                             "the cylinder; κ balanced share")});
    if (!input.envelope.shaft_swing_radius && !input.relieved_shaft) {
        list.push_back(
            {Text::tr("Swing circle of the shaft, assumed"),
             "R = (3 m<sub>1</sub>ρ<sub>1</sub> / (2 ρ B))<sup>1/3</sup>", "", "",
             Text::tr("a half disc of steel, ρ = 7850 kg/m³, as long as the bore B, with "
                      "the unbalance m₁ρ₁")});
    }
    add_gears(list, input.gears);
    list.push_back({Text::tr("Flywheel"),
                    "ΔE = J ω<sup>2</sup> δ, E = ∫ (M<sub>i</sub> − M<sub>im</sub>) dφ", "", "",
                    Text::tr("ΔE excess work between the extremes of E, J moment of inertia, δ "
                             "fluctuation of the speed, Mᵢₘ mean torque")});
    if (input.relieved_shaft) {
        list.push_back({Text::tr("Shaft with a relieved middle"),
                        "m<sub>1</sub>ρ<sub>1</sub> = ρ b ∫ y dA", gots_klevtsov, "Fig. 5",
                        Text::tr("ρ density, b length of the relief, A the segment milled away, y "
                                 "from the axis")});
    }
    return list;
}

std::span<const Text> left_out() {
    static constexpr std::array texts{
        Text::tr(
            "Second-order forces (mⱼ r ω² λ cos 2φ) are not included in the moment on the mounts."),
        Text::tr(
            "The rotating part of rod and crank is balanced by the crank's own counterweights."),
        Text::tr("The engine block is rigid, and the speed within a cycle is constant."),
        Text::tr(
            "Over the speed band the gas torque is constant: its change with speed is not known."),
        Text::tr(
            "The play of the gears allows any shaft angle within it; the motion is not computed."),
        Text::tr("Bending and stress of the relieved shaft, and the load on each of its bearings."),
        Text::tr("Parts that overlap in the front view may be one behind another."),
    };
    return texts;
}

}  // namespace ravnoves::balance_shaft

#include "inertia-moments/results.h"

#include <algorithm>
#include <array>

namespace ravnoves::inertia_moments {

namespace {

constexpr std::string_view chainov = "chainov-vallejo-maldonado";

void add_articulated(std::vector<Formula>& list) {
    list.push_back({Text::tr("Swing of the master rod"),
                    "sin ψ = λ (K<sub>m</sub> − sin θ<sub>m</sub>)", "", "",
                    Text::tr("ψ counter-clockwise from the master cylinder's "
                             "axis, index m: of the master cylinder")});
    list.push_back({Text::tr("Knuckle pin"),
                    "q = R e<sup>iθ</sup> + r<sub>k</sub> e<sup>i(ψ + γ − β + β<sub>m</sub>)</sup>",
                    "", "",
                    Text::tr("along the cylinder's own axis + i across it; r_k and γ radius and "
                             "angle of the knuckle pin, β bank angle")});
    list.push_back({Text::tr("Articulated piston pin"),
                    "s = Re q + √(l<sup>2</sup> − (Im q − e)<sup>2</sup>)", "", "",
                    Text::tr("l length of the articulated rod")});
}

void add_weights(std::vector<Formula>& list, const Input& input) {
    const auto has = [&](Balances what) {
        return std::any_of(input.shafts.begin(), input.shafts.end(),
                           [&](const Shaft& shaft) { return shaft.balances == what; });
    };
    if (!input.shafts.empty()) {
        list.push_back({Text::tr("Rotating parts of order k"),
                        "M<sub>x</sub> + i M<sub>y</sub> = A e<sup>ikφ</sup> + B e<sup>−ikφ</sup>",
                        "", "",
                        Text::tr("A turns with the crank, B against it; each is cancelled by one "
                                 "shaft")});
    }
    if (has(Balances::moment)) {
        list.push_back({Text::tr("Balance shaft against a moment"),
                        "m ρ L (kω)<sup>2</sup> = |A|, |B|", chainov, "Fig. 7, Fig. 8",
                        Text::tr("L distance of its two weights; phase opposite "
                                 "to A or B")});
    }
    if (has(Balances::force)) {
        list.push_back(
            {Text::tr("Balance shaft against a force"), "m ρ (kω)<sup>2</sup> = |A|, |B|"});
    }
    if (input.rotating_mass > 0.0 || input.end_webs) {
        list.push_back({Text::tr("Rotating masses"),
                        "m<sub>R</sub> R ω<sup>2</sup> Σ e<sup>iκ</sup>, m<sub>R</sub> R "
                        "ω<sup>2</sup> Σ (z − z<sub>0</sub>) e<sup>iκ</sup>",
                        chainov, "Fig. 9",
                        Text::tr("force and moment; κ crankpin angle; two weights on the end webs "
                                 "are opposite to both")});
    }
}

}  // namespace

std::vector<Formula> formulas(const Input& input) {
    // All of a layout have its offset, and none has an articulated rod.
    const std::vector<Cylinder> cylinders =
        input.layout ? std::vector{Cylinder{.offset = input.layout->offset}} : input.cylinders;
    const auto any = [&](auto&& test) {
        return std::any_of(cylinders.begin(), cylinders.end(), test);
    };
    const bool offset = any([](const Cylinder& each) { return each.offset != 0.0; });
    const bool articulated = any([](const Cylinder& each) { return each.articulated.has_value(); });
    std::vector<Formula> list;
    list.push_back({Text::tr("Piston pin along its axis"),
                    offset ? "s = R cos θ + √(L<sup>2</sup> − (R sin θ − e)<sup>2</sup>)"
                           : "s = R cos θ + √(L<sup>2</sup> − R<sup>2</sup> sin<sup>2</sup> θ)",
                    "", "",
                    Text::tr("θ = φ + β₁ + κ − β angle of the crankpin from the cylinder's axis, R "
                             "crank radius, L = R/λ rod, e = K R offset")});
    if (articulated) {
        add_articulated(list);
    }
    list.push_back({Text::tr("Inertia force, exact"),
                    "F = −m<sub>j</sub> d<sup>2</sup>s/dt<sup>2</sup>", "", "",
                    Text::tr("orders 1 to 12 by a Fourier transform of the exact motion")});
    list.push_back({Text::tr("Inertia force, two terms"),
                    offset ? "F = m<sub>j</sub> R ω<sup>2</sup> (cos θ + K λ sin θ + λ cos 2θ)"
                           : "F = m<sub>j</sub> R ω<sup>2</sup> (cos θ + λ cos 2θ)",
                    chainov, "(1)–(4)", Text::tr("the paper's form, compared with the exact one")});
    if (offset) {
        list.push_back({Text::tr("Top dead centre"), "θ = arcsin(λK / (1 + λ))", chainov, "Fig. 1",
                        Text::tr("on the side of the offset")});
    }
    if (input.layout && input.layout->name == "vr") {
        list.push_back({Text::tr("Shift of the second bank's crankpins"), "γ + 2 φ<sub>0</sub>",
                        chainov, "Fig. 2",
                        Text::tr("for even firing; γ angle between the banks, φ₀ top dead centre. "
                                 "The paper prints γ + φ₀, but its number is from this formula")});
    }
    list.push_back({Text::tr("Force on the engine"),
                    "F = Σ F<sub>i</sub> "
                    "u<sub>i</sub>",
                    chainov, "Fig. 4", Text::tr("uᵢ direction of cylinder i")});
    list.push_back(
        {Text::tr("Moments in the horizontal and vertical plane"),
         "(M<sub>x</sub>, M<sub>y</sub>) = Σ F<sub>i</sub> u<sub>i</sub> (z<sub>i</sub> "
         "− z<sub>0</sub>)",
         chainov, "(1)–(4)",
         Text::tr("zᵢ place of cylinder i along the crank, z₀ reference point of moments")});
    list.push_back(
        {Text::tr("Roll moment"), "M<sub>z</sub> = −Σ e F − Σ F ds/dφ", "", "",
         Text::tr("due to the offset axes and the reaction to the torque on the crank")});
    if (input.rod) {
        list.push_back(
            {Text::tr("Rod as a rigid body"), "ΔJ = J − m c (L − c)", "", "",
             Text::tr(
                 "difference of its inertia from two masses; acts on roll moment and torque")});
    }
    add_weights(list, input);
    return list;
}

std::span<const Text> left_out() {
    static constexpr std::array texts{
        Text::tr("The engine is rigid, and the crank turns at constant speed."),
        Text::tr(
            "Gas forces act inside the engine, outside only as torque; they have the half orders."),
        Text::tr(
            "All cylinders have the same masses, crank radius and rod, except articulated rods."),
        Text::tr("The inertia of a master rod's big end beyond the mass at its knuckle pins is "
                 "neglected."),
    };
    return texts;
}

}  // namespace ravnoves::inertia_moments

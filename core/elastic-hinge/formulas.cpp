#include "elastic-hinge/results.h"

#include <array>

namespace ravnoves::elastic_hinge {

namespace {

constexpr std::string_view zotov_sviridov = "zotov-sviridov";

void add_rod_hinge(std::vector<Formula>& list, const Input& input) {
    list.push_back({Text::tr("Angle of the rod"),
                    input.kinematics == Kinematics::exact
                        ? "sin ψ = λ sin φ"
                        : "cos ψ ≈ 1 − λ<sup>2</sup>/4 + (λ<sup>2</sup>/4) cos 2φ",
                    zotov_sviridov, "", Text::tr("λ = r/ℓ, ℓ length of the rod")});
    list.push_back(
        {Text::tr("Moment on the rod that makes the side force zero"),
         "M<sub>12</sub> = P<sub>3</sub>h<sub>1</sub> + (P<sub>3</sub>/g) a<sub>B</sub> "
         "h<sub>2</sub> + I<sub>2</sub>ε<sub>2</sub> + (P<sub>2</sub>/g) (a<sub>Cy</sub> "
         "h<sub>3</sub> + a<sub>Cx</sub> h<sub>4</sub>) + P<sub>2</sub>h<sub>3</sub>",
         zotov_sviridov, "(4)",
         Text::tr("h₁ = ℓ cos ψ, h₂ = ℓ sin ψ, h₃ = h₁/2, h₄ = ½ r sin φ, I₂ = (P₂/g) ℓ²/12, "
                  "ε₂ = −d²ψ/dt²; a acceleration, B slider pin, C middle of the rod")});
    if (input.rod_counterweight) {
        list.push_back({Text::tr("Part of the counterweight in M₁₂"),
                        input.rod_counterweight->inertia == CounterweightInertia::newton_euler
                            ? "−P<sub>4</sub>h<sub>5</sub> − (P<sub>4</sub>/g) (a<sub>4x</sub> "
                              "h<sub>6</sub> + "
                              "a<sub>4y</sub> h<sub>5</sub>)"
                            : "−P<sub>4</sub>h<sub>5</sub> + (P<sub>4</sub>/g) (a<sub>4x</sub> "
                              "h<sub>6</sub> + "
                              "a<sub>4y</sub> h<sub>5</sub>)",
                        zotov_sviridov, "(9)",
                        Text::tr("h₅ = ℓ₂ cos ψ, h₆ = ℓ₂ sin ψ, a acceleration; the paper prints "
                                 "+ before both inertia terms, correct is −")});
        list.push_back({Text::tr("Counterweight"),
                        "P<sub>4</sub> ℓ<sub>2</sub> = (P<sub>3</sub> + P<sub>2</sub>/2) ℓ",
                        zotov_sviridov, "(10)",
                        Text::tr("P₄ weight at the distance ℓ₂ beyond the crankpin: the mean of "
                                 "M₁₂ over a turn is zero")});
    }
    list.push_back({Text::tr("Potential part of M₁₂"),
                    "M<sub>12</sub> − (1/2π) ∮ M<sub>12</sub> dφ", zotov_sviridov, "(5)"});
    list.push_back({Text::tr("Side force with the rod's hinge"),
                    "−∮ M<sub>12</sub> dφ / (2π ℓ cos ψ)", zotov_sviridov, "(6)"});
    list.push_back({Text::tr("Side force without the hinge"), "−M<sub>12</sub> / (ℓ cos ψ)",
                    zotov_sviridov, "(7)"});
    list.push_back({Text::tr("Moment on the crank with the rod's hinge"),
                    "M<sub>1</sub> = M + (M<sub>12</sub> − (1/2π) ∮ M<sub>12</sub> dφ) "
                    "(1 + λ cos φ / cos ψ)",
                    zotov_sviridov, input.rod_counterweight ? "(11)" : "(8)",
                    Text::tr("by virtual power; the paper prints a factor ½ that does not belong "
                             "to M₁₂")});
}

}  // namespace

std::vector<Formula> formulas(const Input& input) {
    const bool compressed = input.spring.value_or(Spring{}).branch() == Branch::compressed;
    std::vector<Formula> list;
    list.push_back(
        {Text::tr("Moment that keeps the crank's speed"),
         input.rod_counterweight
             ? "M = d(T + V)/dφ = ½ (ω<sup>2</sup> dI/dφ + r (P<sub>1</sub> + P<sub>2</sub>) "
               "cos φ) + P<sub>4</sub> (r + λ ℓ<sub>2</sub>) cos φ"
             : "M = d(T + V)/dφ = ½ (ω<sup>2</sup> dI/dφ + r (P<sub>1</sub> + P<sub>2</sub>) "
               "cos φ)",
         zotov_sviridov, "[13]",
         Text::tr("T kinetic and V potential energy, I reduced inertia, P₁ and P₂ weights of "
                  "crank and rod, φ crank angle from the slider line")});
    list.push_back({Text::tr("Energy of the spring"),
                    input.guide_sign == GuideSign::energy
                        ? "Π = ½ c (ℓ<sub>0</sub> − 2ρ)<sup>2</sup> = const − (T + V)"
                        : "Π = ½ c (ℓ<sub>0</sub> − 2ρ)<sup>2</sup> = const + (T + V)",
                    zotov_sviridov, "(1)",
                    Text::tr("c stiffness, ℓ₀ free length, ρ polar radius of the guide; the paper "
                             "prints +, only − keeps the speed")});
    list.push_back({Text::tr("Guide"),
                    compressed ? "ρ = ℓ<sub>0</sub>/2 − √(ℓ<sub>0</sub><sup>2</sup>/4 − B)"
                               : "ρ = ℓ<sub>0</sub>/2 + √(ℓ<sub>0</sub><sup>2</sup>/4 − B)",
                    zotov_sviridov, "(3)",
                    Text::tr("B = ℓ₀²/4 − Π/(2c): − of a compressed spring, + of "
                             "a stretched one")});
    if (input.guide_sign == GuideSign::energy) {
        list.push_back(
            {Text::tr("Minimum preload"),
             "|ℓ<sub>0</sub>/2 − ρ<sub>0</sub>| ≥ √( max(T + V − T<sub>0</sub> − "
             "V<sub>0</sub>) / 2c )",
             "", "",
             Text::tr("the spring must store the energy that the mechanism absorbs; 0: at φ = 0")});
    }
    list.push_back({Text::tr("Moment due to a profile error"),
                    "|ΔM| ≤ 4cε √(ρ′<sup>2</sup> + n<sup>2</sup> (ℓ<sub>0</sub>/2 − "
                    "ρ)<sup>2</sup>) + 2cnε<sup>2</sup>",
                    "", "", Text::tr("ε amplitude, n waves in a turn")});
    add_rod_hinge(list, input);
    list.push_back(
        {Text::tr("Motion"),
         "I d<sup>2</sup>φ/dt<sup>2</sup> + ½ I′ (dφ/dt)<sup>2</sup> + V′ + Π′ = M<sub>c</sub>", "",
         "",
         Text::tr("solved by the energy at every angle; ′ by φ, on the right the "
                  "constant moment on the crank")});
    return list;
}

std::span<const Text> left_out() {
    static constexpr std::array texts{
        Text::tr("Friction, and play in the joints."),
        Text::tr("The mass of springs and rollers, and the inertia of the hinges themselves."),
        Text::tr("Gas forces on the slider."),
    };
    return texts;
}

}  // namespace ravnoves::elastic_hinge

#include "bob-weights/results.h"

#include "bob-weights/factor_theory.h"
#include "shop/balance_grade.h"

namespace ravnoves::bob_weights {

std::vector<Formula> formulas(const Input& input) {
    const bool pair = is_pair(input.engine);
    std::vector<Formula> list;
    list.push_back({Text::tr("Masses of one cylinder"),
                    "m<sub>j</sub> = m<sub>1</sub> + m<sub>2</sub> + m<sub>3</sub> + "
                    "m<sub>4</sub> + m<sub>5</sub>, m<sub>r</sub> = m<sub>6</sub> + m<sub>7</sub>",
                    "", "",
                    Text::tr("mⱼ reciprocating, mᵣ rotating mass; m₁ rings, m₂ piston, m₃ pin, m₄ "
                             "locks, m₅ small end, m₆ big end, m₇ shells")});
    list.push_back({Text::tr("First-order force of a piston"),
                    "m<sub>j</sub> r ω<sup>2</sup> cos(ψ − β) e<sup>iβ</sup> = ½ m<sub>j</sub> r "
                    "ω<sup>2</sup> (e<sup>iψ</sup> + e<sup>2iβ</sup> e<sup>−iψ</sup>)",
                    "chainov-vallejo-maldonado", "",
                    Text::tr("β direction of the cylinder, ψ of its crankpin: one half turns with "
                             "the crank, one against it")});
    list.push_back(
        {Text::tr("Residual after the counterweights"),
         pair ? "m<sub>j</sub> r ω<sup>2</sup> [(1 − 2F) cos(δ/2) e<sup>iφ</sup> + cos(γ + δ/2) "
                "e<sup>−iφ</sup>]"
              : "½ m<sub>j</sub> r ω<sup>2</sup> [(1 − 2F) e<sup>iφ</sup> + e<sup>−iφ</sup>]",
         "", "",
         Text::tr("of the cylinders of a throw; F factor with overbalance, γ bank angle, δ split "
                  "of the crankpins, φ direction of the throw from the middle of the banks")});
    list.push_back(
        {Text::tr("Balance factor by theory"),
         input.engine.pin_split == 0.0 ? "F = ½" : "F = ½ [1 − |cos(γ + δ/2)| / cos(δ/2)]"});
    list.push_back({Text::tr("Bob weight"),
                    "B = m<sub>m</sub> + n [m<sub>r</sub> + F m<sub>j</sub>]", "", "",
                    Text::tr("n rods on it, mₘ oil in the crankpin")});
    if (input.correction) {
        list.push_back({Text::tr("Readings transferred to the planes"),
                        "U<sub>1</sub> + U<sub>2</sub> = A + B, z<sub>1</sub>U<sub>1</sub> + "
                        "z<sub>2</sub>U<sub>2</sub> = aA + bB",
                        "", "",
                        Text::tr("A, B vectors read at a, b; U₁, U₂ in the planes at z₁, z₂: same "
                                 "force, same moment")});
        list.push_back(
            {Text::tr("Unbalance that a hole takes off"),
             "u = ρ (πd<sup>2</sup>/4) [h (R − h/2) + (c/3) (R − h − c/4)], c = (d/2) / tan(σ/2)",
             "", "",
             Text::tr("R radius of the rim, d diameter, h depth of the full diameter, σ angle of "
                      "the point, ρ density")});
        if (input.correction->slug) {
            list.push_back({Text::tr("Unbalance that a slug adds"),
                            "u<sub>s</sub> = ρ<sub>s</sub> (πd<sup>2</sup>/4) h (R − h/2) − u", "",
                            "",
                            Text::tr("ρₛ density of the slug, h its length, u unbalance of its "
                                     "hole; the cone below is empty")});
        }
    }
    if (input.tolerance && input.tolerance->by_grade) {
        list.push_back(shop::permissible_unbalance_formula());
    }
    return list;
}

}  // namespace ravnoves::bob_weights

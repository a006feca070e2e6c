#include "v8-plugs/results.h"

namespace ravnoves::v8_plugs {

namespace {

constexpr std::string_view nazarov = "nazarov";

void add_bob_weights(std::vector<Formula>& list, bool repair) {
    const auto weight = [&](const Text& name, std::string_view html, std::string_view equation) {
        list.push_back({name, html, nazarov, equation,
                        Text::tr("mⱼ and m_R nominal reciprocating and rotating mass, mₘ oil, k_m "
                                 "its coefficient")});
    };
    weight(Text::tr("Bob weight, steel plugs"),
           repair ? "m<sub>r</sub> = m<sub>j</sub> + Δm<sub>p</sub> + Δm<sub>rp</sub> + 2 "
                    "[m<sub>R</sub> + (m<sub>s</sub> − Δm) k<sub>p</sub>] + (2 + k<sub>r</sub>) "
                    "Δm<sub>b</sub> + Δm<sub>sh</sub> + m<sub>m</sub>k<sub>m</sub>"
                  : "m<sub>r</sub> = m<sub>j</sub> + Δm<sub>p</sub> + 2 [m<sub>R</sub> + "
                    "(m<sub>s</sub> − Δm) k<sub>p</sub>] + (2 + k<sub>r</sub>) Δm<sub>b</sub> + "
                    "m<sub>m</sub>k<sub>m</sub>",
           repair ? "(5)" : "(4)");
    weight(Text::tr("Bob weight, aluminium plugs"),
           repair ? "m<sub>r</sub> = m<sub>j</sub> + Δm<sub>p</sub> + Δm<sub>rp</sub> + 2 "
                    "[m<sub>R</sub> + (m<sub>a</sub> − Δm) k<sub>p</sub>] + (2 + k<sub>r</sub>) "
                    "Δm<sub>b</sub> + Δm<sub>sh</sub> + m<sub>m</sub>k<sub>m</sub>"
                  : "m<sub>r</sub> = m<sub>j</sub> + Δm<sub>p</sub> + 2 [m<sub>R</sub> + "
                    "(m<sub>a</sub> − Δm) k<sub>p</sub>] + (2 + k<sub>r</sub>) Δm<sub>b</sub> + "
                    "m<sub>m</sub>k<sub>m</sub>",
           repair ? "(8)" : "(7)");
}

}  // namespace

std::vector<Formula> formulas(const Input& input) {
    const bool repair = input.process == Process::repair;
    std::vector<Formula> list;
    list.push_back({Text::tr("Coefficients"),
                    "k<sub>p</sub> = r<sub>p</sub>/r, k<sub>u</sub> = 2 r<sub>p</sub>/r, "
                    "k<sub>un</sub> = 2 r<sub>pn</sub>/r",
                    nazarov, "(11)",
                    Text::tr("r crank radius, rₚ and rₚₙ distance of the centre of mass of the "
                             "present and the new plug from the crank axis")});
    list.push_back(
        {Text::tr("Excess on the crankpin axis"),
         repair ? "Δm<sub>u</sub> = Δm<sub>p</sub> + (2 + k<sub>r</sub>) Δm<sub>b</sub> + "
                  "Δm<sub>rp</sub> + Δm<sub>sh</sub>"
                : "Δm<sub>u</sub> = Δm<sub>p</sub> + (2 + k<sub>r</sub>) Δm<sub>b</sub>",
         nazarov, repair ? "(3), (5)" : "(3), (4)",
         Text::tr("Δmₚ piston, Δm_b big end of the rod, in repair Δm_rp repair piston with rings "
                  "and Δm_sh repair shells; kᵣ coefficient of the rod")});
    list.push_back({Text::tr("Lightening of each plug"), "Δm = Δm<sub>u</sub> / k<sub>u</sub>",
                    nazarov, "(3), (18)"});
    list.push_back({Text::tr("Aluminium in place of steel plugs"),
                    "k<sub>u</sub> (m<sub>s</sub> − m<sub>a</sub>)", nazarov, "(12), (15)",
                    Text::tr("constant part; mₛ and mₐ mass of a plug of steel and of "
                             "aluminium")});
    if (input.crankshaft != Crankshaft::standard) {
        list.push_back({Text::tr("Crankshaft made for new plugs, present plugs fitted"),
                        "k<sub>un</sub> m<sub>sn</sub> − k<sub>u</sub> m<sub>s</sub>, "
                        "k<sub>un</sub> m<sub>sn</sub> − k<sub>u</sub> m<sub>a</sub>",
                        nazarov, "(13), (14), (16), (17)",
                        Text::tr("constant parts with plugs of steel and of aluminium; "
                                 "mₛₙ mass of a new steel plug")});
    }
    list.push_back(
        {Text::tr("Compensated by an option"), "C<sub>i</sub> + k<sub>u</sub> Δm<sub>i</sub>",
         nazarov, "(15)–(22)",
         Text::tr("Cᵢ its constant part, Δmᵢ lightening of each plug, up to the limit of its "
                  "wall")});
    add_bob_weights(list, repair);
    list.push_back({Text::tr("Residual due to the shift of the centre of mass"), "U = 2 Δm d", "",
                    "",
                    Text::tr("d distance of the bored metal from the centre of mass of the plug")});
    return list;
}

}  // namespace ravnoves::v8_plugs

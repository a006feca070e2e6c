#include "bibliography/bibliography.h"

#include <algorithm>
#include <array>

#include "numerics/demand.h"

namespace ravnoves {

namespace {

constexpr std::array<Source, 8> sources{{
    {"gots-klevtsov", "Gots, Klevtsov", "A. N. Gots, V. S. Klevtsov",
     "Selection of the optimal scheme of stabilization of the one-cylinder engine", "", 0, "", ""},
    {"zotov-sviridov", "Zotov, Sviridov", "A. N. Zotov, A. S. Sviridov",
     "Crank-and-rod mechanism with elastic hinges of given characteristics",
     "Problemy mashinostroeniya i nadezhnosti mashin, no. 5", 2021, "14–22", ""},
    {"nazarov", "Nazarov", "A. D. Nazarov",
     "Compensating the total unbalanced mass of crank-gear parts of V-8 engines in manufacture and "
     "repair",
     "", 0, "", ""},
    {"chainov-vallejo-maldonado", "Chainov, Vallejo Maldonado",
     "N. D. Chainov, P. R. Vallejo Maldonado",
     "Balancing the moments of a VR5 engine taking into account a desaxial crank mechanism and "
     "cylinder camber angle",
     "Izvestiya vysshikh uchebnykh zavedeniy. Mashinostroenie, no. 5", 2020, "41–49",
     "10.18698/0536-1044-2020-5-41-49"},
    {"iso-68-1", "ISO 68-1", "ISO", "ISO general purpose screw threads: basic profile, metric",
     "ISO 68-1", 0, "", ""},
    {"iso-724", "ISO 724", "ISO", "ISO general-purpose metric screw threads: basic dimensions",
     "ISO 724", 0, "", ""},
    {"iso-21940-11", "ISO 21940-11", "ISO",
     "Mechanical vibration, rotor balancing: procedures and tolerances for rotors with rigid "
     "behaviour",
     "ISO 21940-11", 0, "", ""},
    {"iso-80000-3", "ISO 80000-3", "ISO", "Quantities and units: space and time", "ISO 80000-3", 0,
     "", ""},
}};

}  // namespace

std::span<const Source> bibliography() {
    return sources;
}

const Source& source(std::string_view key) {
    const auto found = std::find_if(sources.begin(), sources.end(),
                                    [&](const Source& entry) { return entry.key == key; });
    RAVNOVES_DEMAND(found != sources.end(), "the bibliography holds " + std::string(key));
    return *found;
}

std::string citation(const Source& source) {
    std::string text = std::string(source.authors) + ", \"" + std::string(source.title) + "\"";
    if (source.year != 0) {
        text += ", " + std::to_string(source.year);
    }
    return text;
}

}  // namespace ravnoves

#include "bibliography/bibliography.h"

#include <algorithm>
#include <iterator>

#include "numerics/demand.h"

namespace ravnoves {

namespace {

/// Standards are cited in English in every language.
constexpr Source standard(std::string_view key, const char* number, const char* title) {
    return {key, {"", number}, {"", "ISO"}, {"", title}, number, 0, 0, "", ""};
}

constexpr Source sources[] = {
    {"gots-klevtsov", CORE_TEXT("core", "Gots, Klevtsov"),
     CORE_TEXT("core", "A. N. Gots, V. S. Klevtsov"),
     CORE_TEXT("core",
               "Selection of the optimal scheme of stabilization of the one-cylinder engine"),
     "", 0, 2020, "", ""},
    {"zotov-sviridov", CORE_TEXT("core", "Zotov, Sviridov"),
     CORE_TEXT("core", "A. N. Zotov, A. S. Sviridov"),
     CORE_TEXT("core", "Crank-and-rod mechanism with elastic hinges of given characteristics"),
     "Problemy mashinostroeniya i nadezhnosti mashin, no. 5", 2021, 0, "14–22", ""},
    {"nazarov", CORE_TEXT("core", "Nazarov"), CORE_TEXT("core", "A. D. Nazarov"),
     CORE_TEXT("core",
               "Compensating the total unbalanced mass of crank-gear parts of V-8 engines in "
               "manufacture and repair"),
     "", 0, 2007, "", ""},
    {"chainov-vallejo-maldonado", CORE_TEXT("core", "Chainov, Vallejo Maldonado"),
     CORE_TEXT("core", "N. D. Chainov, P. R. Vallejo Maldonado"),
     CORE_TEXT("core",
               "Balancing the moments of a VR5 engine taking into account a desaxial crank "
               "mechanism and cylinder camber angle"),
     "Izvestiya vysshikh uchebnykh zavedeniy. Mashinostroenie, no. 5", 2020, 0, "41–49",
     "10.18698/0536-1044-2020-5-41-49"},
    {"shigley",
     {"", "Budynas, Nisbett"},
     {"", "R. G. Budynas, J. K. Nisbett"},
     {"", "Shigley's Mechanical Engineering Design, 10th edition, McGraw-Hill"},
     "",
     2015,
     0,
     "",
     ""},
    {"en-10083-2",
     {"", "EN 10083-2"},
     {"", "CEN"},
     {"", "Steels for quenching and tempering: technical delivery conditions for non alloy steels"},
     "EN 10083-2",
     2006,
     0,
     "",
     ""},
    standard("iso-68-1", "ISO 68-1", "ISO general purpose screw threads: basic profile, metric"),
    standard("iso-724", "ISO 724", "ISO general-purpose metric screw threads: basic dimensions"),
    standard("iso-21940-11", "ISO 21940-11",
             "Mechanical vibration, rotor balancing: procedures and tolerances for rotors with "
             "rigid behaviour"),
    standard("iso-80000-3", "ISO 80000-3", "Quantities and units: space and time"),
};

}  // namespace

std::span<const Source> bibliography() {
    return sources;
}

const Source& source(std::string_view key) {
    const auto found = std::find_if(std::begin(sources), std::end(sources),
                                    [&](const Source& entry) { return entry.key == key; });
    RAVNOVES_DEMAND(found != std::end(sources), "the bibliography holds " + std::string(key));
    return *found;
}

Message citation(const Source& source) {
    if (source.year != 0) {
        return {CORE_TEXT("core", "%1, \"%2\", %3"), source.authors, source.title, source.year};
    }
    if (source.not_before != 0) {
        return {CORE_TEXT("core",
                          "%1, \"%2\", not before %3 (the copy at hand shows neither journal nor "
                          "year)"),
                source.authors, source.title, source.not_before};
    }
    return {CORE_TEXT("core", "%1, \"%2\""), source.authors, source.title};
}

}  // namespace ravnoves

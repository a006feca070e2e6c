#include "bibliography/bibliography.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "numerics/demand.h"

namespace ravnoves {

namespace {

/// Books and papers that no language but English has; standards are cited so in every language.
constexpr Source in_english(std::string_view key, const char* cited_as, const char* authors,
                            const char* title, const char* journal, int year,
                            std::string_view pages = "", const char* doi = "") {
    return {key, {"", cited_as}, {"", authors}, {"", title}, {"", journal}, year, pages, doi};
}
constexpr Source standard(std::string_view key, const char* number, int year, const char* title) {
    return in_english(key, number, "ISO", title, number, year);
}

constexpr Source sources[] = {
    {"gots-klevtsov",
     CORE_TEXT("core", "Gots, Klevtsov"),
     CORE_TEXT("core", "A. N. Gots, V. S. Klevtsov"),
     CORE_TEXT("core",
               "Selection of the optimal scheme of stabilization of the one-cylinder engine"),
     {},
     2020,
     "",
     ""},
    {"zotov-sviridov", CORE_TEXT("core", "Zotov, Sviridov"),
     CORE_TEXT("core", "A. N. Zotov, A. S. Sviridov"),
     CORE_TEXT("core", "Crank-and-rod mechanism with elastic hinges of given characteristics"),
     CORE_TEXT("core", "Problemy mashinostroeniya i nadezhnosti mashin, no. 5"), 2021, "14–22", ""},
    {"nazarov",
     CORE_TEXT("core", "Nazarov"),
     CORE_TEXT("core", "A. D. Nazarov"),
     CORE_TEXT("core",
               "Compensating the total unbalanced mass of crank-gear parts of V-8 engines in "
               "manufacture and repair"),
     {},
     2007,
     "",
     ""},
    {"chainov-vallejo-maldonado", CORE_TEXT("core", "Chainov, Vallejo Maldonado"),
     CORE_TEXT("core", "N. D. Chainov, P. R. Vallejo Maldonado"),
     CORE_TEXT("core",
               "Balancing the moments of a VR5 engine taking into account a desaxial crank "
               "mechanism and cylinder camber angle"),
     CORE_TEXT("core", "Izvestiya vysshikh uchebnykh zavedeniy. Mashinostroenie, no. 5"), 2020,
     "41–49", "10.18698/0536-1044-2020-5-41-49"},
    in_english("hairer-norsett-wanner", "Hairer, Nørsett, Wanner",
               "E. Hairer, S. P. Nørsett, G. Wanner",
               "Solving Ordinary Differential Equations I: Nonstiff Problems",
               "2nd edition, Springer", 1993),
    in_english("salmon", "Salmon et al.", "J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw",
               "Parallel random numbers: as easy as 1, 2, 3", "Proceedings of SC11", 2011, "",
               "10.1145/2063384.2063405"),
    in_english("burley", "Burley", "B. Burley", "Practical Hash-based Owen Scrambling",
               "Journal of Computer Graphics Techniques, vol. 9, no. 4", 2020, "1–20"),
    in_english("fips-180-4", "FIPS 180-4", "NIST", "Secure Hash Standard", "FIPS 180-4", 2015),
    standard("iso-68-1", "ISO 68-1", 1998,
             "ISO general purpose screw threads: basic profile, metric"),
    standard("iso-724", "ISO 724", 1993,
             "ISO general-purpose metric screw threads: basic dimensions"),
    standard("iso-21940-11", "ISO 21940-11", 2016,
             "Mechanical vibration, rotor balancing: procedures and tolerances for rotors with "
             "rigid behaviour"),
    standard("iso-80000-3", "ISO 80000-3", 2006, "Quantities and units: space and time"),
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
    if (source.journal.empty()) {
        return {CORE_TEXT("core", "%1, \"%2\", %3 or later"), source.authors, source.title,
                source.year};
    }
    Message line{CORE_TEXT("core", "%1, \"%2\", %3, %4"), source.authors, source.title,
                 source.journal, source.year};
    if (!source.pages.empty()) {
        line = joined(std::move(line), {CORE_TEXT("core", "pp. %1"), source.pages});
    }
    if (const Text doi{"", source.doi}; !doi.empty()) {
        line = joined(std::move(line), {Text{"", "DOI %1"}, doi});
    }
    return line;
}

}  // namespace ravnoves

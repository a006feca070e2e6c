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
    return {key, {cited_as}, {authors}, {title}, {journal}, year, pages, doi};
}
constexpr Source standard(std::string_view key, const char* number, int year, const char* title) {
    return in_english(key, number, "ISO", title, number, year);
}

constexpr Source sources[] = {
    {"gots-klevtsov",
     Text::tr("Gots, Klevtsov"),
     Text::tr("A. N. Gots, V. S. Klevtsov"),
     Text::tr("Selection of the optimal scheme of stabilization of the one-cylinder engine"),
     {},
     2020,
     "",
     ""},
    {"zotov-sviridov", Text::tr("Zotov, Sviridov"), Text::tr("A. N. Zotov, A. S. Sviridov"),
     Text::tr("Crank-and-rod mechanism with elastic hinges of given characteristics"),
     Text::tr("Problemy mashinostroeniya i nadezhnosti mashin, no. 5"), 2021, "14–22", ""},
    {"nazarov",
     Text::tr("Nazarov"),
     Text::tr("A. D. Nazarov"),
     Text::tr("Compensating the total unbalanced mass of crank-gear parts of V-8 engines in "
              "manufacture and repair"),
     {},
     2007,
     "",
     ""},
    {"chainov-vallejo-maldonado", Text::tr("Chainov, Vallejo Maldonado"),
     Text::tr("N. D. Chainov, P. R. Vallejo Maldonado"),
     Text::tr("Balancing the moments of a VR5 engine taking into account a desaxial crank "
              "mechanism and cylinder camber angle"),
     Text::tr("Izvestiya vysshikh uchebnykh zavedeniy. Mashinostroenie, no. 5"), 2020, "41–49",
     "10.18698/0536-1044-2020-5-41-49"},
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

const Source& source(std::string_view key) {
    const auto found = std::find_if(std::begin(sources), std::end(sources),
                                    [&](const Source& entry) { return entry.key == key; });
    RAVNOVES_DEMAND(found != std::end(sources), "the bibliography holds " + std::string(key));
    return *found;
}

Message citation(const Source& source) {
    if (source.journal.empty()) {
        return {Text::tr("%1, \"%2\", %3 or later"), source.authors, source.title, source.year};
    }
    Message line{Text::tr("%1, \"%2\", %3, %4"), source.authors, source.title, source.journal,
                 source.year};
    if (!source.pages.empty()) {
        line = joined(std::move(line), {Text::tr("pp. %1"), source.pages});
    }
    if (const Text doi{source.doi}; !doi.empty()) {
        line = joined(std::move(line), {Text{"DOI %1"}, doi});
    }
    return line;
}

}  // namespace ravnoves

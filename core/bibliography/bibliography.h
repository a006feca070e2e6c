#pragma once

#include <string_view>

#include "case-file/message.h"

namespace ravnoves {

/// A source of the program. Comments cite it by its key in brackets: [nazarov]. Unknown parts
/// (journal, year) are empty.
struct Source {
    std::string_view key;    ///< "gots-klevtsov"
    Text cited_as;           ///< "Gots, Klevtsov"
    Text authors;            ///< "A. N. Gots, V. S. Klevtsov"; of a standard who issues it
    Text title;              ///< in English
    Text journal;            ///< with its number; a book's publisher; the standard's number
    int year = 0;            ///< without a journal the year of the newest source it cites
    std::string_view pages;  ///< "14–22"
    const char* doi = "";
};

/// The source of that key, which must be there.
const Source& source(std::string_view key);

/// A source in one line: `A. Author, "Title", Journal, no. 5, 2021, pp. 14–22, DOI 10.1/2`. Without
/// a journal: `A. Author, "Title", 2021 or later`.
Message citation(const Source& source);

}  // namespace ravnoves

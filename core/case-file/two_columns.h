#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/range.h"

namespace ravnoves {

/// A table of two columns of numbers as it stands in a text.
struct TwoColumns {
    char separator = '\t';    ///< between the columns: comma, semicolon, tab or blank
    bool has_header = false;  ///< the first line held words
    bool decimal_comma = false;
    std::string header;             ///< the lines of words above the rows, each with its line feed
    std::vector<double> first;      ///< column
    std::vector<double> second;     ///< column, as many
    std::vector<std::size_t> line;  ///< of the text, from 1, that each row stands in
};

/// What a table of two columns must be.
struct TwoColumnsRule {
    Message first;   ///< what the column holds, for messages: "crank angle"
    Message second;  ///< "torque"
    Range first_range;
    std::size_t most_rows;
};

/// Reads CSV text or what a spreadsheet puts on the clipboard.
///
/// Two columns separated by semicolon, tab, comma or blanks; decimal point or comma; header lines
/// (two at most), empty lines, a byte-order mark and lines that begin with '#' are passed over.
/// Further columns are refused.
/// @throws InputError that names line and column ("line 4, column 2")
TwoColumns read_two_columns(std::string_view text, const TwoColumnsRule& rule);

}  // namespace ravnoves

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/range.h"

namespace ravnoves {

/// The layout of a table of numbers; empty members are found from the lines.
struct TableLayout {
    std::optional<char> separator;  ///< comma, semicolon, tab, or blank for any run of blanks
    std::optional<bool> decimal_comma;
    std::optional<std::size_t> header_lines;  ///< above the rows; empty lines and comments are none
    bool operator==(const TableLayout&) const = default;
};

/// What the first lines of a table show.
struct TableView {
    char separator = '\t';
    std::size_t header_lines = 0;
    std::size_t columns = 0;            ///< of the first row
    std::string header;                 ///< the lines of words, each with its line feed
    std::vector<std::string> headings;  ///< of the columns; empty where the words do not fit them
    std::vector<std::vector<std::string>> rows;  ///< the first ones, unchanged
};

/// Looks at the first lines: header lines (any number), comments (#), a byte-order mark, the
/// separator that divides the rows into the same number of columns.
/// @param decided  already known
/// @param rows     of TableView::rows
TableView look_at_table(std::string_view text, const TableLayout& decided = {},
                        std::size_t rows = 0);

/// All columns of a text's rows as numbers, NaN for anything else; at most that many rows.
std::vector<std::vector<double>> number_columns(std::string_view text, const TableView& view,
                                                std::size_t max_rows);

/// In place of a first column: the rows are counted from 0.
inline constexpr std::size_t row_number = static_cast<std::size_t>(-1);

/// Two columns of a table.
struct TwoColumns {
    TableView view;
    bool decimal_comma = false;
    std::array<std::size_t, 2> column{};  ///< which they are, from 0
    std::vector<double> first;
    std::vector<double> second;     ///< as many
    std::vector<std::size_t> line;  ///< of the text, from 1, that each row is in

    /// The words above a column; where they do not fit the columns, the whole header.
    const std::string& heading(std::size_t which) const;
    Message place(std::size_t row, std::size_t which) const;  ///< "line 4, column 2"
};

/// What the columns must be.
struct TwoColumnsRule {
    Message first;   ///< name of the column, for messages: "crank angle"
    Message second;  ///< "torque"
    Range first_range;
};

/// Reads CSV text or the clipboard of a spreadsheet.
///
/// Columns separated by semicolon, tab, comma or blanks; decimal point or comma; header lines,
/// empty lines, a byte-order mark and lines that begin with '#' are passed over.
/// @param columns  numbers from 1, or headings; both empty: the table has two. The first may be 0:
///                 no column, the rows are counted.
/// @throws InputError that names line and column ("line 4, column 2")
TwoColumns read_two_columns(std::string_view text, const TwoColumnsRule& rule,
                            const TableLayout& layout = {},
                            const std::array<std::string, 2>& columns = {});

}  // namespace ravnoves

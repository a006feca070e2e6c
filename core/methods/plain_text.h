#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ravnoves::methods {

/// One line of a CSV file (RFC 4180, but a line feed alone at its end): fields with a comma, a
/// quote or a line feed are quoted.
std::string csv_line(const std::vector<std::string>& fields);

/// How many characters a terminal shows for UTF-8 text: code points, combining marks left out.
std::size_t shown_width(std::string_view text);

/// Text wrapped between words to `width` characters: the mark, then lines indented by its width.
std::string hanging(const std::string& mark, const std::string& text, std::size_t width);

/// A table in aligned text.
class AlignedTable {
  public:
    struct Column {
        std::string title;
        bool right = false;  ///< numbers are aligned at their end
    };
    explicit AlignedTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

    /// @param cells  one for each column
    void add(std::vector<std::string> cells);
    /// A line of its own, over all columns.
    void heading(std::string text);
    /// The table with its header underlined. The last column is wrapped between words so that lines
    /// stay within `width` characters where the other columns leave it at least 20.
    std::string text(std::size_t width) const;

  private:
    std::vector<Column> columns_;
    std::vector<std::vector<std::string>> lines_;  ///< one cell alone is a heading
};

}  // namespace ravnoves::methods

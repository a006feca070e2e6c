#include "case-file/two_columns.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves {

namespace {

/// In small letters, without signs, blanks and quotes.
std::string word_of(std::string_view text) {
    std::string word;
    for (const char c : text) {
        if (c != '"' && c != '-' && c != '+' && c != ' ') {
            word += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
        }
    }
    return word;
}

bool is_not_a_number_word(std::string_view text) {
    const std::string word = word_of(text);
    return word.starts_with("nan") || word.starts_with("inf") || word.starts_with("#n/a");
}

/// What was there, for a message: of a file that may be no table only what can be a number is
/// said. The file's name may be in a case that somebody else wrote.
Message found(std::string_view text, bool is_table) {
    const bool is_number =
        text.size() < 40 && text.find_first_not_of("0123456789+-.,eE \t") == std::string_view::npos;
    const std::string word = word_of(text);
    const bool is_none = word == "nan" || word == "inf" || word == "infinity" || word == "#n/a";
    return is_table || is_number || is_none ? Message(show(Json(text))) : Message();
}

/// Fields of a line; a blank separator represents any run of blanks. Quotes around a field go.
void split(std::string_view line, char separator, std::vector<std::string_view>& fields) {
    fields.clear();
    line = separator == '\t' ? line : trimmed(line);
    while (true) {
        std::size_t end = 0;
        if (!line.empty() && line.front() == '"') {
            end = line.find('"', 1);
            end = end == std::string_view::npos ? 0 : end;
        }
        end = separator == ' ' ? line.find_first_of(" \t", end) : line.find(separator, end);
        std::string_view text = trimmed(line.substr(0, end));
        if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
            text = trimmed(text.substr(1, text.size() - 2));
        }
        fields.push_back(text);
        if (end == std::string_view::npos) {
            break;
        }
        line.remove_prefix(end + 1);
        if (separator == ' ') {
            line = trimmed(line);
        }
    }
    if (fields.size() > 2 && fields.back().empty()) {
        fields.pop_back();  // a separator at the end of the line
    }
}

bool looks_like_number(std::string_view text) {
    text = trimmed(text);
    while (!text.empty() && text.front() == '"') {
        text.remove_prefix(1);
    }
    if (text.empty()) {
        return false;
    }
    const char c = text.front();
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == ',' ||
           text.substr(0, 3) == "\xE2\x88\x92";
}

/// Goes through the lines that are neither empty nor comments.
class Lines {
  public:
    explicit Lines(std::string_view text) : text_(text) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (text_.starts_with(byte_order_mark)) {
            text_.remove_prefix(byte_order_mark.size());
        }
    }
    bool next() {
        while (!text_.empty()) {
            ++number_;
            const std::size_t end = text_.find_first_of("\r\n");
            line_ = text_.substr(0, end);
            text_.remove_prefix(end == std::string_view::npos    ? text_.size()
                                : text_.substr(end, 2) == "\r\n" ? end + 2
                                                                 : end + 1);
            const std::string_view words = trimmed(line_);
            if (!words.empty() && words.front() != '#') {
                return true;
            }
        }
        return false;
    }
    std::string_view line() const { return line_; }
    std::size_t number() const { return number_; }  ///< from 1
    void check_text() const {
        const auto bad = std::find_if(line_.begin(), line_.end(), [](char c) {
            const auto byte = static_cast<unsigned char>(c);
            return (byte < 0x20 && c != '\t' && c != '\v' && c != '\f') || byte == 0x7F;
        });
        if (bad != line_.end()) {
            throw InputError(line_place(number_),
                             Text::tr("must be text; this looks like a binary file"));
        }
    }

  private:
    std::string_view text_;
    std::string_view line_;
    std::size_t number_ = 0;
};

constexpr std::array separators{';', '\t', ',', ' '};

/// How much of a line is numbers.
struct RowLook {
    std::size_t columns = 0;
    std::size_t numbers = 0;
    bool is_row() const {
        return columns == 1 ? numbers == 1 : numbers >= 2 && 2 * numbers >= columns;
    }
    double share() const { return static_cast<double>(numbers) / static_cast<double>(columns); }
};

RowLook look_at_row(std::string_view line, char separator) {
    std::vector<std::string_view> fields;
    split(line, separator, fields);
    const auto numbers = std::count_if(fields.begin(), fields.end(), [](std::string_view field) {
        return parse_decimal(field).has_value();
    });
    return {fields.size(), static_cast<std::size_t>(numbers)};
}

/// Where the rows begin by a separator: the first line that is one with its next `more` lines.
struct RowStart {
    std::size_t line;
    RowLook look;
};

std::optional<RowStart> find_rows(const std::vector<std::string_view>& lines, char separator,
                                  std::size_t more, std::size_t fewest_columns) {
    for (std::size_t i = 0; i + more < lines.size(); ++i) {
        const RowLook look = look_at_row(lines[i], separator);
        bool holds = look.is_row() && look.columns >= fewest_columns;
        for (std::size_t k = 1; k <= more && holds; ++k) {
            const RowLook next = look_at_row(lines[i + k], separator);
            holds = next.is_row() && next.columns == look.columns;
        }
        if (holds) {
            return RowStart{i, look};
        }
    }
    return std::nullopt;
}

/// The separator of a line that is no row; what is wrong with it is said as it is read.
char usual_separator(std::string_view line) {
    const auto is_in = [&](char sign) { return line.find(sign) != std::string_view::npos; };
    const auto found = std::ranges::find_if(separators, is_in);
    return found != separators.end() ? *found : ' ';
}

/// What the commas of a column can be.
struct DecimalSigns {
    std::size_t doubtful_line = 0;  ///< of the first "1,893"; 0 where there is none
    std::string_view doubtful;
    bool has_comma = false;
    bool has_point = false;
    bool has_whole = false;   ///< a number without a comma that is no 0
    bool is_decimal = false;  ///< a comma that cannot divide thousands

    void note(std::string_view text, std::size_t line) {
        has_point = has_point || text.find('.') != std::string_view::npos;
        if (text.find(',') == std::string_view::npos) {
            has_whole = has_whole || text.find_first_of("123456789") != std::string_view::npos;
            return;
        }
        has_comma = true;
        if (!may_have_thousands(text)) {
            is_decimal = true;
        } else if (doubtful_line == 0) {
            doubtful_line = line;
            doubtful = text;
        }
    }
};

}  // namespace

TableView look_at_table(std::string_view text, const TableLayout& decided, std::size_t rows) {
    constexpr std::size_t enough = 1000;
    std::vector<std::string_view> lines;
    for (Lines all(text); lines.size() < enough && all.next();) {
        lines.push_back(all.line());
    }
    TableView view;
    std::optional<RowStart> start;
    // Of one column only where there is nothing else.
    for (const auto& [more, fewest] :
         {std::pair(2U, 2U), std::pair(1U, 2U), std::pair(0U, 2U), std::pair(2U, 1U)}) {
        for (const char separator : separators) {
            if (decided.separator && separator != *decided.separator) {
                continue;
            }
            const auto found = find_rows(lines, separator, more, fewest);
            if (found &&
                (!start || found->line < start->line ||
                 (found->line == start->line && found->look.share() > start->look.share()))) {
                start = found;
                view.separator = separator;
            }
        }
        if (start) {
            break;
        }
    }
    std::vector<std::string_view> fields;
    if (start) {
        // A line above that is as long and begins with a number is a row that is wrong.
        const auto is_row_too = [&](std::string_view line) {
            split(line, view.separator, fields);
            return fields.size() == start->look.columns &&
                   (looks_like_number(line) || is_not_a_number_word(line));
        };
        view.header_lines = static_cast<std::size_t>(
            std::find_if(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(start->line),
                         is_row_too) -
            lines.begin());
    } else {
        constexpr std::size_t names_and_units = 2;
        while (view.header_lines < std::min(lines.size(), names_and_units) &&
               !looks_like_number(lines[view.header_lines]) &&
               !is_not_a_number_word(lines[view.header_lines])) {
            ++view.header_lines;
        }
        view.separator = decided.separator.value_or(
            view.header_lines < lines.size() ? usual_separator(lines[view.header_lines]) : '\t');
    }
    view.header_lines = decided.header_lines.value_or(view.header_lines);
    if (view.header_lines < lines.size()) {
        split(lines[view.header_lines], view.separator, fields);
        view.columns = fields.size();
    }
    for (std::size_t i = 0; i < std::min(view.header_lines, lines.size()); ++i) {
        view.header.append(lines[i]).append("\n");
        split(lines[i], view.separator, fields);
        if (fields.size() == view.columns) {
            view.headings.resize(view.columns);
            for (std::size_t column = 0; column < view.columns; ++column) {
                std::string& heading = view.headings[column];
                heading.append(heading.empty() ? "" : " ").append(fields[column]);
            }
        }
    }
    for (std::size_t i = view.header_lines; i < lines.size() && view.rows.size() < rows; ++i) {
        split(lines[i], view.separator, fields);
        view.rows.emplace_back(fields.begin(), fields.end());
    }
    return view;
}

std::vector<std::vector<double>> number_columns(std::string_view text, const TableView& view,
                                                std::size_t max_rows) {
    std::vector<std::vector<double>> columns(view.columns);
    std::vector<std::string_view> fields;
    Lines lines(text);
    for (std::size_t i = 0; i < view.header_lines + max_rows && lines.next(); ++i) {
        if (i < view.header_lines) {
            continue;
        }
        split(lines.line(), view.separator, fields);
        for (std::size_t column = 0; column < columns.size(); ++column) {
            const auto number =
                column < fields.size() ? parse_decimal(fields[column]) : std::nullopt;
            columns[column].push_back(number.value_or(std::nan("")));
        }
    }
    return columns;
}

const std::string& TwoColumns::heading(std::size_t which) const {
    static const std::string none;
    const std::size_t place = column.at(which);
    return place == row_number            ? none
           : place < view.headings.size() ? view.headings[place]
                                          : view.header;
}

Message TwoColumns::place(std::size_t row, std::size_t which) const {
    return column.at(which) == row_number
               ? line_place(line[row])
               : table_place(line[row], static_cast<int>(column.at(which)) + 1);
}

namespace {

/// Which column a case names, from 0.
std::size_t named_column(const std::string& name, const TableView& view) {
    std::size_t number = 0;
    const char* const end = name.data() + name.size();
    if (const auto [stop, fault] = std::from_chars(name.data(), end, number);
        fault == std::errc{} && stop == end) {
        return number == 0 ? row_number : number - 1;
    }
    // The whole heading, or its words in one of the header lines: names are above units.
    const auto place_in = [&](const auto& headings) -> std::optional<std::size_t> {
        const auto found = std::find(headings.begin(), headings.end(), name);
        return found != headings.end() && headings.size() == view.columns
                   ? std::optional<std::size_t>(found - headings.begin())
                   : std::nullopt;
    };
    std::optional<std::size_t> place = place_in(view.headings);
    std::vector<std::string_view> fields;
    for (Lines lines(view.header); !place && lines.next();) {
        split(lines.line(), view.separator, fields);
        place = place_in(fields);
    }
    if (!place) {
        throw InputError("",
                         {Text::tr("must have a column with the heading %1"), quoted_list({name})},
                         view.headings.empty() ? Message() : quoted_list(view.headings));
    }
    return *place;
}

}  // namespace

TwoColumns read_two_columns(std::string_view text, const TwoColumnsRule& rule,
                            const TableLayout& layout, const std::array<std::string, 2>& columns) {
    TwoColumns rows;
    rows.view = look_at_table(text, layout);
    const bool takes_all = columns[0].empty() && columns[1].empty();
    for (std::size_t i = 0; i < 2; ++i) {
        rows.column[i] = takes_all ? i : named_column(columns[i], rows.view);
    }
    if (rows.column[1] == row_number) {
        throw InputError("", Text::tr("must have a column of values: columns are numbered from 1"),
                         Number{0.0});
    }
    const bool counts = rows.column[0] == row_number;
    const std::size_t needed =
        (counts ? rows.column[1] : std::max(rows.column[0], rows.column[1])) + 1;
    std::vector<std::string_view> fields;
    std::array<DecimalSigns, 2> signs;
    const auto any = [&signs](auto which) {
        return static_cast<bool>(signs[0].*which) || static_cast<bool>(signs[1].*which);
    };
    Lines lines(text);
    for (std::size_t i = 0; lines.next(); ++i) {
        lines.check_text();
        if (i < rows.view.header_lines) {
            continue;
        }
        const std::size_t number = lines.number();
        split(lines.line(), rows.view.separator, fields);
        const bool is_first = rows.first.empty();
        if (takes_all && fields.size() == 4 && rows.view.separator == ',' &&
            lines.line().find_first_of("\".") == std::string_view::npos) {
            throw InputError(table_place(number, 1),
                             Text::tr("must not separate columns by commas and use decimal commas "
                                      "at once; separate the columns by semicolons"),
                             found(lines.line(), false));
        }
        if (takes_all ? fields.size() != 2 : fields.size() < needed) {
            throw InputError(
                line_place(number),
                fields.size() > 2 && takes_all
                    ? Message(Text::tr("must have two columns, %1 and %2, or the case must name "
                                       "two of them in \"columns\""),
                              rule.first, rule.second)
                : takes_all
                    ? Message(Text::tr("must have two columns, %1 and %2"), rule.first, rule.second)
                    : Message(Text::tr("must have at least %1 columns"), needed),
                fields.size() == 1 ? found(fields[0], !is_first)
                                   : Message(Text::tr("%1 columns"), fields.size()));
        }
        std::array<double, 2> values{static_cast<double>(rows.first.size()), 0.0};
        for (std::size_t which = counts ? 1 : 0; which < 2; ++which) {
            const std::string_view field = fields[rows.column[which]];
            const Message place = table_place(number, static_cast<int>(rows.column[which]) + 1);
            const auto value = parse_decimal(field);
            if (!value) {
                throw InputError(place, Text::tr("must be a finite number"),
                                 found(field, !is_first));
            }
            values[which] = *value;
            signs[which].note(field, number);
            const bool is_mixed =
                layout.decimal_comma
                    ? field.find(*layout.decimal_comma ? '.' : ',') != std::string_view::npos
                    // "1,893" below 60.30 is 1893 to who wrote it.
                    : any(&DecimalSigns::doubtful_line) && any(&DecimalSigns::has_point);
            if (is_mixed) {
                throw InputError(place,
                                 Text::tr("must have the decimal sign of the numbers above: all "
                                          "points or all commas, and nothing between thousands"),
                                 found(field, true));
            }
        }
        rows.first.push_back(values[0]);
        rows.second.push_back(values[1]);
        rows.line.push_back(number);
        if (!rule.first_range.contains(values[0])) {
            throw InputError(rows.place(rows.first.size() - 1, 0), rule.first_range.message(),
                             Number{values[0]});
        }
    }
    rows.decimal_comma = layout.decimal_comma.value_or(any(&DecimalSigns::has_comma));
    const bool is_known = layout.decimal_comma || any(&DecimalSigns::is_decimal);
    for (std::size_t which = 0; which < 2 && !is_known; ++which) {
        if (const DecimalSigns& seen = signs[which]; seen.doubtful_line != 0 && seen.has_whole) {
            throw InputError(
                table_place(seen.doubtful_line, static_cast<int>(rows.column[which]) + 1),
                Text::tr("must be unambiguous: its comma may divide thousands or be a decimal "
                         "sign, as no other number of the column has one"),
                found(seen.doubtful, true));
        }
    }
    return rows;
}

}  // namespace ravnoves

#include "case-file/two_columns.h"

#include <algorithm>
#include <array>

#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves {

namespace {

std::string_view trim(std::string_view text) {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v'; };
    while (!text.empty() && is_blank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_blank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

std::string quote(std::string_view text) {
    constexpr std::size_t longest = 40;
    // Bytes of another code page are none of UTF-8; JSON puts a sign in their place.
    const std::string json = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
    return "\"" + printable(std::string_view(json).substr(1, json.size() - 2), longest) + "\"";
}

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

/// What stood there, for a message: of a file that may be no table only what can be a number is
/// said. The file's name may be in a case that somebody else wrote.
Message found(std::string_view text, bool is_table) {
    const bool is_number =
        text.size() < 40 && text.find_first_not_of("0123456789+-.,eE \t") == std::string_view::npos;
    const std::string word = word_of(text);
    const bool is_none = word == "nan" || word == "inf" || word == "infinity" || word == "#n/a";
    return is_table || is_number || is_none ? Message(quote(text)) : Message();
}

/// Fields of a line; a blank separator stands for any run of blanks. Quotes around a field go.
void split(std::string_view line, char separator, std::vector<std::string_view>& fields) {
    fields.clear();
    line = separator == '\t' ? line : trim(line);
    while (true) {
        std::size_t end = 0;
        if (!line.empty() && line.front() == '"') {
            end = line.find('"', 1);
            end = end == std::string_view::npos ? 0 : end;
        }
        end = separator == ' ' ? line.find_first_of(" \t", end) : line.find(separator, end);
        std::string_view text = trim(line.substr(0, end));
        if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
            text = trim(text.substr(1, text.size() - 2));
        }
        fields.push_back(text);
        if (end == std::string_view::npos) {
            break;
        }
        line.remove_prefix(end + 1);
        if (separator == ' ') {
            line = trim(line);
        }
    }
    if (fields.size() > 2 && fields.back().empty()) {
        fields.pop_back();  // a separator at the end of the line
    }
}

bool looks_like_number(std::string_view text) {
    text = trim(text);
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

/// The separator that a line of two numbers uses.
char find_separator(std::string_view line, std::size_t number) {
    if (line.find(';') != std::string_view::npos) {
        return ';';
    }
    if (line.find('\t') != std::string_view::npos) {
        return '\t';
    }
    if (line.find(',') == std::string_view::npos) {
        return ' ';
    }
    std::vector<std::string_view> fields;
    split(line, ' ', fields);
    if (fields.size() == 2 && !fields[0].ends_with(',') && !fields[1].starts_with(',')) {
        return ' ';
    }
    split(line, ',', fields);
    if (fields.size() == 4 && line.find('"') == std::string_view::npos) {
        throw InputError(table_place(number, 1),
                         CORE_TEXT("core",
                                   "must not separate columns by commas and use decimal commas at "
                                   "once; separate the columns by semicolons"),
                         found(line, false));
    }
    return ',';
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

TwoColumns read_two_columns(std::string_view text, const TwoColumnsRule& rule) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) {
        text.remove_prefix(byte_order_mark.size());
    }
    TwoColumns rows;
    std::vector<std::string_view> fields;
    std::size_t number = 0;
    std::size_t header_lines = 0;
    bool separator_known = false;
    std::array<DecimalSigns, 2> signs;
    const auto any = [&signs](auto which) {
        return static_cast<bool>(signs[0].*which) || static_cast<bool>(signs[1].*which);
    };
    while (!text.empty()) {
        ++number;
        const std::size_t end = text.find_first_of("\r\n");
        const std::string_view line = text.substr(0, end);
        if (end == std::string_view::npos) {
            text = {};
        } else {
            text.remove_prefix(end + (text.substr(end, 2) == "\r\n" ? 2 : 1));
        }
        const auto bad = std::find_if(line.begin(), line.end(), [](char c) {
            const auto byte = static_cast<unsigned char>(c);
            return (byte < 0x20 && c != '\t' && c != '\v' && c != '\f') || byte == 0x7F;
        });
        if (bad != line.end()) {
            throw InputError(line_place(number),
                             CORE_TEXT("core", "must be text; this looks like a binary file"));
        }
        if (trim(line).empty() || trim(line).front() == '#') {
            continue;
        }
        if (rows.first.empty() && !looks_like_number(line) && !is_not_a_number_word(line) &&
            header_lines < 2) {
            ++header_lines;  // names, and units below them
            rows.header.append(line).append("\n");
            rows.has_header = true;
            continue;
        }
        if (!separator_known) {
            rows.separator = find_separator(line, number);
            separator_known = true;
        }
        split(line, rows.separator, fields);
        if (fields.size() != 2) {
            throw InputError(
                line_place(number),
                {CORE_TEXT("core", "must hold two columns, %1 and %2"), rule.first, rule.second},
                fields.size() == 1 ? found(fields[0], !rows.first.empty())
                                   : Message(CORE_TEXT("core", "%1 columns"), fields.size()));
        }
        std::array<double, 2> values{};
        for (std::size_t column = 0; column < 2; ++column) {
            const auto value = parse_decimal(fields[column]);
            if (!value) {
                throw InputError(table_place(number, static_cast<int>(column) + 1),
                                 CORE_TEXT("core", "must be a finite number"),
                                 found(fields[column], !rows.first.empty()));
            }
            values[column] = *value;
            signs[column].note(fields[column], number);
            if (any(&DecimalSigns::doubtful_line) && any(&DecimalSigns::has_point)) {
                // "1,893" below 60.30 is 1893 to who wrote it.
                throw InputError(table_place(number, static_cast<int>(column) + 1),
                                 CORE_TEXT("core",
                                           "must have the decimal sign of the numbers above: all "
                                           "points or all commas, and nothing between thousands"),
                                 found(fields[column], true));
            }
        }
        if (!rule.first_range.contains(values[0])) {
            throw InputError(table_place(number, 1), rule.first_range.message(), Number{values[0]});
        }
        if (rows.first.size() >= rule.most_rows) {
            throw InputError(
                line_place(number),
                {CORE_TEXT("core",
                           "the table must have at most %1 rows: average the cycles, or take "
                           "larger steps"),
                 rule.most_rows});
        }
        rows.first.push_back(values[0]);
        rows.second.push_back(values[1]);
        rows.line.push_back(number);
    }
    rows.decimal_comma = any(&DecimalSigns::has_comma);
    for (std::size_t column = 0; column < 2 && !any(&DecimalSigns::is_decimal); ++column) {
        if (const DecimalSigns& seen = signs[column]; seen.doubtful_line != 0 && seen.has_whole) {
            throw InputError(
                table_place(seen.doubtful_line, static_cast<int>(column) + 1),
                CORE_TEXT("core",
                          "must not leave open whether its comma divides thousands or is a decimal "
                          "sign: other numbers of the column have none"),
                found(seen.doubtful, true));
        }
    }
    return rows;
}

}  // namespace ravnoves

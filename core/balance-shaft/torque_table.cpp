#include "balance-shaft/torque_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/range.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr double cycle_deg = 720.0;
constexpr double largest_angle_deg = 1e5;
constexpr double span_tolerance = 1e-3;        ///< of the span, for tables rounded by hand
constexpr double end_torque_tolerance = 1e-9;  ///< of the largest torque

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
    std::string shown(text.substr(0, longest));
    // Bytes that are not ASCII may be cut in the middle or be of another code page.
    for (char& c : shown) {
        if (static_cast<unsigned char>(c) >= 0x7F || static_cast<unsigned char>(c) < 0x20) {
            c = '?';
        }
    }
    return "\"" + shown + (text.size() > longest ? "…\"" : "\"");
}

std::string at(std::size_t line, int column) {
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
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

bool is_not_a_number_word(std::string_view text) {
    std::string word;
    for (const char c : text) {
        if (c != '"' && c != '-' && c != '+' && c != ' ') {
            word += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
        }
    }
    return word.starts_with("nan") || word.starts_with("inf") || word.starts_with("#n/a");
}

/// The separator that a line of two numbers uses.
char find_separator(std::string_view line, std::size_t number) {
    if (line.find(';') != std::string_view::npos) {
        return ';';
    }
    if (line.find('\t') != std::string_view::npos) {
        return '\t';
    }
    std::vector<std::string_view> fields;
    split(line, ' ', fields);
    if (fields.size() == 2 && !fields[0].ends_with(',') && !fields[1].starts_with(',')) {
        return ' ';
    }
    split(line, ',', fields);
    if (fields.size() == 4 && line.find('"') == std::string_view::npos) {
        throw InputError(at(number, 1),
                         "must not separate columns by commas and use decimal commas at once; "
                         "separate the columns by semicolons",
                         quote(line));
    }
    return ',';
}

std::optional<bool> header_says_radians(std::string_view header) {
    std::string word;
    for (const char c : header) {
        word += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    }
    // The Russian words too: "град" before "рад", which it contains.
    if (word.find("deg") != std::string::npos || word.find("°") != std::string::npos ||
        word.find("град") != std::string::npos) {
        return false;
    }
    if (word.find("рад") != std::string::npos) {
        return true;
    }
    // "rad" as a word of its own: not in "radius" or "grad".
    for (std::size_t i = word.find("rad"); i != std::string::npos; i = word.find("rad", i + 1)) {
        const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
        const bool begins = i == 0 || !is_letter(word[i - 1]);
        const bool ends =
            i + 3 >= word.size() || !is_letter(word[i + 3]) || word.substr(i, 6) == "radian";
        if (begins && ends) {
            return true;
        }
    }
    return std::nullopt;
}

bool near(double value, double wanted) {
    return std::abs(value - wanted) <= span_tolerance * wanted;
}

void check_rows(const TorqueTable& table, const auto& place_of_angle, const auto& place_of_torque) {
    const double allowed =
        end_torque_tolerance *
        std::abs(*std::max_element(table.torque.begin(), table.torque.end(),
                                   [](double a, double b) { return std::abs(a) < std::abs(b); }));
    for (std::size_t i = 1; i < table.size(); ++i) {
        const double previous = table.crank_angle_deg[i - 1];
        if (table.crank_angle_deg[i] == previous) {
            throw InputError(
                place_of_angle(i),
                "must not repeat the angle of the row before, " + format_number(previous),
                format_number(table.crank_angle_deg[i]));
        }
        if (!(table.crank_angle_deg[i] > previous)) {
            throw InputError(
                place_of_angle(i),
                "must be greater than the angle of the row before, " + format_number(previous),
                format_number(table.crank_angle_deg[i]));
        }
    }
    if (!(std::abs(table.torque.back() - table.torque.front()) <= allowed)) {
        throw InputError(place_of_torque(table.size() - 1),
                         "must equal the first torque, " + format_number(table.torque.front()) +
                             " N·m, since the cycle repeats",
                         format_number(table.torque.back()) + " N·m");
    }
}

}  // namespace

std::string TorqueTableText::describe() const {
    std::string text = std::to_string(table.size()) + " rows, separated by ";
    text += separator == ';'    ? "semicolons"
            : separator == ','  ? "commas"
            : separator == '\t' ? "tabs"
                                : "blanks";
    text += decimal_comma ? ", decimal comma" : "";
    text += in_radians ? ", angles in radians" : ", angles in degrees";
    text += has_header ? ", with a header" : "";
    text += repeated ? ", 360° repeated to 720°" : "";
    return text;
}

TorqueTableText parse_torque_table(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) {
        text.remove_prefix(byte_order_mark.size());
    }
    TorqueTableText result;
    std::vector<std::size_t> line_of_row;
    std::vector<std::string_view> fields;
    std::string_view header;
    std::size_t number = 0;
    std::size_t header_lines = 0;
    bool separator_known = false;
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
            throw InputError("line " + std::to_string(number),
                             "must be text; this looks like a binary file");
        }
        if (trim(line).empty() || trim(line).front() == '#') {
            continue;
        }
        if (result.table.size() == 0 && !looks_like_number(line) && !is_not_a_number_word(line) &&
            header_lines < 2) {
            ++header_lines;  // names, and units below them
            if (!header_says_radians(header).has_value()) {
                header = line;
            }
            result.has_header = true;
            continue;
        }
        if (!separator_known) {
            result.separator = find_separator(line, number);
            separator_known = true;
        }
        split(line, result.separator, fields);
        if (fields.size() != 2) {
            throw InputError(
                "line " + std::to_string(number), "must hold two columns, crank angle and torque",
                fields.size() == 1 ? quote(fields[0]) : std::to_string(fields.size()) + " columns");
        }
        std::array<double, 2> values{};
        for (std::size_t column = 0; column < 2; ++column) {
            const auto value = parse_decimal(fields[column]);
            if (!value) {
                throw InputError(at(number, static_cast<int>(column) + 1),
                                 "must be a finite number", quote(fields[column]));
            }
            values[column] = *value;
            result.decimal_comma =
                result.decimal_comma || fields[column].find(',') != std::string_view::npos;
        }
        if (std::abs(values[0]) > largest_angle_deg) {
            throw InputError(at(number, 1),
                             Range::between(-largest_angle_deg, largest_angle_deg).describe(),
                             format_number(values[0]));
        }
        if (std::abs(values[1]) > largest_torque) {
            throw InputError(at(number, 2),
                             Range::between(-largest_torque, largest_torque).describe(),
                             format_number(values[1]));
        }
        if (result.table.size() >= largest_torque_table) {
            throw InputError(
                "line " + std::to_string(number),
                "the table must have at most " + std::to_string(largest_torque_table) + " rows");
        }
        result.table.crank_angle_deg.push_back(values[0]);
        result.table.torque.push_back(values[1]);
        line_of_row.push_back(number);
    }

    TorqueTable& table = result.table;
    if (table.size() < 3) {
        throw InputError("", "the torque table must have at least 3 rows",
                         std::to_string(table.size()));
    }
    check_rows(
        table, [&](std::size_t i) { return at(line_of_row[i], 1); },
        [&](std::size_t i) { return at(line_of_row[i], 2); });

    const double first = table.crank_angle_deg.front();
    const double span = table.crank_angle_deg.back() - first;
    const auto from_header = header_says_radians(header);
    const bool is_degrees = near(span, cycle_deg) || near(span, cycle_deg / 2.0);
    const bool is_radians = near(span, 2.0 * two_pi) || near(span, two_pi);
    result.in_radians = from_header.value_or(is_radians);
    const double turn = result.in_radians ? two_pi : cycle_deg / 2.0;
    if (!(result.in_radians ? is_radians : is_degrees)) {
        const std::string unit = result.in_radians ? " rad" : "°";
        throw InputError(at(line_of_row.back(), 1),
                         "the angles must span 720° (or 360°, or 4π or 2π in radians), the last "
                         "row repeating the first",
                         format_number(span) + unit);
    }
    if (result.in_radians) {
        for (double& angle : table.crank_angle_deg) {
            angle /= degree;
        }
    }
    result.repeated = near(span, turn);
    table.torque.back() = table.torque.front();
    const double first_deg = table.crank_angle_deg.front();
    if (result.repeated) {
        const std::size_t rows = table.size();
        if (2 * rows - 1 > largest_torque_table) {
            throw InputError("",
                             "the torque table of 720° must have at most " +
                                 std::to_string(largest_torque_table) + " rows",
                             std::to_string(2 * rows - 1));
        }
        table.crank_angle_deg.back() = first_deg + cycle_deg / 2.0;
        for (std::size_t i = 1; i < rows; ++i) {
            table.crank_angle_deg.push_back(table.crank_angle_deg[i] + cycle_deg / 2.0);
            table.torque.push_back(table.torque[i]);
        }
    }
    table.crank_angle_deg.back() = first_deg + cycle_deg;
    // Rounding of the units must not have undone the order.
    for (std::size_t i = 1; i < table.size(); ++i) {
        if (!(table.crank_angle_deg[i] > table.crank_angle_deg[i - 1])) {
            throw InputError("", "the angles of neighbouring rows are too close together",
                             format_number(table.crank_angle_deg[i]) + "°");
        }
    }
    return result;
}

void check_torque_table(const TorqueTable& table, const std::string& where) {
    const std::string angles = where + "/crank_angle_deg";
    const std::string torques = where + "/torque_Nm";
    if (table.crank_angle_deg.size() != table.torque.size()) {
        throw InputError(torques,
                         "must hold as many numbers as crank_angle_deg, " +
                             std::to_string(table.crank_angle_deg.size()),
                         std::to_string(table.torque.size()));
    }
    if (table.size() < 3) {
        throw InputError(angles, "must hold at least 3 numbers", std::to_string(table.size()));
    }
    if (table.size() > largest_torque_table) {
        throw InputError(angles,
                         "must hold at most " + std::to_string(largest_torque_table) + " numbers",
                         std::to_string(table.size()));
    }
    constexpr Range angle_range = Range::between(-largest_angle_deg, largest_angle_deg);
    constexpr Range torque_range = Range::between(-largest_torque, largest_torque);
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (!angle_range.contains(table.crank_angle_deg[i])) {
            throw InputError(angles + "/" + std::to_string(i), angle_range.describe(),
                             format_number(table.crank_angle_deg[i]));
        }
        if (!torque_range.contains(table.torque[i])) {
            throw InputError(torques + "/" + std::to_string(i), torque_range.describe(),
                             format_number(table.torque[i]));
        }
    }
    check_rows(
        table, [&](std::size_t i) { return angles + "/" + std::to_string(i); },
        [&](std::size_t i) { return torques + "/" + std::to_string(i); });
    const double span = table.crank_angle_deg.back() - table.crank_angle_deg.front();
    if (std::abs(span - cycle_deg) > 1e-9 * cycle_deg) {
        throw InputError(angles, "must span 720°, the last row repeating the first",
                         format_number(span) + "°");
    }
}

std::string write_torque_table(const TorqueTable& table) {
    std::string text = "crank_angle_deg,torque_Nm\n";
    for (std::size_t i = 0; i < table.size(); ++i) {
        text += format_number(table.crank_angle_deg[i]) + "," + format_number(table.torque[i]);
        text += "\n";
    }
    return text;
}

}  // namespace ravnoves::balance_shaft

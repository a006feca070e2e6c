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
constexpr double span_tolerance = 1e-3;          ///< of the span, for tables rounded by hand
constexpr double end_torque_tolerance = 1e-9;    ///< of the largest torque
constexpr double end_pressure_tolerance = 0.02;  ///< of the largest pressure

/// What the second column holds.
struct Column {
    const char* name;
    std::string unit;
    double to_si;
    Range range;  ///< in SI
    double end_tolerance;
    bool may_be_open;  ///< the closing row may be missing
};

Column torque_column() {
    return {
        "torque", "N·m", 1.0, Range::between(-largest_torque, largest_torque), end_torque_tolerance,
        false};
}

Column pressure_column(const std::string& unit, double to_si) {
    return {"pressure", unit, to_si, Range::between(0.0, largest_pressure), end_pressure_tolerance,
            true};
}

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

void check_ascending(const std::vector<double>& angles, const auto& place) {
    for (std::size_t i = 1; i < angles.size(); ++i) {
        const double previous = angles[i - 1];
        if (angles[i] == previous) {
            throw InputError(
                place(i), "must not repeat the angle of the row before, " + format_number(previous),
                format_number(angles[i]));
        }
        if (!(angles[i] > previous)) {
            throw InputError(
                place(i),
                "must be greater than the angle of the row before, " + format_number(previous),
                format_number(angles[i]));
        }
    }
}

void check_end(const std::vector<double>& values, const Column& column, double tolerance,
               const std::string& place) {
    double largest = 0.0;
    for (const double value : values) {
        largest = std::max(largest, std::abs(value));
    }
    if (!(std::abs(values.back() - values.front()) <= tolerance * largest)) {
        const auto show_value = [&](double value) {
            return format_number(value / column.to_si) + " " + column.unit;
        };
        throw InputError(place,
                         "must equal the first " + std::string(column.name) + ", " +
                             show_value(values.front()) + ", since the cycle repeats",
                         show_value(values.back()));
    }
}

/// A table of two columns, of one cycle of 720°.
struct Cycle {
    TableText text;
    std::vector<double> angle_deg;
    std::vector<double> value;
};

}  // namespace

std::string TableText::describe() const {
    std::string text = std::to_string(rows) + " rows, separated by ";
    text += separator == ';'    ? "semicolons"
            : separator == ','  ? "commas"
            : separator == '\t' ? "tabs"
                                : "blanks";
    text += decimal_comma ? ", decimal comma" : "";
    text += in_radians ? ", angles in radians" : ", angles in degrees";
    text += has_header ? ", with a header" : "";
    text += pressure_unit.empty() ? "" : ", pressure in " + pressure_unit;
    text += repeated ? ", 360° repeated to 720°" : "";
    text += closed ? ", end joined to the start" : "";
    return text;
}

namespace {

/// Rows as they stand in the text.
struct Rows {
    TableText text;
    std::string header;
    std::vector<double> angle;
    std::vector<double> value;
    std::vector<std::size_t> line;
};

Rows read_rows(std::string_view text, const char* value_name) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) {
        text.remove_prefix(byte_order_mark.size());
    }
    Rows rows;
    std::vector<std::string_view> fields;
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
        if (rows.angle.empty() && !looks_like_number(line) && !is_not_a_number_word(line) &&
            header_lines < 2) {
            ++header_lines;  // names, and units below them
            rows.header.append(line).append("\n");
            rows.text.has_header = true;
            continue;
        }
        if (!separator_known) {
            rows.text.separator = find_separator(line, number);
            separator_known = true;
        }
        split(line, rows.text.separator, fields);
        if (fields.size() != 2) {
            throw InputError(
                "line " + std::to_string(number),
                std::string("must hold two columns, crank angle and ") + value_name,
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
            rows.text.decimal_comma =
                rows.text.decimal_comma || fields[column].find(',') != std::string_view::npos;
        }
        if (std::abs(values[0]) > largest_angle_deg) {
            throw InputError(at(number, 1),
                             Range::between(-largest_angle_deg, largest_angle_deg).describe(),
                             format_number(values[0]));
        }
        if (rows.angle.size() >= largest_torque_table) {
            throw InputError(
                "line " + std::to_string(number),
                "the table must have at most " + std::to_string(largest_torque_table) + " rows");
        }
        rows.angle.push_back(values[0]);
        rows.value.push_back(values[1]);
        rows.line.push_back(number);
    }
    return rows;
}

/// Checks the rows, finds the unit of the angles and brings the table to one cycle of 720°.
Cycle to_cycle(Rows&& rows, const Column& column) {
    Cycle cycle{rows.text, std::move(rows.angle), std::move(rows.value)};
    std::vector<double>& angle = cycle.angle_deg;
    std::vector<double>& value = cycle.value;
    const auto place_of_angle = [&](std::size_t i) { return at(rows.line[i], 1); };
    if (angle.size() < 3) {
        throw InputError("", std::string("the ") + column.name + " table must have at least 3 rows",
                         std::to_string(angle.size()));
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
        value[i] *= column.to_si;
        if (!column.range.contains(value[i])) {
            Range shown = column.range;
            shown.min /= column.to_si;
            shown.max /= column.to_si;
            throw InputError(at(rows.line[i], 2), shown.describe(),
                             format_number(value[i] / column.to_si));
        }
    }
    check_ascending(angle, place_of_angle);

    const double first = angle.front();
    double span = angle.back() - first;
    const auto from_header = header_says_radians(rows.header);
    const auto is_cycle = [&](double length, bool radians) {
        const double turn = radians ? two_pi : cycle_deg / 2.0;
        return near(length, turn) || near(length, 2.0 * turn);
    };
    const double open_span = span + angle.back() - angle[angle.size() - 2];
    if (column.may_be_open && !is_cycle(span, false) && !is_cycle(span, true) &&
        (is_cycle(open_span, false) || is_cycle(open_span, true))) {
        angle.push_back(first + open_span);
        value.push_back(value.front());
        rows.line.push_back(rows.line.back());
        span = open_span;
        cycle.text.closed = true;
    }
    check_end(value, column, column.end_tolerance, at(rows.line.back(), 2));
    cycle.text.in_radians = from_header.value_or(is_cycle(span, true));
    if (!is_cycle(span, cycle.text.in_radians)) {
        const std::string unit = cycle.text.in_radians ? " rad" : "°";
        throw InputError(at(rows.line.back(), 1),
                         "the angles must span 720° (or 360°, or 4π or 2π in radians), the last "
                         "row repeating the first",
                         format_number(span) + unit);
    }
    if (column.may_be_open && value.back() != value.front()) {
        value.front() = (value.front() + value.back()) / 2.0;
        cycle.text.closed = true;
    }
    value.back() = value.front();
    if (cycle.text.in_radians) {
        for (double& a : angle) {
            a /= degree;
        }
    }
    cycle.text.repeated = near(angle.back() - angle.front(), cycle_deg / 2.0);
    const double first_deg = angle.front();
    if (cycle.text.repeated) {
        const std::size_t count = angle.size();
        if (2 * count - 1 > largest_torque_table) {
            throw InputError("",
                             "the table of 720° must have at most " +
                                 std::to_string(largest_torque_table) + " rows",
                             std::to_string(2 * count - 1));
        }
        angle.back() = first_deg + cycle_deg / 2.0;
        for (std::size_t i = 1; i < count; ++i) {
            angle.push_back(angle[i] + cycle_deg / 2.0);
            value.push_back(value[i]);
        }
    }
    angle.back() = first_deg + cycle_deg;
    cycle.text.rows = angle.size();
    // Rounding of the units must not have undone the order.
    for (std::size_t i = 1; i < angle.size(); ++i) {
        if (!(angle[i] > angle[i - 1])) {
            throw InputError("", "the angles of neighbouring rows are too close together",
                             format_number(angle[i]) + "°");
        }
    }
    return cycle;
}

/// The unit that the header names for a pressure, with its size in Pa.
std::pair<std::string, double> pressure_unit(std::string_view header) {
    const auto has_word = [&](std::string_view word) {
        const auto is_letter = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        };
        for (std::size_t i = header.find(word); i != std::string_view::npos;
             i = header.find(word, i + 1)) {
            const std::size_t end = i + word.size();
            if ((i == 0 || !is_letter(header[i - 1])) &&
                (end >= header.size() || !is_letter(header[end]))) {
                return true;
            }
        }
        return false;
    };
    if (has_word("MPa") || header.find("МПа") != std::string_view::npos) {
        return {"MPa", 1e6};
    }
    if (has_word("kPa") || header.find("кПа") != std::string_view::npos) {
        return {"kPa", 1e3};
    }
    if (has_word("Pa") || header.find("Па") != std::string_view::npos) {
        return {"Pa", 1.0};
    }
    if (has_word("psi")) {
        return {"psi", 6894.757293168361};
    }
    return {"bar", 1e5};
}

void check_table(const std::vector<double>& angle, const std::vector<double>& value,
                 const Column& column, const std::string& angles, const std::string& values) {
    if (angle.size() != value.size()) {
        throw InputError(
            values, "must hold as many numbers as crank_angle_deg, " + std::to_string(angle.size()),
            std::to_string(value.size()));
    }
    if (angle.size() < 3) {
        throw InputError(angles, "must hold at least 3 numbers", std::to_string(angle.size()));
    }
    if (angle.size() > largest_torque_table) {
        throw InputError(angles,
                         "must hold at most " + std::to_string(largest_torque_table) + " numbers",
                         std::to_string(angle.size()));
    }
    constexpr Range angle_range = Range::between(-largest_angle_deg, largest_angle_deg);
    for (std::size_t i = 0; i < angle.size(); ++i) {
        if (!angle_range.contains(angle[i])) {
            throw InputError(angles + "/" + std::to_string(i), angle_range.describe(),
                             format_number(angle[i]));
        }
        if (!column.range.contains(value[i])) {
            throw InputError(values + "/" + std::to_string(i), column.range.describe(),
                             format_number(value[i]));
        }
    }
    check_ascending(angle, [&](std::size_t i) { return angles + "/" + std::to_string(i); });
    // Rows still closer leave no digits to the slope between them, or let it overflow.
    constexpr double least_gap_deg = 1e-9;
    for (std::size_t i = 1; i < angle.size(); ++i) {
        if (!(angle[i] - angle[i - 1] >= least_gap_deg)) {
            throw InputError(angles + "/" + std::to_string(i),
                             "must be at least " + format_number(least_gap_deg) +
                                 "° more than the angle of the row before, " +
                                 format_number(angle[i - 1]),
                             format_number(angle[i]));
        }
    }
    check_end(value, column, end_torque_tolerance, values + "/" + std::to_string(value.size() - 1));
    const double span = angle.back() - angle.front();
    if (std::abs(span - cycle_deg) > 1e-9 * cycle_deg) {
        throw InputError(angles, "must span 720°, the last row repeating the first",
                         format_number(span) + "°");
    }
}

}  // namespace

TorqueTableText parse_torque_table(std::string_view text) {
    Cycle cycle = to_cycle(read_rows(text, "torque"), torque_column());
    TorqueTableText result;
    static_cast<TableText&>(result) = cycle.text;
    result.table = {std::move(cycle.angle_deg), std::move(cycle.value)};
    return result;
}

PressureTraceText parse_pressure_trace(std::string_view text) {
    Rows rows = read_rows(text, "pressure");
    const auto [unit, to_si] = pressure_unit(rows.header);
    Cycle cycle = to_cycle(std::move(rows), pressure_column(unit, to_si));
    PressureTraceText result;
    static_cast<TableText&>(result) = cycle.text;
    result.pressure_unit = unit;
    result.trace = {std::move(cycle.angle_deg), std::move(cycle.value)};
    return result;
}

void check_torque_table(const TorqueTable& table, const std::string& where) {
    check_table(table.crank_angle_deg, table.torque, torque_column(), where + "/crank_angle_deg",
                where + "/torque_Nm");
}

void check_pressure_trace(const PressureTrace& trace, const std::string& where) {
    check_table(trace.crank_angle_deg, trace.pressure, pressure_column("Pa", 1.0), where, where);
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

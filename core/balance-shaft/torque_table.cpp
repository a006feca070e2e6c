#include "balance-shaft/torque_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

#include "balance-shaft/fields.h"
#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "case-file/range.h"
#include "case-file/two_columns.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr double largest_angle_deg = 1e5;
constexpr double span_tolerance = 1e-3;          ///< of the span, for tables rounded by hand
constexpr double end_torque_tolerance = 1e-9;    ///< of the largest torque
constexpr double end_pressure_tolerance = 0.02;  ///< of the largest pressure

/// What the second column holds.
struct Column {
    Text name;
    Unit unit;
    Range range;  ///< in SI
    double end_tolerance;
    bool may_be_open;        ///< the closing row may be missing
    bool unit_named = true;  ///< else it is what is usual
};

Column torque_column(Unit unit = units::N_m) {
    return {CORE_TEXT("balance-shaft", "torque"), unit,
            Range::between(-largest_torque, largest_torque), end_torque_tolerance, false};
}

Column pressure_column(Unit unit, bool unit_named = true) {
    return {CORE_TEXT("balance-shaft", "pressure"),
            unit,
            Range::between(0.0, largest_pressure),
            end_pressure_tolerance,
            true,
            unit_named};
}

TwoColumnsRule rule_for(const Column& column) {
    return {CORE_TEXT("balance-shaft", "crank angle"), column.name,
            Range::between(-largest_angle_deg, largest_angle_deg), largest_torque_table};
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
                place(i),
                {CORE_TEXT("balance-shaft", "must not repeat the angle of the row before, %1"),
                 previous},
                Number{angles[i]});
        }
        if (!(angles[i] > previous)) {
            throw InputError(
                place(i),
                {CORE_TEXT("balance-shaft", "must be greater than the angle of the row before, %1"),
                 previous},
                Number{angles[i]});
        }
    }
}

void check_end(const std::vector<double>& values, const Column& column, double tolerance,
               const Message& place) {
    double largest = 0.0;
    for (const double value : values) {
        largest = std::max(largest, std::abs(value));
    }
    if (!(std::abs(values.back() - values.front()) <= tolerance * largest)) {
        const auto shown = [&](double value) { return Number{value / column.unit, column.unit}; };
        throw InputError(
            place,
            {CORE_TEXT("balance-shaft", "must equal the first %1, %2, since the cycle repeats"),
             column.name, shown(values.front())},
            shown(values.back()));
    }
}

Number count(const std::vector<double>& values) {
    return {static_cast<double>(values.size())};
}

/// A table of two columns, of one cycle.
struct Cycle {
    TableFormat format;
    std::vector<double> angle_deg;
    std::vector<double> value;
};

}  // namespace

int strokes_of(const std::vector<double>& crank_angle_deg) {
    return !crank_angle_deg.empty() &&
                   near(crank_angle_deg.back() - crank_angle_deg.front(), turn_deg)
               ? 2
               : 4;
}

Message TableFormat::describe() const {
    Message text(CORE_TEXT("balance-shaft", "%1 rows"), rows);
    const auto add = [&](bool holds, const Message& part) {
        if (holds) {
            text = Message(Text{"", "%1, %2"}, text, part);
        }
    };
    add(true, separator == ';'    ? CORE_TEXT("balance-shaft", "separated by semicolons")
              : separator == ','  ? CORE_TEXT("balance-shaft", "separated by commas")
              : separator == '\t' ? CORE_TEXT("balance-shaft", "separated by tabs")
                                  : CORE_TEXT("balance-shaft", "separated by blanks"));
    add(decimal_comma, CORE_TEXT("balance-shaft", "decimal comma"));
    add(true, in_radians ? CORE_TEXT("balance-shaft", "angles in radians")
                         : CORE_TEXT("balance-shaft", "angles in degrees"));
    add(has_header, CORE_TEXT("balance-shaft", "with a header"));
    add(!pressure_unit.empty(),
        {unit_named
             ? CORE_TEXT("balance-shaft", "pressure in %1")
             : CORE_TEXT("balance-shaft",
                         "pressure taken for %1, as the heading names no unit that is known"),
         Text{"core", pressure_unit.data()}});
    add(!torque_unit.empty(),
        {CORE_TEXT("balance-shaft", "torque in %1"), Text{"core", torque_unit.data()}});
    add(strokes == 2, CORE_TEXT("balance-shaft", "360°, the cycle of a two-stroke engine"));
    add(closed, CORE_TEXT("balance-shaft", "end joined to the start"));
    return text;
}

namespace {

/// Checks the rows, finds the unit of the angles and brings the table to one cycle in degrees.
Cycle to_cycle(TwoColumns&& rows, const Column& column) {
    Cycle cycle{{}, std::move(rows.first), std::move(rows.second)};
    cycle.format.separator = rows.separator;
    cycle.format.has_header = rows.has_header;
    cycle.format.decimal_comma = rows.decimal_comma;
    std::vector<double>& angle = cycle.angle_deg;
    std::vector<double>& value = cycle.value;
    const auto place_of_angle = [&](std::size_t i) { return table_place(rows.line[i], 1); };
    if (angle.size() < 3) {
        throw InputError(
            "", {CORE_TEXT("balance-shaft", "the %1 table must have at least 3 rows"), column.name},
            count(angle));
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
        value[i] *= column.unit.to_si;
        if (!column.range.contains(value[i])) {
            Range shown = column.range;
            shown.min /= column.unit.to_si;
            shown.max /= column.unit.to_si;
            throw InputError(
                table_place(rows.line[i], 2),
                column.unit_named || value[i] < column.range.min
                    ? shown.message()
                    : Message(CORE_TEXT("balance-shaft",
                                        "%1 in %2, which is taken where the heading names no unit; "
                                        "write the unit above the column, for example Pa"),
                              shown.message(), Text{"core", column.unit.name.data()}),
                Number{value[i] / column.unit});
        }
    }
    check_ascending(angle, place_of_angle);

    const double first = angle.front();
    double span = angle.back() - first;
    const auto from_header = header_says_radians(rows.header);
    const auto is_cycle = [&](double length, bool radians) {
        const double turn = radians ? two_pi : turn_deg;
        return near(length, turn) || near(length, 2.0 * turn);
    };
    const double open_span = span + angle.back() - angle[angle.size() - 2];
    if (column.may_be_open && !is_cycle(span, false) && !is_cycle(span, true) &&
        (is_cycle(open_span, false) || is_cycle(open_span, true))) {
        angle.push_back(first + open_span);
        value.push_back(value.front());
        rows.line.push_back(rows.line.back());
        span = open_span;
        cycle.format.closed = true;
    }
    cycle.format.in_radians = from_header.value_or(is_cycle(span, true));
    if (!is_cycle(span, cycle.format.in_radians)) {
        throw InputError(
            table_place(rows.line.back(), 1),
            CORE_TEXT("balance-shaft",
                      "the angles must span 720° (or 360°, or 4π or 2π in radians), the last row "
                      "repeating the first"),
            Number{span, cycle.format.in_radians ? units::radian : units::degree});
    }
    check_end(value, column, column.end_tolerance, table_place(rows.line.back(), 2));
    if (column.may_be_open && value.back() != value.front()) {
        value.front() = (value.front() + value.back()) / 2.0;
        cycle.format.closed = true;
    }
    value.back() = value.front();
    if (cycle.format.in_radians) {
        for (double& a : angle) {
            a /= degree;
        }
    }
    cycle.format.strokes = strokes_of(angle);
    angle.back() = angle.front() + turn_deg * cycle.format.strokes / 2.0;
    cycle.format.rows = angle.size();
    // Rounding of the units must not have undone the order.
    for (std::size_t i = 1; i < angle.size(); ++i) {
        if (!(angle[i] > angle[i - 1])) {
            throw InputError("",
                             CORE_TEXT("balance-shaft",
                                       "the angles of neighbouring rows are too close together"),
                             Number{angle[i], units::degree});
        }
    }
    return cycle;
}

/// True for "bar(g)", "barg", "gauge pressure" and the like.
bool names_gauge_pressure(std::string_view header) {
    return std::ranges::any_of(
        std::array{"barg", "(g)", "gauge", "Gauge", "psig", "изб"},
        [&](std::string_view word) { return header.find(word) != std::string_view::npos; });
}

/// The unit that the header names for a pressure, if any.
std::optional<Unit> pressure_unit(std::string_view header) {
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
        return units::MPa;
    }
    if (has_word("kPa") || header.find("кПа") != std::string_view::npos) {
        return units::kPa;
    }
    if (has_word("Pa") || header.find("Па") != std::string_view::npos) {
        return units::pascal;
    }
    if (has_word("mbar") || header.find("мбар") != std::string_view::npos) {
        return units::mbar;
    }
    if (has_word("psi")) {
        return units::psi;
    }
    if (has_word("bar") || header.find("бар") != std::string_view::npos) {
        return units::bar;
    }
    return std::nullopt;
}

/// The unit that the header names for a torque, where it is not N·m: "M (kN·m)", "torque, lb-ft".
std::optional<Unit> torque_unit(std::string_view header) {
    std::string word;  // without what stands between the parts of a unit
    for (std::size_t at = 0; at <= header.size(); ++at) {
        const char c = at < header.size() ? header[at] : ';';
        constexpr std::string_view dot = "·";
        if (header.substr(at, dot.size()) == dot) {
            at += dot.size() - 1;
        } else if (std::string_view(",;()[]\t\n\"").find(c) == std::string_view::npos) {
            if (c != ' ' && c != '*' && c != '-' && c != '.') {
                word += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
            }
        } else {
            const auto ends = [&](std::initializer_list<std::string_view> names) {
                return std::ranges::any_of(
                    names, [&](std::string_view name) { return word.ends_with(name); });
            };
            if (ends({"knm", "кНм"})) {
                return units::kN_m;
            }
            if (ends({"lbfft", "lbft", "ftlbf", "ftlb", "ftlbs"})) {
                return units::lbf_ft;
            }
            if (ends({"lbfin", "lbin", "inlbf", "inlb", "inlbs"})) {
                return units::lbf_in;
            }
            word.clear();
        }
    }
    return std::nullopt;
}

void check_table(const std::vector<double>& angle, const std::vector<double>& value,
                 const Column& column, const std::string& angles, const std::string& values) {
    if (angle.size() != value.size()) {
        throw InputError(values,
                         {CORE_TEXT("balance-shaft", "must hold as many numbers as %1, %2"),
                          field::table_angle.key, angle.size()},
                         count(value));
    }
    if (angle.size() < 3) {
        throw InputError(angles, CORE_TEXT("balance-shaft", "must hold at least 3 numbers"),
                         count(angle));
    }
    if (angle.size() > largest_torque_table) {
        throw InputError(
            angles,
            {CORE_TEXT("balance-shaft",
                       "must hold at most %1 numbers: average the cycles, or take larger steps"),
             largest_torque_table},
            count(angle));
    }
    constexpr Range angle_range = Range::between(-largest_angle_deg, largest_angle_deg);
    for (std::size_t i = 0; i < angle.size(); ++i) {
        if (!angle_range.contains(angle[i])) {
            throw InputError(angles + "/" + std::to_string(i), angle_range.message(),
                             Number{angle[i]});
        }
        if (!column.range.contains(value[i])) {
            throw InputError(values + "/" + std::to_string(i), column.range.message(),
                             Number{value[i]});
        }
    }
    check_ascending(angle, [&](std::size_t i) { return angles + "/" + std::to_string(i); });
    // Rows still closer leave no digits to the slope between them, or let it overflow.
    constexpr double least_gap_deg = 1e-9;
    for (std::size_t i = 1; i < angle.size(); ++i) {
        if (!(angle[i] - angle[i - 1] >= least_gap_deg)) {
            throw InputError(
                angles + "/" + std::to_string(i),
                {CORE_TEXT("balance-shaft",
                           "must be at least %1 more than the angle of the row before, %2"),
                 Number{least_gap_deg, units::degree}, angle[i - 1]},
                Number{angle[i]});
        }
    }
    check_end(value, column, end_torque_tolerance, values + "/" + std::to_string(value.size() - 1));
    const double span = angle.back() - angle.front();
    const double cycle_deg = turn_deg * strokes_of(angle) / 2.0;
    if (std::abs(span - cycle_deg) > 1e-9 * cycle_deg) {
        throw InputError(
            angles,
            CORE_TEXT("balance-shaft",
                      "must span 720°, or 360° for a two-stroke engine, the last row repeating the "
                      "first"),
            Number{span, units::degree});
    }
}

}  // namespace

ParsedTorqueTable parse_torque_table(std::string_view text) {
    TwoColumns rows = read_two_columns(text, rule_for(torque_column()));
    const std::optional<Unit> named = torque_unit(rows.header);
    Cycle cycle = to_cycle(std::move(rows), torque_column(named.value_or(units::N_m)));
    ParsedTorqueTable result;
    static_cast<TableFormat&>(result) = cycle.format;
    result.torque_unit = named ? named->name : std::string_view();
    result.table = {std::move(cycle.angle_deg), std::move(cycle.value)};
    return result;
}

ParsedPressureTrace parse_pressure_trace(std::string_view text) {
    TwoColumns rows = read_two_columns(text, rule_for(pressure_column(units::bar)));
    if (names_gauge_pressure(rows.header)) {
        throw InputError("line 1",
                         CORE_TEXT("balance-shaft",
                                   "must name absolute pressure: add the pressure of the "
                                   "surroundings to every row, and name the unit alone"),
                         CORE_TEXT("balance-shaft", "gauge pressure"));
    }
    const std::optional<Unit> named = pressure_unit(rows.header);
    const Unit unit = named.value_or(units::bar);
    Cycle cycle = to_cycle(std::move(rows), pressure_column(unit, named.has_value()));
    ParsedPressureTrace result;
    static_cast<TableFormat&>(result) = cycle.format;
    result.pressure_unit = unit.name;
    result.unit_named = named.has_value();
    result.trace = {std::move(cycle.angle_deg), std::move(cycle.value), unit, named.has_value()};
    return result;
}

void check_torque_table(const TorqueTable& table, const std::string& where) {
    check_table(table.crank_angle_deg, table.torque, torque_column(), where + "/crank_angle_deg",
                where + "/torque_Nm");
}

void check_pressure_trace(const PressureTrace& trace, const std::string& where) {
    check_table(trace.crank_angle_deg, trace.pressure, pressure_column(units::pascal), where,
                where);
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

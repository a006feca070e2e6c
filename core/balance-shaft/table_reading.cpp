#include "balance-shaft/table_reading.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <tuple>
#include <utility>

#include "case-file/input_error.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr double atmosphere = 101325.0;  // Pa

const Column& column_of(Measured what) {
    return what == Measured::torque ? torque_column : pressure_column;
}

// ------------------------------------------------------------------------------ words of a heading

std::string in_small_letters(std::string_view text) {
    std::string word;
    for (const char c : text) {
        word += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    }
    return word;
}

bool has_any(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(
        words, [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

/// "rad" as a word of its own: not in "radius" or "grad". Of pressures "barg" and "bara" too.
bool has_word(std::string_view text, std::string_view word, std::string_view suffixes = {}) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    for (std::size_t i = text.find(word); i != std::string_view::npos; i = text.find(word, i + 1)) {
        std::size_t end = i + word.size();
        if (end < text.size() && suffixes.find(text[end]) != std::string_view::npos) {
            ++end;
        }
        if ((i == 0 || !is_letter(text[i - 1])) && (end >= text.size() || !is_letter(text[end]))) {
            return true;
        }
    }
    return false;
}

std::optional<bool> heading_says_radians(std::string_view heading) {
    const std::string word = in_small_letters(heading);
    // The Russian words too: "град" before "рад", which it contains.
    if (has_any(word, {"deg", "°", "град"})) {
        return false;
    }
    if (has_any(word, {"рад"}) || has_word(word, "rad") || has_word(word, "radian") ||
        has_word(word, "radians")) {
        return true;
    }
    return std::nullopt;
}

/// True for "bar(g)", "barg", "gauge pressure" and the like.
bool names_gauge_pressure(std::string_view heading) {
    const std::string word = in_small_letters(heading);
    return has_any(word, {"(g)", "gauge", "изб"}) ||
           std::ranges::any_of(std::array{"barg", "mbarg", "psig", "kpag", "mpag", "pag"},
                               [&](std::string_view unit) { return has_word(word, unit); });
}

std::optional<Unit> named_pressure_unit(std::string_view text) {
    const struct {
        Unit unit;
        std::string_view word;
        std::string_view russian;
    } names[] = {{units::MPa, "mpa", "МПа"},    {units::kPa, "kpa", "кПа"},
                 {units::mbar, "mbar", "мбар"}, {units::bar, "bar", "бар"},
                 {units::psi, "psi", "psi"},    {units::pascal, "Pa", "Па"}};
    const std::string small = in_small_letters(text);
    for (const auto& name : names) {
        if (has_word(name.unit == units::pascal ? text : small, name.word, "ag") ||
            text.find(name.russian) != std::string_view::npos) {
            return name.unit;
        }
    }
    return std::nullopt;
}

/// "M (kN·m)", "torque, lb-ft": whole words, for daN·m and MN·m end in N·m too.
std::optional<Unit> named_torque_unit(std::string_view text) {
    constexpr std::tuple<std::string_view, std::string_view, Unit> names[] = {
        {"n", "m", units::N_m},       {"Н", "м", units::N_m},       {"kn", "m", units::kN_m},
        {"кН", "м", units::kN_m},     {"lbf", "ft", units::lbf_ft}, {"lb", "ft", units::lbf_ft},
        {"ft", "lbf", units::lbf_ft}, {"ft", "lb", units::lbf_ft},  {"ft", "lbs", units::lbf_ft},
        {"lbf", "in", units::lbf_in}, {"lb", "in", units::lbf_in},  {"in", "lbf", units::lbf_in},
        {"in", "lb", units::lbf_in},  {"in", "lbs", units::lbf_in}};
    std::string words = ";" + in_small_letters(text) + ";";
    for (const std::string_view joint : {"·", "⋅", "*", "-", ".", "_"}) {
        for (auto at = words.find(joint); at != std::string::npos; at = words.find(joint)) {
            words.replace(at, joint.size(), " ");
        }
    }
    const auto is_apart = [](char c) {
        return static_cast<unsigned char>(c) < 0x80 && !(c >= 'a' && c <= 'z') &&
               !(c >= '0' && c <= '9');
    };
    for (const auto& [first, second, unit] : names) {
        for (const char* const joint : {"", " "}) {
            const std::string name = std::string(first).append(joint).append(second);
            for (auto at = words.find(name); at != std::string::npos;
                 at = words.find(name, at + 1)) {
                const std::size_t end = at + name.size();
                if (is_apart(words[at - 1]) && is_apart(words[end]) &&
                    words[words.find_first_not_of(' ', end)] != '/') {
                    return unit;
                }
            }
        }
    }
    return std::nullopt;
}

std::optional<Unit> named_unit(Measured what, std::string_view text) {
    return what == Measured::torque ? named_torque_unit(text) : named_pressure_unit(text);
}

}  // namespace

std::vector<Unit> units_of(Measured what) {
    return what == Measured::torque
               ? std::vector{units::N_m, units::kN_m, units::lbf_ft, units::lbf_in}
               : std::vector{units::bar, units::kPa,  units::MPa,
                             units::psi, units::mbar, units::pascal};
}

Message TableFormat::describe() const {
    Message text(Text::tr("%1 rows"), rows);
    const auto add = [&](bool holds, const Message& part) {
        if (holds) {
            text = Message(Text{"%1, %2"}, text, part);
        }
    };
    const Text name{unit.name.data()};
    add(true, separator == ';'    ? Text::tr("separated by semicolons")
              : separator == ','  ? Text::tr("separated by commas")
              : separator == '\t' ? Text::tr("separated by tabs")
                                  : Text::tr("separated by blanks"));
    add(decimal_comma, Text::tr("decimal comma"));
    add(true, in_radians ? Text::tr("angles in radians") : Text::tr("angles in degrees"));
    add(header_lines > 0, Text::tr("with a header"));
    if (what == Measured::pressure) {
        add(true,
            {!unit_named ? Text::tr("pressure assumed in %1, without a known unit in the heading")
             : gauge     ? Text::tr("gauge pressure in %1")
                         : Text::tr("pressure in %1"),
             name});
    } else if (unit_named) {
        add(unit != units::N_m, {Text::tr("torque in %1"), name});
    } else {
        add(header_lines > 0,
            {Text::tr("torque assumed in %1, without a known unit in the heading"), name});
    }
    add(strokes == 2, Text::tr("360°, the cycle of a two-stroke engine"));
    add(cycles > 1, {Text::tr("mean of %1 cycles"), cycles});
    add(left_over > 0.0,
        {Text::tr("%1 at the end left out"), Number{left_over / degree, units::degree, 4}});
    add(closed, Text::tr("end joined to the start"));
    return text;
}

namespace {

// ------------------------------------------------------------------------- rows of several cycles

constexpr std::size_t fewest_rows = 3;

/// Rows whose angles go on over all turns.
struct Series {
    std::vector<double> angle;  ///< °
    std::vector<double> value;
    std::vector<std::size_t> row;  ///< of the file

    double span() const { return angle.back() - angle.front(); }
    double last_step() const { return angle.back() - angle[angle.size() - 2]; }
    /// By straight lines; the last value beyond the end.
    /// @param i  the row found, from where the next angle, a larger one, is looked for
    double at(double wanted, std::size_t& i) const {
        while (i < angle.size() && angle[i] < wanted - 1e-7) {
            ++i;
        }
        if (i == 0 || i == angle.size()) {
            return i == 0 ? value.front() : value.back();
        }
        if (angle[i] <= wanted + 1e-7) {
            return value[i];
        }
        const double part = (wanted - angle[i - 1]) / (angle[i] - angle[i - 1]);
        return value[i - 1] + part * (value[i] - value[i - 1]);
    }
};

/// Angles that begin again at each turn or cycle go on instead. A row that repeats the instant
/// before (720° and then 0°) goes.
Series unrolled(const std::vector<double>& angle, std::vector<double>&& value) {
    Series series;
    constexpr double half_turn = turn_deg / 2.0;
    constexpr double same = 1e-9;
    double turned = 0.0;
    double largest_step = 0.0;
    for (std::size_t i = 0; i < angle.size(); ++i) {
        double next = angle[i] + turned;
        if (!series.angle.empty()) {
            const double step = next - series.angle.back();
            const double turns = std::ceil(-step / turn_deg - same) * turn_deg;
            if (step >= -half_turn) {
                largest_step = std::max(largest_step, step);
            } else if (step + turns <= 2.0 * largest_step) {
                turned += turns;
                next += turns;
                if (std::abs(step + turns) <= same * turn_deg) {
                    continue;
                }
            }
        }
        series.angle.push_back(next);
        series.value.push_back(value[i]);
        series.row.push_back(i);
    }
    return series;
}

/// Whether the values a turn later are the same ones: the cycle of a two-stroke engine.
bool repeats_each_turn(const Series& series) {
    const double mean = std::accumulate(series.value.begin(), series.value.end(), 0.0) /
                        static_cast<double>(series.value.size());
    double difference = 0.0;
    double size = 0.0;
    std::size_t row = 0;
    for (std::size_t i = 0;
         i < series.angle.size() && series.angle[i] + turn_deg <= series.angle.back() + 1e-7; ++i) {
        difference += std::abs(series.at(series.angle[i] + turn_deg, row) - series.value[i]);
        size += std::abs(series.value[i] - mean);
    }
    constexpr double cycles_differ = 0.3;  // from one to the next, and more would be another stroke
    return difference <= cycles_differ * size;
}

void check_length(std::size_t rows) {
    if (rows > largest_torque_table) {
        throw InputError(
            "",
            {Text::tr("a cycle must have at most %1 rows: use larger steps"), largest_torque_table},
            Number{static_cast<double>(rows)});
    }
}

/// The mean of the whole cycles, at the angles of the first, without its closing row.
void average(Series& series, double period, std::size_t cycles) {
    Series mean;
    for (std::size_t i = 0;
         i < series.angle.size() && series.angle[i] < series.angle.front() + period - 1e-7; ++i) {
        mean.angle.push_back(series.angle[i]);
        mean.value.push_back(0.0);
        mean.row.push_back(series.row[i]);
    }
    check_length(mean.angle.size() + 1);
    std::size_t row = 0;
    for (std::size_t cycle = 0; cycle < cycles; ++cycle) {
        for (std::size_t i = 0; i < mean.angle.size(); ++i) {
            mean.value[i] += series.at(mean.angle[i] + static_cast<double>(cycle) * period, row);
        }
    }
    for (double& value : mean.value) {
        value /= static_cast<double>(cycles);
    }
    series = std::move(mean);
}

void close(Series& series, double period) {
    series.angle.push_back(series.angle.front() + period);
    series.value.push_back(series.value.front());
    series.row.push_back(series.row.back());
}

/// Brings values to SI and checks them.
void convert(const TwoColumns& rows, const Column& column, const TableReading& reading,
             const TableFormat& format, std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double si = values[i] * format.unit + (format.gauge ? atmosphere : 0.0);
        if (!column.range.contains(si)) {
            Range shown = column.range;
            shown.min /= format.unit.to_si;
            shown.max /= format.unit.to_si;
            const bool may_be_gauge =
                format.what == Measured::pressure && si < 0.0 && !reading.gauge && !format.gauge;
            throw InputError(rows.place(i, 1),
                             may_be_gauge
                                 ? Message(Text::tr("%1; for gauge pressure set \"gauge\": true"),
                                           shown.message())
                                 : shown.message(),
                             Number{values[i]});
        }
        values[i] = si;
    }
}

void check_rows(std::size_t rows, const Column& column) {
    if (rows < fewest_rows) {
        throw InputError("", {Text::tr("the %1 table must have at least 3 rows"), column.name},
                         Number{static_cast<double>(rows)});
    }
}

/// Checks the rows, finds the unit of the angles and brings the table to one cycle in degrees.
ParsedCycle to_cycle(TwoColumns&& rows, Measured what, const TableReading& reading) {
    const Column& column = column_of(what);
    const std::optional<Unit> named =
        reading.unit ? reading.unit : named_unit(what, rows.heading(1));
    ParsedCycle format;
    format.what = what;
    format.separator = rows.view.separator;
    format.header_lines = rows.view.header_lines;
    format.decimal_comma = rows.decimal_comma;
    format.unit_named = named.has_value();
    format.gauge =
        what == Measured::pressure && reading.gauge.value_or(names_gauge_pressure(rows.heading(1)));
    check_rows(rows.first.size(), column);
    format.unit = named ? *named : likely_unit(what, rows.second);
    convert(rows, column, reading, format, rows.second);
    const bool counts = rows.column[0] == row_number;
    if (counts) {  // equal steps over one cycle; a closing row of torque is none
        const bool is_closed =
            what == Measured::torque && rows.second.back() == rows.second.front();
        const double step = 180.0 * reading.strokes.value_or(4) /
                            static_cast<double>(rows.first.size() - (is_closed ? 1 : 0));
        for (double& angle : rows.first) {
            angle *= step;
        }
    }

    const auto is_cycle = [](double length, bool radians) {
        const double turn = radians ? two_pi : turn_deg;
        return near(length, turn) || near(length, 2.0 * turn);
    };
    const double raw_span = rows.first.back() - rows.first.front();
    const double open_span = raw_span + rows.first.back() - rows.first[rows.first.size() - 2];
    const auto from_heading =
        reading.in_radians ? reading.in_radians : heading_says_radians(rows.heading(0));
    format.in_radians = from_heading.value_or(
        is_cycle(raw_span, true) || (what == Measured::pressure && !is_cycle(raw_span, false) &&
                                     !is_cycle(open_span, false) && is_cycle(open_span, true)));
    if (format.in_radians) {
        for (double& angle : rows.first) {
            angle /= degree;
        }
    }
    Series series = unrolled(rows.first, std::move(rows.second));
    check_rows(series.angle.size(), column);
    check_ascending(series.angle, [&](std::size_t i) { return rows.place(series.row[i], 0); });

    constexpr double cycle_deg = 2.0 * turn_deg;
    const double span = series.span();
    const bool may_be_open = what == Measured::pressure || counts;
    const double next = span + series.last_step();
    // Steps that do not divide the cycle: it ends within the last one if the user chose it.
    const double chosen = turn_deg * reading.strokes.value_or(0) / 2.0;
    const bool ends_within = may_be_open && span < chosen && chosen < next &&
                             !is_cycle(span, false) && !is_cycle(next, false);
    const double whole = ends_within ? chosen : may_be_open || span > cycle_deg ? next : span;
    const double nominal = near(whole, turn_deg) ? turn_deg : cycle_deg;
    // Of fine steps either may be a cycle: the nearer one is.
    const bool is_closed =
        is_cycle(span, false) && !(may_be_open && is_cycle(whole, false) &&
                                   std::abs(whole - nominal) < std::abs(span - nominal));
    double period = near(is_closed ? span : whole, turn_deg) ? turn_deg : cycle_deg;
    // Of fewer rows it is no curve: the unit of the angles is another.
    constexpr double fewest_of_curve = 6.0;
    const bool is_dense =
        static_cast<double>(series.angle.size()) * cycle_deg >= fewest_of_curve * span;
    if ((span > cycle_deg * 1.001 && is_dense &&
         (may_be_open || whole > 1.99 * turn_deg * reading.strokes.value_or(4) / 2.0)) ||
        (period == cycle_deg && is_cycle(is_closed ? span : whole, false) && reading.strokes == 2 &&
         repeats_each_turn(series))) {
        format.strokes = reading.strokes.value_or(repeats_each_turn(series) ? 2 : 4);
        period = turn_deg * format.strokes / 2.0;
        // Half a row of tolerance: the last one may be missing, or be rounded.
        format.cycles = static_cast<std::size_t>((whole + series.last_step() / 2.0) / period);
        const double rest = whole - static_cast<double>(format.cycles) * period;
        format.left_over = rest > 1.5 * series.last_step() ? rest * degree : 0.0;
        average(series, period, std::max<std::size_t>(format.cycles, 1));
        format.rows = series.angle.size();
        close(series, period);
    } else if (!is_closed && may_be_open && is_cycle(whole, false)) {
        format.rows = series.angle.size();
        close(series, period);
        format.closed = true;
    } else if (!is_closed) {
        throw InputError(
            rows.place(rows.first.size() - 1, 0),
            Text::tr("the angles must span 720° (or 360°, or 4π or 2π in radians), "
                     "the last row repeating the first"),
            format.in_radians ? Number{raw_span, units::radian} : Number{span, units::degree});
    } else {
        format.rows = series.angle.size();
    }
    check_length(series.angle.size());
    check_end(series.value, column, column.end_tolerance, format.unit,
              rows.place(rows.first.size() - 1, 1));
    if (may_be_open && series.value.back() != series.value.front()) {
        series.value.front() = (series.value.front() + series.value.back()) / 2.0;
        format.closed = true;
    }
    series.value.back() = series.value.front();
    format.strokes = period < cycle_deg ? 2 : 4;
    // Counted from the crank's first turns.
    if (std::abs(series.angle.front()) > 2.0 * cycle_deg) {
        const double turns = std::floor(series.angle.front() / cycle_deg) * cycle_deg;
        for (double& angle : series.angle) {
            angle -= turns;
        }
    }
    series.angle.back() = series.angle.front() + period;
    // Rounding of the units must not have undone the order.
    check_ascending(series.angle, [&](std::size_t i) { return rows.place(series.row[i], 0); });
    if (what == Measured::torque) {
        format.table = {std::move(series.angle), std::move(series.value)};
    } else {
        format.trace = {std::move(series.angle), std::move(series.value), format.unit,
                        format.unit_named};
    }
    return format;
}

TwoColumns read_columns(std::string_view text, Measured what, const TableReading& reading) {
    constexpr double max_turns = 1e5;
    const TwoColumnsRule rule{Text::tr("crank angle"), column_of(what).name,
                              Range::between(-max_turns * turn_deg, max_turns * turn_deg)};
    return read_two_columns(text, rule, reading.layout, reading.columns);
}

}  // namespace

ParsedCycle parse_cycle(Measured what, std::string_view text, const TableReading& reading) {
    return to_cycle(read_columns(text, what, reading), what, reading);
}

Message assumed_unit_note(const Unit& unit) {
    return {Text::tr("The heading of the pressure has no unit; the numbers look like %1."),
            Text{unit.name.data()}};
}

// ----------------------------------------------------------------------------- what a file may be

namespace {

/// What the numbers of a column are like.
struct ColumnLook {
    double numbers = 0.0;    ///< share of cells that are numbers
    double ascending = 0.0;  ///< share of steps that go up, or back by about whole turns
    double span_deg = 0.0;   ///< over all turns
    double lowest = 0.0;
    double low = 0.0;  ///< a fifth of the values are lower
    double peak = 0.0;
    double high_share = 1.0;  ///< of the values, above the middle of low and peak
};

ColumnLook look_at_column(const std::vector<double>& cells) {
    ColumnLook look;
    std::vector<double> values;
    for (const double cell : cells) {
        if (std::isfinite(cell)) {
            values.push_back(cell);
        }
    }
    if (values.size() < fewest_rows) {
        return look;
    }
    look.numbers = static_cast<double>(values.size()) / static_cast<double>(cells.size());
    const Series series = unrolled(values, std::vector<double>(values));
    if (series.angle.size() >= fewest_rows) {
        std::size_t up = 0;
        for (std::size_t i = 1; i < series.angle.size(); ++i) {
            up += series.angle[i] > series.angle[i - 1] ? 1 : 0;
        }
        look.ascending = static_cast<double>(up) / static_cast<double>(series.angle.size() - 1);
        look.span_deg = series.span() + series.last_step();
    }
    std::sort(values.begin(), values.end());
    look.lowest = values.front();
    look.low = values[values.size() / 5];
    look.peak = values.back();
    const double middle = (look.low + look.peak) / 2.0;
    look.high_share =
        static_cast<double>(values.end() - std::upper_bound(values.begin(), values.end(), middle)) /
        static_cast<double>(values.size());
    return look;
}

/// How much a column looks like the crank angle; below 0 it cannot be.
double angle_score(const ColumnLook& look, const std::string& heading) {
    if (look.ascending < 0.98) {
        return -1.0;
    }
    const std::string word = in_small_letters(heading);
    double score = 0.0;
    if (has_any(word,
                {"angle", "crank", "deg", "°", "phi", "φ", "theta", "θ", "угол", "град", "пкв"}) ||
        has_word(word, "ca") || has_word(word, "cad") || has_word(word, "rad")) {
        score += 3.0;
    }
    if (has_any(word, {"time", "врем", "index", "sample", "cycle"})) {
        score -= 3.0;
    }
    const auto is_whole = [&](double turn) {
        const double turns = look.span_deg / turn;
        return turns > 0.99 && std::abs(turns - std::round(turns)) < 0.01;
    };
    return score + (is_whole(turn_deg) ? 2.0 : is_whole(two_pi) ? 1.0 : 0.0);
}

double value_score(const ColumnLook& look, const std::string& heading, Measured what) {
    const std::string word = in_small_letters(heading);
    double score = look.ascending > 0.98 ? -2.0 : 0.0;
    if (what == Measured::torque) {
        return score + (named_torque_unit(heading) ? 3.0 : 0.0) +
               (has_any(word, {"torque", "moment", "момент"}) ? 3.0 : 0.0);
    }
    if (named_pressure_unit(heading)) {
        score += 3.0;
    }
    if (has_any(word, {"press", "давлен", "cyl"}) || has_word(word, "p")) {
        score += 2.0;
    }
    // One peak in a cycle, and hardly anything below the gas exchange.
    const double range = look.peak - look.low;
    score += range > 0.0 && look.high_share < 0.2 ? 2.0 : 0.0;
    score += range > 0.0 && look.lowest > look.low - 0.1 * range ? 1.0 : -1.0;
    return score;
}

std::size_t best_column(std::size_t columns, const auto& score, std::optional<std::size_t> other) {
    std::size_t best = other == 0U ? 1 : 0;
    for (std::size_t i = 0; i < columns; ++i) {
        if (i != other && score(i) > score(best)) {
            best = i;
        }
    }
    return best;
}

}  // namespace

Unit likely_unit(Measured what, std::vector<double> values) {
    if (what == Measured::torque) {
        return units::N_m;
    }
    const auto fifth = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 5);
    std::nth_element(values.begin(), fifth, values.end());
    const double low = *fifth;
    const double peak = *std::max_element(fifth, values.end());
    const bool by_low = low > 0.005 * peak;
    constexpr double usual_peak = 50e5;
    const auto misfit = [&](const Unit& unit) {
        const double ratio = by_low ? low * unit / atmosphere : peak * unit / usual_peak;
        // psi must be much likelier than the bar that it is near.
        return std::abs(std::log(ratio)) + (unit == units::psi ? 1.0 : 0.0);
    };
    Unit likely = units::bar;
    for (const Unit& unit : {units::kPa, units::MPa, units::pascal, units::psi}) {
        if (misfit(unit) < misfit(likely)) {
            likely = unit;
        }
    }
    return likely;
}

ReadingProposal propose_reading(std::string_view text, Measured what, const TableReading& decided) {
    const TableView view = look_at_table(text, decided.layout);
    ReadingProposal proposal;
    TableReading& reading = proposal.reading;
    reading = decided;
    reading.layout.separator = view.separator;
    reading.layout.header_lines = view.header_lines;
    proposal.headings = view.headings;
    // Rows that are enough; fewer of very many columns.
    const std::size_t enough =
        std::min<std::size_t>(20'000, 10'000'000 / std::max<std::size_t>(view.columns, 1));
    const auto cells = enough < fewest_rows ? std::vector<std::vector<double>>()
                                            : number_columns(text, view, enough);
    std::vector<ColumnLook> looks;
    for (const std::vector<double>& column : cells) {
        looks.push_back(look_at_column(column));
    }
    if (looks.empty() || cells.front().size() < fewest_rows || looks.front().numbers == 0.0) {
        throw InputError("", Text::tr("must have rows of numbers"));
    }
    const auto heading = [&](std::size_t column) {
        return view.headings.empty() ? std::string() : view.headings[column];
    };
    if (decided.columns[0].empty() || decided.columns[1].empty()) {
        const bool counts = looks.size() == 1;
        const auto angle =
            counts ? row_number
                   : best_column(
                         looks.size(),
                         [&](std::size_t i) { return angle_score(looks[i], heading(i)); },
                         std::nullopt);
        const auto value = best_column(
            looks.size(), [&](std::size_t i) { return value_score(looks[i], heading(i), what); },
            angle);
        reading.columns = {std::to_string(angle + 1), std::to_string(value + 1)};
        if (counts) {
            proposal.doubts.emplace_back(
                Text::tr("The file has no crank angles: equal steps over one cycle are assumed."));
        } else if (angle_score(looks[angle], heading(angle)) < 2.0) {
            proposal.doubts.emplace_back(
                Text::tr("The column of the crank angle is uncertain; column %1 is proposed."),
                angle + 1);
        }
    }
    try {
        TwoColumns chosen = read_columns(text, what, reading);
        const ColumnLook& look = looks[chosen.column[1]];
        const std::optional<Unit> named = named_unit(what, chosen.heading(1));
        if (!decided.unit) {
            reading.unit = named ? *named : likely_unit(what, chosen.second);
            if (!named && what == Measured::pressure) {
                proposal.doubts.push_back(assumed_unit_note(*reading.unit));
            }
        }
        if (what == Measured::pressure && !decided.gauge) {
            const double low = look.low * *reading.unit;
            constexpr double min_absolute = 0.15 * atmosphere;
            const bool says_so = names_gauge_pressure(chosen.heading(1));
            reading.gauge = says_so || look.lowest < 0.0 || low < min_absolute;
            if (*reading.gauge && !says_so) {
                proposal.doubts.emplace_back(
                    Text::tr("The minimum pressure is %1 %2: gauge pressure?"),
                    Number{look.lowest, {}, 4}, Text{reading.unit->name.data()});
            }
        }
        const TableFormat format = to_cycle(std::move(chosen), what, reading);
        reading.in_radians = format.in_radians;
        reading.strokes = format.strokes;
    } catch (const InputError& error) {
        proposal.doubts.push_back(
            {Text{"%1: %2."}, error.where_message(), error.allowed_message()});
    }
    return proposal;
}

}  // namespace ravnoves::balance_shaft

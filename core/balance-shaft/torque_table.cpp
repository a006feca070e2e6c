#include "balance-shaft/torque_table.h"

#include "balance-shaft/fields.h"
#include "case-file/decimal.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

int strokes_of(const std::vector<double>& crank_angle_deg) {
    return !crank_angle_deg.empty() &&
                   near(crank_angle_deg.back() - crank_angle_deg.front(), turn_deg)
               ? 2
               : 4;
}

void check_end(const std::vector<double>& values, const Column& column, double tolerance,
               const Unit& unit, const Message& place) {
    double largest = 0.0;
    for (const double value : values) {
        largest = std::max(largest, std::abs(value));
    }
    if (!(std::abs(values.back() - values.front()) <= tolerance * largest)) {
        const auto shown = [&](double value) { return Number{value / unit, unit}; };
        throw InputError(place,
                         {Text::tr("must equal the first %1, %2, since the cycle repeats"),
                          column.name, shown(values.front())},
                         shown(values.back()));
    }
}

namespace {

Number count(const std::vector<double>& values) {
    return {static_cast<double>(values.size())};
}

void check_table(const std::vector<double>& angle, const std::vector<double>& value,
                 const Column& column, const Unit& unit, const std::string& angles,
                 const std::string& values) {
    if (angle.size() != value.size()) {
        throw InputError(
            values,
            {Text::tr("must have as many numbers as %1, %2"), field::table_angle.key, angle.size()},
            count(value));
    }
    if (angle.size() < 3) {
        throw InputError(angles, Text::tr("must have at least 3 numbers"), count(angle));
    }
    if (angle.size() > largest_torque_table) {
        throw InputError(
            angles,
            {Text::tr("must have at most %1 numbers: average the cycles, or use larger steps"),
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
    constexpr double min_gap_deg = 1e-9;
    for (std::size_t i = 1; i < angle.size(); ++i) {
        if (!(angle[i] - angle[i - 1] >= min_gap_deg)) {
            throw InputError(
                angles + "/" + std::to_string(i),
                {Text::tr("must be at least %1 more than the angle of the row before, %2"),
                 Number{min_gap_deg, units::degree}, angle[i - 1]},
                Number{angle[i]});
        }
    }
    check_end(value, column, torque_column.end_tolerance, unit,
              values + "/" + std::to_string(value.size() - 1));
    const double span = angle.back() - angle.front();
    const double cycle_deg = turn_deg * strokes_of(angle) / 2.0;
    if (std::abs(span - cycle_deg) > 1e-9 * cycle_deg) {
        throw InputError(
            angles,
            Text::tr("must span 720°, or 360° for a two-stroke engine, the last row repeating the "
                     "first"),
            Number{span, units::degree});
    }
}

std::string written(const char* header, const std::vector<double>& angles,
                    const std::vector<double>& values, const Unit& unit) {
    std::string text = header;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        text += format_number(angles[i]) + "," + format_number(values[i] / unit) + "\n";
    }
    return text;
}

}  // namespace

void check_torque_table(const TorqueTable& table, const std::string& where) {
    check_table(table.crank_angle_deg, table.torque, torque_column, units::N_m,
                where + "/crank_angle_deg", where + "/torque_Nm");
}

void check_pressure_trace(const PressureTrace& trace, const std::string& where) {
    check_table(trace.crank_angle_deg, trace.pressure, pressure_column, units::pascal, where,
                where);
}

std::string write_torque_table(const TorqueTable& table) {
    return written("crank_angle_deg,torque_Nm\n", table.crank_angle_deg, table.torque, units::N_m);
}

std::string write_pressure_trace(const PressureTrace& trace) {
    return written("crank angle (deg),pressure (bar)\n", trace.crank_angle_deg, trace.pressure,
                   units::bar);
}

}  // namespace ravnoves::balance_shaft

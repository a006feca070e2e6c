#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balance-shaft/cylinder_gas.h"
#include "balance-shaft/torque_table.h"
#include "case-file/message.h"
#include "case-file/two_columns.h"
#include "numerics/units.h"

namespace ravnoves::balance_shaft {

/// Measured values of a file beside the crank angle.
enum class Measured { torque, pressure };

/// How a file of measured values is read. Empty members follow from the words and the numbers of
/// the file. A case keeps columns, unit and gauge.
struct TableReading {
    TableLayout layout;
    /// Of angle and value: numbers from 1, or headings; both empty: the file has two. An angle's of
    /// 0: the file has none, its rows are equal steps over one cycle.
    std::array<std::string, 2> columns;
    std::optional<Unit> unit;        ///< one of units_of()
    std::optional<bool> gauge;       ///< a pressure above the atmosphere, 1.01325 bar
    std::optional<bool> in_radians;  ///< the angles
    std::optional<int> strokes;      ///< of the cycle, where the file has more than one

    bool operator==(const TableReading&) const = default;
};

/// The units that a file may have, the usual one first.
std::vector<Unit> units_of(Measured what);

/// How a file of measured values was read, for the page to say.
struct TableFormat {
    char separator = '\t';         ///< between the columns: comma, semicolon, tab or blank
    std::size_t header_lines = 0;  ///< lines of words above the rows
    bool in_radians = false;       ///< angles, by the heading or by the span
    int strokes = 4;               ///< of the cycle: 2 for 360°
    bool decimal_comma = false;
    Unit unit;               ///< of the values
    bool unit_named = true;  ///< by the heading or by the reading; else the likely one is taken
    bool gauge = false;      ///< the atmosphere was added
    std::size_t rows = 0;    ///< of the cycle, without one that was added to close it
    std::size_t cycles = 1;  ///< whole ones, which were averaged
    double left_over = 0.0;  ///< behind them, rad
    bool closed = false;     ///< a pressure trace's end was made to meet its start
    Measured what = Measured::torque;

    /// "49 rows, separated by semicolons, decimal comma, angles in degrees": one sentence without
    /// the full stop.
    Message describe() const;
};

/// What a file has of the two.
struct ParsedCycle : TableFormat {
    TorqueTable table;
    PressureTrace trace;
};

/// Reads one cycle from CSV text or from what a spreadsheet puts on the clipboard.
///
/// Two columns, crank angle and value, or those that the reading names (read_two_columns()).
/// Angles in degrees or radians: the header says which ("rad", "deg", "°"), else the span (720,
/// 360, 4π or 2π within 0.1 %). A span of 360° is the cycle of a two-stroke engine. Angles may
/// begin anywhere, and may begin again at each turn or cycle. A file of more than one cycle is
/// averaged over its whole cycles, at the angles of the first; the strokes tell how long one is,
/// else the values themselves. Torques in N·m, or in what the heading names: kN·m, lbf·ft, lbf·in.
///
/// The unit of a pressure is what the heading names ("Pa", "kPa", "MPa", "bar", "mbar", "psi"),
/// else what the size of the numbers suggests; a heading that names gauge pressure ("bar(g)",
/// "gauge") is believed, too. A cycle that lacks its last row is closed, and one whose end differs
/// from its start by at most 2 % of the peak (a measured trace always does) is made to meet it half
/// way.
/// @throws InputError that names line and column ("line 4, column 2"), or the row for a table that
///         is not one cycle: unsorted, duplicate angle, too few rows or more than
///         largest_torque_table, end that differs from start
ParsedCycle parse_cycle(Measured what, std::string_view text, const TableReading& reading = {});

/// Of values without a unit: N·m, or what makes pressures an engine's: about an atmosphere where
/// the gas is exchanged (a fifth of the values are lower), or by the peak where that is the zero.
Unit likely_unit(Measured what, std::vector<double> values);

/// That the unit of a pressure is the likely one.
Message assumed_unit_note(const Unit& unit);

/// What a look at a file proposes, for a person to change.
struct ReadingProposal {
    TableReading reading;  ///< complete but for the decimal sign, which the numbers show
    std::vector<std::string> headings;  ///< of the columns; empty where there are none
    std::vector<Message> doubts;        ///< doubts with their reason: "gauge pressure?"
};

/// Looks at the lines of a file: separator, decimal sign, header lines, which column is the angle
/// and which the pressure (or torque), unit, gauge or absolute, strokes.
/// @param decided  the user's decisions; all else is proposed again
/// @throws InputError where the text has no rows of at least two numbers
ReadingProposal propose_reading(std::string_view text, Measured what,
                                const TableReading& decided = {});

}  // namespace ravnoves::balance_shaft

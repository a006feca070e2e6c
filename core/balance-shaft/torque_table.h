#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "balance-shaft/cylinder_gas.h"
#include "case-file/message.h"

namespace ravnoves::balance_shaft {

/// Engine torque M_id over one cycle, at rows of ascending crank angle.
///
/// The last row repeats the first one cycle later: its angle is the first angle + 720°
/// (four-stroke) or 360° (two-stroke), its torque is the first torque. Angles are kept in degrees
/// because tables are written in them: 15° stays 15°.
struct TorqueTable {
    std::vector<double> crank_angle_deg;  ///< °, from top dead centre, in the direction of rotation
    std::vector<double> torque;           ///< N·m, as many as angles

    std::size_t size() const { return crank_angle_deg.size(); }
    bool operator==(const TorqueTable&) const = default;
};

inline constexpr std::size_t largest_torque_table = 20'000;  ///< rows; 0.1° takes 7201
inline constexpr double largest_torque = 1e12;               ///< N·m

inline constexpr double largest_pressure = 1e10;  ///< Pa

/// Strokes of the cycle that rows span: 2 for 360°, else 4.
int strokes_of(const std::vector<double>& crank_angle_deg);

/// What the text of a table of two columns turned out to be, for the page to say.
struct TableFormat {
    char separator = '\t';    ///< between the columns: comma, semicolon, tab or blank
    bool has_header = false;  ///< the first line held words
    bool in_radians = false;  ///< angles were in radians (by the header or by the span)
    int strokes = 4;          ///< of the cycle that the angles span: 2 for 360°
    bool decimal_comma = false;
    std::size_t rows = 0;            ///< of the table
    std::string_view pressure_unit;  ///< "bar", "kPa" and so on, of a pressure trace
    bool unit_named = true;          ///< the header names it; else bar is taken
    std::string_view torque_unit;    ///< of a torque table, where it is not N·m
    bool closed = false;             ///< a pressure trace's end was made to meet its start

    /// "49 rows, separated by semicolons, decimal comma, angles in degrees": one sentence without
    /// the full stop.
    Message describe() const;
};

struct ParsedTorqueTable : TableFormat {
    TorqueTable table;
};

struct ParsedPressureTrace : TableFormat {
    PressureTrace trace;
};

/// Reads a torque table from CSV text or from what a spreadsheet puts on the clipboard.
///
/// Two columns, crank angle and torque, separated by semicolon, tab, comma or blanks; decimal point
/// or comma; a header line, empty lines, a byte-order mark and lines that begin with '#' are
/// passed over. Further columns are refused. Angles in degrees or radians: the header says which
/// ("rad", "deg", "°"), else the span (720, 360, 4π or 2π within 0.1 %). A span of 360° is the
/// cycle of a two-stroke engine. Torques in N·m, or in what the header names: kN·m, lbf·ft, lbf·in.
/// @throws InputError that names line and column ("line 4, column 2"), or the row for a table that
///         is not one cycle: unsorted, duplicate angle, too few rows, end that differs from start
ParsedTorqueTable parse_torque_table(std::string_view text);

/// Reads a measured pressure trace the same way. The unit of the second column is what the header
/// names ("Pa", "kPa", "MPa", "bar", "psi"), else bar; absolute pressures, not below 0. A cycle
/// that lacks its last row is closed, and one whose end differs from its start by at most 2 % of
/// the peak (a measured trace always does) is made to meet it half way.
/// @throws InputError as parse_torque_table()
ParsedPressureTrace parse_pressure_trace(std::string_view text);
/// Checks a trace as check_torque_table() does; pressures from 0 to largest_pressure.
/// @throws InputError
void check_pressure_trace(const PressureTrace& trace, const std::string& where);

/// Checks that a table is one cycle: at least 3 rows, finite, angles ascending, span of 720° or
/// 360°, last torque equal to the first (to 1e-9 of the largest), at most largest_torque_table
/// rows.
/// @param where  JSON pointer of the object that holds crank_angle_deg and torque_Nm
/// @throws InputError
void check_torque_table(const TorqueTable& table, const std::string& where);

/// The table as CSV with a header, decimal point and comma, for the clipboard or a file.
std::string write_torque_table(const TorqueTable& table);

}  // namespace ravnoves::balance_shaft

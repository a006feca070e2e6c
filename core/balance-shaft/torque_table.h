#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "balance-shaft/cylinder_gas.h"

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

/// Checks a trace as check_torque_table() does; pressures from 0 to largest_pressure.
/// @throws InputError
void check_pressure_trace(const PressureTrace& trace, const std::string& where);

/// Checks that a table is one cycle: at least 3 rows, finite, angles ascending, span of 720° or
/// 360°, last torque equal to the first (to 1e-9 of the largest), at most largest_torque_table
/// rows.
/// @param where  JSON pointer of the object with crank_angle_deg and torque_Nm
/// @throws InputError
void check_torque_table(const TorqueTable& table, const std::string& where);

/// The table as CSV with a header, decimal point and comma, for the clipboard or a file.
std::string write_torque_table(const TorqueTable& table);
/// A trace likewise, in bar.
std::string write_pressure_trace(const PressureTrace& trace);

}  // namespace ravnoves::balance_shaft

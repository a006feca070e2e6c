#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "balance-shaft/cylinder_gas.h"
#include "case-file/input_error.h"
#include "case-file/range.h"

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
inline constexpr double largest_pressure = 1e10;             ///< Pa
inline constexpr double largest_angle_deg = 1e5;

/// A column beside the angles.
struct Column {
    Text name;
    Range range;           ///< in SI
    double end_tolerance;  ///< of the largest value
};

inline constexpr Column torque_column{Text::tr("torque"),
                                      Range::between(-largest_torque, largest_torque), 1e-9};
inline constexpr Column pressure_column{Text::tr("pressure"), Range::between(0.0, largest_pressure),
                                        0.02};

/// To 0.1 %, for tables rounded by hand.
inline bool near(double value, double wanted) {
    return std::abs(value - wanted) <= 1e-3 * wanted;
}

/// @param place  of a row's angle
void check_ascending(const std::vector<double>& angles, const auto& place) {
    for (std::size_t i = 1; i < angles.size(); ++i) {
        const double previous = angles[i - 1];
        if (!(angles[i] > previous)) {
            throw InputError(
                place(i),
                {angles[i] == previous
                     ? Text::tr("must not repeat the angle of the row before, %1")
                     : Text::tr("must be greater than the angle of the row before, %1"),
                 previous},
                Number{angles[i]});
        }
    }
}

/// The last value must be the first.
void check_end(const std::vector<double>& values, const Column& column, double tolerance,
               const Unit& unit, const Message& place);

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

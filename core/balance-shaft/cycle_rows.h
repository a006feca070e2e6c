#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "balance-shaft/torque_table.h"
#include "case-file/input_error.h"
#include "case-file/range.h"

namespace ravnoves::balance_shaft {

/// What rows of one cycle must be, from a case or from a file.
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
        if (angles[i] == previous) {
            throw InputError(
                place(i), {Text::tr("must not repeat the angle of the row before, %1"), previous},
                Number{angles[i]});
        }
        if (!(angles[i] > previous)) {
            throw InputError(
                place(i),
                {Text::tr("must be greater than the angle of the row before, %1"), previous},
                Number{angles[i]});
        }
    }
}

/// The last value must be the first.
void check_end(const std::vector<double>& values, const Column& column, double tolerance,
               const Unit& unit, const Message& place);

}  // namespace ravnoves::balance_shaft

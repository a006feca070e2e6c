#pragma once

#include <numbers>

namespace ravnoves {

inline constexpr double pi = std::numbers::pi;
inline constexpr double two_pi = 2.0 * pi;
inline constexpr double degree = pi / 180.0;  ///< rad per degree
inline constexpr double turn_deg = 360.0;
inline constexpr double standard_gravity = 9.80665;  ///< m/s², [iso-80000-3]
inline constexpr double steel_density = 7850.0;      ///< kg/m³, carbon steel

}  // namespace ravnoves

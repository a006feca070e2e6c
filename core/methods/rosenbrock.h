#pragma once

#include <functional>
#include <vector>

namespace ravnoves::methods {

/// y′ = slope(x, y) with its partial derivatives.
struct ScalarEquation {
    std::function<double(double x, double y)> slope;
    std::function<double(double x, double y)> by_y;
    std::function<double(double x, double y)> by_x;
};

/// Integrates with Boost.Odeint's Rosenbrock method of order 4 (implicit, with step control).
/// @param x    ascending places at which values are wanted, the start first
/// @param out  as many values; out[0] holds the start's on entry
/// @return false where the steps shrink to nothing or a value is not finite
bool integrate_rosenbrock(const ScalarEquation& equation, const std::vector<double>& x,
                          double absolute_tolerance, double relative_tolerance, double* out);

}  // namespace ravnoves::methods

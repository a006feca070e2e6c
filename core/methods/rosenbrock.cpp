// Compiled as C++17 (see core/CMakeLists.txt): Boost 1.74's uBLAS, on which Odeint's implicit
// methods rest, uses allocator members that C++20 took out.

#include "methods/rosenbrock.h"

#include <algorithm>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>
#include <cmath>
#include <utility>

namespace ravnoves::methods {

bool integrate_rosenbrock(const ScalarEquation& equation, const std::vector<double>& x,
                          double absolute_tolerance, double relative_tolerance, double* out) {
    namespace odeint = boost::numeric::odeint;
    using Vector = boost::numeric::ublas::vector<double>;
    using Matrix = boost::numeric::ublas::matrix<double>;
    // x rides along as a second unknown: with a right-hand side that depends on the independent
    // variable, rosenbrock4 of Boost 1.74 falls to order 1.
    const auto system = [&](const Vector& state, Vector& slope, double /*time*/) {
        slope[0] = equation.slope(state[1], state[0]);
        slope[1] = 1.0;
    };
    const auto jacobian = [&](const Vector& state, Matrix& by_state, double /*time*/,
                              Vector& by_time) {
        by_state(0, 0) = equation.by_y(state[1], state[0]);
        by_state(0, 1) = equation.by_x(state[1], state[0]);
        by_state(1, 0) = 0.0;
        by_state(1, 1) = 0.0;
        by_time[0] = 0.0;
        by_time[1] = 0.0;
    };
    odeint::rosenbrock4_controller<odeint::rosenbrock4<double>> stepper(absolute_tolerance,
                                                                        relative_tolerance);
    Vector state(2);
    state[0] = out[0];
    state[1] = x.front();
    double h = x[1] - x[0];
    for (std::size_t i = 1; i < x.size(); ++i) {
        double at = x[i - 1];
        constexpr int most_tries = 2000;
        int tries = 0;
        while (at < x[i]) {
            const bool last = at + h >= x[i];
            double step = last ? x[i] - at : h;
            const double tried = step;
            const auto outcome =
                stepper.try_step(std::make_pair(system, jacobian), state, at, step);
            if (outcome == odeint::success && last) {
                at = x[i];  // the place itself, not its neighbour by rounding
                state[1] = at;
                h = std::max(h, step);
            } else {
                h = step;
            }
            constexpr double no_step = 1e-16;
            if (++tries > most_tries || !(std::abs(tried) > no_step) || !std::isfinite(state[0])) {
                return false;
            }
        }
        out[i] = state[0];
    }
    return true;
}

}  // namespace ravnoves::methods

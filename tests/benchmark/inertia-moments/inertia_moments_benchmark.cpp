#include <benchmark/benchmark.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "numerics/constants.h"
#include "numerics/slider_crank.h"

namespace ravnoves {
namespace {

constexpr SliderCrank<double> vr5_crank{0.045, 0.045 / 0.265, 0.0125};

/// Piston's way, speed and acceleration at every half degree, exact.
void PistonOfSliderCrank(benchmark::State& state) {
    std::vector<PistonMotion<double>> motion(721);
    for (auto _ : state) {
        for (std::size_t i = 0; i < motion.size(); ++i) {
            motion[i] = vr5_crank.at(static_cast<double>(i) * 0.5 * degree);
        }
        benchmark::DoNotOptimize(motion.data());
        benchmark::ClobberMemory();
    }
}
BENCHMARK(PistonOfSliderCrank)->Unit(benchmark::kMicrosecond);

/// The rival: the general way of programs for any mechanism. The loop of crank, rod and cylinder is
/// closed by Newton's method at every angle, from the angle before; speed and acceleration follow
/// from its Jacobian.
void PistonByNewtonClosure(benchmark::State& state) {
    const auto& [r, l, e] = vr5_crank;
    std::vector<PistonMotion<double>> motion(721);
    for (auto _ : state) {
        Eigen::Vector2d q(r + l, 0.0);  // the pin's way s, the rod's angle ψ
        for (std::size_t i = 0; i < motion.size(); ++i) {
            const double theta = static_cast<double>(i) * 0.5 * degree;
            const double x = r * std::cos(theta);
            const double y = r * std::sin(theta);
            Eigen::Matrix2d jacobian;
            for (int step = 0; step < 20; ++step) {
                const double along = l * std::cos(q[1]);
                const double across = l * std::sin(q[1]);
                jacobian << 1.0, across, 0.0, along;
                const Eigen::Vector2d gap(q[0] - x - along, y + across - e);
                const Eigen::Vector2d change = jacobian.partialPivLu().solve(gap);
                q -= change;
                if (change.norm() < 1e-14) {
                    break;
                }
            }
            const double along = l * std::cos(q[1]);
            const double across = l * std::sin(q[1]);
            jacobian << 1.0, across, 0.0, along;
            const auto factors = jacobian.partialPivLu();
            const Eigen::Vector2d dq = factors.solve(Eigen::Vector2d(-y, -x));
            const double square = dq[1] * dq[1];
            const Eigen::Vector2d d2q =
                factors.solve(Eigen::Vector2d(-x - along * square, y + across * square));
            motion[i] = {q[0], dq[0], d2q[0]};
        }
        benchmark::DoNotOptimize(motion.data());
        benchmark::ClobberMemory();
    }
}
BENCHMARK(PistonByNewtonClosure)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ravnoves

#include <benchmark/benchmark.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "inertia-moments/scene.h"
#include "inertia-moments/solver.h"
#include "numerics/constants.h"
#include "numerics/slider_crank.h"

namespace ravnoves::inertia_moments {
namespace {

Input vr(int cylinders, std::vector<int> firing_order) {
    const Json json = parse_json(R"({"crank_radius_mm": 45, "lambda": 0.265, "speed_rpm": 6200,
        "reciprocating_mass_kg": 0.622, "rotating_mass_kg": 0.8,
        "layout": {"type": "vr", "cylinders": 5, "bank_angle_deg": 15, "offset_mm": 12.5,
                   "spacing_mm": 63, "firing_order": [1, 2, 4, 5, 3], "first_position_mm": 204.8}
        })");
    Input input = read_input(json);
    input.layout->cylinders = cylinders;
    input.layout->firing_order = std::move(firing_order);
    return input;
}

Input vr6() {
    return vr(6, {1, 5, 3, 6, 2, 4});
}

/// The page's promise: exact orders 1…12 of a VR6 in at most 30 µs.
void ExactOrdersOfVr6(benchmark::State& state) {
    const Engine engine = make_engine(vr6());
    for (auto _ : state) {
        benchmark::DoNotOptimize(exact_orders(engine));
    }
}
BENCHMARK(ExactOrdersOfVr6)->Unit(benchmark::kMicrosecond);

/// The same from the form's numbers, crankpins included.
void ExactOrdersOfVr6FromInput(benchmark::State& state) {
    const Input input = vr6();
    for (auto _ : state) {
        benchmark::DoNotOptimize(exact_orders(make_engine(input)));
    }
}
BENCHMARK(ExactOrdersOfVr6FromInput)->Unit(benchmark::kMicrosecond);

void TwoTermOrdersOfVr6(benchmark::State& state) {
    const Engine engine = make_engine(vr6());
    for (auto _ : state) {
        benchmark::DoNotOptimize(two_term_orders(engine));
    }
}
BENCHMARK(TwoTermOrdersOfVr6)->Unit(benchmark::kMicrosecond);

/// One step of a slider: everything, with curves at 1° and four shafts.
void SolveVr6(benchmark::State& state) {
    Input input = vr6();
    for (const int order : {1, 2}) {
        for (const Direction direction : {Direction::forward, Direction::backward}) {
            Shaft shaft;
            shaft.order = order;
            shaft.direction = direction;
            input.shafts.push_back(shaft);
        }
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(solve(input));
    }
}
BENCHMARK(SolveVr6)->Unit(benchmark::kMicrosecond);

void ExactCurvesOfVr6(benchmark::State& state) {
    const Engine engine = make_engine(vr6());
    for (auto _ : state) {
        benchmark::DoNotOptimize(exact_curves(engine, 360));
    }
}
BENCHMARK(ExactCurvesOfVr6)->Unit(benchmark::kMicrosecond);

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
}  // namespace ravnoves::inertia_moments

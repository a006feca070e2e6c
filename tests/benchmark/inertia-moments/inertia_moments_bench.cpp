#include <benchmark/benchmark.h>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "inertia-moments/scene.h"
#include "inertia-moments/solver.h"

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

}  // namespace
}  // namespace ravnoves::inertia_moments

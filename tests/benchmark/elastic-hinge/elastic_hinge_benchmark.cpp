#include <benchmark/benchmark.h>

#include "elastic-hinge/guide_export.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/solver.h"

namespace ravnoves::elastic_hinge {
namespace {

/// All that the page draws: the curves, the side force for five λ, all curves for three ω.
SolveOptions page_options() {
    SolveOptions options;
    options.speeds = {100.0, 300.0, 500.0};
    options.lambdas = {0.3, 0.4, 0.6, 0.8};
    return options;
}

void all_curves_of_the_page(benchmark::State& state) {
    Input input = preset_zotov();
    if (state.range(0) != 0) {
        input.rod_counterweight =
            RodCounterweight{0.1, std::nullopt, CounterweightInertia::newton_euler};
    }
    const SolveOptions options = page_options();
    for (auto _ : state) {
        input.angular_speed = input.angular_speed == 100.0 ? 101.0 : 100.0;
        benchmark::DoNotOptimize(solve(input, options));
    }
}
BENCHMARK(all_curves_of_the_page)->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

void curves_near_the_locking_lambda(benchmark::State& state) {
    Input input = preset_zotov();
    input.lambda = 0.01 * static_cast<double>(state.range(0));
    const SolveOptions options = page_options();
    for (auto _ : state) {
        benchmark::DoNotOptimize(solve(input, options));
    }
}
BENCHMARK(curves_near_the_locking_lambda)
    ->ArgName("lambda_percent")
    ->Arg(95)
    ->Arg(99)
    ->Unit(benchmark::kMicrosecond);

void prepare_a_design(benchmark::State& state) {
    const Input input = preset_zotov();
    for (auto _ : state) {
        benchmark::DoNotOptimize(Design(input));
    }
}
BENCHMARK(prepare_a_design)->Unit(benchmark::kMicrosecond);

void motion_of_twenty_turns(benchmark::State& state) {
    Input input = preset_zotov();
    input.motion = MotionWish{20.0, {}, 0.0, 0.0, false};
    const Result result = solve(input);
    const auto hinges = static_cast<HingeSet>(state.range(0));
    for (auto _ : state) {
        benchmark::DoNotOptimize(simulate(input, result, hinges));
    }
}
BENCHMARK(motion_of_twenty_turns)
    ->ArgName("hinges")
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond);

void guide_search(benchmark::State& state) {
    const Result result = solve(preset_zotov());
    for (auto _ : state) {
        benchmark::DoNotOptimize(search_guide(result.design, Hinge::crank, GuideSign::energy,
                                              Branch::compressed, 0.2, 0.008,
                                              GuideWish{1e-3, 0.24, {}}));
    }
}
BENCHMARK(guide_search)->Unit(benchmark::kMicrosecond);

void guide_as_dxf(benchmark::State& state) {
    const Result result = solve(preset_zotov());
    for (auto _ : state) {
        benchmark::DoNotOptimize(guide_dxf(result.crank_guide, {}));
    }
}
BENCHMARK(guide_as_dxf)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ravnoves::elastic_hinge

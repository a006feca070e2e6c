#include <benchmark/benchmark.h>

#include <filesystem>
#include <random>

#include "bob-weights/matching.h"
#include "bob-weights/scene.h"
#include "bob-weights/solver.h"
#include "case-file/text_file.h"
#include "scenes/scenes.h"

namespace {

using namespace ravnoves::bob_weights;

Input example() {
    return read_input(
        ravnoves::parse_case(ravnoves::read_text_file(std::filesystem::path(RAVNOVES_EXAMPLES) /
                                                      "bob-weights-v8.case.json"))
            .input);
}

/// A whole case, holes and all, as the form solves it at every keystroke.
void bm_solve(benchmark::State& state) {
    const Input input = example();
    for (auto _ : state) {
        benchmark::DoNotOptimize(solve(input));
    }
}
BENCHMARK(bm_solve)->Unit(benchmark::kMicrosecond);

/// The same with a weigh-in sheet, whose parts are placed: what it costs beside the first.
void bm_solve_and_match(benchmark::State& state) {
    Input input = example();
    input.engine.cylinders = static_cast<int>(state.range(0));
    input.weigh_in.emplace();
    fit_weigh_in(input);
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> mass(0.495, 0.505);  // kg
    for (auto& column : input.weigh_in->columns) {
        for (auto& weighed : column.mass) {
            weighed = mass(generator);
        }
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(solve(input));
    }
}
BENCHMARK(bm_solve_and_match)->Arg(4)->Arg(6)->Arg(8)->Unit(benchmark::kMillisecond);

}  // namespace

#include <benchmark/benchmark.h>

#include <filesystem>
#include <random>

#include "case-file/text_file.h"
#include "scenes/scenes.h"
#include "v8-plugs/scene.h"
#include "v8-plugs/solver.h"

namespace {

using namespace ravnoves::v8_plugs;

std::vector<std::array<int, 2>> eight_cylinders() {
    const Crankpins pins = crankpins(CylinderNumbering::bank_by_bank);
    return {pins.begin(), pins.end()};
}

/// Masses that differ from part to part: one best assignment.
void bm_best_assignment(benchmark::State& state) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> deviation(-0.02, 0.02);
    std::vector<double> pistons(8);
    std::vector<double> rods(8);
    for (std::size_t i = 0; i < 8; ++i) {
        pistons[i] = deviation(generator);
        rods[i] = deviation(generator);
    }
    const auto pins = eight_cylinders();
    for (auto _ : state) {
        benchmark::DoNotOptimize(best_assignment(pistons, rods, pins));
    }
}
BENCHMARK(bm_best_assignment)->Unit(benchmark::kMillisecond);

/// Masses to the gram, so that thousands of assignments tie and the fewest moves are sought.
void bm_best_assignment_with_ties(benchmark::State& state) {
    std::vector<double> pistons(8, 0.0);
    std::vector<double> rods(8, 0.0);
    for (std::size_t i = 0; i < 8; ++i) {
        pistons[i] = i == 0 ? 0.003 : 0.0;
        rods[i] = i == 4 ? 0.003 : 0.0;
    }
    const auto pins = eight_cylinders();
    for (auto _ : state) {
        benchmark::DoNotOptimize(best_assignment(pistons, rods, pins));
    }
}
BENCHMARK(bm_best_assignment_with_ties)->Unit(benchmark::kMillisecond);

/// A whole case as the form solves it at every keystroke.
void bm_solve(benchmark::State& state) {
    const ravnoves::CaseFile file = ravnoves::parse_case(ravnoves::read_text_file(
        std::filesystem::path(RAVNOVES_EXAMPLES) / "v8-4.25-repair.case.json"));
    Input input = read_input(file.input);
    input.weigh_in.emplace();
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> deviation(-0.005, 0.005);
    for (const Part part : all_parts) {
        PartColumn& column = (*input.weigh_in)[part];
        column.nominal = 0.5;
        for (auto& mass : column.mass) {
            mass = 0.5 + deviation(generator);
        }
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(solve(input));
    }
}
BENCHMARK(bm_solve)->Unit(benchmark::kMicrosecond);

}  // namespace

#include <benchmark/benchmark.h>

#include <filesystem>
#include <random>

#include "case-file/text_file.h"
#include "scenes/scenes.h"
#include "v8-plugs/scene.h"
#include "v8-plugs/solver.h"

namespace {

using namespace ravnoves::v8_plugs;

/// Weights of eight pistons and eight big ends: grams above nominal.
void match_all(benchmark::State& state, const std::vector<double>& pistons,
               const std::vector<double>& rods, ravnoves::shop::MatchingGoal goal) {
    WeighIn sheet;
    for (const Part part : all_parts) {
        const bool with_piston = ravnoves::shop::is_of_piston(part);
        sheet[part].nominal = 0.5;
        for (std::size_t i = 0; i < 8; ++i) {
            sheet[part].mass[i] = 0.5 + (with_piston ? pistons : rods)[i];
        }
    }
    sheet.matching.goal = goal;
    const auto task = matching_task(sheet, Process::repair, 0.4);
    for (auto _ : state) {
        benchmark::DoNotOptimize(ravnoves::shop::match(task, sheet.matching));
    }
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
    match_all(state, pistons, rods, static_cast<ravnoves::shop::MatchingGoal>(state.range(0)));
}
BENCHMARK(bm_best_assignment)->Arg(0)->Arg(2)->Unit(benchmark::kMillisecond);

/// Masses to the gram, so that thousands of assignments tie and the fewest moves are sought.
void bm_best_assignment_with_ties(benchmark::State& state) {
    std::vector<double> pistons(8, 0.0);
    std::vector<double> rods(8, 0.0);
    pistons[0] = 0.003;
    rods[4] = 0.003;
    match_all(state, pistons, rods, ravnoves::shop::MatchingGoal::least_spread);
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

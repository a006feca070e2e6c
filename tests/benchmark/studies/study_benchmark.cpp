// Samples a second of a study, by one thread: the range of the balance shaft at its α, its best α,
// a value of every other scene, and whole cases as --batch --only solves them.

#include <benchmark/benchmark.h>

#include <string>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "scenes/scenes.h"
#include "studies/study_run.h"

namespace {

using namespace ravnoves;

std::string example(const std::string& name) {
    return read_text_file(std::string(RAVNOVES_EXAMPLES) + "/" + name + ".case.json");
}

/// Samples of a study whose basis is there.
void study(benchmark::State& state, const std::string& name, const Json& vary,
           const std::string& watched, const std::string& method) {
    constexpr std::uint64_t stretch = 100;
    CaseFile file = parse_case(example(name));
    file.study = {{"vary", vary},
                  {"watch", {{watched, Json::object()}}},
                  {"method", method},
                  {"samples", 1'000'000'000}};
    const studies::Problem problem = studies::problem_of(file, {});
    // Beyond the first samples, which are solved twice for the total sensitivities.
    studies::Part part = studies::begin_part(problem, 2, 2, 1);
    part.blocks.resize(1);
    studies::Block& block = part.blocks.front();
    std::uint64_t samples = 0;
    for (auto _ : state) {
        block.to = block.done + stretch * static_cast<std::uint64_t>(state.range(0));
        samples += block.to - block.done;
        studies::run_part(problem, part, 1);
    }
    state.counters["samples/s"] =
        benchmark::Counter(static_cast<double>(samples), benchmark::Counter::kIsRate);
}

const Json sizes = {{"/crank_radius_mm", {{"plus_minus", 0.02}}},
                    {"/reciprocating_masses_kg/piston", {{"normal_sd", 0.002}}},
                    {"/centre_distance_mm", {{"plus_minus_percent", 0.1}}}};
const Json ratio = {{"/crank_radius_mm", {{"plus_minus", 0.02}}},
                    {"/lambda", {{"plus_minus", 0.001}}}};
const Json torque = {{"/torque/torque_Nm/26", {{"plus_minus_percent", 1}}},
                     {"/torque/torque_Nm/27", {{"plus_minus_percent", 1}}}};
const std::string range = "/metrics/M_ups/range_Nm";

BENCHMARK_CAPTURE(study, range, "tmz-650d", sizes, range, "sobol")->Arg(1000);
BENCHMARK_CAPTURE(study, range_monte_carlo, "tmz-650d", sizes, range, "monte-carlo")->Arg(1000);
BENCHMARK_CAPTURE(study, range_of_torque, "tmz-650d", torque, range, "sobol")->Arg(1000);
BENCHMARK_CAPTURE(study, best_angle, "tmz-650d", sizes, "/optimum/range/shaft_angle_deg", "sobol")
    ->Arg(100);
BENCHMARK_CAPTURE(study, elastic_hinge, "zotov-energy", ratio, "/guide/minimum_preload_mm", "sobol")
    ->Arg(4);
BENCHMARK_CAPTURE(study, v8_plugs, "v8-4.25-repair",
                  Json{{"/mass_changes_g/piston", {{"normal_sd", 1}}}},
                  "/options/steel-machined/required_reduction_g", "sobol")
    ->Arg(10);
BENCHMARK_CAPTURE(study, inertia_moments, "vr5-volkswagen", ratio,
                  "/exact/order_1/force_N/forward/amplitude", "sobol")
    ->Arg(4);

/// One line of `solve --batch --only`.
void batch_only(benchmark::State& state) {
    const std::string text = Json::parse(example("tmz-650d")).dump();
    const Wanted wanted({"/metrics/M_ups/range_Nm", "/optimum/range"});
    for (auto _ : state) {
        benchmark::DoNotOptimize(solve_case(parse_case(text), {}, wanted).dump().size());
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(batch_only)->Unit(benchmark::kMicrosecond);

}  // namespace

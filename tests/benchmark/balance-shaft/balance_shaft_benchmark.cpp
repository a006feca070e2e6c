// What the balance-shaft page waits for: one position of the shaft, the sweep over its angle, the
// best angle. On the paper's table of 49 rows and on one of 721 rows (every degree).

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/presets.h"
#include "balance-shaft/solver.h"
#include "numerics/periodic_piecewise.h"

namespace {

using namespace ravnoves;
using namespace ravnoves::balance_shaft;

/// The paper's engine; its torque on the given rows, read off the periodic spline of Table 2.
Input engine(int rows, Interpolation interpolation = Interpolation::linear) {
    Input input = preset_tmz_650d();
    input.interpolation = interpolation;
    TorqueTable& table = input.torque.table;
    if (rows != static_cast<int>(table.size())) {
        const auto spline = PeriodicPiecewise::cubic(table.crank_angle_deg, table.torque);
        table = {};
        for (int i = 0; i < rows; ++i) {
            table.crank_angle_deg.push_back(720.0 * i / (rows - 1));
            table.torque.push_back(spline(720.0 * (i % (rows - 1)) / (rows - 1)));
        }
    }
    return input;
}

Interpolation interpolation_of(const benchmark::State& state) {
    return state.range(1) == 0 ? Interpolation::linear : Interpolation::periodic_cubic;
}

/// Curves of 721 points and all metrics at a new α.
void move_shaft(benchmark::State& state) {
    const Solver solver(engine(static_cast<int>(state.range(0)), interpolation_of(state)));
    Result result = solver.result();
    double alpha = 0.0;
    for (auto _ : state) {
        solver.move_shaft(alpha, result);
        benchmark::DoNotOptimize(result.curves.M_ups.data());
        benchmark::ClobberMemory();
        alpha += 0.0174;
    }
}
BENCHMARK(move_shaft)->ArgsProduct({{49, 721}, {0, 1}})->ArgNames({"rows", "cubic"});

/// Range and RMS at 360 angles, exact over the continuous cycle, as the page's sweep asks for them.
void sweep(benchmark::State& state) {
    const Solver solver(engine(static_cast<int>(state.range(0)), interpolation_of(state)));
    std::vector<double> alpha(360);
    for (std::size_t i = 0; i < alpha.size(); ++i) {
        alpha[i] = static_cast<double>(i) * degree;
    }
    std::vector<double> range(alpha.size());
    std::vector<double> rms(alpha.size());
    for (auto _ : state) {
        solver.moments().sweep(alpha, range, rms);
        benchmark::DoNotOptimize(range.data());
        benchmark::DoNotOptimize(rms.data());
        benchmark::ClobberMemory();
    }
}
BENCHMARK(sweep)
    ->ArgsProduct({{49, 721}, {0, 1}})
    ->ArgNames({"rows", "cubic"})
    ->Unit(benchmark::kMicrosecond);

/// The global minimum of the range over α.
void best_angle(benchmark::State& state) {
    const Solver solver(engine(static_cast<int>(state.range(0)), interpolation_of(state)));
    const double amplitude = solver.result().moment_amplitude;
    int evaluations = 0;
    for (auto _ : state) {
        const AngleMinimum best = minimise_range(solver.moments().plane, amplitude);
        evaluations = best.evaluations;
        benchmark::DoNotOptimize(best.alpha);
    }
    state.counters["evaluations"] = evaluations;
}
BENCHMARK(best_angle)
    ->ArgsProduct({{49, 721}, {0, 1}})
    ->ArgNames({"rows", "cubic"})
    ->Unit(benchmark::kMicrosecond);

/// For comparison: one range by a plain loop over 721 samples, not exact.
void plain_range_sweep(benchmark::State& state) {
    const Result result = solve(engine(721));
    const auto count = static_cast<Eigen::Index>(result.curves.M_up.size());
    const Eigen::ArrayXd moment =
        Eigen::Map<const Eigen::ArrayXd>(result.curves.M_up.data(), count);
    const Eigen::ArrayXd phi =
        Eigen::Map<const Eigen::ArrayXd>(result.curves.crank_angle_deg.data(), count) * degree;
    const Eigen::ArrayXd cosine = phi.cos();
    const Eigen::ArrayXd sine = phi.sin();
    std::vector<double> range(360);
    for (auto _ : state) {
        for (std::size_t i = 0; i < range.size(); ++i) {
            const double alpha = static_cast<double>(i) * degree;
            const double x = result.moment_amplitude * std::sin(alpha);
            const double y = result.moment_amplitude * std::cos(alpha);
            range[i] = (moment + x * cosine + y * sine).maxCoeff() -
                       (moment + x * cosine + y * sine).minCoeff();
        }
        benchmark::DoNotOptimize(range.data());
        benchmark::ClobberMemory();
    }
}
BENCHMARK(plain_range_sweep)->Unit(benchmark::kMicrosecond);

}  // namespace

// What the balance-shaft page waits for: one position of the shaft, the sweep over its angle, the
// map. On 721 rows (every degree); the map on the paper's table of 49.

#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/position_study.h"
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

/// Of the rows of a benchmark.
Solver solver_of(const benchmark::State& state, bool cubic = false) {
    return Solver(engine(static_cast<int>(state.range(0)),
                         cubic ? Interpolation::periodic_cubic : Interpolation::linear));
}

/// Curves of 721 points and all metrics at a new α.
void move_shaft(benchmark::State& state) {
    const Solver solver = solver_of(state, state.range(1) != 0);
    Result result = solver.result();
    double alpha = 0.0;
    for (auto _ : state) {
        solver.move_shaft(alpha, result);
        benchmark::DoNotOptimize(result.curves.M_ups.data());
        benchmark::ClobberMemory();
        alpha += 0.0174;
    }
}
BENCHMARK(move_shaft)->ArgsProduct({{721}, {0, 1}})->ArgNames({"rows", "cubic"});

/// Range and RMS at 360 angles, exact over the continuous cycle, as the page's sweep asks for them.
void sweep(benchmark::State& state) {
    const Solver solver = solver_of(state, state.range(1) != 0);
    std::vector<double> alpha(360);
    for (std::size_t i = 0; i < alpha.size(); ++i) {
        alpha[i] = static_cast<double>(i) * degree;
    }
    std::vector<double> range(alpha.size());
    std::vector<double> rms(alpha.size());
    for (auto _ : state) {
        balance_shaft::sweep(solver.moments().plane, solver.moments().forces.moment_amplitude,
                             alpha, range, rms);
        benchmark::DoNotOptimize(range.data());
        benchmark::DoNotOptimize(rms.data());
        benchmark::ClobberMemory();
    }
}
BENCHMARK(sweep)->ArgsProduct({{721}, {0, 1}})->ArgNames({"rows", "cubic"});

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
BENCHMARK(plain_range_sweep);

// The map of range and RMS over places; beside a plain grid in Eigen, which sees the torque at
// every degree alone.

/// M_up at every degree, with M_s of a place.
struct Samples {
    Eigen::ArrayXd moment, cos, sin;
    double force;

    explicit Samples(const Solver& solver)
        : moment(721), cos(721), sin(721), force(solver.moments().forces.counterweight_force) {
        for (int i = 0; i <= 720; ++i) {
            moment[i] = solver.M_up(i * degree);
            cos[i] = std::cos(i * degree);
            sin[i] = std::sin(i * degree);
        }
    }
    double range(double x, double y) const {
        const Eigen::ArrayXd sum = moment + force * x * cos + force * y * sin;
        return sum.maxCoeff() - sum.minCoeff();
    }
};

/// Range and RMS at 200 × 200 places, exact over the continuous cycle.
void map_of_places(benchmark::State& state) {
    const PositionStudy study(solver_of(state));
    for (auto _ : state) {
        benchmark::DoNotOptimize(study.map(-0.25, 0.25, -0.25, 0.25, 200, 200).range.data());
    }
}
BENCHMARK(map_of_places)->Arg(49);

/// The rival: ranges of the sampled torque.
void plain_map_of_places(benchmark::State& state) {
    const Samples samples(solver_of(state));
    std::vector<double> range(40'000);
    for (auto _ : state) {
        for (int i = 0; i < 40'000; ++i) {
            range[static_cast<std::size_t>(i)] =
                samples.range(-0.25 + 0.0025 * (i % 200), -0.25 + 0.0025 * (i / 200));
        }
        benchmark::DoNotOptimize(range.data());
        benchmark::ClobberMemory();
    }
}
BENCHMARK(plain_map_of_places)->Arg(49);

}  // namespace

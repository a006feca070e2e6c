// The place of the shaft: the best one from a prepared solver, the map of range and RMS; beside a
// plain grid in Eigen and the method of Nelder and Mead, which see the torque at every degree
// alone.

#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

#include "balance-shaft/position_study.h"
#include "balance-shaft/presets.h"
#include "numerics/constants.h"
#include "numerics/periodic_piecewise.h"

namespace {

using namespace ravnoves;
using namespace ravnoves::balance_shaft;

/// The paper's engine; its torque on the given rows, read off the periodic spline of Table 2.
Solver solver_of(const benchmark::State& state) {
    Input input = preset_tmz_650d();
    TorqueTable& table = input.torque.table;
    const auto rows = static_cast<int>(state.range(0));
    if (rows != static_cast<int>(table.size())) {
        const auto spline = PeriodicPiecewise::cubic(table.crank_angle_deg, table.torque);
        table = {};
        for (int i = 0; i < rows; ++i) {
            table.crank_angle_deg.push_back(720.0 * i / (rows - 1));
            table.torque.push_back(spline(720.0 * (i % (rows - 1)) / (rows - 1)));
        }
    }
    return Solver(input);
}

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

void best_place(benchmark::State& state) {
    const Solver solver = solver_of(state);
    for (auto _ : state) {
        benchmark::DoNotOptimize(PositionStudy(solver).best().rms->position.x);
    }
}
BENCHMARK(best_place)->Arg(49)->Arg(721)->Unit(benchmark::kMicrosecond);

/// Range and RMS at 200 × 200 places, exact over the continuous cycle.
void map_of_places(benchmark::State& state) {
    const PositionStudy study(solver_of(state));
    for (auto _ : state) {
        benchmark::DoNotOptimize(study.map(-0.25, 0.25, -0.25, 0.25, 200, 200).range.data());
    }
}
BENCHMARK(map_of_places)->Arg(49)->Arg(721)->Unit(benchmark::kMillisecond);

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
BENCHMARK(plain_map_of_places)->Arg(49)->Unit(benchmark::kMillisecond);

/// The rival: Nelder and Mead's simplex on the sampled torque until it is 1e-9 m small.
void nelder_mead_place(benchmark::State& state) {
    const Samples samples(solver_of(state));
    struct Corner {
        Eigen::Vector2d at;
        double range;
    };
    int evaluations = 0;
    double found = 0.0;
    for (auto _ : state) {
        evaluations = 0;
        const auto corner = [&](const Eigen::Vector2d& at) {
            ++evaluations;
            return Corner{at, samples.range(at.x(), at.y())};
        };
        std::array<Corner, 3> simplex{corner({0.0, 0.0}), corner({0.05, 0.0}), corner({0.0, 0.05})};
        while ((simplex[0].at - simplex[2].at).norm() + (simplex[1].at - simplex[2].at).norm() >
                   1e-9 &&
               evaluations < 1000) {
            std::sort(simplex.begin(), simplex.end(),
                      [](const Corner& a, const Corner& b) { return a.range < b.range; });
            const Eigen::Vector2d middle = (simplex[0].at + simplex[1].at) / 2.0;
            const Eigen::Vector2d away = middle - simplex[2].at;
            const Corner reflected = corner(middle + away);
            if (reflected.range < simplex[0].range) {
                const Corner expanded = corner(middle + 2.0 * away);
                simplex[2] = expanded.range < reflected.range ? expanded : reflected;
            } else if (reflected.range < simplex[1].range) {
                simplex[2] = reflected;
            } else {
                const bool outside = reflected.range < simplex[2].range;
                const Corner contracted = corner(middle + (outside ? 0.5 : -0.5) * away);
                if (contracted.range < std::min(reflected.range, simplex[2].range)) {
                    simplex[2] = contracted;
                } else {
                    simplex[1] = corner((simplex[0].at + simplex[1].at) / 2.0);
                    simplex[2] = corner((simplex[0].at + simplex[2].at) / 2.0);
                }
            }
        }
        found = simplex[0].range;
        benchmark::ClobberMemory();
    }
    state.counters["evaluations"] = evaluations;
    state.counters["range_Nm"] = found;
}
BENCHMARK(nelder_mead_place)->Arg(49)->Arg(721)->Unit(benchmark::kMicrosecond);

}  // namespace

/// What the balance-shaft page waits for, each beside a plain loop with Eigen. Then how the cost of
/// what a user may make large grows with its size: the exponent fitted to processor times over a
/// range of sizes, on log axes, and the one that theory gives. In lines for table.py.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/position_study.h"
#include "balance-shaft/presets.h"
#include "balance-shaft/solver.h"
#include "balance-shaft/speed_study.h"
#include "case-file/case_file.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "elastic-hinge/motion.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/result.h"
#include "inertia-moments/orders.h"
#include "inertia-moments/presets.h"
#include "inertia-moments/result.h"
#include "numerics/constants.h"
#include "numerics/periodic_piecewise.h"
#include "scenes/scenes.h"
#include "studies/study_run.h"

namespace {

using namespace ravnoves;

using Work = std::function<void()>;

struct Growth {
    std::string name;
    std::vector<int> sizes;
    double theory;  ///< exponent; of n log n what it is over these sizes
    std::function<Work(int size)> prepare;
};

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The smallest of some runs, each of at least a few milliseconds.
double seconds_of(const Work& work) {
    double minimum = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 3; ++run) {
        const double begin = processor_seconds();
        int times = 0;
        double taken = 0.0;
        do {
            work();
            ++times;
            taken = processor_seconds() - begin;
        } while (taken < 5e-3);
        minimum = std::min(minimum, taken / times);
    }
    return minimum;
}

/// The slope of log time over log size, by least squares.
double exponent_of(const std::vector<std::pair<double, double>>& points) {
    double x_mean = 0.0;
    double y_mean = 0.0;
    for (const auto& [size, time] : points) {
        x_mean += std::log(size) / static_cast<double>(points.size());
        y_mean += std::log(time) / static_cast<double>(points.size());
    }
    double xy = 0.0;
    double xx = 0.0;
    for (const auto& [size, time] : points) {
        xy += (std::log(size) - x_mean) * (std::log(time) - y_mean);
        xx += (std::log(size) - x_mean) * (std::log(size) - x_mean);
    }
    return xy / xx;
}

using balance_shaft::Interpolation;

/// The paper's engine; its torque on the given rows, read off the periodic spline of Table 2.
balance_shaft::Input engine(int rows, Interpolation interpolation) {
    balance_shaft::Input input = balance_shaft::preset_tmz_650d();
    input.interpolation = interpolation;
    balance_shaft::TorqueTable& table = input.torque.table;
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

/// The rival of the page: it sees the torque at every degree alone.
struct Samples {
    Eigen::ArrayXd moment{721}, cos{721}, sin{721};

    explicit Samples(const balance_shaft::Solver& solver) {
        for (int i = 0; i <= 720; ++i) {
            moment[i] = solver.M_up(i * degree);
            cos[i] = std::cos(i * degree);
            sin[i] = std::sin(i * degree);
        }
    }
    auto sum(double x, double y) const { return moment + x * cos + y * sin; }
};

struct Pair {
    const char* name;
    Work here, rival;
};

std::vector<Pair> all_pairs() {
    const auto solver_of = [](int rows, Interpolation interpolation) {
        return balance_shaft::Solver(engine(rows, interpolation));
    };
    const balance_shaft::Solver linear = solver_of(721, Interpolation::linear);
    const balance_shaft::Solver cubic = solver_of(721, Interpolation::periodic_cubic);
    const balance_shaft::Solver paper = solver_of(49, Interpolation::linear);
    const double amplitude = linear.moments().forces.moment_amplitude;
    constexpr int angles = 360;
    // Range and RMS, exact over the continuous cycle.
    const auto sweep = [=](const balance_shaft::Solver& solver) -> Work {
        std::vector<double> alpha(angles), range(angles), rms(angles);
        for (int i = 0; i < angles; ++i) {
            alpha[static_cast<std::size_t>(i)] = i * degree;
        }
        return [=]() mutable {
            balance_shaft::sweep(solver.moments().plane, amplitude, alpha, range, rms);
        };
    };
    const auto plain_sweep = [=](int count) -> Work {
        std::vector<double> range(static_cast<std::size_t>(count));
        return [=, samples = Samples(linear)]() mutable {
            for (std::size_t i = 0; i < range.size(); ++i) {
                const double alpha = static_cast<double>(i) * degree;
                const auto sum =
                    samples.sum(amplitude * std::sin(alpha), amplitude * std::cos(alpha));
                range[i] = sum.maxCoeff() - sum.minCoeff();
            }
        };
    };
    const auto move = [](const balance_shaft::Solver& solver) -> Work {
        return [=, result = solver.result(), alpha = 0.0]() mutable {
            solver.move_shaft(alpha, result);
            alpha += 0.0174;
        };
    };
    constexpr double reach = 0.25;
    constexpr int places = 200;
    const auto plain_map = [=, samples = Samples(paper), range = std::vector<double>(),
                            force = paper.moments().forces.counterweight_force]() mutable {
        range.clear();
        for (int row = 0; row < places; ++row) {
            for (int column = 0; column < places; ++column) {
                const double step = force * 2.0 * reach / places;
                const Eigen::ArrayXd sum =
                    samples.sum(step * column - force * reach, step * row - force * reach);
                range.push_back(sum.maxCoeff() - sum.minCoeff());
            }
        }
    };
    return {{"360 α of 721 rows: exact range and RMS (rival: ranges of samples, Eigen)",
             sweep(linear), plain_sweep(angles)},
            {"360 α of a spline of 721 rows (rival: the same)", sweep(cubic), plain_sweep(angles)},
            {"a new α: curve of 721 points and all its figures (rival: its range, Eigen)",
             move(linear), plain_sweep(1)},
            {"a new α of a spline (rival: the same)", move(cubic), plain_sweep(1)},
            {"map of places (rival: a plain loop)",
             [study = balance_shaft::PositionStudy(paper)] {
                 study.map(-reach, reach, -reach, reach, places, places);
             },
             plain_map}};
}

balance_shaft::Input diesel() {
    balance_shaft::Input input = balance_shaft::preset_tmz_650d();
    input.cylinder.rod_length = 0.150;
    input.torque = {};
    input.torque.kind = balance_shaft::TorqueSource::Kind::cycle;
    input.cylinder.bore = 0.0955;
    input.torque.cycle.heat = 1300.0;
    input.torque.cycle.combustion_start = 352.0 * degree;
    input.torque.cycle.combustion_duration = 60.0 * degree;
    return input;
}

CaseFile example(const std::string& name) {
    return parse_case(read_text_file(std::string(RAVNOVES_EXAMPLES) + "/" + name + ".case.json"));
}

/// Runs so many samples of a study of the balance shaft's range.
Work study_of(int samples) {
    CaseFile file = example("tmz-650d");
    file.study = {{"vary",
                   {{"/crank_radius_mm", {{"plus_minus", 0.02}}},
                    {"/centre_distance_mm", {{"plus_minus_percent", 0.1}}}}},
                  {"watch", {{"/metrics/M_ups/range_Nm", Json::object()}}},
                  {"samples", samples}};
    return [problem = studies::problem_of(file, {})] { studies::run_study(problem, 1, 1, 1); };
}

std::vector<Growth> all_growths() {
    const auto rows = [](Interpolation interpolation) {
        return [interpolation](int size) -> Work {
            return [input = engine(size, interpolation)] { balance_shaft::Solver{input}; };
        };
    };
    return {
        // Knots are sorted, each is looked up.
        {"rows, straight lines", {500, 3000, 20'000}, 1.1, rows(Interpolation::linear)},
        {"rows, spline", {500, 3000, 20'000}, 1.1, rows(Interpolation::periodic_cubic)},
        {"cylinders",
         {8, 16, 32, 64},
         1.0,
         [](int size) -> Work {
             inertia_moments::Input input = inertia_moments::preset_vw_vr5();
             input.layout->cylinders = size;
             input.layout->firing_order.clear();
             for (int i = 0; i < size; ++i) {
                 input.layout->firing_order.push_back(i + 1);
             }
             return [engine = make_engine(input)] { exact_orders(engine); };
         }},
        {"speeds of a band",
         {50, 100, 200, 400},
         1.0,
         [](int size) -> Work {
             return [input = diesel(), size] {
                 balance_shaft::SpeedStudy{input,
                                           {1000.0 * units::rpm, 4000.0 * units::rpm, size, false}};
             };
         }},
        {"speeds, best compromise angle",
         {50, 100, 200, 400},
         1.0,
         [](int size) -> Work {
             return [study = balance_shaft::SpeedStudy(
                         diesel(), {1000.0 * units::rpm, 4000.0 * units::rpm, size, false})] {
                 study.best_compromise_angle(balance_shaft::SpeedStudy::Criterion::range,
                                             balance_shaft::SpeedStudy::Measure::relative);
             };
         }},
        {"samples of a study", {1000, 10'000, 100'000}, 1.0, study_of},
        {"turns of the motion",
         {10, 100, 1000},
         1.0,
         [](int size) -> Work {
             elastic_hinge::Input input = elastic_hinge::preset_zotov();
             input.motion =
                 elastic_hinge::MotionWish{static_cast<double>(size), {}, 0.0, 0.0, false};
             return [input, result = elastic_hinge::solve(input)] {
                 elastic_hinge::simulate(input, result, elastic_hinge::HingeSet::crank);
             };
         }},
        {"variants of a case",
         {1000, 10'000, 100'000},
         1.1,
         [](int size) -> Work {
             Json json = write_case(example("tmz-650d"));
             for (int i = 0; i < size; ++i) {
                 json["variants"].push_back(
                     {{"name", "v" + std::to_string(i)}, {"input", Json::object()}});
             }
             return [text = json.dump()] { parse_case(text); };
         }},
    };
}

}  // namespace

int main() {
    for (const Pair& pair : all_pairs()) {
        double here = std::numeric_limits<double>::infinity();
        double rival = here;
        for (int turn = 0; turn < 5; ++turn) {  // in turns, so that both meet the same machine
            here = std::min(here, seconds_of(pair.here));
            rival = std::min(rival, seconds_of(pair.rival));
        }
        std::printf("%s | %.2f µs | %.2f µs | %.2f\n", pair.name, 1e6 * here, 1e6 * rival,
                    here / rival);
    }
    for (const Growth& growth : all_growths()) {
        std::vector<std::pair<double, double>> points;
        for (const int size : growth.sizes) {
            points.emplace_back(size, seconds_of(growth.prepare(size)));
        }
        const double exponent = exponent_of(points);
        std::printf("exponent of cost over %s, %d to %d (rival: theory) | %.2f | %.2f | %.2f\n",
                    growth.name.c_str(), growth.sizes.front(), growth.sizes.back(), exponent,
                    growth.theory, exponent / growth.theory);
        std::fflush(stdout);
    }
    return 0;
}

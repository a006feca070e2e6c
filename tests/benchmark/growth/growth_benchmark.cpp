/// How the cost of what a user may make large grows with its size: the exponent fitted to processor
/// times over a range of sizes, on log axes, and the one that theory gives; in lines for table.py.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

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

balance_shaft::Input engine_of_rows(int rows, balance_shaft::Interpolation interpolation) {
    balance_shaft::Input input = balance_shaft::preset_tmz_650d();
    input.interpolation = interpolation;
    balance_shaft::TorqueTable& table = input.torque.table;
    table = {};
    const int steps = rows - 1;
    for (int i = 0; i < rows; ++i) {
        const double turn = two_pi * (i % steps) / steps;
        table.crank_angle_deg.push_back(720.0 * i / steps);
        table.torque.push_back(300.0 * std::sin(turn) + 80.0 * std::cos(7.0 * turn));
    }
    return input;
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
    using balance_shaft::Interpolation;
    const auto rows = [](Interpolation interpolation) {
        return [interpolation](int size) -> Work {
            return [input = engine_of_rows(size, interpolation)] { balance_shaft::Solver{input}; };
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

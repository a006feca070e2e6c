#pragma once

#include <random>
#include <string>
#include <vector>

#include "balance-shaft/input.h"
#include "balance-shaft/presets.h"
#include "balance-shaft/results.h"
#include "balance-shaft/solver.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/result_json.h"
#include "error_of.h"

namespace ravnoves::balance_shaft::test {

using ravnoves::test::error_of;

/// What is said of an input that a patch of its case changes (RFC 7396: null takes a key away); "no
/// error" where it is solved.
inline std::string rejection(const Input& input, const std::string& patch) {
    Json json = write_input(input);
    json.merge_patch(parse_json(patch));
    return error_of([&] { Solver(read_input(json, {})); });
}

/// The paper's engine with a plain diesel cycle in place of its table.
inline Input diesel() {
    Input input = preset_tmz_650d();
    input.cylinder.rod_length = 0.150;
    input.torque = {};
    input.torque.kind = TorqueSource::Kind::cycle;
    input.cylinder.bore = 0.0955;
    GasCycle& cycle = input.torque.cycle;
    cycle.compression_ratio = 18.0;
    cycle.heat = 1300.0;
    cycle.combustion_start = 352.0 * degree;
    cycle.combustion_duration = 60.0 * degree;
    cycle.wiebe_m = 1.0;
    return input;
}

/// The same as a two-stroke engine.
inline Input two_stroke() {
    Input input = diesel();
    input.strokes = 2;
    input.torque.cycle.intake_pressure = 1.2e5;
    input.torque.cycle.exhaust_pressure = 1.1e5;
    return input;
}

/// A torque table over 720° with n irregular rows, drawn by a fixed seed.
inline TorqueTable random_table(unsigned seed, std::size_t rows, double size = 500.0) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> gap(0.2, 1.8);
    std::uniform_real_distribution<double> torque(-size, size);
    TorqueTable table;
    double angle = 0.0;
    for (std::size_t i = 0; i + 1 < rows; ++i) {
        table.crank_angle_deg.push_back(angle);
        table.torque.push_back(torque(generator));
        angle += gap(generator);
    }
    for (double& a : table.crank_angle_deg) {
        a *= 720.0 / angle;
    }
    table.crank_angle_deg.push_back(720.0);
    table.torque.push_back(table.torque.front());
    return table;
}

/// The same engine with a table for its torque.
inline Input with_table(Input input, TorqueTable table) {
    input.torque = {};
    input.torque.table = std::move(table);
    return input;
}

/// The same with its computed torque as a table of equal steps over the cycle.
inline Input as_table(const Input& computed, int step_deg = 1) {
    const Solver solver(computed);
    const int cycle = static_cast<int>(computed.cycle_deg());
    TorqueTable table;
    for (int angle = 0; angle <= cycle; angle += step_deg) {
        table.crank_angle_deg.push_back(angle);
        table.torque.push_back(-solver.M_up(angle % cycle * degree));
    }
    return with_table(computed, std::move(table));
}

/// The "result" object of an input.
inline Json written(const Input& input) {
    return result_json({}, input);
}

}  // namespace ravnoves::balance_shaft::test

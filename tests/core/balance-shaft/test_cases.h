#pragma once

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "balance-shaft/presets.h"
#include "balance-shaft/results.h"
#include "balance-shaft/scene.h"
#include "balance-shaft/solver.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/result_json.h"
#include "error_of.h"

namespace ravnoves::balance_shaft::test {

inline std::filesystem::path data_folder() {
    return std::filesystem::path(RAVNOVES_EXPECTED).parent_path() / "balance-shaft";
}

using ravnoves::test::error_of;

/// What is said of an input that a patch of its case changes; "no error" where it is solved.
inline std::string rejection(const Input& input, const std::string& patch) {
    Json json = write_input(input);
    json.merge_patch(parse_json(patch));
    return error_of([&] { Solver(read_input(json, {})); });
}

/// Rows of a CSV file of numbers without comments and header; the first field may be a word.
inline std::vector<std::vector<std::string>> read_csv(const std::filesystem::path& path) {
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() == '#') {
            continue;
        }
        std::vector<std::string> row;
        std::stringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) {
            row.push_back(cell);
        }
        rows.push_back(row);
    }
    return rows;
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

/// The "result" object of an input.
inline Json written(const Input& input) {
    return result_json({}, input);
}

struct Reference {
    double max;
    double min;
};

/// Extrema of M_up + M_s by brute force: a grid and the table's rows. The grid misses a smooth
/// extremum by at most h²/8 (A + max|M″|).
inline Reference dense_extrema(const Solver& solver, double alpha, int samples) {
    Reference found{-1e300, 1e300};
    const auto look = [&](double angle) {
        const double value = solver.M_up(angle) + solver.M_s(angle, alpha);
        found.max = std::max(found.max, value);
        found.min = std::min(found.min, value);
    };
    for (int i = 0; i < samples; ++i) {
        look(4.0 * pi * i / samples);
    }
    for (const double angle : solver.input().torque.table.crank_angle_deg) {
        look(angle * degree);
    }
    return found;
}

}  // namespace ravnoves::balance_shaft::test

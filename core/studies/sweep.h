#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "studies/study.h"

namespace ravnoves::studies {

struct Part;

/// An input that is led through its values, the others standing as they are.
struct SweptInput {
    std::string pointer;
    double from = 0.0;  ///< in the unit of the key, like to
    double to = 0.0;
    int steps = 101;  ///< values, both ends among them
};

/// The study of one input swept, or of a map of two: a grid, solved by begin_part() and run_part().
Study sweep_study(const std::vector<SweptInput>& inputs, std::vector<Watched> watch);

/// Where an input that scatters goes: its ends, or three standard deviations to each side.
std::pair<double, double> swept_range(const Varied& varied, double nominal);

/// What a grid has found so far, laid out for plots.
struct SweepTable {
    std::vector<std::vector<double>> axes;  ///< the values of each input
    /// By watched value, then by point, the last input changing fastest; not a number where there
    /// is none, or none yet.
    std::vector<std::vector<double>> values;

    double at(std::size_t watched, std::size_t i) const { return values[watched][i]; }
    /// Of a map: at the first input's i-th value and the second's j-th.
    double at(std::size_t watched, std::size_t i, std::size_t j) const {
        return values[watched][i * axes[1].size() + j];
    }
};
SweepTable sweep_table(const Part& part);

}  // namespace ravnoves::studies

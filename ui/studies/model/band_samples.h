#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case-file/json.h"
#include "case-file/message.h"
#include "studies/law.h"
#include "studies/study.h"

namespace ravnoves {

/// The numbers that a page shows, points of curves and cells of tables, and what is to be found out
/// about them: where they lie when the inputs scatter, and where slopes do not tell that.
struct BandTask {
    struct Source {
        Json::json_pointer place;
        std::string name;  ///< of the input, for reasons
        studies::Law law;
        std::size_t input = 0;      ///< its place in the study
        std::vector<float> slopes;  ///< of each number, per standard deviation
    };
    /// Numbers that fail or hold together: those of a curve, or one cell.
    struct Group {
        std::size_t from = 0;
        std::size_t count = 1;
        std::string name;
    };
    Json input;
    studies::Study study;
    std::vector<Source> sources;
    std::vector<double> nominal;  ///< of each number; not a number where there is none
    std::vector<float> shift;     ///< of its mean, as far as slopes tell it
    std::vector<double> periods;  ///< of angles; else 0
    std::vector<Group> groups;
};

struct BandAnswer {
    std::uint64_t samples = 0;  ///< solved
    std::uint64_t of = 0;       ///< of so many that will be
    std::uint64_t refused = 0;
    /// From the 5 % point to the number, and from it to the 95 % point; not a number where too
    /// few samples have one. Empty where slopes are what is asked for.
    std::vector<float> below;
    std::vector<float> above;
    /// Of groups for which slopes fail: why.
    std::map<std::size_t, Message> fails;
};

/// All numbers of the page at another input; nothing where the work is stopped.
/// @throws InputError where the input is refused
using BandValues = std::function<std::optional<std::vector<double>>(const Json& input)>;

/// Solves samples of the study, at most 1024 and as many as 32 MB hold, and keeps what they are off
/// the nominal numbers; where the study asks for slopes, 64 that these are tried by.
/// @param progress  0…1; false stops the work
/// @param found  sees what the samples so far say, after 64 and each time they have doubled
/// @return nothing where it was stopped
std::optional<BandAnswer> findBands(const BandTask& task, const BandValues& values,
                                    const std::function<bool(double)>& progress,
                                    const std::function<void(BandAnswer)>& found);

}  // namespace ravnoves

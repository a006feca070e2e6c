#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "case-file/message.h"
#include "studies/study_run.h"

namespace ravnoves {

/// What a study has found so far, of one watched value, in the unit of its key.
struct StudyAnswer {
    struct Share {
        std::string pointer;  ///< of the input
        std::optional<double> linear;
        std::optional<double> first;  ///< of the variance, by itself
        std::optional<double> total;  ///< with what it does together with others
    };
    std::string pointer;
    std::optional<double> nominal, mean, deviation, linearDeviation, low, high;  ///< 5 %, 95 %
    std::optional<double> within, withinLow, withinHigh;  ///< share inside the limits
    std::optional<Message> fails;                         ///< why the linear answer does
    std::vector<Share> shares;
    std::vector<double> middles;  ///< of the bars of its histogram
    std::vector<double> heights;  ///< shares of the samples
};

struct StudyAnswers {
    std::vector<StudyAnswer> values;
    std::uint64_t solved = 0;
    std::vector<studies::Refusal> refused;
    std::vector<Message> notes;
    std::vector<Message> said;  ///< reasons that notes hold
    /// Some of the samples that could be solved: inputs, then watched values.
    std::vector<std::vector<double>> samples;
};

/// What is told of a study that is done, or under way with at least one solved sample.
StudyAnswers answersOf(const studies::Part& part);

}  // namespace ravnoves

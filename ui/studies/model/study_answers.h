#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "case-file/message.h"
#include "studies/study_run.h"

namespace ravnoves {

/// What a study has found of one watched value, in the unit of its key.
struct StudyAnswer {
    /// Of the variance, by an input.
    struct Share {
        std::string pointer;
        double alone = 0.0;
        double whole = 0.0;  ///< with its interactions
    };
    std::string pointer;
    std::optional<double> nominal, mean, deviation, linearDeviation, low, high;  ///< 5 %, 95 %
    std::optional<double> within, withinLow, withinHigh;  ///< share inside the limits
    std::optional<Message> fails;                         ///< why the linear answer does
    std::vector<Share> shares;
    std::vector<double> middles;  ///< of the bars of its histogram
    std::vector<double> heights;  ///< shares of the samples

    /// One of its numbers in the unit that is shown, to the second digit of the standard deviation.
    QString text(const std::optional<double>& number, double factor) const;
    /// "98.2 % (97.7 … 98.6)"
    QString withinText() const;
};

struct StudyAnswers {
    std::vector<StudyAnswer> values;
    std::uint64_t solved = 0;
    std::optional<double> feasible = {};  ///< share of these, where the scene tells
    std::vector<studies::Rejection> rejected;
    std::vector<Message> notes;
};

/// The answers of a study that is done.
/// @param watched  values that are asked for; one behind them tells whether a sample is feasible
StudyAnswers answersOf(const studies::Part& part, std::size_t watched);

}  // namespace ravnoves

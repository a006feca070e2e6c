#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "case-file/json_fwd.h"

namespace ravnoves {

class SceneModel;

/// One value of the input that a reference has otherwise.
struct InputDifference {
    std::string pointer;  ///< below "input"
    QString name;         ///< label of the field; of a list's element with its place, from 1
    QString unit;         ///< as the user wants it
    QString present;      ///< as a person writes it; empty where it is not given
    QString reference;    ///< likewise
    // Where both are numbers, in the unit:
    std::optional<double> presentValue = {};
    std::optional<double> referenceValue = {};

    QString absolute() const;  ///< present − reference with its sign; empty where that is nothing
    QString percent() const;   ///< of the reference
};

/// Where the model's input and another of its scene differ, in the order of the case file, list
/// elements one by one.
std::vector<InputDifference> inputDifferences(const SceneModel& model, const Json& reference);

}  // namespace ravnoves

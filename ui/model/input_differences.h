#pragma once

#include <QString>
#include <vector>

#include "case-file/json_fwd.h"
#include "text/result_row.h"
#include "text/shown_units.h"

namespace ravnoves {

class SceneModel;
struct FieldEntry;

/// One value of the input that a reference has otherwise.
struct InputDifference {
    std::string pointer;  ///< below "input"
    QString name;         ///< label of the field; of a list's element with its place, from 1
    QString unit;         ///< as the user wants it
    ResultCell present;   ///< as a person writes it; empty where it is not given
    ResultCell reference;
};

/// Where the model's input and another of its scene differ, in the order of the case file, list
/// elements one by one.
std::vector<InputDifference> inputDifferences(const SceneModel& model, const Json& reference);

/// A word of the input, or yes or no, as a person reads it. Null: of no field.
QString wordText(const Json& value, const FieldEntry* entry);

/// What tells the present input from the reference: its layout, or a few values: "α 60°, l 90 mm";
/// else empty.
QString nameByDifferences(SceneModel& model);

/// The values that say which design it is, SceneModel::designInputs(): "Shaft angle α 45°, …".
QString designText(const SceneModel& model);

/// A number of the input with its name in the form.
struct InputNumber {
    std::string pointer;  ///< below "input"
    QString name;
    QString unit;  ///< its key's
    double value = 0.0;
    bool hasLabel = true;  ///< else its name is its key
    ShownUnit shown = {};  ///< in which the form shows it
};

/// The numbers of the present input that may take any value, in the order of the case file, each
/// object's own defaults behind its numbers; long lists are left out, and Field::is_setting.
std::vector<InputNumber> inputNumbers(const SceneModel& model);

}  // namespace ravnoves

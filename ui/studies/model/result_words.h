#pragma once

#include <QString>
#include <string>

namespace ravnoves {

/// A number of a result as a person says it.
struct ResultName {
    QString text;  ///< "Mᵤₚₛ, range"
    QString unit;  ///< of its key; may be empty

    QString withUnit() const { return unit.isEmpty() ? text : text + QStringLiteral(", ") + unit; }
};

/// @param pointer  below "result", for example "/metrics/M_ups/range_Nm"
ResultName resultName(const std::string& pointer);

}  // namespace ravnoves

#pragma once

#include <QString>
#include <string>

#include "case-file/case_context.h"
#include "case-file/json_fwd.h"
#include "text/shown_units.h"

namespace ravnoves {

/// A number of a result as a person says it.
struct ResultName {
    QString text;  ///< "Mᵤₚₛ, range"
    QString unit;  ///< of its key; may be empty

    /// How numbers of it are shown.
    ShownUnit shown() const { return shownUnit(unit); }
    /// With the unit that is shown.
    QString withUnit() const { return shownTitle(ownTitle()).text; }
    /// With that of its key: of an axis, which shows another one itself.
    QString ownTitle() const { return titleWithUnit(text, unit); }
};

/// As the scene's result describes it: of its presets, and of the inputs that were learned.
/// @param pointer  below "result", for example "/metrics/M_ups/range_Nm"
ResultName resultName(const QString& scene, const std::string& pointer);

/// Whether the presets' results or those that were learned have it.
bool isNamed(const QString& scene, const std::string& pointer);
/// What this input's result has is known by name from now on.
void learnResultNames(const QString& scene, const Json& input, const CaseContext& context);

}  // namespace ravnoves

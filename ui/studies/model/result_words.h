#pragma once

#include <QString>
#include <string>

#include "text/shown_units.h"

namespace ravnoves {

/// A number of a result as a person says it.
struct ResultName {
    QString text;  ///< "Mᵤₚₛ, range"
    QString unit;  ///< of its key; may be empty

    /// The unit of its numbers on the screen.
    ShownUnit shown() const { return shownUnit(unit); }
    /// With the unit that is shown.
    QString withUnit() const { return shownTitle(ownTitle()).text; }
    /// With the unit of its key: of an axis, which converts by itself.
    QString ownTitle() const { return titleWithUnit(text, unit); }
};

/// Of what no description names.
ResultName nameByKeys(const std::string& pointer);

}  // namespace ravnoves

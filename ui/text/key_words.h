#pragma once

#include <QString>
#include <string>

#include "numerics/units.h"

namespace ravnoves {

/// The unit that a key ends in, cut off it: of "shaft_angle_deg" degrees, and "shaft_angle" is
/// left.
Unit takeUnit(QString& key);

/// A key of a case file as text, in the user's language and without the unit that it ends in:
/// "shaft_angle_deg" as "shaft angle". For places without a name in a form: objects, lists, and
/// replaced fields. Translations are in resources/translations/extra_LL.ts.
QString keyInWords(const std::string& key);

/// A word or a text of a case as tables show it: of the sum of a file its first digits.
QString caseText(const std::string& text);

}  // namespace ravnoves

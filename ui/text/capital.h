#pragma once

#include <QString>

namespace ravnoves {

/// A name as it begins a line: with a capital, but for symbols of formulas ("λ = R / L", "c").
inline QString capitalised(QString name) {
    if (name.size() > 1 && name[0].isLower() && name[1].isLower()) {
        name[0] = name[0].toUpper();
    }
    return name;
}

/// The same inside a sentence.
inline QString inSentence(QString name) {
    if (name.size() > 1 && name[0].isUpper() && name[1].isLower()) {
        name[0] = name[0].toLower();
    }
    return name;
}

}  // namespace ravnoves

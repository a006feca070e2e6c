#pragma once

#include <QString>

#include "case-file/field.h"
#include "numerics/units.h"

namespace ravnoves {

/// A unit as the user wants to see it. Inputs, results and data keep their own units: only texts
/// written or read on the screen are in these.
struct ShownUnit {
    QString name;         ///< in the language of the program; empty for pure numbers
    double factor = 1.0;  ///< numbers shown per number in the own unit: 0.0394 for mm as inches
    int decimals = 0;     ///< that a number needs more than in its own unit
};

/// The one place for it: how a unit of core is shown now.
ShownUnit shownUnit(const Unit& unit);
/// The unit of a field: heavy things such as rotors stay in kilograms beside parts in grams.
ShownUnit shownUnit(const Field& field);
/// The same for a unit by its name in the language of the program; other words are unchanged.
ShownUnit shownUnit(const QString& name);

/// The unit itself, for texts in another language than the program's.
Unit shownAs(const Unit& unit);
Unit shownAs(const Field& field);

/// A heading or the title of an axis that ends in a unit ("l, mm", "N·m"), with the one shown in
/// its place.
struct ShownTitle {
    QString text;
    double factor = 1.0;
    int decimals = 0;
};
ShownTitle shownTitle(const QString& title);
/// A title that ends in a unit: "l, mm"; without one the name alone.
QString titleWithUnit(const QString& name, const QString& unit);
/// The unit at the end of a title, unchanged; empty without one.
QString unitOfTitle(const QString& title);

/// An SI value as the number shown, for formats of their own.
double shownValue(double si, const Unit& unit);
/// An SI value in the unit shown: "46.00 mm", "1.8110 in".
QString shownNumber(double si, const Unit& unit, int decimals);
/// The same without the unit.
QString shownDigits(double si, const Unit& unit, int decimals);
/// `digits` significant digits, with the unit and without it.
QString shownShort(double si, const Unit& unit, int digits);
QString shownFigures(double si, const Unit& unit, int digits);

}  // namespace ravnoves

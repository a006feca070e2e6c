#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "case-file/field.h"

namespace ravnoves {

/// A number as a person types it, or a scale that is a keyboard: "568.5", "568,5 г", "1.2 kg".
struct TypedNumber {
    std::optional<double> value;  ///< in the unit asked for; empty where it is no number
    QString trouble;              ///< where only the unit is wrong, or it may be two, that as text
};

/// Reads a number with a unit behind it, or without one: then it is in `unit`, as are the results.
/// Masses are taken in g, kg, mg, oz, lb, lengths in mm, cm, m, µm, in, mil, ft, densities in
/// kg/m³ and g/cm³, in the letters of English, Russian and the language of the program, capital or
/// not; of other quantities only the unit itself. Where the language has a decimal point, "3,600"
/// may be 3600 or 3.6, and is rejected.
/// @param unit  in the language of the program, as forms show it; empty for pure numbers
TypedNumber readTypedNumber(const QString& text, const QString& unit);
/// The same of a field on a form, where it may have to be computed first: "75/2", "2*46+3 mm". Not
/// of lists and scales, where "8-10" is no difference.
TypedNumber readTypedFormula(const QString& text, const QString& unit);

/// That a text is no number; of a long one, as a table that was pasted into a field, its beginning.
QString notANumberText(const QString& text);

/// True for a number with a unit of mass or length, or without one.
bool isTypedNumber(const QString& text);
/// True for a unit of mass, in the language of the program.
bool isMassUnit(const QString& unit);

/// Reads numbers one after the other, in the field's shown unit: between them are blanks,
/// semicolons, or commas with a blank behind. An ambiguous text ("8,10") is rejected.
/// @param where    names the list
/// @param isUsual  false: the decimal comma of such a number may be between two; if empty, all are
/// @return the values in the field's unit; throws InputError for anything but numbers in range
std::vector<double> readNumberList(const QString& typed, const Field& field, const Message& where,
                                   bool (*isUsual)(double si) = nullptr);
/// Values in the field's unit, as typed.
QString numberListText(const std::vector<double>& values, const Field& field);

}  // namespace ravnoves

#pragma once

#include <span>
#include <string_view>

#include "case-file/key_units.h"
#include "case-file/message.h"
#include "case-file/range.h"
#include "numerics/units.h"

namespace ravnoves {

/// One of the words of a choice.
struct Word {
    std::string_view word;  ///< in the case file
    Text label{};           ///< in the form
};

/// One input of a scene, described once: the reader, the writer, the range check, the form, the
/// undo step, the table of the help and the studies all follow from it.
struct Field {
    std::string_view key;  ///< key in the case file, for example "crank_radius_mm"
    Unit unit = unit_of_key(key).unit;
    Range range{};  ///< in the unit; of whole numbers too
    /// Within the range, what an engine can be and arithmetic can take: said only where it is left.
    Range size{};
    /// Name in the form, with & before its mnemonic; without it the name of the undo step.
    Text label{};
    std::string_view symbol{};  ///< in formulas, for example "r"
    Text hint{};                ///< meaning, example, source
    Text if_empty{};            ///< what an empty field represents, as read after "Empty:"
    Text placeholder{};         ///< what an empty field of the form represents ("auto")
    /// Of a choice, in the order of its enumeration; of a whole number, the two that it can be.
    std::span<const Word> words{};
    /// Of a curve, a computation or a wish: it has no tolerance, and is not swept.
    bool is_setting = false;

    /// The range, or the size, that a value in the unit leaves; null where it is allowed.
    const Range* left_by(double value) const {
        return !range.contains(value) ? &range : !size.contains(value) ? &size : nullptr;
    }
    /// True for a whole number of the range or, where there are words, one that they name.
    bool allows_whole(double value) const;
    /// The rule as text: "must be a whole number from 6 to 1000", "must be 2 or 4".
    Message whole_number_rule() const;
};

/// The number that a word is: 2 of "2".
int whole_number(const Word& word);

/// The value in the field's unit, as a person would write it: of the doubles that read back to this
/// SI value, the one with the shortest decimal text, so that 46 mm written and read again stays 46.
double from_si(const Field& field, double si);

/// An SI value rounded to significant digits in the field's unit.
double rounded(double si, const Field& field, int digits);

/// Throws where a value in the field's unit is not in its range, or beyond its size.
/// @param where  of the value: a JSON pointer, or words
/// @param shown  the field's unit where the place does not name it
/// @throws InputError
void check_range(const Field& field, double value, const Message& where,
                 const Unit& shown = units::none);

}  // namespace ravnoves

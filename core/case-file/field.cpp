#include "case-file/field.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "case-file/decimal.h"
#include "case-file/input_error.h"

namespace ravnoves {

Message Range::message(Unit unit) const {
    if (std::isfinite(min) && std::isfinite(max)) {
        return {min_open ? Text::tr("must be greater than %1 and at most %2")
                         : Text::tr("must be from %1 to %2"),
                Number{min, unit, 0, true}, Number{max, unit}};
    }
    if (std::isfinite(min)) {
        return {min_open ? Text::tr("must be greater than %1") : Text::tr("must be at least %1"),
                Number{min, unit}};
    }
    if (std::isfinite(max)) {
        return {Text::tr("must be at most %1"), Number{max, unit}};
    }
    return Text::tr("must be a finite number");
}

int whole_number(const Word& word) {
    int number = 0;
    std::from_chars(word.word.data(), word.word.data() + word.word.size(), number);
    return number;
}

bool Field::allows_whole(double value) const {
    return range.contains(value) && std::floor(value) == value &&
           (words.empty() || std::any_of(words.begin(), words.end(), [&](const Word& word) {
                return whole_number(word) == value;
            }));
}

Message Field::whole_number_rule() const {
    return words.empty()
               ? Message(Text::tr("must be a whole number from %1 to %2"), range.min, range.max)
               : Message(Text::tr("must be %1 or %2"), words.front().word, words.back().word);
}

void check_range(const Field& field, double value, const Message& where, const Unit& shown) {
    if (const Range* range = field.left_by(value)) {
        throw InputError(where, range->message(shown), Number{value, shown});
    }
}

double from_si(const Field& field, double si) {
    const double value = si / field.unit;
    // The digits that nearly every field has: no text is needed to round to them.
    constexpr double millionth = 1e6;
    constexpr double maximum = 1e12;  // so many digits in all
    const double whole = std::nearbyint(value * millionth);
    if (std::abs(whole) < maximum && whole / millionth * field.unit == si) {
        return whole / millionth;
    }
    for (const int digits : {12, 15, 16}) {
        const double shorter = rounded_to_digits(value, digits);
        if (shorter * field.unit == si) {
            return shorter;
        }
    }
    return value;
}

double rounded(double si, const Field& field, int digits) {
    return std::isfinite(si) ? rounded_to_digits(si / field.unit, digits) * field.unit : si;
}

}  // namespace ravnoves

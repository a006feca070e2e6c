#include "case-file/range.h"

#include <cmath>

namespace ravnoves {

Message Range::message(Unit unit) const {
    const auto number = [&](double value) { return Number{value, unit}; };
    const Number low{min, unit, 0, true};
    const bool has_min = std::isfinite(min);
    const bool has_max = std::isfinite(max);
    if (has_min && has_max) {
        if (!min_open && !max_open) {
            return {Text::tr("must be from %1 to %2"), low, number(max)};
        }
        const Text text = min_open
                              ? (max_open ? Text::tr("must be greater than %1 and less than %2")
                                          : Text::tr("must be greater than %1 and at most %2"))
                              : Text::tr("must be at least %1 and less than %2");
        return {text, low, number(max)};
    }
    if (has_min) {
        return {min_open ? Text::tr("must be greater than %1") : Text::tr("must be at least %1"),
                number(min)};
    }
    if (has_max) {
        return {max_open ? Text::tr("must be less than %1") : Text::tr("must be at most %1"),
                number(max)};
    }
    return Text::tr("must be a finite number");
}

Message Range::whole_number_message() const {
    return {Text::tr("must be a whole number from %1 to %2"), min, max};
}

}  // namespace ravnoves

#pragma once

#include "case-file/decimal.h"
#include "widgets/form.h"

namespace ravnoves {

/// Shows in an empty field, grey, the value that applies: "auto 88"; its unit is beside it.
/// @param value  in the field's unit; empty where the field's own words are enough
inline void showAssumed(Form* form, NumberField* field,
                        std::function<std::optional<double>()> value) {
    form->follow([field, value = std::move(value), word = field->placeholderText()] {
        const std::optional<double> assumed = value();
        constexpr int digits = 4;
        field->setPlaceholderText(assumed && std::isfinite(*assumed)
                                      ? word + QChar::Nbsp +
                                            field->textOf(rounded_to_digits(*assumed, digits))
                                      : word);
    });
}

}  // namespace ravnoves

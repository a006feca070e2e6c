#pragma once

#include "case-file/field.h"
#include "case-file/message.h"

// Fields for whole numbers: those of a range, or one of the two that the field's words name.
namespace ravnoves {

/// The number that a word is: 2 of "2".
int whole_number(const Word& word);
/// True for a whole number that the field may hold.
bool allows_whole(const Field& field, double value);
/// The rule in words: "must be a whole number from 6 to 1000", "must be 2 or 4".
Message whole_number_rule(const Field& field);

}  // namespace ravnoves

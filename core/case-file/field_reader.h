#pragma once

#include "case-file/field_visitor.h"

namespace ravnoves {

/// What a case may lack.
enum class Completeness {
    required,  ///< every value that a result needs must be there
    as_is,     ///< each given value is checked; missing ones are empty, as in a half-filled form
};

/// Fills an input from the "input" object of a case, each value checked against its range, and
/// rejects every missing key, wrong type and unknown key; rules that join fields are the scene's.
/// @throws InputError that names the JSON pointer
void read_fields(const Json& json, Completeness completeness, const VisitFields& visit);

template <typename Input>
Input read_fields(const Json& json, Completeness completeness = Completeness::required) {
    Input input;
    read_fields(json, completeness, fields_of(input));
    return input;
}

}  // namespace ravnoves

#pragma once

#include "case-file/field_visitor.h"

namespace ravnoves {

/// What a case may lack.
enum class Completeness {
    required,  ///< every value that a result needs must be there
    as_is,     ///< each value that is there is checked; what is missing stays empty, as in a form
               ///< half filled
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

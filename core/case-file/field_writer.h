#pragma once

#include "case-file/field_visitor.h"
#include "case-file/json.h"

namespace ravnoves {

Json write_fields(const VisitFields& visit);
void check_fields(const VisitFields& visit, const std::string& root);

/// The "input" object that read_fields() turns into the same input.
template <typename Input>
Json write_fields(const Input& input) {
    return write_fields(fields_of(input));
}

/// Checks every value of an input against the range of its field.
/// @throws InputError that names the JSON pointer, as read_fields() would
template <typename Input>
void check_fields(const Input& input, const std::string& root = "/input") {
    check_fields(fields_of(input), root);
}

}  // namespace ravnoves

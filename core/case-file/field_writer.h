#pragma once

#include "case-file/field_visitor.h"
#include "case-file/json.h"

namespace ravnoves {

namespace detail {
/// Runs `visit` with a visitor that writes.
Json write_with(void (*visit)(FieldVisitor& visitor, const void* input), const void* input);
/// Runs `visit` with a visitor that checks ranges.
void check_with(void (*visit)(FieldVisitor& visitor, const void* input), const void* input,
                const char* root);
}  // namespace detail

/// The "input" object that read_fields() turns into the same input.
template <typename Input>
Json write_fields(const Input& input) {
    return detail::write_with(
        [](FieldVisitor& visitor, const void* it) {
            visit_constant(visitor, *static_cast<const Input*>(it));
        },
        &input);
}

/// Checks every value of an input against the range of its field.
/// @throws InputError that names the JSON pointer, as read_fields() would
template <typename Input>
void check_fields(const Input& input, const char* root = "/input") {
    detail::check_with(
        [](FieldVisitor& visitor, const void* it) {
            visit_constant(visitor, *static_cast<const Input*>(it));
        },
        &input, root);
}

}  // namespace ravnoves

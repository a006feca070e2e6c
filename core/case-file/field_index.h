#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "case-file/field_visitor.h"

namespace ravnoves {

/// The value of a field as a form shows it: nothing, a number in the field's unit, a whole number
/// (of a choice: the place of its word), yes or no, a text.
using FieldValue = std::variant<std::monostate, double, int, bool, std::string>;

enum class FieldKind { number, integer, flag, text, choice, object, list, custom };

/// One field of an input at its place.
struct FieldEntry {
    std::string pointer;  ///< below "input", for example "/spring/stiffness_N_m"
    Field field;
    FieldKind kind = FieldKind::number;
    bool may_be_empty = false;  ///< a number that may be left out
    FieldValue value{};
    bool required = false;    ///< the case must give it where it gives the object around it
    FieldValue usual{};       ///< its replacement; nothing without one
    std::string_view word{};  ///< a word in place of the number, for example "solve"
    /// Keys of which one is to be given, this one among them; empty where there is no such choice.
    std::vector<std::string> alternatives{};
    /// The number's place in the input, valid until the input is moved or reshaped; null without a
    /// number. A number that the fields hand out as a copy has no lasting place: compare the places
    /// of two inputs.
    double* place = nullptr;
    Unit place_unit = units::none;  ///< of the place: of the field, none of a list's element
};

std::vector<FieldEntry> list_fields(const VisitFields& visit, bool all, std::string_view only);
bool set_field(const VisitFields& visit, std::string_view pointer, const FieldValue& value);

/// The fields of an input with their present values. Objects that are absent are listed with the
/// values that they would begin with.
/// @param only  the pointer of the one that is wanted, an element of a list of numbers too; empty:
///              all fields
template <typename Input>
std::vector<FieldEntry> list_fields(const Input& input, std::string_view only = {}) {
    return list_fields(fields_of(input), false, only);
}

/// Every field that a case of the scene may have, one element for each list: the table of the help.
template <typename Input>
std::vector<FieldEntry> describe_fields(std::string_view only = {}) {
    Input input;
    return list_fields(fields_of(input), true, only);
}

/// Sets one scalar by its pointer below "input"; an object that was absent comes into being, and so
/// does a name in an object of free names. Nothing sets what has a default back to it.
/// Nothing is checked. @return false where there is no such field or the kind of value is wrong
template <typename Input>
bool set_field(Input& input, std::string_view pointer, const FieldValue& value) {
    return set_field(fields_of(input), pointer, value);
}

}  // namespace ravnoves

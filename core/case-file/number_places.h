#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case-file/field_visitor.h"

namespace ravnoves {

/// Where an input keeps a number that its case file has at a pointer.
struct NumberPlace {
    double* value = nullptr;  ///< in SI units, or as the list holds it
    Unit unit = units::none;  ///< of the key; none of a list's element
    Range range{};            ///< in that unit
    Range size{};             ///< of the field
};

namespace detail {
using VisitNumbers = void (*)(FieldVisitor& visitor, void* input);
std::vector<NumberPlace> places_with(VisitNumbers visit, void* input,
                                     std::span<const std::string> pointers);
}  // namespace detail

/// The places of the pointers below "input"; value is null of what is not there or is no number.
/// They hold as long as the input is neither moved nor given another shape. A number that the
/// fields hand out as a copy has no place that holds: compare the places of two inputs.
template <typename Input>
std::vector<NumberPlace> find_numbers(Input& input, std::span<const std::string> pointers) {
    return detail::places_with(
        [](FieldVisitor& visitor, void* it) { visit_fields(visitor, *static_cast<Input*>(it)); },
        &input, pointers);
}

}  // namespace ravnoves

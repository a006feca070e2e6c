#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/result_json.h"
#include "error_of.h"
#include "fixtures.h"
#include "workshop/input.h"
#include "workshop/older_formats.h"
#include "workshop/results.h"

namespace ravnoves::workshop::test {

inline Json solved(const Json& input) {
    return result_json({}, read_input(input));
}

inline Json solved_plugs_case(const Json& input) {
    return result_json({}, read_plugs_case(input));
}
inline Json solved_bob_weights_case(const Json& input) {
    return result_json({}, read_bob_weights_case(input));
}

/// The value at a pointer.
inline Json at(const Json& json, const std::string& pointer) {
    return json.at(Json::json_pointer(pointer));
}
inline double number(const Json& json, const std::string& pointer) {
    return at(json, pointer).get<double>();
}

/// Values at their pointers; null for none.
using Changes = std::vector<std::pair<const char*, Json>>;

inline Json changed(Json input, const Changes& changes) {
    for (const auto& [pointer, value] : changes) {
        const Json::json_pointer at(pointer);
        if (value.is_null()) {
            input[at.parent_pointer()].erase(at.back());
        } else {
            input[at] = value;
        }
    }
    return input;
}

/// What a reader, or one that solves what it has read, rejects.
inline std::string error_of(const Json& input, Json (*solved)(const Json&) = test::solved) {
    return ravnoves::test::error_of([&] { solved(input); });
}

/// A value at a place below "input", and the beginning of what it is rejected with.
struct Rejection {
    const char* pointer;
    Json value;
    const char* beginning;
};
inline void expect_rejected(const Json& base, std::initializer_list<Rejection> rows,
                            Json (*solved)(const Json&) = test::solved) {
    for (const auto& [pointer, value, beginning] : rows) {
        const std::string error = error_of(changed(base, {{pointer, value}}), solved);
        EXPECT_TRUE(error.starts_with(beginning)) << error;
    }
}

/// Where values differ by more than rounding, or are not there; "" for nowhere.
inline std::string difference(const Json& was, const Json& is) {
    if (was.is_array() && was.size() != is.size()) {
        return "was " + was.dump() + ", is " + is.dump();
    }
    const auto found = ravnoves::test::differences("", was, is, {});
    return found.empty() ? "" : ravnoves::test::first_of(found);
}

/// A V-8 whose parts nobody doubts.
inline Json card() {
    return parse_json(R"({
        "engine": {"type": "v", "cylinders": 8, "bank_angle_deg": 90},
        "parts_g": {"piston": 583.9, "pin": 173.6, "rings": 69.5, "locks": 4.8, "small_end": 162.4,
                    "big_end": 429.8, "shells": 43.7, "oil": 4},
        "tolerance": {"grade_mm_s": 16, "rotor_mass_kg": 30, "service_speed_rpm": 5500},
        "correction": {
            "planes": [{"position_mm": 60, "radius_mm": 85, "from_deg": 0, "to_deg": 359},
                       {"position_mm": 480, "radius_mm": 80, "from_deg": 0, "to_deg": 359}],
            "readings": [{"unbalance_g_mm": 2500, "angle_deg": 40},
                         {"unbalance_g_mm": 1200, "angle_deg": 290}],
            "drill": {"diameters_mm": [10, 16], "maximum_depth_mm": 30}}})");
}

/// A V-8 with plugs.
inline Json plugs_card() {
    Json input = card();
    input.erase("parts_g");
    input["plugs"] = parse_json(R"({
        "engine": {
            "crank_radius_mm": 40, "plug_radius_mm": 47.2, "new_plug_radius_mm": 49.3,
            "steel_plug_mass_g": 28.5, "aluminium_plug_mass_g": 9.8,
            "new_steel_plug_mass_g": 30, "new_aluminium_plug_mass_g": 10.3,
            "max_steel_reduction_g": 6, "max_aluminium_reduction_g": 2,
            "rod_coefficient": 0.445, "oil_mass_g": 20, "oil_coefficient": 1.0,
            "reciprocating_mass_g": 1000, "rotating_mass_g": 650},
        "process": "repair", "tolerance_g_mm": 100,
        "mass_changes_g": {"rod_big_end": 0.5, "repair_piston_and_rings": 2, "repair_bearing": 1.1},
        "plug": {"thread": "M22x1.5", "height_mm": 14, "bore_diameter_mm": 14, "bore_depth_mm": 8}})");
    return input;
}

}  // namespace ravnoves::workshop::test

#pragma once

#include <vector>

#include "case-file/message.h"

namespace ravnoves {

/// What no engine has, though the mechanics takes it: a slip of the keys rather than a design.
/// @param angular_speed  of the crank, rad/s
/// @param crank_radius, rod_length  m
inline std::vector<Message> unusual_engine_notes(double angular_speed, double crank_radius,
                                                 double rod_length) {
    constexpr double fastest = 60000 * units::rpm;  // model engines come near it
    constexpr double largest = 10 * units::metre;   // three times those of the largest ships
    constexpr int digits = 4;
    std::vector<Message> notes;
    if (angular_speed > fastest) {
        notes.emplace_back(CORE_TEXT("core", "No engine turns at %1: is the speed right?"),
                           Number{angular_speed / units::rpm, units::rpm, digits});
    }
    if (crank_radius > largest) {
        notes.emplace_back(CORE_TEXT("core", "No engine has a crank radius of %1: is it right?"),
                           Number{crank_radius / units::mm, units::mm, digits});
    }
    if (rod_length > largest) {
        notes.emplace_back(CORE_TEXT("core", "No engine has a rod of %1: is its length right?"),
                           Number{rod_length / units::mm, units::mm, digits});
    }
    return notes;
}

}  // namespace ravnoves

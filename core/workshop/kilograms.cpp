#include "workshop/kilograms.h"

namespace ravnoves::workshop {

namespace {

/// No such part of a car or truck weighs less, kg; in kilograms each does.
double least_mass(Part part) {
    return (part == Part::rings || part == Part::shells ? 2.0 : 5.0) * units::gram;
}

}  // namespace

std::optional<double> mass_in_kilograms(Part part, const std::optional<double>& nominal,
                                        std::span<const Weighed> masses) {
    const double least = least_mass(part);
    if (nominal && *nominal < least) {
        return nominal;
    }
    for (const Weighed& mass : masses) {
        if (!mass || *mass == 0.0) {
            continue;
        }
        if (*mass < least || (nominal && *mass <= 0.01 * *nominal)) {
            return mass;
        }
        if (nominal && *nominal <= 0.01 * *mass) {
            return nominal;
        }
    }
    return std::nullopt;
}

}  // namespace ravnoves::workshop

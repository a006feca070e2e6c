#include "case-file/unusual_engine.h"

#include <algorithm>

namespace ravnoves {

std::vector<Message> unusual_engine_notes(const EngineSizes& engine) {
    constexpr double fastest = 60000 * units::rpm;  // model engines come near it
    constexpr double largest = 10 * units::metre;   // three times those of the largest ships
    constexpr double heaviest = 1e6;                // kg/m³
    constexpr double min_ratio = 0.06;
    std::vector<Message> notes;
    if (engine.angular_speed > fastest) {
        notes.emplace_back(Text::tr("Speed %1 is implausible: check it."),
                           Number{engine.angular_speed / units::rpm, units::rpm, 4});
    }
    const double radius = engine.crank_radius;
    if (radius > largest) {
        notes.emplace_back(Text::tr("Crank radius %1 is implausible: check it."), in_mm(radius));
    }
    if (engine.rod_length > largest) {
        notes.emplace_back(Text::tr("Rod length %1 is implausible: check it."),
                           in_mm(engine.rod_length));
    }
    if (engine.rod_length > 0.0 && radius < min_ratio * engine.rod_length) {
        notes.emplace_back(
            Text::tr("Crank radius %1 and rod %2 are implausible together: check their units, for "
                     "example centimetres instead of millimetres."),
            in_mm(radius), in_mm(engine.rod_length));
        return notes;  // masses would only say it again
    }
    const double mass =
        engine.masses.empty() ? 0.0 : *std::max_element(engine.masses.begin(), engine.masses.end());
    if (mass > heaviest * radius * radius * radius) {
        notes.emplace_back(Text::tr("Mass %1 and crank radius %2 are implausible together: check "
                                    "their units, for example grams instead of kilograms."),
                           Number{mass, units::kg, 4}, in_mm(radius));
    }
    return notes;
}

}  // namespace ravnoves

#include "scenes/shared_engine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "case-file/decimal.h"
#include "case-file/json.h"
#include "numerics/units.h"

namespace ravnoves {

namespace {

/// Where a scene has a number of the engine.
struct EnginePlace {
    std::string_view scene;
    std::optional<double> SharedEngine::*what;
    const char* pointer;
    Unit unit;
    bool is_ratio = false;  ///< of the crank radius to it
};

// Of several places for one number the first is written where the case has none of them.
constexpr std::array engine_places{
    EnginePlace{"balance-shaft", &SharedEngine::bore, "/cylinder/bore_mm", units::mm},
    EnginePlace{"balance-shaft", &SharedEngine::crank_radius, "/crank_radius_mm", units::mm},
    EnginePlace{"balance-shaft", &SharedEngine::rod_length, "/cylinder/rod_length_mm", units::mm},
    EnginePlace{"balance-shaft", &SharedEngine::offset, "/cylinder/offset_mm", units::mm},
    EnginePlace{"balance-shaft", &SharedEngine::speed, "/speed_rpm", units::rpm},
    EnginePlace{"balance-shaft", &SharedEngine::speed, "/angular_speed_rad_s", units::rad_per_s},
    EnginePlace{"balance-shaft", &SharedEngine::reciprocating_mass, "/reciprocating_mass_kg",
                units::kg},
    EnginePlace{"elastic-hinge", &SharedEngine::crank_radius, "/crank_radius_mm", units::mm},
    EnginePlace{"elastic-hinge", &SharedEngine::rod_length, "/lambda", units::none, true},
    EnginePlace{"elastic-hinge", &SharedEngine::speed, "/angular_speed_rad_s", units::rad_per_s},
    EnginePlace{"inertia-moments", &SharedEngine::crank_radius, "/crank_radius_mm", units::mm},
    EnginePlace{"inertia-moments", &SharedEngine::rod_length, "/lambda", units::none, true},
    EnginePlace{"inertia-moments", &SharedEngine::rod_length, "/rod_length_mm", units::mm},
    EnginePlace{"inertia-moments", &SharedEngine::speed, "/speed_rpm", units::rpm},
    EnginePlace{"inertia-moments", &SharedEngine::reciprocating_mass, "/reciprocating_mass_kg",
                units::kg},
    EnginePlace{"inertia-moments", &SharedEngine::rotating_mass, "/rotating_mass_kg", units::kg},
};

constexpr const char* mass_parts = "reciprocating_masses_kg";

struct EngineName {
    std::optional<double> SharedEngine::*what;
    Text name;
};
constexpr std::array engine_names{
    EngineName{&SharedEngine::bore, Text::tr("bore")},
    EngineName{&SharedEngine::crank_radius, Text::tr("crank radius")},
    EngineName{&SharedEngine::rod_length, Text::tr("rod length")},
    EngineName{&SharedEngine::offset, Text::tr("offset")},
    EngineName{&SharedEngine::speed, Text::tr("speed")},
    EngineName{&SharedEngine::reciprocating_mass, Text::tr("reciprocating mass")},
    EngineName{&SharedEngine::rotating_mass, Text::tr("rotating mass")},
};

const Json* number_at(const Json& input, const char* pointer) {
    const Json::json_pointer at(pointer);
    return input.contains(at) && input.at(at).is_number() ? &input.at(at) : nullptr;
}

bool is_same(const std::optional<double>& one, const std::optional<double>& other) {
    constexpr double rounding = 1e-9;
    return one && other && std::abs(*one - *other) <= rounding * std::abs(*one);
}

constexpr int ratio_digits = 6;

/// With the fewest digits that give the ratio.
double rod_length(double crank_radius, double ratio) {
    const double length = crank_radius / ratio;
    for (int digits = 1; digits < std::numeric_limits<double>::digits10; ++digits) {
        const double shorter = rounded_to_digits(length, digits);
        if (rounded_to_digits(crank_radius / shorter, ratio_digits) ==
            rounded_to_digits(ratio, ratio_digits)) {
            return shorter;
        }
    }
    return length;
}

}  // namespace

SharedEngine engine_of(std::string_view scene, const Json& input) {
    SharedEngine engine;
    for (const EnginePlace& place : engine_places) {
        const Json* number = place.scene == scene ? number_at(input, place.pointer) : nullptr;
        if (number != nullptr) {
            const double value = number->get<double>() * place.unit.to_si;
            engine.*place.what = !place.is_ratio ? std::optional(value)
                                 : engine.crank_radius && value > 0.0
                                     ? std::optional(rod_length(*engine.crank_radius, value))
                                     : std::nullopt;
        }
    }
    if (scene == "balance-shaft" && input.contains(mass_parts)) {
        double sum = 0.0;
        for (const Json& part : input[mass_parts]) {
            sum += part.get<double>();
        }
        engine.reciprocating_mass = sum;
        const Json* rod = number_at(input, "/rod_mass_kg");
        const Json* small_end = number_at(input, "/reciprocating_masses_kg/rod_small_end");
        if (rod != nullptr && small_end != nullptr) {
            engine.rotating_mass = rod->get<double>() - small_end->get<double>();
        }
    }
    if (engine.rotating_mass && input.contains("cylinders") &&
        std::ranges::any_of(input["cylinders"], [](const Json& cylinder) {
            return number_at(cylinder, "/articulated/knuckle_mass_kg") != nullptr;
        })) {
        engine.rotating_mass.reset();  // that of a master rod with its knuckles
    }
    return engine;
}

GivenEngine give_engine(const SharedEngine& engine, std::string_view scene, Json& input) {
    const SharedEngine before = engine_of(scene, input);
    constexpr int digits = 12;
    GivenEngine given;
    for (const auto& [what, name] : engine_names) {
        if (before.*what && !(engine.*what)) {
            given.kept.push_back(name);
        }
        // A ratio is another with another crank radius, too.
        if (!(engine.*what) || is_same(engine.*what, engine_of(scene, input).*what)) {
            continue;
        }
        const EnginePlace* to = nullptr;
        for (const EnginePlace& place : engine_places) {
            const bool is_it = place.scene == scene && place.what == what;
            if (is_it && (to == nullptr || number_at(input, place.pointer) != nullptr)) {
                to = &place;
            }
        }
        const auto radius = engine.crank_radius ? engine.crank_radius : before.crank_radius;
        if (to == nullptr || (to->is_ratio && !radius)) {
            continue;
        }
        // A rod as a rigid body, or the mass of a whole throw, holds more than this one.
        if (what == &SharedEngine::rotating_mass && !before.rotating_mass) {
            given.kept.push_back(name);
            continue;
        }
        if (what == &SharedEngine::reciprocating_mass) {
            input.erase(mass_parts);
        }
        const double value = to->is_ratio
                                 ? rounded_to_digits(*radius / *(engine.*what), ratio_digits)
                                 : rounded_to_digits(*(engine.*what) / to->unit.to_si, digits);
        Json& number = input[Json::json_pointer(to->pointer)];
        if (number == value) {
            continue;
        }
        number = value;
        if (!is_same(engine.*what, before.*what)) {
            given.changed.push_back(name);
        }
    }
    return given;
}

}  // namespace ravnoves

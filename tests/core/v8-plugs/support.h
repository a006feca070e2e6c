#pragma once

#include <random>

#include "v8-plugs/input.h"

namespace ravnoves::v8_plugs::test {

inline constexpr double gram = 1e-3;
inline constexpr double millimetre = 1e-3;
inline constexpr double gram_millimetre = 1e-6;

/// Random engines and parts, the same in every run.
class Workshop {
  public:
    explicit Workshop(unsigned seed) : generator_(seed) {}

    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator_);
    }

    Engine engine() {
        Engine engine;
        engine.crank_radius = between(25, 150) * millimetre;
        engine.plug_radius = *engine.crank_radius * between(0.8, 1.5);
        engine.steel_plug_mass = between(1, 100) * gram;
        engine.max_steel_reduction = *engine.steel_plug_mass * between(0, 0.9);
        engine.rod_coefficient = between(0, 2);
        engine.aluminium_plug_mass = *engine.steel_plug_mass * between(0.2, 0.6);
        engine.max_aluminium_reduction = *engine.aluminium_plug_mass * between(0, 0.9);
        engine.new_plug_radius = *engine.plug_radius * between(0.9, 1.2);
        engine.new_steel_plug_mass = *engine.steel_plug_mass * between(1, 2);
        engine.new_aluminium_plug_mass = engine.aluminium_plug_mass;
        engine.reciprocating_mass = between(300, 5000) * gram;
        engine.rotating_mass = between(300, 5000) * gram;
        engine.oil_mass = between(0, 100) * gram;
        engine.oil_coefficient = between(0, 2);
        return engine;
    }

    MassChanges changes(double largest_grams) {
        MassChanges changes;
        for (const MassChangeField& field : mass_change_fields()) {
            changes.*field.member = between(-0.3, 1.0) * largest_grams * gram;
        }
        return changes;
    }

    Process process() { return between(0, 1) < 0.5 ? Process::manufacture : Process::repair; }

  private:
    std::mt19937 generator_;
};

}  // namespace ravnoves::v8_plugs::test

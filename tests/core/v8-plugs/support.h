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

    PlugSet plugs() {
        PlugSet plugs{};
        plugs.crank_radius = between(25, 150) * millimetre;
        plugs.plug_radius = plugs.crank_radius * between(0.8, 1.5);
        plugs.steel_mass = between(1, 100) * gram;
        plugs.max_steel_reduction = plugs.steel_mass * between(0, 0.9);
        plugs.rod_coefficient = between(0, 2);
        const double aluminium = plugs.steel_mass * between(0.2, 0.6);
        plugs.aluminium = PlugSet::Aluminium{aluminium, aluminium * between(0, 0.9)};
        plugs.new_design = PlugSet::NewDesign{plugs.plug_radius * between(0.9, 1.2),
                                              plugs.steel_mass * between(1, 2)};
        return plugs;
    }

    GearMasses gear() {
        return {between(300, 5000) * gram, between(300, 5000) * gram, between(0, 100) * gram,
                between(0, 2)};
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

#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "shop/sentences.h"
#include "shop/weigh_in.h"
#include "v8-plugs/engine.h"

namespace ravnoves::v8_plugs {

// Compensation of the excess mass of crank-gear parts by lighter plugs of the crankpins' sludge
// traps. Source: [nazarov] of the bibliography; equation numbers are that paper's. Masses in kg,
// lengths in m, unbalance in kg·m.

enum class Process { manufacture, repair };

/// Which plugs the counterweights of the crankshaft were made for.
enum class Crankshaft { standard, new_plugs };

/// How much heavier the parts are than nominal, kg; negative where lighter.
struct MassChanges {
    double piston = 0.0;                   ///< Δm_п, improved piston (one cylinder)
    double rod_big_end = 0.0;              ///< Δm_шк, improved big end (one rod)
    double repair_piston_and_rings = 0.0;  ///< Δm_рп, repair piston with rings (one cylinder)
    double repair_bearing = 0.0;           ///< Δm_шр, repair shells (one crankpin)

    friend bool operator==(const MassChanges&, const MassChanges&) = default;
};

/// Excess on each crankpin's axis, kg: Δm_yd = Δm_п + (2 + k_ш) Δm_шк + Δm_рп + Δm_шр, from (3),
/// (4), (5); Δm_yo of manufacture is the same without repair parts.
double unbalanced_mass(const MassChanges& changes, double rod_coefficient);

/// What a plug's mass counts for on the crankpin's axis, eq. (11).
struct Coefficients {
    double k_p;                     ///< r_p / r, one plug
    double k_y;                     ///< 2 r_p / r, both plugs of a crankpin; the slope (24)
    std::optional<double> k_y_new;  ///< 2 r_pн / r, where there is a plug of the new design
};
/// @param engine  here and below one that has_plug_data()
Coefficients coefficients(const Engine& engine);

enum class OptionId {
    steel_machined,         ///< present steel plugs machined, (18), (22)
    steel_to_aluminium,     ///< aluminium plugs instead, (15), (19)
    new_steel_to_steel,     ///< present steel plugs in a crankshaft made for new ones, (16), (20)
    new_steel_machined,     ///< the new steel plugs of such a crankshaft machined, (18) with k_yн
    new_steel_to_aluminium  ///< aluminium plugs in such a crankshaft, (17), (21)
};
/// In the order of cost on each crankshaft.
inline constexpr std::array<OptionId, 5> all_options{
    OptionId::steel_machined, OptionId::steel_to_aluminium, OptionId::new_steel_to_steel,
    OptionId::new_steel_machined, OptionId::new_steel_to_aluminium};

/// Names of the options, in the order of the enumeration.
inline constexpr Word option_words[] = {
    {"steel-machined", Text::tr("Machine the steel plugs")},
    {"steel-to-aluminium", Text::tr("Aluminium plugs")},
    {"new-steel-to-steel", Text::tr("New crankshaft, steel plugs")},
    {"new-steel-machined", Text::tr("New crankshaft, its own plugs")},
    {"new-steel-to-aluminium", Text::tr("New crankshaft, aluminium plugs")}};
constexpr const Word& option_word(OptionId option) {
    return option_words[static_cast<std::size_t>(option)];
}
/// True where the option's plugs are of steel, present or new ones; false where of aluminium.
constexpr bool has_steel_plugs(OptionId option) {
    return option != OptionId::steel_to_aluminium && option != OptionId::new_steel_to_aluminium;
}
/// True for plugs of the new design, not the present ones in steel or aluminium.
constexpr bool has_new_plugs(OptionId option) {
    return option == OptionId::new_steel_machined;
}
/// True where the option is for a crankshaft made for the plugs of the new design.
constexpr bool needs_new_crankshaft(OptionId option) {
    return option >= OptionId::new_steel_to_steel;
}

/// One way to compensate: constant + slope · reduction, the reduction from 0 to its limit.
struct Option {
    OptionId id;
    double constant;     ///< Δm_yra, Δm_yhr, Δm_yna (12)–(14) or 0, kg
    double slope;        ///< k_y (24), or k_yн where new plugs are machined
    double plug_radius;  ///< r_p or r_pн, m
    /// The wall-strength limit of one plug, kg. The paper gives none for a new plug: the present
    /// steel plug's is used, in proportion where the new one is lighter.
    double max_reduction;
    double maximum;               ///< (19)–(22), kg
    double required_reduction;    ///< one plug, kg; may be negative or beyond the limit
    double reduction;             ///< the same, within the feasible range, kg
    bool feasible;                ///< |residual unbalance| within the tolerance
    double residual_mass;         ///< excess left on a crankpin, kg; negative: over-compensated
    double residual_unbalance;    ///< the same times r, kg·m
    double plug_mass_unmachined;  ///< m_p, m_a or m_pн, kg

    /// A hundredth of a gram is what the words show; less is not worth a set-up of the machine.
    bool machined() const { return reduction >= 0.005 * units::gram; }
};

/// The option; nothing where the engine has not the plugs it needs.
std::optional<Option> evaluate_option(OptionId id, const Engine& engine, double unbalanced_mass,
                                      double tolerance);

/// The mass to hang on a crankpin when the crankshaft is balanced, line by line.
struct BobWeight {
    std::vector<shop::WeightLine> lines;
    double plugs;        ///< total of their line, kg
    double oil;          ///< likewise
    double sum() const;  ///< kg
    /// Bob weight where the plugs are in the shaft already: the sum includes them, kg.
    double with_plugs_in() const { return sum() - plugs; }
};

// Bob weight of an engine with its nominal masses and these parts, eqs. (4), (5), (7), (8): with
// the plugs that the crankshaft was made for (nothing for new_plugs where the engine has none), or
// with plugs of that mass each, with their centre of mass at that radius.
std::optional<BobWeight> bob_weight(const Engine& engine, const MassChanges& changes,
                                    Crankshaft crankshaft);
BobWeight bob_weight(const Engine& engine, const MassChanges& changes, double plug_mass,
                     double plug_radius);

/// The shift of a machined plug's centre of mass that (2) neglects: 0.8 to 1.2 mm in the paper.
inline constexpr double smallest_shift = 0.8e-3;  ///< m
inline constexpr double largest_shift = 1.2e-3;   ///< m
/// Δk = Δr / r, eq. (1).
inline double shift_coefficient(double shift, double crank_radius) {
    return shift / crank_radius;
}
/// What the shift is worth on a crankpin with two such plugs, 2 m Δk r = 2 m Δr, kg·m.
inline double shift_unbalance(double plug_mass, double shift) {
    return 2.0 * plug_mass * shift;
}

}  // namespace ravnoves::v8_plugs

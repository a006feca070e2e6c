#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/field.h"

namespace ravnoves::v8_plugs {

inline constexpr int cylinder_count = 8;

/// The seven engines of the paper, by displacement in litres, and the data it gives for them.
///
/// A value that is not known stays empty: it has to be asked for, never guessed. Masses in kg,
/// lengths in m. Where an engine has no aluminium plug, or no plug of the new design, the
/// corresponding flag is false and the group's values stay empty.
struct Engine {
    std::string name;
    std::optional<double> crank_radius;             ///< r, m
    std::optional<double> plug_radius;              ///< r_p, centre of mass of the present plug, m
    std::optional<double> new_plug_radius;          ///< r_pн, the same of the new design, m
    std::optional<double> steel_plug_mass;          ///< m_p, kg
    std::optional<double> aluminium_plug_mass;      ///< m_a, kg
    std::optional<double> new_steel_plug_mass;      ///< m_pн, kg
    std::optional<double> new_aluminium_plug_mass;  ///< m_aн, kg
    std::optional<double> max_steel_reduction;      ///< Δm_pm, wall-strength limit, kg
    std::optional<double> max_aluminium_reduction;  ///< Δm_am, wall-strength limit, kg
    std::optional<double> rod_coefficient;          ///< k_ш
    std::optional<double> oil_mass;                 ///< m_m, oil in one crankpin, kg
    std::optional<double> oil_coefficient;          ///< k_m
    std::optional<double> reciprocating_mass;       ///< m_j, nominal, of one cylinder, kg
    std::optional<double> rotating_mass;            ///< m_R, nominal, of one cylinder, kg
    bool has_aluminium_plug = true;
    bool has_new_plug = true;

    friend bool operator==(const Engine&, const Engine&) = default;
};

/// Which plugs a value of the engine belongs to.
enum class EngineGroup { basic, aluminium_plug, new_plug, bob_weight };

/// One value of the engine: its description, and where it is kept.
struct EngineField {
    Field field;
    std::optional<double> Engine::*member;
    EngineGroup group;
};

/// The values of an engine, in the order of the contract.
std::span<const EngineField> engine_fields();

/// True where the engine lacks the plug that the value belongs to, so that it is not asked for.
bool is_inapplicable(const Engine& engine, EngineGroup group);
/// Says whether the engine has the plugs of the group; the values of those that it lacks go.
void set_plugs(Engine& engine, EngineGroup group, bool present);
/// The fields that the engine needs and does not have; bob-weight fields only when asked for.
std::vector<const EngineField*> missing_fields(const Engine& engine, bool with_bob_weight);
/// Whether the data of the plugs are complete, and the nominal masses for the bob weight.
bool has_plug_data(const Engine& engine);
bool has_nominal_masses(const Engine& engine);

/// Less can be cut off a plug than it weighs: where this rule is broken.
struct EngineConflict {
    const EngineField* reduction;
    double plug_mass;  ///< kg
};
std::vector<EngineConflict> engine_conflicts(const Engine& engine);

}  // namespace ravnoves::v8_plugs

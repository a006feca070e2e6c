#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/field.h"
#include "numerics/constants.h"
#include "v8-plugs/compensation.h"
#include "v8-plugs/engine.h"
#include "v8-plugs/plug_geometry.h"
#include "v8-plugs/weigh_in.h"

namespace ravnoves {
class FieldVisitor;
}

namespace ravnoves::v8_plugs {

inline constexpr double default_tolerance =
    5 * units::gram_mm;  ///< kg·m, the paper's limit on the machine

/// The mass changes of the case file, in the order of the contract.
struct MassChangeField {
    Field field;
    double MassChanges::*member;
    bool repair_only;
};
std::span<const MassChangeField> mass_change_fields();

/// The known dimensions of the plug.
struct PlugSheet {
    std::optional<Thread> thread;
    std::optional<double> height;           ///< m
    std::optional<double> bore_diameter;    ///< m; a solid plug where not given
    std::optional<double> bore_depth;       ///< m
    std::optional<double> cutter_diameter;  ///< m; no boring is planned where not given
    std::optional<double> minimum_wall;     ///< m; no limit where not given
    std::optional<double> minimum_bottom;   ///< m
    double steel_density = ravnoves::steel_density;
    double aluminium_density = v8_plugs::aluminium_density;

    /// Nothing while thread or height are missing.
    std::optional<PlugGeometry> geometry() const;
    std::optional<BoreLimits> limits() const;
    double density(PlugMaterial material) const {
        return material == PlugMaterial::steel ? steel_density : aluminium_density;
    }

    friend bool operator==(const PlugSheet&, const PlugSheet&) = default;
};

/// What the method takes.
struct Input {
    std::string preset;  ///< name of the preset that the engine was made from; empty: custom
    Engine engine;
    Crankshaft crankshaft = Crankshaft::standard;
    Process process = Process::repair;
    MassChanges typed_changes;
    bool changes_given = false;  ///< though all of them may be 0
    bool changes_from_weigh_in = false;
    std::optional<WeighIn> weigh_in;
    double tolerance = default_tolerance;  ///< kg·m
    std::optional<PlugSheet> plug;

    /// Typed, or from the weigh-in sheet as far as it has been weighed; 0 where they are not known.
    /// In manufacture repair parts that are typed do not count; weighed ones do.
    MassChanges changes() const;
    /// True where the change is the typed one, not the weighed.
    bool takes_typed(double MassChanges::*change) const;
    /// k_ш, the part of a heavier big end that its small end adds; 0 where small ends are weighed,
    /// which then add it themselves. Nothing while the engine has none.
    std::optional<double> rod_coefficient() const;
    bool has_typed_changes() const { return changes_given || typed_changes != MassChanges{}; }
    /// False on a sheet on which none is typed, or nothing weighed counts yet.
    bool changes_known() const {
        return changes_from_weigh_in ? weigh_in && weigh_in->is_counted() : has_typed_changes();
    }

    friend bool operator==(const Input&, const Input&) = default;
};

void visit_fields(FieldVisitor& visitor, PlugSheet& sheet);
/// All but the weigh-in.
/// @param weighed  there is one
void visit_plugs(FieldVisitor& visitor, Input& input, bool weighed);

/// Σ c²/n of shop::Weighing, by the means of the columns that count.
double rounding_squares(const Input& input);

/// A sentence for each typed mass that weighed ones replace.
std::vector<Message> replaced(const Input& input);
/// A sentence for each other typed or weighed mass that is not used, and for each typed one that is
/// used beside weights.
std::vector<Message> not_counted(const Input& input);

/// Checks that nothing which a result needs is missing, and the rules that join fields.
/// @param place  of the method's fields, "/input/" or the object in it
/// @throws InputError
void check_method(const Input& input, const std::string& place);
/// The same for a form that is half filled: what no form lets happen.
/// @throws InputError
void check_choices(const Input& input, const std::string& place);

}  // namespace ravnoves::v8_plugs

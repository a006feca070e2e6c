#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "case-file/message.h"
#include "case-file/range.h"

namespace ravnoves::v8_plugs {

// The plug as a body: a threaded cylinder with a flat-bottomed bore from its outer face. Lengths in
// m, masses in kg, densities in kg/m³.

/// Metric thread M d × P with the proportions of [iso-68-1] (basic profile, [iso-724]).
struct Thread {
    double diameter;  ///< d, major diameter, m
    double pitch;     ///< P, m

    double pitch_diameter() const;  ///< d₂ = d − 0.6495 P
    double root_diameter() const;   ///< d₃ = d − 1.2269 P, at the bottom of the external thread

    friend bool operator==(const Thread&, const Thread&) = default;
};

inline constexpr Range thread_diameter_range = Range::between(5, 200);  ///< mm
inline constexpr Range thread_pitch_range = Range::between(0.2, 8);     ///< mm

/// Reads "M22x1.5", "m22×1,5", "М30х1.5" (Cyrillic letters too). Without a pitch ("M22") the
/// thread is not known: sludge-trap plugs have fine threads.
/// @throws InputError (where: the argument `where`) for anything else or out of range
Thread parse_thread(std::string_view text, const std::string& where);
std::string thread_name(const Thread& thread);  ///< "M22x1.5"

enum class PlugMaterial { steel, aluminium };

inline constexpr double aluminium_density = 2700;  ///< kg/m³, wrought alloys 2640 to 2850

/// A plug's dimensions.
struct PlugGeometry {
    Thread thread;
    double height;               ///< m
    double bore_diameter = 0.0;  ///< of the bore that is there, m; 0 for a solid plug
    double bore_depth = 0.0;     ///< from the outer face, m

    /// Volume of the threaded cylinder at its pitch diameter less the bore, m³.
    double volume() const;
    /// Height of the centre of mass above the inner face, m (the solid plug: half its height).
    double centre_of_mass() const;

    friend bool operator==(const PlugGeometry&, const PlugGeometry&) = default;
};

/// The fault of the dimensions, as text; empty where the plug can exist.
std::optional<Message> geometry_fault(const PlugGeometry& plug);

/// The cutter and the walls that must stay.
struct BoreLimits {
    double cutter_diameter;       ///< m
    double minimum_wall = 0.0;    ///< between bore and thread root, m
    double minimum_bottom = 0.0;  ///< between bore and inner face, m

    friend bool operator==(const BoreLimits&, const BoreLimits&) = default;
};

/// How the plugs are bored.
struct BoreSetup {
    PlugGeometry plug;
    BoreLimits limits;
    double density;  ///< kg/m³
};

/// How deep to bore.
struct Boring {
    enum class Limit {
        none,   ///< can be bored
        wall,   ///< the cutter leaves too thin a wall under the thread
        bottom  ///< the bore would leave too thin a bottom
    };
    bool cuts = false;           ///< there is something to cut
    bool is_wider = false;       ///< the cutter than the bore: it cuts from the face on
    double depth = 0.0;          ///< from the outer face, m
    double deeper = 0.0;         ///< depth less the depth that is there (0 for a wider cutter), m
    double wall = 0.0;           ///< left between bore and thread root, m
    double bottom = 0.0;         ///< left under the bore, m
    double max_reduction = 0.0;  ///< what the walls allow in all, kg
    Limit limit = Limit::none;   ///< what forbids the reduction asked for
    /// Distance from the plug's centre of mass outwards to the centre of the metal cut off, m; also
    /// where a limit forbids the cut.
    double cut_distance = 0.0;
    double shift = 0.0;  ///< centre of mass of the bored plug moves inwards by this much, m
};

/// Mass removed from the plug when the cutter bores to `depth` from the outer face, kg.
double bored_mass(const PlugGeometry& plug, double cutter_diameter, double depth, double density);

/// The bore that removes `reduction` (kg, >= 0); where a wall limit forbids it, `limit` says which,
/// and depth is the one that would be needed.
Boring plan_boring(const BoreSetup& setup, double reduction);
/// The boring as a technician would say it: "Bore 0.74 mm deeper with a 20 mm cutter, to 8.74 mm
/// from the face." Empty where nothing is to be cut.
Message describe(const Boring& boring, const BoreLimits& limits);

/// A typed mass against the mass of the dimensions: true where they differ by more than this part
/// of the latter. Chamfers, hexagons and thread tolerances explain less.
inline constexpr double mass_mismatch = 0.15;
bool mass_fits(double typed_mass, double geometry_mass);

}  // namespace ravnoves::v8_plugs

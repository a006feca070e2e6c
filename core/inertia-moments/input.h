#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case-file/json_fwd.h"
#include "numerics/constants.h"

namespace ravnoves {
class FieldVisitor;
}

/// Inertia forces and moments of a piston engine of any layout.
///
/// Source: [chainov-vallejo-maldonado] of the bibliography.
///
/// Front view: x right, y up; angles of cylinder axes and crankpins counter-clockwise from +y. The
/// crank turns counter-clockwise at constant speed ω; φ is crankpin 1's angle from cylinder 1's
/// axis. Axial positions z are positive towards cylinder 1. Forces and moments are those that the
/// moving parts exert on the engine (inertia forces, −m a). Moments follow the paper's rule
/// (M_x, M_y) = Σ F_i u_i (z_i − z_ref), "in the horizontal and in the vertical plane"; the vector
/// moment about the axes is (−M_y, M_x). The roll moment M_z is counter-clockwise.
namespace ravnoves::inertia_moments {

inline constexpr int max_cylinders = 64;
inline constexpr int max_shafts = 32;
inline constexpr int highest_order = 12;          ///< of the results and of balance shafts
inline constexpr int highest_two_term_order = 4;  ///< the torque's; forces have orders 1 and 2
inline constexpr double order_accuracy = 1e-13;   ///< asked of the orders, relative to m R ω²

/// A rod that hangs on the master rod of its crankpin by a knuckle pin, instead of running on the
/// crankpin itself (radials; master-and-articulated V engines).
struct ArticulatedRod {
    double knuckle_radius = 0.0;          ///< r_k, m, of the knuckle pin from the crankpin's centre
    std::optional<double> knuckle_angle;  ///< γ, rad, counter-clockwise from the master rod's axis
    std::optional<double> rod_length;     ///< l, m, from knuckle pin to piston pin
    int master = 0;                       ///< number of the master's cylinder; 0: the only one
    /// Part of the cylinder's rotating mass at the knuckle pin instead of the crankpin, kg.
    double knuckle_mass = 0.0;
    bool operator==(const ArticulatedRod&) const = default;
};

/// One cylinder of the table.
struct Cylinder {
    double axial_position = 0.0;  ///< z, m, positive towards cylinder 1
    double bank_angle = 0.0;      ///< β, rad; the axis points along (−sin β, cos β)
    double offset = 0.0;          ///< e, m, positive on the counter-clockwise side
    double crankpin_angle = 0.0;  ///< κ, rad, counter-clockwise from crankpin 1
    std::optional<ArticulatedRod> articulated = std::nullopt;  ///< empty: a rod on the crankpin
    bool operator==(const Cylinder&) const = default;
};

/// A layout by name instead of a table; layouts.h turns it into cylinders.
struct Layout {
    std::string name = "vr";  ///< "vr" (any number of cylinders) or a name of the library
    int cylinders = 0;        ///< of "vr"; the library's layouts know theirs
    double bank_angle = 0.0;  ///< γ, rad, between the banks
    double offset = 0.0;      ///< e, m: +e in bank 1, −e in bank 2
    double spacing = 0.0;     ///< a, m, between neighbouring stations along the crank
    double stagger = 0.0;     ///< m, from bank 1's cylinder to bank 2's at one station
    std::optional<double> first_position;  ///< z of cylinder 1, m; empty: z = 0 in the middle
    std::vector<int> firing_order;         ///< numbers from 1
    bool operator==(const Layout&) const = default;
};

/// A connecting rod as a rigid body. Its centre of mass is on the line of its two bearings.
struct RigidRod {
    double mass = 0.0;                 ///< kg
    double centre_from_big_end = 0.0;  ///< m, towards the small end
    double inertia = 0.0;              ///< about its centre of mass, kg·m²
    bool operator==(const RigidRod&) const = default;
};

/// Which way a part turns: with the crank or against it.
enum class Direction { forward, backward };
/// What a balance shaft acts on: one weight against a force, two opposite ones against a moment.
enum class Balances { moment, force };
/// Which orders the balance shafts are designed for.
enum class DesignBasis { exact, two_term };

/// A balance shaft, designed by the program for the order it is to cancel.
struct Shaft {
    int order = 1;  ///< k: the shaft turns at kω
    Direction direction = Direction::forward;
    Balances balances = Balances::moment;
    double weight_distance = 0.1;          ///< L, m, between the two weights (moment)
    std::optional<double> axial_position;  ///< m, of the weight (force); empty: reference position
    std::optional<double> weight_radius;   ///< ρ, m: then masses are given too
    double phase_error = 0.0;              ///< rad, added to the right phase
    bool enabled = true;                   ///< is part of the residual
    bool operator==(const Shaft&) const = default;
};

/// The two counterweights on the end webs.
struct EndWebs {
    double front_position = 0.0;  ///< z, m
    double rear_position = 0.0;   ///< z, m, other than front_position
    double front_radius = 0.05;   ///< of the centre of mass, m
    double rear_radius = 0.05;    ///< m
    /// Share of the forward part of the reciprocating first order that they balance too, 0…1.
    double first_order_share = 0.0;
    bool enabled = true;  ///< are part of the residual
    bool operator==(const EndWebs&) const = default;
};

/// The input of the scene.
struct Input {
    double crank_radius = 0.0;               ///< R, m
    double lambda = 0.0;                     ///< R/L; of no account where the rod's length is given
    std::optional<double> given_rod_length;  ///< L, m, instead of λ
    double angular_speed = 0.0;              ///< ω, rad/s
    /// m_j, kg, of one cylinder. With a rod: without any share of the rod.
    double reciprocating_mass = 0.0;
    /// kg at the radius R, of one cylinder: a crankpin that two rods share carries it twice. With a
    /// rod: without any share of the rod.
    double rotating_mass = 0.0;
    /// The mass above is given for each throw (rods.h); its rods share it out.
    bool rotating_mass_of_throw = false;
    double reference_position = 0.0;  ///< z of the point that moments refer to, m
    std::vector<Cylinder> cylinders;  ///< where there is no layout
    std::vector<int> firing_order;    ///< of the table, numbers from 1; may be empty
    int strokes = 4;                  ///< of a cycle: 4 (720°) or 2 (360°)
    std::optional<Layout> layout;     ///< instead of the table
    std::optional<RigidRod> rod;      ///< empty: its shares are in the two masses
    std::vector<Shaft> shafts;
    DesignBasis shaft_basis = DesignBasis::exact;
    std::optional<EndWebs> end_webs;
    std::optional<double> step;  ///< rad; empty: 1°, and no curves in the result file

    /// R/L, given or by the rod's length.
    double ratio() const { return given_rod_length ? crank_radius / *given_rod_length : lambda; }
    double rod_length() const {
        return given_rod_length.value_or(crank_radius / lambda);
    }                                                                      ///< L, m
    double cycle() const { return strokes == 2 ? two_pi : 2.0 * two_pi; }  ///< rad of the crank
    bool operator==(const Input&) const = default;
};

// The fields in the order of the case file; fields.h describes them.
void visit_fields(FieldVisitor& visitor, ArticulatedRod& rod);
void visit_fields(FieldVisitor& visitor, Cylinder& cylinder);
void visit_fields(FieldVisitor& visitor, RigidRod& rod);
void visit_fields(FieldVisitor& visitor, Shaft& shaft);
void visit_fields(FieldVisitor& visitor, EndWebs& webs);
void visit_fields(FieldVisitor& visitor, Input& input);

/// A rod that its two masses would be: a third of its length from the big end, 0.8 of the
/// reciprocating mass.
RigidRod usual_rod(const Input& input);

/// Checks ranges, the layout, locking, and that forces and moments stay in the range of numbers.
/// @throws InputError that names the JSON pointer, as read_input() would
void check_input(const Input& input);

/// Reads the "input" object of a case, and checks it.
/// @throws InputError that names the JSON pointer
Input read_input(const Json& input);
/// The "input" object that reads back to the same Input.
Json write_input(const Input& input);

}  // namespace ravnoves::inertia_moments

#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "case-file/message.h"
#include "inertia-moments/engine.h"

namespace ravnoves::inertia_moments {

/// Arrangement of a library layout's cylinders.
enum class Arrangement {
    in_line,   ///< one bank, one station per cylinder
    v,         ///< odd cylinders in bank 1, even in bank 2, one station per pair
    vr,        ///< odd in bank 1, even in bank 2, one station per cylinder, offset axes
    double_vr  ///< W: first half a VR block, second half another, one station per pair of them
};

/// A layout of the library: what stays the same when its sizes change.
struct LayoutSpec {
    std::string_view name;  ///< as in case files, for example "v6-60"
    Text title;             ///< for the page's list
    Arrangement arrangement;
    int cylinders;
    double bank_angle_deg;    ///< γ, usual value
    int first_bank_side;      ///< +1: bank 1 on the counter-clockwise side; 0: in line
    double relative_offset;   ///< K, usual value
    double relative_spacing;  ///< spacing/R, usual value
    double relative_stagger;  ///< stagger/R, usual value
    /// Crankpins of a fixed crank, °; empty: they follow bank angle and offset for even firing.
    std::string_view pins_deg;
    std::string_view firing_order;
};

inline constexpr double w_inner_angle = 15.0 * degree;  ///< between the rows of each VR block

/// I1…I6, V-twins, V6, V8, flat twins to sixes, VR5, VR6, W12, in the order of the page's list.
std::span<const LayoutSpec> layout_library();
/// The layout of that name, or nothing.
const LayoutSpec* find_layout(std::string_view name);

/// A library layout with its usual sizes for a crank radius (m), centred on z = 0. The VR layouts
/// return as "vr", their name in case files.
Layout usual_layout(const LayoutSpec& spec, double crank_radius);

/// z of cylinder 1 where the layout is centred on z = 0, m.
double centred_position(const Layout& layout);

/// The arrangement of a layout ("vr" included) and its number of cylinders.
Arrangement arrangement_of(const Layout& layout);
int cylinder_count(const Layout& layout);

/// Whether two banks share the stations of the crank; else the stagger has no effect.
bool has_paired_banks(const Layout& layout);

/// The cylinders of the input's layout. "vr": odd cylinders in bank 1 (positive angle and offset),
/// crankpins for even firing over the cycle.
/// @param input  its layout is checked: known name, firing order a permutation
/// @throws std::logic_error for an unknown name (our fault: check_input() comes first)
std::vector<Cylinder> make_cylinders(const Input& input);

/// Sets every crankpin so that the cylinders fire at even intervals over the input's cycle,
/// in the given order: κ_i = θ_tdc,i − θ_tdc,1 + β_i − β_1 − n_i·cycle/N, n_i the place in the
/// order after cylinder 1. For two banks it shifts the second one's crankpins against the in-line
/// engine by γ + 2 θ_tdc (the paper prints γ + θ_tdc; its own angle, 21°40′, is the one with 2).
/// Result 0…2π.
/// @param firing_order  a permutation of 1…N
void set_even_firing(std::vector<Cylinder>& cylinders, std::span<const int> firing_order,
                     const Input& input);

/// A crank angle in the turn 0 ≤ angle < 2π; what rounding leaves just below 2π becomes 0. rad
double wrap_turn(double angle);

/// The whole numbers in a text: 1, 3, 4, 2 of "1-3-4-2".
std::vector<int> whole_numbers(std::string_view text);

/// True for a permutation of 1…count.
bool is_firing_order(std::span<const int> order, int count);

/// Why an order cannot be the firing order of `count` cylinders; empty where it can.
Message firing_order_trouble(std::span<const int> order, int count);
/// "1-3-4-2"; "nothing" for an empty one.
Message firing_order_text(std::span<const int> order);

/// One firing of the cycle.
struct FiringEvent {
    int cylinder = 0;          ///< number from 1
    double crank_angle = 0.0;  ///< φ at which it fires (top dead centre), rad, from 0 at the first
    double interval = 0.0;     ///< to the next firing, rad
};

/// The firings over the cycle for an order. Of four strokes (720°): each cylinder fires at one of
/// its two top dead centres, no two at once. Of two strokes (360°): each fires whenever it comes to
/// the top, and several may do so at once; without an order it is the crank's own.
/// Empty where the order cannot be run through in the cycle on this crank.
std::vector<FiringEvent> firing_events(const Engine& engine, std::span<const int> firing_order,
                                       double cycle = 2.0 * two_pi);

/// True where all firings have the same interval.
bool fires_evenly(std::span<const FiringEvent> firing);

/// The cylinders in the order in which the crank brings them to the top, from cylinder 1: the only
/// one in which a two-stroke can fire, but for those that come to the top at once.
std::vector<int> dead_centre_order(const Engine& engine);

/// Why firing_events() has none for an order, as a sentence.
Message describe_misfit(const Engine& engine, std::span<const int> firing_order, double cycle);

}  // namespace ravnoves::inertia_moments

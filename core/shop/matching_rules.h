#pragma once

#include <optional>
#include <vector>

#include "case-file/field.h"

namespace ravnoves::shop {

/// What the matching of weighed parts aims at.
enum class MatchingGoal {
    min_spread,    ///< of the crankpins' weights
    fewest_moves,  ///< that bring the crankpins within the permitted spread
    min_shaking    ///< first-order forces at the ends of the crankshaft
};

/// Where a set may go.
enum class SetMoves { anywhere, within_bank, stays };
/// Whether a part moves with its set, or remains where it was fitted.
enum class PartMoves { with_set, stays };

/// How weighed parts are matched: pistons with their pins and rings, and rods with their shells,
/// change places.
struct MatchingRules {
    MatchingGoal goal = MatchingGoal::min_spread;
    SetMoves pistons = SetMoves::anywhere;
    PartMoves pins = PartMoves::with_set;
    PartMoves rings = PartMoves::with_set;
    SetMoves rods = SetMoves::anywhere;
    PartMoves shells = PartMoves::with_set;
    std::optional<double> permitted_spread;  ///< of the crankpins' weights, kg
    // What the engine feels. The angles count in the sense from the second bank to the first.
    std::vector<double> crankpin_angles_deg;  ///< empty: those usual for the engine
    std::optional<double> cylinder_spacing;   ///< along the crankshaft, m
    std::optional<double> bank_offset;        ///< second bank behind the first, m
    std::optional<double> crank_radius;       ///< m; of scenes whose engine does not say it

    friend bool operator==(const MatchingRules&, const MatchingRules&) = default;
};

inline constexpr Word goal_words[] = {{"least-spread", Text::tr("Equal crankpins")},
                                      {"fewest-moves", Text::tr("Fewest moves")},
                                      {"least-shaking", Text::tr("Minimum shaking")}};
inline constexpr Word set_moves_words[] = {{"anywhere", Text::tr("anywhere")},
                                           {"within-bank", Text::tr("within bank")},
                                           {"stay", Text::tr("fixed")}};
inline constexpr Word part_moves_words[] = {{"with-set", Text::tr("with its set")},
                                            {"stay", Text::tr("fixed")}};

namespace field {

inline constexpr Field matching{
    .key = "matching", .hint = Text::tr("Matching of weighed parts: goal, and permitted moves.")};
inline constexpr Field goal{
    .key = "goal",
    .label = Text::tr("Place the parts for"),
    .hint = Text::tr("Minimum range of the crankpins, fewest moves to the permitted range, or "
                     "minimum first-order shaking at the ends of the crankshaft."),
    .words = goal_words};
inline constexpr Field piston_moves{
    .key = "pistons",
    .label = Text::tr("Piston sets may move"),
    .hint = Text::tr("Piston with pin and rings: anywhere; within its bank (valve pockets, offset "
                     "pin); or fixed (fitted to the bore)."),
    .words = set_moves_words};
inline constexpr Field pin_moves{.key = "pins",
                                 .label = Text::tr("Pins may move"),
                                 .hint = Text::tr("With its set, or fixed."),
                                 .words = part_moves_words};
inline constexpr Field ring_moves{.key = "rings",
                                  .label = Text::tr("Rings may move"),
                                  .hint = Text::tr("With its set, or fixed (gapped to the bore)."),
                                  .words = part_moves_words};
inline constexpr Field rod_moves{
    .key = "rods",
    .label = Text::tr("Rods may move"),
    .hint = Text::tr("Rod with its shells: anywhere; within its bank (each faces its side of the "
                     "crankpin); or fixed."),
    .words = set_moves_words};
inline constexpr Field shell_moves{
    .key = "shells",
    .label = Text::tr("Shells may move"),
    .hint = Text::tr("With its set, or fixed (chosen for the journal)."),
    .words = part_moves_words};
inline constexpr Field permitted_crankpin_spread{
    .key = "permitted_spread_g",
    .range = Range::between(0, 100'000),
    .label = Text::tr("Permitted crankpin range"),
    .hint =
        Text::tr("Heaviest minus lightest crankpin by bob weight, for the goal “Fewest moves”."),
    .placeholder = Text::tr("no limit")};
inline constexpr Field crankpin_angles{
    .key = "crankpin_angles_deg",
    .range = Range::between(-720, 720),
    .label = Text::tr("Crankpins at"),
    .hint = Text::tr(
        "Angles of the throws from the front, positive from the second bank to the first."),
    .if_empty = Text::tr("usual for the engine, cross-plane V-8: 0; 90; 270; 180"),
    .placeholder = Text::tr("as usual")};
inline constexpr Field cylinder_spacing{
    .key = "cylinder_spacing_mm",
    .range = Range::between(1, 10'000),
    .label = Text::tr("Cylinder spacing"),
    .hint = Text::tr("Distance between neighbours of a bank along the crankshaft, for the couple."),
    .placeholder = Text::tr("no couple")};
inline constexpr Field bank_offset{
    .key = "bank_offset_mm",
    .range = Range::between(-1000, 1000),
    .label = Text::tr("Bank offset"),
    .hint = Text::tr("Distance of the second bank behind the first (width of a big end). Enter "
                     "the spacing too."),
    .placeholder = {"0"}};
inline constexpr Field matching_crank_radius{
    .key = "crank_radius_mm",
    .range = Range::between(1, 5000),
    .label = Text::tr("Crank radius"),
    .hint = Text::tr(
        "Crank radius for forces in g·mm and N; without it they are masses at the crank radius."),
    .placeholder = Text::tr("no force")};

}  // namespace field

}  // namespace ravnoves::shop

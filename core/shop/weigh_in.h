#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "case-file/field.h"

namespace ravnoves {
class FieldVisitor;
}

/// What the scenes of the workshop share: the weigh-in sheet, the head of the job card, grades of
/// balance quality.
namespace ravnoves::shop {

// The weigh-in sheet: every part of every cylinder on the scale. Masses in kg.

enum class Part { piston, pin, rings, rod_small_end, rod_big_end, shells };
inline constexpr std::array<Part, 6> all_parts{
    Part::piston, Part::pin, Part::rings, Part::rod_small_end, Part::rod_big_end, Part::shells};
/// Names of the parts, in the order of the enumeration.
inline constexpr Word part_words[] = {{"piston", Text::tr("Piston")},
                                      {"pin", Text::tr("Pin")},
                                      {"rings", Text::tr("Rings")},
                                      {"rod_small_end", Text::tr("Rod, small end")},
                                      {"rod_big_end", Text::tr("Rod, big end")},
                                      {"shells", Text::tr("Shells")}};
constexpr const Word& part_word(Part part) {
    return part_words[static_cast<std::size_t>(part)];
}

/// Whether it belongs to the piston's set, else to the rod's.
constexpr bool is_of_piston(Part part) {
    return part == Part::piston || part == Part::pin || part == Part::rings;
}

/// A mass on the scale, kg; nothing where the part has not been weighed.
using Weighed = std::optional<double>;

/// The column of one kind of part.
struct PartColumn {
    std::optional<double> nominal;           ///< kg
    std::optional<double> permitted_spread;  ///< heaviest minus lightest, kg
    std::vector<Weighed> mass;               ///< kg, by cylinder

    bool is_empty() const {  ///< nothing weighed
        return std::none_of(mass.begin(), mass.end(), [](const Weighed& m) { return m; });
    }
    bool is_weighed() const {  ///< all cylinders
        return !mass.empty() &&
               std::all_of(mass.begin(), mass.end(), [](const Weighed& m) { return m; });
    }
    bool is_complete() const { return nominal && is_weighed(); }  ///< and the nominal mass known
    bool is_begun() const { return nominal || permitted_spread || !is_empty(); }

    friend bool operator==(const PartColumn&, const PartColumn&) = default;
};

/// Which cylinders share a crankpin.
enum class CylinderNumbering {
    bank_by_bank,  ///< of n the first half in one bank: crankpin k carries k and k + n/2
    alternating    ///< 1, 3, 5 … in one bank: crankpin k carries 2k − 1 and 2k
};

/// The number of the set in each cylinder: of the cylinder, from 1, that it was weighed in. Empty
/// where each is where it was weighed.
using SetNumbers = std::vector<int>;
/// With their numbers where the list is empty, or of another number of cylinders.
SetNumbers whole_numbers(const SetNumbers& numbers, std::size_t cylinders);
/// The numbers after moving: element i of `from` is the cylinder (from 0) whose set moves to i.
SetNumbers moved_numbers(const SetNumbers& numbers, const std::vector<int>& from);

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

struct WeighIn {
    std::array<PartColumn, 6> columns;  ///< in the order of all_parts
    CylinderNumbering numbering = CylinderNumbering::bank_by_bank;
    SetNumbers piston_sets;  ///< piston with its pin and rings
    SetNumbers rod_sets;     ///< rod with its shells
    MatchingRules matching;

    /// Whether sets are in other cylinders than those they were weighed in.
    bool is_moved() const { return !piston_sets.empty() || !rod_sets.empty(); }

    /// As many rows as there are cylinders; numbers of the sets of another engine go.
    void fit(std::size_t cylinders);
    bool is_empty() const {  ///< nothing weighed
        return std::all_of(columns.begin(), columns.end(),
                           [](const auto& column) { return column.is_empty(); });
    }
    bool is_counted() const {  ///< a column is complete
        return std::any_of(columns.begin(), columns.end(),
                           [](const auto& column) { return column.is_complete(); });
    }

    PartColumn& operator[](Part part) { return columns[static_cast<std::size_t>(part)]; }
    const PartColumn& operator[](Part part) const {
        return columns[static_cast<std::size_t>(part)];
    }

    friend bool operator==(const WeighIn&, const WeighIn&) = default;
};

/// Statistics of what has been weighed so far in a column.
struct ColumnStatistics {
    int count;
    double mean;    ///< kg
    double spread;  ///< heaviest minus lightest, kg
    int heaviest;   ///< cylinder, counted from 0
    int lightest;
    bool within_permitted;  ///< true where no permitted spread is given
};
/// Nothing where nothing has been weighed.
std::optional<ColumnStatistics> statistics(std::span<const Weighed> masses,
                                           const std::optional<double>& permitted_spread);
std::optional<ColumnStatistics> statistics(const PartColumn& column);

/// One line of a bob weight's sum.
struct WeightLine {
    Word name;
    double factor;  ///< how many times the mass counts in the bob weight
    double mass;    ///< kg
    bool reciprocates = false;

    double product() const { return factor * mass; }
};

/// Whether readings of the balancing machine were taken with another bob weight than there is now,
/// kg. One that is not known is no other; bob weights are made to a tenth of a gram.
inline bool is_other_bob_weight(const std::optional<double>& then,
                                const std::optional<double>& now) {
    constexpr double rounding = 0.05 * units::gram;
    return then && now && (*then > *now + rounding || *then < *now - rounding);
}

inline constexpr Word numbering_words[] = {{"bank-by-bank", Text::tr("Bank by bank")},
                                           {"alternating", Text::tr("1 and 2, 3 and 4, …")}};

namespace field {

inline constexpr Field weigh_in{.key = "weigh_in",
                                .hint = Text::tr("Masses of the parts by the scale.")};
inline constexpr Field numbering{.key = "cylinder_numbering",
                                 .label = Text::tr("C&ylinders of a crankpin"),
                                 .hint = Text::tr("The two cylinders that share a crankpin."),
                                 .words = numbering_words};
inline constexpr Field nominal{.key = "nominal_g",
                               .range = Range::between(0.001, 100'000),
                               .hint = Text::tr("Nominal mass of the part.")};
inline constexpr Field part_mass{
    .key = "mass_g", .range = nominal.range, .hint = Text::tr("Masses by cylinder.")};
inline constexpr Field permitted_spread{.key = "permitted_spread_g",
                                        .range = Range::between(0, 100'000),
                                        .hint = Text::tr("Permitted range of the masses.")};
inline constexpr Field piston_sets{
    .key = "piston_sets",
    .hint = Text::tr("Piston set in each cylinder, by the cylinder where it was weighed.")};
inline constexpr Field rod_sets{
    .key = "rod_sets",
    .hint = Text::tr("Rod in each cylinder, by the cylinder where it was weighed.")};
/// Of a reading of the balancing machine.
inline constexpr Field bob_weight_then{
    .key = "bobweight_g",
    .range = Range::between(0, 100'000'000),
    .label = Text::tr("Bob weight of the reading"),
    .hint = Text::tr(
        "Bob weight on each crankpin during the reading; the reading is valid only with it.")};

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

/// The sheet in the order of the case file, its columns as long as there are cylinders.
/// @param of_plugs  a column needs its nominal mass, and the engine says its crank radius
void visit_sheet(FieldVisitor& visitor, WeighIn& sheet, bool of_plugs);

/// Throws where a column with any weight lacks another one. A nominal mass alone is no weight.
/// @param nominal_needed  or its nominal mass
/// @throws InputError
void check_weighed(const WeighIn& sheet, bool nominal_needed);

}  // namespace ravnoves::shop

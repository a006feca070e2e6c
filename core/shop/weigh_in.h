#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "case-file/field.h"
#include "case-file/field_visitor.h"
#include "case-file/json_fwd.h"
#include "shop/matching_rules.h"

/// What the scenes of the workshop share: the weigh-in sheet, the head of the job card, grades of
/// balance quality.
namespace ravnoves::shop {

// The weigh-in sheet: every part of every cylinder on the scale. Masses in kg.

enum class Part { piston, pin, rings, rod_big_end, rod_small_end, shells };
inline constexpr std::array<Part, 6> all_parts{
    Part::piston, Part::pin, Part::rings, Part::rod_big_end, Part::rod_small_end, Part::shells};
/// Names of the parts, in the order of the enumeration.
inline constexpr Word part_words[] = {{"piston", CORE_TEXT("V8", "Piston")},
                                      {"pin", CORE_TEXT("V8", "Pin")},
                                      {"rings", CORE_TEXT("V8", "Rings")},
                                      {"rod_big_end", CORE_TEXT("V8", "Rod, big end")},
                                      {"rod_small_end", CORE_TEXT("V8", "Rod, small end")},
                                      {"shells", CORE_TEXT("V8", "Shells")}};
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
/// @tparam Masses  an array of Weighed, or a vector where the engine says how many there are
template <typename Masses>
struct PartColumn {
    std::optional<double> nominal;           ///< kg
    std::optional<double> permitted_spread;  ///< heaviest less lightest, kg
    Masses mass{};                           ///< kg, by cylinder

    bool is_empty() const {  ///< nothing weighed
        return std::none_of(mass.begin(), mass.end(), [](const Weighed& m) { return m; });
    }
    bool is_weighed() const {  ///< all cylinders
        return !mass.empty() &&
               std::all_of(mass.begin(), mass.end(), [](const Weighed& m) { return m; });
    }
    bool is_complete() const { return nominal && is_weighed(); }  ///< and the nominal mass known

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
/// The numbers after moving: element i of `from` is the cylinder (from 0) whose set goes to i.
SetNumbers moved_numbers(const SetNumbers& numbers, const std::vector<int>& from);

template <typename Masses>
struct WeighIn {
    std::array<PartColumn<Masses>, 6> columns;  ///< in the order of all_parts
    CylinderNumbering numbering = CylinderNumbering::bank_by_bank;
    SetNumbers piston_sets;  ///< piston with its pin and rings
    SetNumbers rod_sets;     ///< rod with its shells
    MatchingRules matching;

    /// Whether sets are in other cylinders than those they were weighed in.
    bool is_moved() const { return !piston_sets.empty() || !rod_sets.empty(); }

    bool is_empty() const {  ///< nothing weighed
        return std::all_of(columns.begin(), columns.end(),
                           [](const auto& column) { return column.is_empty(); });
    }
    bool is_counted() const {  ///< a column is complete
        return std::any_of(columns.begin(), columns.end(),
                           [](const auto& column) { return column.is_complete(); });
    }

    PartColumn<Masses>& operator[](Part part) { return columns[static_cast<std::size_t>(part)]; }
    const PartColumn<Masses>& operator[](Part part) const {
        return columns[static_cast<std::size_t>(part)];
    }

    friend bool operator==(const WeighIn&, const WeighIn&) = default;
};

/// Statistics of what has been weighed so far in a column.
struct ColumnStatistics {
    int count;
    double mean;    ///< kg
    double spread;  ///< heaviest less lightest, kg
    int heaviest;   ///< cylinder, counted from 0
    int lightest;
    bool within_permitted;  ///< true where no permitted spread is given
};
/// Nothing where nothing has been weighed.
std::optional<ColumnStatistics> statistics(std::span<const Weighed> masses,
                                           const std::optional<double>& permitted_spread);
template <typename Masses>
std::optional<ColumnStatistics> statistics(const PartColumn<Masses>& column) {
    return statistics(column.mass, column.permitted_spread);
}

/// Whether readings of the balancing machine were taken with another bob weight than there is now,
/// kg. One that is not known is no other; bob weights are made to a tenth of a gram.
inline bool is_other_bob_weight(const std::optional<double>& then,
                                const std::optional<double>& now) {
    constexpr double rounding = 0.05 * units::gram;
    return then && now && (*then > *now + rounding || *then < *now - rounding);
}

namespace field {

inline constexpr Field weigh_in{.key = "weigh_in",
                                .hint = CORE_TEXT("V8", "Weights of the parts as the scale says.")};
inline constexpr Field nominal{.key = "nominal_g",
                               .unit = units::gram,
                               .range = Range::between(0.001, 100'000),
                               .hint = CORE_TEXT("V8", "Nominal mass of the part.")};
inline constexpr Field permitted_spread{
    .key = "permitted_spread_g",
    .unit = units::gram,
    .range = Range::between(0, 100'000),
    .hint = CORE_TEXT("V8", "By how much the parts may differ from one another.")};
inline constexpr Field piston_sets{
    .key = "piston_sets",
    .hint = CORE_TEXT("V8",
                      "Number of the piston set in each cylinder, where it is not that of the "
                      "cylinder: it was weighed there.")};
inline constexpr Field rod_sets{
    .key = "rod_sets",
    .hint = CORE_TEXT("V8",
                      "Number of the rod in each cylinder, where it is not that of the cylinder: "
                      "it was weighed there.")};
/// Of a reading of the balancing machine.
inline constexpr Field bob_weight_then{
    .key = "bobweight_g",
    .unit = units::gram,
    .range = Range::between(0, 100'000'000),
    .label = CORE_TEXT("V8", "Bob weight then"),
    .hint = CORE_TEXT("V8",
                      "That hung on each crankpin when the machine read; readings hold for it "
                      "alone.")};

}  // namespace field

/// The numbers of the sets: a permutation of 1 to n, not written where nothing was moved.
void visit_set_numbers(FieldVisitor& visitor, const Field& field, SetNumbers& numbers,
                       std::size_t cylinders);
template <typename Masses>
void visit_sets(FieldVisitor& visitor, WeighIn<Masses>& sheet) {
    const std::size_t cylinders = sheet.columns.front().mass.size();
    visit_set_numbers(visitor, field::piston_sets, sheet.piston_sets, cylinders);
    visit_set_numbers(visitor, field::rod_sets, sheet.rod_sets, cylinders);
}

/// The weights of a column in a case file; null for what is not weighed yet.
class WeightList final : public FieldVisitor::Custom {
  public:
    WeightList(const Field& mass, std::span<Weighed> weights) : mass_(mass), weights_(weights) {}

    void read(const Json& masses, const std::string& pointer) override;
    Json write() override;
    void check(const std::string& pointer) override;

  private:
    const Field& mass_;
    std::span<Weighed> weights_;
};

/// The six columns in the order of the case file.
/// @param mass             the field of the weights: key, range and hint
/// @param nominal_needed   a column without it cannot be read
template <typename Masses>
void visit_columns(FieldVisitor& visitor, WeighIn<Masses>& sheet, const Field& mass,
                   bool nominal_needed) {
    for (const Part part : all_parts) {
        PartColumn<Masses>& column = sheet[part];
        const bool is_there = column.nominal || column.permitted_spread || !column.is_empty();
        visitor.object_of({.key = part_word(part).word, .label = part_word(part).label}, false,
                          is_there, [&] {
                              if (nominal_needed) {
                                  visitor.required(field::nominal, column.nominal);
                              } else {
                                  visitor.number(field::nominal, column.nominal);
                              }
                              visitor.number(field::permitted_spread, column.permitted_spread);
                              WeightList weights(mass, column.mass);
                              visitor.custom(mass, true, weights);
                          });
    }
}

/// Throws where a column that is begun lacks a weight.
/// @throws InputError
void check_weighed(Part part, std::span<const Weighed> masses);
template <typename Masses>
void check_weighed(const WeighIn<Masses>& sheet) {
    for (const Part part : all_parts) {
        const PartColumn<Masses>& column = sheet[part];
        if (column.nominal || column.permitted_spread || !column.is_empty()) {
            check_weighed(part, column.mass);
        }
    }
}

}  // namespace ravnoves::shop

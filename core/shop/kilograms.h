#pragma once

#include <optional>
#include <span>
#include <vector>

#include "shop/weigh_in.h"

namespace ravnoves::shop {

/// A mass that seems typed in kilograms: the first of these that is less than any such part of a
/// car or truck weighs (a piston of 0.5 g is no piston), or a hundredth of the nominal mass or
/// less, or a hundred times that. Empty without one; 0 is no mass.
std::optional<double> mass_in_kilograms(Part part, const std::optional<double>& nominal,
                                        std::span<const Weighed> masses);

inline std::optional<double> mass_in_kilograms(Part part, const PartColumn& column) {
    return mass_in_kilograms(part, column.nominal, column.mass);
}

/// A mass that is unlike the others of its column, as a slip of the keys makes it.
struct OddMass {
    std::size_t cylinder;  ///< counted from 0
    double mass;           ///< kg
    double usual;          ///< median of the others, kg
    /// How many times the usual scatter of the others it is away (a robust z-score); of four and
    /// more parts.
    std::optional<double> score{};
    /// Cylinders that are unlike theirs as well, as an equal slip makes them; half of them and more
    /// where there are two kinds.
    std::vector<std::size_t> also{};
    /// Within a tenth of the others: no slip where the shop permits that range.
    bool may_be_permitted = false;

    /// All of them, in order.
    std::vector<std::size_t> cylinders() const;
};
/// Scatters that a part may be away from the others of its kind; beyond them it is a slip.
inline constexpr double max_score = 6.0;

/// The mass that is farthest from the others, where that is by more than a tenth: parts of one
/// engine differ by a few percent; of four or more also by more than a hundredth, more than the
/// permitted spread and more than max_score times the scatter of the others; where several are, by
/// more than three hundredths, unless they are more than a third. Of two or three, whose median
/// says little, by a factor of more than 3, as from a misplaced decimal sign; of two the one that
/// is farther from the nominal mass, or the heavier one. Empty without one; 0 is no mass.
std::optional<OddMass> odd_mass(const PartColumn& column);

/// Cylinders, counted from 0, whose rod weighs less at its big end than at its small one: no rod
/// does, the two were typed into each other's column.
std::vector<std::size_t> swapped_rod_ends(std::span<const Weighed> big_ends,
                                          std::span<const Weighed> small_ends);

}  // namespace ravnoves::shop

#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "v8-plugs/compensation.h"
#include "workshop/weigh_in.h"

namespace ravnoves::v8_plugs {

// The weigh-in sheet: every part of every cylinder on the scale. Masses in kg.

using workshop::all_parts;
using workshop::ColumnStatistics;
using workshop::CylinderNumbering;
using workshop::Part;
using workshop::part_word;
using workshop::part_words;

/// Masses by cylinder.
using Masses = std::array<workshop::Weighed, cylinder_count>;
using PartColumn = workshop::PartColumn<Masses>;

/// The two cylinders of each crankpin, counted from 0.
using Crankpins = std::array<std::array<int, 2>, crankpin_count>;
Crankpins crankpins(CylinderNumbering numbering);

/// The number of the set in each cylinder: of the cylinder, from 1, that it was weighed in.
using SetNumbers = std::array<int, cylinder_count>;
inline constexpr SetNumbers as_weighed{1, 2, 3, 4, 5, 6, 7, 8};

struct WeighIn : workshop::WeighIn<Masses> {
    SetNumbers piston_sets = as_weighed;  ///< piston with its pin and rings
    SetNumbers rod_sets = as_weighed;     ///< rod with its shells

    friend bool operator==(const WeighIn&, const WeighIn&) = default;
};

/// The nominal masses of one cylinder that follow from its parts, kg: piston, pin, rings and small
/// end move with the piston, big end and shells turn with the crankpin. Nothing while the nominal
/// mass of one of them is missing.
std::optional<double> nominal_reciprocating(const WeighIn& sheet);
std::optional<double> nominal_rotating(const WeighIn& sheet);

/// A mass of the column that was typed in kilograms, as it seems: workshop/kilograms.h.
std::optional<double> mass_in_kilograms(Part part, const PartColumn& column);

/// The mass changes of the method from the sheet: means over the cylinders against nominal.
///
/// In repair the piston with its rings is Δm_рп, pin and small end (which move with the piston) are
/// Δm_п, the shells of both rods of a crankpin Δm_шр. In manufacture piston, pin, rings and small
/// end are Δm_п and the shells are not counted, as the method has it. Columns that are not complete
/// count as nominal; a change of which no column is complete stays what was typed.
MassChanges mass_changes(const WeighIn& sheet, Process process, const MassChanges& typed = {});
/// The change of the method that the part belongs to; null where the method does not count it.
double MassChanges::*change_of(Part part, Process process);
/// True where the sheet says the change: a column of its parts is complete.
bool is_weighed(const WeighIn& sheet, Process process, double MassChanges::*change);

/// Excess on each crankpin's own axis, from the parts of its two cylinders; their mean is the
/// unbalanced_mass() of mass_changes().
std::array<double, crankpin_count> crankpin_excess(const WeighIn& sheet, Process process,
                                                   double rod_coefficient);

/// Heaviest less lightest crankpin, kg.
double spread(const std::array<double, crankpin_count>& totals);

/// Which part goes where: element i is the cylinder (from 0) whose part goes to cylinder i.
struct Assignment {
    std::vector<int> pistons;  ///< piston with its pin and rings
    std::vector<int> rods;     ///< rod with its shells
    double spread = 0.0;       ///< heaviest less lightest crankpin total, kg
    int moved = 0;             ///< sets that change their cylinder
};

/// The assignment of two kinds of sets to the crankpins that makes the spread of the crankpins'
/// totals (largest less smallest) as small as can be, and among those of the same spread one that
/// moves the fewest sets.
///
/// Exact. A crankpin's total is the sum of the contributions of its two pistons and its two rods,
/// so only the pairing matters: (n − 1)!! pairings of each kind (105 for n = 8), and for a pairing
/// of pistons and one of rods the best match puts the heaviest pair to the lightest (it is
/// majorized by every other match, so its largest total is the smallest and its smallest the
/// largest).
///
/// @param pistons, rods  contribution of each set to its crankpin's total, kg; n even, 2 to 8
/// @param crankpins      the two positions of each crankpin, n / 2 of them
Assignment best_assignment(const std::vector<double>& pistons, const std::vector<double>& rods,
                           const std::vector<std::array<int, 2>>& crankpins);

/// Spread of the crankpins' totals for an assignment, kg.
double assignment_spread(const std::vector<double>& pistons, const std::vector<double>& rods,
                         const std::vector<std::array<int, 2>>& crankpins,
                         const Assignment& assignment);

/// The best assignment for a sheet; columns that are not complete count as nominal. Nothing where
/// no column is complete.
std::optional<Assignment> best_assignment(const WeighIn& sheet, Process process,
                                          double rod_coefficient);
/// The sheet with the parts moved as the assignment says; they keep their numbers.
WeighIn reassigned(const WeighIn& sheet, const Assignment& assignment);

}  // namespace ravnoves::v8_plugs

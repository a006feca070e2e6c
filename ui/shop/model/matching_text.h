#pragma once

#include <QStringList>
#include <QVector>

#include "shop/matching.h"
#include "shop/model/words.h"

/// What the pages of the workshop and their job cards say of matched parts.
namespace ravnoves::matching_text {

/// A placing, and what the scene knows of the engine beside it.
struct Shown {
    shop::Matched matched;
    shop::Crank crank;
    std::optional<double> crank_radius;  ///< m
    std::optional<double> speed;         ///< rad/s
    shop::SetNumbers piston_sets;        ///< as on the sheet
    shop::SetNumbers rod_sets;
    /// Parts were moved on a sheet of another number of cylinders, whose set numbers say nothing.
    bool is_origin_unknown = false;

    bool is_moved() const { return !piston_sets.empty() || !rod_sets.empty(); }
};

/// Which sets to move, as text.
QString summary(const Words& words, const Shown& shown);
/// Why it misses the goal, unproven parts, and the assumptions.
QStringList remarks(const Words& words, const Shown& shown);
/// The gain: a quantity, as weighed, as placed.
Results effects(const Words& words, const Shown& shown);

/// From which cylinder each set comes; a dot where it was weighed there.
Results assignment(const Words& words, const Shown& shown);
/// Parts to weigh again before the weights of a sheet are used: those unlike the others of their
/// column, and rods whose ends are swapped. "Weigh again first: piston of cylinder 3; rod of
/// cylinder 5."; empty where the weights are plausible.
QString weighAgain(const Words& words, const shop::WeighIn& sheet);

/// Metal to remove from each part to reach the lightest of its column, for columns that differ; by
/// the numbers of the parts, wherever they are moved. Columns with doubtful weights are left out:
/// no part is ground by a slip of the keys.
Results takeOff(const Words& words, shop::WeighIn sheet);

}  // namespace ravnoves::matching_text

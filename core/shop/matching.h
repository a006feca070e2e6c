#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "case-file/message.h"
#include "shop/weigh_in.h"

/// Matching of weighed parts: metal to remove to reach the lightest, and which set belongs to which
/// cylinder.
namespace ravnoves::shop {

/// What to take off each part, so that it equals the lightest of its column; kg. Nothing for those
/// that are not weighed.
std::vector<Weighed> take_off(std::span<const Weighed> masses);

/// Where a cylinder's parts act on the crankshaft.
struct CylinderPlace {
    int crankpin = 0;
    int bank = 0;
    double crank_angle = 0.0;  ///< ψ of its crankpin, rad
    double axis = 0.0;         ///< β of its cylinder, rad
    double position = 0.0;     ///< along the crankshaft, m; in spacings where that is not known
};

/// The crankshaft and its cylinders.
struct Crank {
    int cylinders = 0;
    int rods_per_pin = 2;
    CylinderNumbering numbering = CylinderNumbering::bank_by_bank;
    bool has_banks = true;             ///< two
    bool has_throws = true;            ///< each of two cylinders, one of either bank
    std::optional<double> bank_angle;  ///< γ, rad
    double split = 0.0;                ///< δ of the two crankpins of a throw, rad
    /// Of the throws, else of the cylinders' crankpins, rad; empty: not known.
    std::vector<double> angles;
    std::optional<double> spacing;  ///< m
    double bank_offset = 0.0;       ///< m

    /// How many angles there must be.
    int angle_count() const;
    /// What a sheet says of the crank; the angles stay where it gives none.
    void follow(const WeighIn& sheet);
};

/// By cylinder. Crankpins of a throw at φ ∓ δ/2 for axes at ±γ/2, the first bank first.
std::vector<CylinderPlace> places_of(const Crank& crank);

/// What the differences of the parts do to the engine, as masses at the crank radius.
///
/// Every part by which a cylinder differs from the mean of its column pulls with the crank (what
/// rotates: m e^{iψ}) or along its cylinder (what reciprocates, first order:
/// ½ m e^{iψ} + ½ m e^{2iβ} e^{−iψ}, a part that turns with the crank and one that turns against
/// it). Left out: what the engine leaves by its design, which no placing changes; higher orders;
/// the bend of crankshaft and block; the tilt of the rods.
struct Shaking {
    double force;   ///< maximum over a turn, kg
    double couple;  ///< the same about the middle, kg·m, or kg·spacing
    double ends;    ///< at the end crankpins: root mean square over a turn and both ends, kg
};

/// How often a part of each column counts in its crankpin; 0: it does not.
using PartFactors = std::array<double, 6>;

/// The matching problem.
struct MatchingTask {
    WeighIn sheet;  ///< with its rules
    Crank crank;
    PartFactors factors{};
};

/// What a placing makes of the crankpins and of the engine, whatever its goal.
struct Placed {
    std::vector<double> crankpins;  ///< each less the mean of all, kg
    double spread = 0.0;            ///< heaviest minus lightest crankpin, kg
    std::optional<Shaking> shaking;
};
Placed placed_by(const MatchingTask& task, const std::array<std::vector<int>, 2>& from);

/// The placing: element i is the cylinder (from 0) whose set moves to cylinder i.
struct Matched {
    std::vector<int> pistons;  ///< piston with its pin and rings
    std::vector<int> rods;     ///< rod with its shells
    int moved = 0;             ///< sets that change their cylinder
    Placed before;
    Placed after;
    Placed as_weighed;                             ///< the parts where they were weighed
    MatchingGoal goal = MatchingGoal::min_spread;  ///< that was followed
    bool proven = true;                            ///< no placing is better by the goal
    Message remark;  ///< why it is not the goal asked for, or why that is not reached
    bool spacing_known = false;
};

/// The best placing by the sheet's rules; see best_placing() for the proof. Empty without a column.
std::optional<Matched> match(const MatchingTask& task);

/// By cylinder, the number of the part that is there: of the cylinder, from 1, that it was weighed
/// in.
std::vector<int> part_numbers(const WeighIn& sheet, Part part);

/// The sheet with the parts moved; the sets keep their numbers.
void move_sets(WeighIn& sheet, const std::vector<int>& pistons, const std::vector<int>& rods);

/// Sets of which nothing is weighed any more lose their numbers.
void forget_sets(WeighIn& sheet);

/// The sheet with all parts where they were weighed.
void move_back(WeighIn& sheet);

/// Whether the rules contradict themselves or the engine.
/// @param angle_count  Crank::angle_count() of the engine
/// @throws InputError
void check_matching(const MatchingRules& rules, int angle_count);

}  // namespace ravnoves::shop

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bob-weights/drilling.h"
#include "bob-weights/factor_theory.h"
#include "bob-weights/input.h"

namespace ravnoves::bob_weights {

/// One line of the card.
struct Line {
    const PartField* part;
    double factor;  ///< how many times the mass counts in the bob weight
    double mass;    ///< kg

    double product() const { return factor * mass; }
};

/// Statistics of a weighed column, and what to take off each part to match the lightest.
struct Matching {
    const PartField* part;
    workshop::ColumnStatistics statistics;
    std::vector<workshop::Weighed> take_off;  ///< kg
};

/// What is to be done in one plane.
struct PlaneResult {
    double unbalance;         ///< of the readings taken to the plane, kg·m
    double angle;             ///< rad, 0…2π
    double grams_at_radius;   ///< kg at the plane's radius
    std::vector<Hole> holes;  ///< at the heavy spot
    std::vector<Hole> slugs;  ///< opposite it
    double remaining;         ///< kg·m
    double remaining_angle;   ///< rad
    std::optional<bool> within_tolerance;
    Message reason;  ///< why more remains than may; empty where all is well
};

/// Everything the page, the card and the result file show. What needs values that are not there yet
/// is empty.
struct Result {
    double theory_factor = 0.5;
    double factor = 0.5;  ///< in use, without the overbalance
    std::vector<Line> lines;
    std::optional<double> reciprocating;  ///< of one cylinder, kg
    std::optional<double> rotating;       ///< of one cylinder, kg
    std::optional<double> bob_weight;     ///< kg
    std::optional<FirstOrder> first_order;
    std::vector<double> crankpins;  ///< each one's own bob weight, of the parts weighed; kg
    std::vector<Matching> matching;
    std::optional<double> permissible_whole;           ///< U_per of the rotor, kg·m
    std::optional<std::array<double, 2>> permissible;  ///< of each plane, kg·m
    std::optional<std::array<PlaneResult, 2>> correction;
};

/// What of the bob weight is missing, by its fields; empty where it is known.
std::vector<const Field*> missing_for_bob_weight(const Input& input);

}  // namespace ravnoves::bob_weights

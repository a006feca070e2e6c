#pragma once

#include <functional>

#include "bob-weights/drilled.h"
#include "bob-weights/input.h"
#include "bob-weights/plane_plan.h"
#include "bob-weights/result.h"

namespace ravnoves::bob_weights {

/// Fills in a bob weight that does not follow from the masses of the parts, as far as known:
/// lines and sum, what reciprocates and what rotates, the placing of the parts.
using OtherWeight = std::function<void(const Input&, Result&)>;

/// Computes whatever the input allows, also where a check does not let it pass.
/// @param places_parts  false: without the placing of the parts, which takes longest
Result solve(const Input& given, bool places_parts = true, const OtherWeight& other = {});

/// Whether the machine reads in the planes, as far as the places of both are known.
bool reads_in_planes(const Input& input);

/// What would remain of the newest reading of a plane, were a hole drilled there; nothing while
/// reading or rim are not known.
struct Remaining {
    double unbalance;                      ///< kg·m
    double angle;                          ///< rad, 0…2π
    std::optional<bool> within_tolerance;  ///< nothing without a limit
    TriedRoom room;
};
std::optional<Remaining> what_if(const Input& input, const Result& result, PlaneName plane,
                                 double diameter, double depth, double angle);

/// Σ c²/n of shop::Weighing, of the lines of the bob weight.
double rounding_squares(const Input& input, const Result& result);

/// The limits of the two planes. By grade U_per = m G / ω is shared by the place of the centre of
/// mass between the planes, each share from 0.3 to 0.7. With the end bearings the shares apply to
/// them, and the planes' limits are the largest in the ratio of their own shares for which no phase
/// of the residual exceeds a bearing's.
/// @param positions  of the planes, m; empty where unknown: halves
std::optional<std::array<double, 2>> plane_limits(
    const Tolerance& tolerance, const std::optional<std::array<double, 2>>& positions);

}  // namespace ravnoves::bob_weights

#pragma once

#include <QPolygonF>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "balance-shaft/position_study.h"

namespace ravnoves {

/// The range and RMS over the places of the shaft's axis, and the best ones, independent of the
/// present axis. Lengths in m, moments in N·m.
struct ShaftMap {
    using Position = balance_shaft::ShaftPosition;
    using Criteria = balance_shaft::PositionCriteria;

    using Place = balance_shaft::BestPosition;

    /// Half of the square to show: it contains the best places and this l, with room around.
    double viewFor(double centreDistance) const;

    balance_shaft::PositionStudy study;
    double view = 0.0;  ///< half of the square that is shown first
    balance_shaft::PositionMap field = {};
    /// Infeasible places: closed lines, to be filled by the odd-even rule.
    std::vector<QPolygonF> blocked = {};
    balance_shaft::BestPositions best = {};
    balance_shaft::BestPositions buildable = {};
    /// Of each criterion the smallest place that is at most a hundredth worse.
    std::optional<Place> smallRange = {}, smallRms = {};
    std::vector<balance_shaft::BestPosition> front = {};
};

/// Makes the map of an engine.
/// @param present   l of the shaft now, which is to be seen; m
/// @param progress  receives the part that is done, 0…1; false stops it
/// @return null where it was stopped
std::shared_ptr<const ShaftMap> makeShaftMap(const balance_shaft::Solver& solver, double present,
                                             const std::function<bool(double)>& progress);

}  // namespace ravnoves

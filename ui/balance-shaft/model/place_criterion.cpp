#include "balance-shaft/model/place_criterion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/constants.h"
#include "numerics/units.h"

namespace ravnoves {

bool PlaceCriterion::judges(const Study& study) {
    return study.range_without() > 0.0 && study.rms_without() > 0.0;
}

double PlaceCriterion::rangeShare() const {
    return of(kind, 1.0, 0.0, weight);
}

double PlaceCriterion::rangeWeight(const Study& study) const {
    const double share = rangeShare();
    const double range = share * study.rms_without();
    const double rms = (1.0 - share) * study.range_without();
    return range + rms > 0.0 ? range / (range + rms) : share;
}

double PlaceCriterion::change(const Study& study, double range, double rms) const {
    const double share = rangeShare();
    double sum = 0.0;
    if (share > 0.0) {
        sum += share * range / study.range_without();
    }
    if (share < 1.0) {
        sum += (1.0 - share) * rms / study.rms_without();
    }
    return sum - 1.0;
}

double PlaceCriterion::valueOf(const Study& study, const Criteria& criteria) const {
    return of(kind, criteria.range, criteria.rms, change(study, criteria.range, criteria.rms));
}

PlaceCriterion::Position PlaceCriterion::shortened(const Study& study,
                                                   const Position& exact) const {
    constexpr double parts = 100.0;  // of a millimetre and of a degree
    constexpr int around = 3;
    const auto isBuildable = [&](const Position& position) {
        return study.obstacle(position) == balance_shaft::Obstacle::none;
    };
    const double l = std::floor(parts * exact.centre_distance() / units::mm);
    const double alpha = std::floor(parts * exact.shaft_angle() / degree);
    const bool canBeBuilt = isBuildable(exact);
    Position best = exact;
    double minimum = std::numeric_limits<double>::infinity();
    for (int i = 1 - around; i <= around; ++i) {
        for (int k = 1 - around; k <= around; ++k) {
            const Position at = Position::at(std::max(l + i, 0.0) / parts * units::mm,
                                             (alpha + k) / parts * degree);
            if (isBuildable(at) != canBeBuilt) {
                continue;
            }
            if (const double value = valueOf(study, study.at(at)); value < minimum) {
                minimum = value;
                best = at;
            }
        }
    }
    return best;
}

}  // namespace ravnoves

#include "model/crank_angle.h"

#include <cmath>

#include "numerics/angle.h"

namespace ravnoves {

void CrankAngle::setCycle(double degrees) {
    if (degrees != cycle_) {
        cycle_ = degrees;
        Q_EMIT cycleChanged(degrees);
        turnTo(degrees_);
    }
}

void CrankAngle::turnTo(double degrees) {
    if (!std::isfinite(degrees)) {
        return;
    }
    if (degrees != cycle_) {
        degrees = wrap(degrees, cycle_);
    }
    if (degrees != degrees_) {
        degrees_ = degrees;
        Q_EMIT changed(degrees);
    }
}

}  // namespace ravnoves

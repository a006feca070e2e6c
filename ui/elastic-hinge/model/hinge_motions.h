#pragma once

#include <QString>
#include <memory>
#include <optional>

#include "elastic-hinge/motion.h"
#include "model/background_job.h"

namespace ravnoves {

/// The motions that the page compares; those whose hinges do not exist are empty.
struct HingeMotions {
    std::optional<elastic_hinge::Motion> without;    ///< no hinge, from the design speed
    std::optional<elastic_hinge::Motion> crank;      ///< the crank's hinge, from the design speed
    std::optional<elastic_hinge::Motion> both;       ///< crank's and rod's hinge
    std::optional<elastic_hinge::Motion> offDesign;  ///< the crank's hinge, from another speed
    double offSpeed = 0.0;                           ///< that speed, rad/s
    QString trouble;                                 ///< why there are none at all; else empty
};

/// The speed of the run that starts away from the design speed.
double offSpeed(const elastic_hinge::Input& input);
/// As many motions as there are before the progress is stopped.
std::shared_ptr<HingeMotions> computeMotions(const elastic_hinge::Input& input,
                                             const elastic_hinge::Result& result,
                                             const BackgroundJob::Progress& progress);

}  // namespace ravnoves

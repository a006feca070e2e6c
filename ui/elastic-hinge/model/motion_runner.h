#pragma once

#include <QString>
#include <memory>
#include <optional>

#include "elastic-hinge/solver.h"
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

/// Computes the motions in a worker thread, the newest wish first, when the hand rests: they take
/// as long as a hundred frames of a drag. A long run is cancelled when a newer wish is there.
class MotionRunner : public BackgroundJob {
    Q_OBJECT

  public:
    explicit MotionRunner(QObject* parent = nullptr);

    void start(const elastic_hinge::Input& input,
               std::shared_ptr<const elastic_hinge::Result> result);

    /// The speed of the run that starts away from the design speed.
    static double offSpeed(const elastic_hinge::Input& input);

  Q_SIGNALS:
    void computed(std::shared_ptr<const HingeMotions> motions);

  private:
    double offSpeed_ = 0.0;  ///< of the newest wish
};

}  // namespace ravnoves

#pragma once

#include <QObject>
#include <cmath>

#include "numerics/angle.h"

namespace ravnoves {

/// φ of a scene's picture and of the cursors in its plots, °, within a cycle.
class CrankAngle : public QObject {
    Q_OBJECT

  public:
    CrankAngle(double degrees, double cycle) : degrees_(degrees), cycle_(cycle) {}

    double degrees() const { return degrees_; }
    double cycle() const { return cycle_; }
    void setCycle(double degrees) {
        if (degrees != cycle_) {
            cycle_ = degrees;
            Q_EMIT cycleChanged(degrees);
            turnTo(degrees_);
        }
    }
    /// The end of the cycle, where a slider ends, is kept.
    void turnTo(double degrees) {
        if (!std::isfinite(degrees)) {
            return;
        }
        degrees = degrees == cycle_ ? degrees : wrap(degrees, cycle_);
        if (degrees != degrees_) {
            degrees_ = degrees;
            Q_EMIT changed(degrees);
        }
    }

  Q_SIGNALS:
    void changed(double degrees);
    void cycleChanged(double degrees);

  private:
    double degrees_;
    double cycle_;
};

}  // namespace ravnoves

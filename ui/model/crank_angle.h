#pragma once

#include <QObject>

namespace ravnoves {

/// φ of a scene's picture and of the cursors in its plots, °, within a cycle.
class CrankAngle : public QObject {
    Q_OBJECT

  public:
    CrankAngle(double degrees, double cycle) : degrees_(degrees), cycle_(cycle) {}

    double degrees() const { return degrees_; }
    double cycle() const { return cycle_; }
    void setCycle(double degrees);
    /// The end of the cycle, where a slider ends, is kept.
    void turnTo(double degrees);

  Q_SIGNALS:
    void changed(double degrees);
    void cycleChanged(double degrees);

  private:
    double degrees_;
    double cycle_;
};

}  // namespace ravnoves

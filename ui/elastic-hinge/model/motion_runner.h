#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <memory>
#include <optional>

#include "elastic-hinge/solver.h"

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

/// Computes the motions in a worker thread, the newest wish first: short runs come to their end
/// while a slider moves, long ones are cancelled when a newer wish is there.
class MotionRunner : public QObject {
    Q_OBJECT

  public:
    explicit MotionRunner(QObject* parent = nullptr);
    ~MotionRunner() override;

    void start(const elastic_hinge::Input& input,
               std::shared_ptr<const elastic_hinge::Result> result);
    /// Stops a run that is under way; what it has is thrown away.
    void cancel();
    bool isRunning() const { return job_ != nullptr || pending_ != nullptr; }

    /// The speed of the run that starts away from the design speed.
    static double offSpeed(const elastic_hinge::Input& input);

  Q_SIGNALS:
    void runningChanged(bool running);
    /// Part done, 0…1.
    void progress(double part);
    void finished(std::shared_ptr<const HingeMotions> motions);

  private:
    struct Job {
        elastic_hinge::Input input;
        std::shared_ptr<const elastic_hinge::Result> result;
        std::atomic<bool> cancelled{false};
    };

    void launch();
    void done(const std::shared_ptr<Job>& job, std::shared_ptr<const HingeMotions> motions);
    std::shared_ptr<const HingeMotions> compute(Job& job);

    QThreadPool pool_;
    QTimer pause_;                  ///< gathers the steps of a drag into one run
    QElapsedTimer clock_;           ///< of the run under way
    std::shared_ptr<Job> job_;      ///< under way
    std::shared_ptr<Job> pending_;  ///< to follow
};

}  // namespace ravnoves

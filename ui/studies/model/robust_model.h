#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>
#include <string>

#include "studies/robust_best.h"

namespace ravnoves {

class BackgroundJob;
class StudyModel;

/// The angle of the study's case that holds best when its inputs scatter, beside the one that is
/// best of the inputs as they are; computed in the background while someone looks.
class RobustModel : public QObject {
    Q_OBJECT

  public:
    explicit RobustModel(StudyModel* study, QObject* parent = nullptr);

    BackgroundJob* job() const { return job_; }
    /// Whether the scene chooses an angle at all.
    bool isAsked() const;
    void setWatched(bool watched);
    const studies::RobustBest* best() const { return best_ ? &*best_ : nullptr; }
    bool isStale() const { return stale_; }
    /// Nothing varies, or it cannot be found; empty otherwise.
    QString trouble() const { return trouble_; }
    void stop();
    void run();
    bool isStopped() const { return stopped_; }
    /// Sets the case's angle, as one step of the history.
    void goTo(double angle);

  Q_SIGNALS:
    void changed();

  private:
    void follow();
    void start();

    StudyModel* study_;
    BackgroundJob* job_;
    QTimer later_;
    std::optional<studies::RobustBest> best_;
    std::string followed_;  ///< what the angle depends on
    QString trouble_;
    bool stopped_ = false;
    bool stale_ = false;
    bool watched_ = false;
};

}  // namespace ravnoves

#pragma once

#include <QObject>
#include <QString>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/background_job.h"
#include "model/scene_model.h"
#include "studies/model/study_model.h"

namespace ravnoves {

/// A result over one input while the other inputs scatter, in the units of their keys.
struct Sweep {
    /// The result over the samples at one value of the input.
    struct Place {
        double x = 0.0;
        // Not a number where no sample could be solved:
        double mean = 0.0;
        double low = 0.0;       ///< 5 %
        double high = 0.0;      ///< 95 %
        double size = 0.0;      ///< 95 % of the amount, |…|
        double built = 0.0;     ///< share of the samples that are solved and feasible
        double rejected = 0.0;  ///< share of the samples that are not solved
        bool operator==(const Place&) const = default;
    };
    /// The minimum share of feasible samples at the best place.
    static constexpr double minBuilt = 0.95;

    std::optional<double> nominalResult = {};
    std::vector<Place> places = {};
    /// Where the 95 % amount is smallest, with `minBuilt` of the samples feasible, or the largest
    /// share; between the places.
    std::optional<Place> best = {};
    bool operator==(const Sweep&) const = default;
};

/// Computes sweeps of the study's case in the background while someone looks.
class SweepModel : public QObject {
    Q_OBJECT

  public:
    explicit SweepModel(StudyModel* study, QObject* parent = nullptr);

    BackgroundJob* job() const { return job_; }
    bool isBusy() const { return job_->isRunning(); }
    // Pointers.
    const std::string& input() const { return choice_.input; }
    const std::string& result() const { return choice_.result; }
    /// What may be swept, what scatters first.
    std::vector<const StudyModel::Input*> inputs() const;
    /// Adopts what the scene is to sweep: a removed input or result is replaced by the first, a
    /// missing end is taken from usualEnds().
    void follow();
    /// From and to, in the unit of the input's key.
    using Ends = std::pair<double, double>;
    /// The limits of the input's tolerance; without one, a whole turn of an angle, or a tenth of
    /// the value either way: within the range of its field. Nothing where no input is chosen.
    std::optional<Ends> usualEnds() const;
    /// Begins while someone looks; what has begun comes to its end.
    void setWatched(bool watched);

    /// The latest sweep, whole or partial; null before any.
    const Sweep* sweep() const { return sweep_ ? &*sweep_ : nullptr; }
    /// Newer numbers are on the way, or should be.
    bool isStale() const { return stale_; }
    /// It has the places so far, the others are on the way.
    bool isPartial() const { return partial_; }
    QString trouble() const { return trouble_; }
    /// Sets the input to the best place, as one step of the history.
    void takeBest();

  Q_SIGNALS:
    void changed();

  private:
    /// What a sweep is made of.
    struct Wanted {
        studies::Study study = {};  ///< varies nothing where no sweep can be made
        int solution = -1;          ///< of the scene
        bool operator==(const Wanted&) const = default;
    };
    Wanted wantedNow() const;
    void start();
    void show(const Sweep& sweep, bool isPartial);

    StudyModel* study_;
    BackgroundJob* job_;
    SweepChoice choice_;
    Wanted wanted_;
    std::optional<Sweep> sweep_;
    QString trouble_;
    bool stale_ = false;
    bool partial_ = false;
    bool watched_ = false;
};

}  // namespace ravnoves

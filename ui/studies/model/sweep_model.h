#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>
#include <string>
#include <vector>

namespace ravnoves {

class BackgroundJob;
class StudyModel;

/// A result over one input, or over two: what a change of these alone does to it.
struct Sweep {
    struct Axis {
        std::string pointer;
        double nominal = 0.0;
        double half = 0.0;  ///< of its ±; 0 where it has none
        std::vector<double> values;
    };
    Axis x;
    std::optional<Axis> y;
    std::string result;         ///< its pointer
    std::vector<double> found;  ///< a row of x for each y; not a number where it was refused
    std::size_t refused = 0;
    std::optional<double> nominal;
};

/// Computes sweeps of the study's case in the background while someone looks.
class SweepModel : public QObject {
    Q_OBJECT

  public:
    explicit SweepModel(StudyModel* study, QObject* parent = nullptr);

    StudyModel* study() const { return study_; }
    BackgroundJob* job() const { return job_; }
    // Pointers; without a second input it is a line.
    const std::string& input() const { return input_; }
    const std::string& other() const { return other_; }
    const std::string& result() const { return result_; }
    void choose(const std::string& input, const std::string& other, const std::string& result);
    /// How far it goes: so many times the ± of each input, which is a tenth of what has none.
    double reach() const { return reach_; }
    void setReach(double times);
    /// Computes while someone looks.
    void setWatched(bool watched);

    /// What was found last; null where there is nothing.
    const Sweep* sweep() const { return sweep_ ? &*sweep_ : nullptr; }
    /// Newer numbers are on the way, or should be.
    bool isStale() const { return stale_; }
    QString trouble() const { return trouble_; }

  Q_SIGNALS:
    void changed();

  private:
    void follow();
    void start();
    Sweep::Axis axisOf(const std::string& pointer) const;

    StudyModel* study_;
    BackgroundJob* job_;
    QTimer later_;
    std::string input_;
    std::string other_;
    std::string result_;
    double reach_ = 1.0;
    std::optional<Sweep> sweep_;
    QString trouble_;
    bool stale_ = false;
    bool watched_ = false;
};

}  // namespace ravnoves

#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/input_differences.h"
#include "model/scene_model.h"
#include "studies/model/study_answers.h"
#include "studies/study.h"
#include "text/shown_units.h"

namespace ravnoves {

class BackgroundJob;

/// A number of a result as a person says it.
struct ResultName {
    QString text;         ///< "Mᵤₚₛ, range"
    QString unit;         ///< of its key; may be empty
    double period = 0.0;  ///< 360 or 720 of an angle; else 0

    /// The unit of its numbers on the screen.
    ShownUnit shown() const { return shownUnit(unit); }
    /// With the unit that is shown.
    QString withUnit() const { return shownTitle(titleWithUnit(text, unit)).text; }
};

/// The tolerances of a case: which inputs scatter, which results are watched, and what follows. It
/// is the "study" of the case file; every change is one step of the case's history.
class StudyModel : public QObject {
    Q_OBJECT

  public:
    /// A number of the input that may scatter.
    struct Input : InputNumber {
        std::optional<studies::Varied> varied = {};
        bool isMissing = false;  ///< the case has it no more: the study runs without it
        /// Half of what its tolerance allows; 0 without one.
        double half() const;
    };
    enum class Preset { Typical, OnePercent };

    explicit StudyModel(SceneModel* scene, QObject* parent = nullptr);

    SceneModel* scene() const { return scene_; }
    const studies::Study& study() const { return study_; }
    /// Why the case's study or its answer is rejected; empty where neither is.
    QString trouble() const { return trouble_; }
    /// A removed method that older cases have; empty without one.
    QString removedMethod() const { return removedMethod_; }
    BackgroundJob* job() const { return job_; }

    const std::vector<Input>& inputs() const { return inputs_; }
    /// The one with a pointer that the case has; else null.
    const Input* input(const std::string& pointer) const;
    /// Of its field, in the unit of its key.
    Range rangeOf(const std::string& pointer) const;
    /// Pointers below "result" of the single numbers that the case has now; solves it.
    std::vector<std::string> results() const;
    /// As the scene describes it, or by its keys where no case so far had it.
    ResultName resultName(const std::string& pointer) const;
    QString inputName(const std::string& pointer) const;
    /// The title of its axis in the unit shown.
    ShownTitle inputTitle(const std::string& pointer) const;

    /// "0.02", "1 %", "σ 0.5", in the unit of its field; empty where the input does not scatter.
    static QString scatterText(const Input& input);
    /// Takes the same of an input into a study; an empty text takes the input out.
    /// @return an empty string, or why it cannot be
    QString readScatter(studies::Study& next, const std::string& pointer,
                        const QString& text) const;
    static constexpr double weighedGrams = 0.5;
    static constexpr double machinedMm = 0.05;
    /// Gives inputs their usual scatter: masses and lengths these, or all of them ± 1 %.
    void take(Preset preset);
    /// Removes all scatters and watched results, with the case's study, a rejected one too.
    void clear();
    void watch(const std::string& pointer);
    /// A limit of a result for typing, in the unit shown.
    QString limitText(const std::string& pointer, const std::optional<double>& limit) const;
    /// Takes the same into a limit.
    /// @return an empty string, or why it cannot be
    QString readLimit(const std::string& pointer, const QString& text,
                      std::optional<double>& limit) const;
    /// Another study, as one step of the history.
    /// @return an empty string, or why it cannot be
    QString change(const QString& name, const studies::Study& next);
    void setMethod(studies::Method method);
    void setSamples(std::uint64_t samples);

    /// True while newer answers are on the way.
    bool isBusy() const;
    /// Computes while someone looks.
    void setWatched(bool watched);
    /// Null without answers.
    const StudyAnswers* answers() const { return answers_ ? &*answers_ : nullptr; }
    /// They are of an earlier state, and newer ones are being computed.
    bool isStale() const { return stale_; }
    /// With names of inputs and results in the place of their pointers.
    QString named(const Message& message) const;

  Q_SIGNALS:
    /// Inputs, study or trouble.
    void changed();
    void answered();

  private:
    /// The one with a pointer, also a missing one; else null.
    const Input* known(const std::string& pointer) const;
    void follow();
    /// Adopts study and inputs.
    void refresh();
    /// The history says that something happened: a drag says no more than that.
    void move();
    /// The input has moved since it was adopted.
    bool isBehind() const { return solutions_ != scene_->solutions(); }
    void readStudy();
    /// Newer answers are to come, when the hand that moves something rests.
    void outdate();
    void start();
    void show(std::optional<StudyAnswers> answers, const QString& trouble);

    SceneModel* scene_;
    BackgroundJob* job_;
    QTimer later_;
    studies::Study study_;
    std::vector<Input> inputs_;
    std::optional<StudyAnswers> answers_;
    QString trouble_;
    QString removedMethod_;
    bool isRejected_ = false;  ///< the case's study cannot be read, and stays until it is cleared
    int solutions_ = -1;       ///< of the scene, when it was adopted
    mutable std::map<std::string, ResultName> names_;  ///< of results
    mutable int namedOf_ = -1;                         ///< solutions_ when they were looked up
    bool stale_ = false;
    bool watched_ = false;
};

/// Watches last whether a sample is feasible, where the scene tells.
void watchFeasible(studies::Study& study, const SceneModel& scene);

/// The study of a case from its JSON text. A removed method of older versions becomes Sobol points.
/// @param gone  set to the word of that method
/// @throws InputError
studies::Study readStudyText(const std::string& text, QString* gone = nullptr);

}  // namespace ravnoves

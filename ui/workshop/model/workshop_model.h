#pragma once

#include "model/case_model.h"
#include "workshop/model/job_desk.h"
#include "workshop/model/matching_text.h"

namespace ravnoves {

/// The model of a page of the workshop: the job on the sheet, what follows from it, its history and
/// its place in the journal. Beside what CaseModel asks for, `Scene` says
///
///     bool dated;              // a new job is of today
///     void startJob(Input&) const;  // fills in what a new job has then
///     static Json solvedJson(const Json& input, const CaseContext&);  // throws InputError
template <typename Scene>
class WorkshopModel : public CaseModel<Scene> {
  public:
    using Input = typename Scene::Input;
    using Solved = typename Scene::Solved;

    const Solved& solution() const { return this->solved(); }

    QString edit(const QString& name, const std::function<void(Input&)>& mutate,
                 const QString& title = {}) {
        if (!this->isTyped()) {
            beforeEditing_ = this->input();
        }
        return CaseModel<Scene>::edit(
            name,
            [&](Input& input) {
                if (bobWeightAsLoaded_) {
                    noteBobWeight(input, *bobWeightAsLoaded_);
                }
                const auto before = input.job;
                mutate(input);
                if (input.job != before) {
                    noteShaft(input, beforeEditing_);
                }
            },
            title);
    }

    // What is to be done with the weighed parts.
    /// Parts are elsewhere than they were weighed, and it is known where that was.
    virtual bool canMoveBack() const {
        const auto& sheet = this->input().weigh_in;
        return sheet && sheet->is_moved();
    }
    /// Which of the weights are doubted: by them no part is moved.
    virtual QString weighAgain() const = 0;
    /// Which sets to move; nothing where no column counts, or weights are doubted.
    virtual std::optional<matching_text::Shown> matchingShown() const = 0;
    QString assignmentText() const {
        const QString again = weighAgain();
        return again.isEmpty() ? ofMatching(matching_text::summary) : again;
    }
    QStringList assignmentRemarks() const { return ofMatching(matching_text::remarks); }
    Results assignmentResults() const { return ofMatching(matching_text::assignment); }
    /// What the placing makes of spread, force and couple.
    Results effectResults() const { return ofMatching(matching_text::effects); }

    /// Its place in the journal.
    JobDesk* desk() { return &desk_; }
    QString jobName() const override {
        const JournalJob job = JobDesk::entryOf(this->input().job);
        return !job.engineNumber.isEmpty()       ? job.engineNumber
               : !job.crankshaftNumber.isEmpty() ? job.crankshaftNumber
                                                 : job.customer;
    }

    // In workshop_model_json.h.
    Json resultJson() const override;
    Json placeJson() const override;
    void takePlace(const Json& place) override;
    CaseFile asNew(const CaseFile& file) const override;

  protected:
    /// @param journalPath  the journal's file; empty: none is kept (pictures, tests)
    WorkshopModel(const QString& journalPath, QObject* parent)
        : CaseModel<Scene>({.dated = !journalPath.isEmpty()}, parent),
          desk_(this, journalPath,
                {[this] { return journalEntry(); },
                 [this](const CaseFile& file, bool isCopy) { takeJob(file, isCopy); },
                 [this] { return hasNumbers(); }, [this] { return answerLacks(); },
                 [this](const CaseFile& file) { return isEngineOf(file); }}) {}

    void aboutToLoad() override {
        desk_.forgetJob();
        isLoading_ = true;
    }
    void taken() override {
        if (isLoading_) {
            isLoading_ = false;
            bobWeightAsLoaded_ = bobWeight();
        }
    }
    /// The sheet of the next job, done by who did the one before.
    void beginJob(Input next) {
        next.job.technician = this->input().job.technician;
        desk_.beginJob([&] {
            this->setTitle({});
            // Undo must not bring another job's values under this job's number.
            this->restart(next);
        });
    }
    /// A job of the journal comes onto the sheet.
    virtual void takeJob(const CaseFile& file, bool isCopy);

  private:
    template <typename Said>
    Said ofMatching(Said (*say)(const Words&, const matching_text::Shown&)) const {
        const auto shown = matchingShown();
        return shown ? say(Words(), *shown) : Said();
    }

    // What the desk asks for, as JobDesk::Scene.
    virtual JournalJob journalEntry() const = 0;
    virtual bool hasNumbers() const = 0;
    virtual QString answerLacks() const = 0;
    /// Whether the sheet's engine is that of a job in all but its name; false where its values name
    /// it.
    virtual bool isEngineOf(const CaseFile& /*job*/) const { return false; }
    /// What hangs on the crankshaft while it is read; nothing where it is not known.
    virtual std::optional<double> bobWeight() const = 0;
    /// Readings that do not say with which bob weight they were taken get this one.
    virtual void noteBobWeight(Input& input, double bobWeight) const = 0;
    /// The card has become that of another crankshaft: whose the readings are is noted with them.
    /// @param before  the editing
    virtual void noteShaft(Input& input, const Input& before) const = 0;
    /// Those of the machine are of one shaft.
    virtual void forgetReadings(Input& input) const = 0;
    /// What the job of another engine of the kind keeps: nothing that was weighed or read.
    virtual Input nextOf(const Input& before) const = 0;

    bool isLoading_ = false;
    /// Of readings that do not say it: that of the case as it came.
    std::optional<double> bobWeightAsLoaded_;
    Input beforeEditing_;  ///< of a field; else before the last change
    JobDesk desk_;
};

}  // namespace ravnoves

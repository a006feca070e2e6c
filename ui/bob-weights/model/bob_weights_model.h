#pragma once

#include <QStringList>
#include <QVector>

#include "bob-weights/input.h"
#include "bob-weights/model/bob_parts.h"
#include "bob-weights/solver.h"
#include "text/result_row.h"
#include "workshop/model/weigh_in_table.h"
#include "workshop/model/workshop_model.h"

namespace ravnoves {

class InputError;

/// What CaseModel knows of the scene.
struct BobWeightsScene {
    using Input = bob_weights::Input;
    using Solved = bob_weights::Result;
    Input defaultInput() const;
    void startJob(Input& input) const;
    static QString defaultTitle() { return {}; }
    /// The title is the engine's; its job and weights are another thing.
    static bool isSameEngine(const Input& a, const Input& b) { return a.engine == b.engine; }
    static Input read(const Json& input, const CaseContext& context);
    static Json write(const Input& input);
    /// Refuses nothing: what is missing or broken is named by the model.
    /// Where engine or factor contradict themselves there is no answer.
    static Solved solve(const Input& input);
    static Json solvedJson(const Json& input, const CaseContext& context);

    bool dated;
};

/// The state of the page of bob weights. The sheet may be half filled: what is missing is named,
/// what can be computed is computed.
class BobWeightsModel : public WorkshopModel<BobWeightsScene> {
    Q_OBJECT

  public:
    /// @param journalPath  the journal's file; empty: none is kept (pictures, tests)
    explicit BobWeightsModel(const QString& journalPath, QObject* parent = nullptr);

    QString sceneName() const override { return QStringLiteral("bob-weights"); }
    std::span<const PagePart> parts() const override { return bobParts(); }
    Content part(std::string_view id) const override { return bobPart(*this, id); }
    std::unique_ptr<SceneModel> another(bool /*runsJobs*/) const override {
        return std::make_unique<BobWeightsModel>(QString());
    }
    std::vector<std::string> replacedInputs() const override;
    bool setViewOption(const QString& key, const QString& value) override;

    QString edit(const QString& name, const std::function<void(bob_weights::Input&)>& mutate,
                 const QString& title = {});
    QString editField(const std::string& pointer, const FieldValue& value,
                      const QString& name) override;

    // --------------------------------------------------------------------- beyond single fields
    /// Chooses the type, with as many rods on a bob weight as are usual for it.
    QString chooseType(int type);
    /// Changes the correction; it comes into being with the first value and goes with the last.
    QString editCorrection(const QString& name,
                           const std::function<void(bob_weights::Correction&)>& mutate);
    /// The same for the slug alone.
    QString editSlug(const QString& name, const std::function<void(bob_weights::Slug&)>& mutate);
    QString editTolerance(const QString& name,
                          const std::function<void(bob_weights::Tolerance&)>& mutate);
    /// Changes the weights, as many as the engine has cylinders; without any there is no sheet.
    QString editWeights(const QString& name,
                        const std::function<void(bob_weights::WeighIn&)>& mutate);
    /// Number of the run that is corrected: 0 before drilling.
    std::size_t newestRun() const;
    /// True where both of its readings are whole: a further run may follow.
    bool isRunRead() const;
    /// A reading of the machine, SI.
    std::optional<double> reading(std::size_t run, std::size_t plane, bool isAngle) const;
    /// The first of the run after the newest makes that the newest; without any it is none.
    QString editReading(const QString& name, std::size_t run, std::size_t plane, bool isAngle,
                        std::optional<double> value);
    /// The newest readings that do not hold are said to hold for the crankshaft and the bob weight
    /// that there are now, and with them what was read together with them.
    void confirmReadings();
    /// What is wrong with them; empty where all hold.
    QString otherRunText() const;
    /// What is wrong with readings of another bob weight; empty where nothing.
    QString otherReadingsText() const;
    WeighedColumn columnNote(shop::Part part) const;
    /// Each crankpin's own bob weight.
    QString weighInText() const;
    QString weighAgain() const override;
    std::optional<matching_text::Shown> matchingShown() const override;
    Results takeOffResults() const;
    /// The weights change places as the placing says.
    void moveParts();
    /// The weights go back to where they were weighed.
    void moveBack();
    bool canMoveBack() const override;

    // -------------------------------------------------------------------- what the page shows
    QString headline() const;  ///< the bob weight; why where it is not known
    QString hangText() const;  ///< on what it is hung
    QString factorText() const;
    QString reasonText() const;
    QString limitText() const;
    QString verdictText() const;
    QString holeNote() const;
    /// Masses that look like kilograms or are unlike the others: the answer is not to be trusted.
    QStringList doubts() const;
    /// Rules broken and what falls short, a sentence each.
    QStringList troubles() const;
    /// True where all planes are within their limits, or no limit is given and all is taken off.
    bool isDone() const;

    Results lineResults() const;
    Results runResults() const;  ///< nothing where there is but one run
    /// A row for each quantity, a column for each plane.
    Results planeResults() const;
    Results holeResults() const;
    /// What was drilled after earlier runs.
    Results drilledResults() const;
    QString drilledNote() const;

    // ------------------------------------------------------------------------------- journal
    /// Empties the sheet for the next job; engine, factor, planes, drills and limits stay.
    void newJob();
    /// What newJob() keeps.
    static QString carriedOver() { return tr("Kept: engine, factor, planes, drills and limits."); }

  Q_SIGNALS:
    /// Which sheet of the form to show: job, parts, weigh-in, machine, drills.
    void sheetChosen(int sheet);

  private:
    QString shownError(const InputError& error) const;
    /// Why there are not so many cylinders with two rods on a pin; empty where there may be.
    static QString oddRods(const bob_weights::Engine& engine);

    JournalJob journalEntry() const override;
    bool hasNumbers() const override;
    /// With planes the crankshaft is to be read, too.
    QString answerLacks() const override;
    std::optional<double> bobWeight() const override { return solution().bob_weight; }
    void noteBobWeight(bob_weights::Input& input, double bobWeight) const override;
    void noteShaft(bob_weights::Input& input, const bob_weights::Input& before) const override;
    bob_weights::Input nextOf(const bob_weights::Input& before) const override;
    /// Where it reads stays.
    void forgetReadings(bob_weights::Input& input) const override;
};

extern template class CaseModel<BobWeightsScene>;
extern template class WorkshopModel<BobWeightsScene>;

}  // namespace ravnoves

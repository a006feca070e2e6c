#pragma once

#include <QList>
#include <QStringList>
#include <array>
#include <optional>

#include "model/case_model.h"
#include "shop/model/words.h"
#include "text/result_row.h"
#include "workshop/input.h"
#include "workshop/model/job_desk.h"
#include "workshop/model/workshop_parts.h"
#include "workshop/result.h"

namespace ravnoves {

class InputError;

/// The lines below a column of the weigh-in sheet; dashes where nothing is weighed.
struct WeighedColumn {
    /// The mean, its deviation from nominal with its sign, the range.
    std::array<QString, 3> texts{QStringLiteral("–"), QStringLiteral("–"), QStringLiteral("–")};
    bool tooWide = false;
    bool counts = true;  ///< or nothing is weighed
    QString toolTip;
};

/// What CaseModel knows of the scene.
struct WorkshopScene {
    using Input = workshop::Input;
    struct Solved {
        workshop::Result found;    ///< all results, with the doubtful ones
        workshop::Result allowed;  ///< what may be shown as an answer
        Verdict verdict;
        std::optional<shop::WeighIn> sheet;  ///< with a line for each cylinder
        /// Parts to weigh again, by their cylinders; no part: the whole rod. Until then none is
        /// moved.
        std::vector<std::pair<std::optional<shop::Part>, std::size_t>> unlikely;
    };
    Input defaultInput() const;
    /// Fills in what a new job has beside its engine.
    void startJob(Input& input) const;
    /// Gives the plugs of a new job the shop's own limit.
    void startPlugs(v8_plugs::Input& plugs) const;
    static QString defaultTitle() { return {}; }
    /// The title is the engine's; its job and weights are another thing.
    static bool isSameEngine(const Input& input, const Input& named);
    /// The plan that was printed or put aside stays where a step of the same run is undone.
    static void keepBeside(Input& undone, const Input& present);
    static Input read(const Json& input, const CaseContext& context);
    static Json write(const Input& input);
    /// Rejects nothing: the model names missing and wrong values.
    static Solved solve(const Input& input);

    bool dated;  ///< a new job is of today, and has what the shop keeps
};

/// The state of the page Workshop: one job from the scale to the drilled crankshaft. The sheet may
/// be half filled: missing values are named, everything else is computed.
class WorkshopModel : public CaseModel<WorkshopScene> {
    Q_OBJECT

  public:
    using Input = workshop::Input;

    /// @param journalPath  the journal's file; empty: none is kept (pictures, tests)
    explicit WorkshopModel(const QString& journalPath, QObject* parent = nullptr);

    QString sceneName() const override { return QStringLiteral("workshop"); }
    std::span<const PagePart> parts() const override { return workshopParts(); }
    Content part(std::string_view id) const override { return workshopPart(*this, id); }
    std::unique_ptr<SceneModel> another(bool /*runsJobs*/) const override {
        return std::make_unique<WorkshopModel>(QString());
    }
    Json resultJson() const override;
    Json placeJson() const override;
    void takePlace(const Json& place) override;
    CaseFile asNew(const CaseFile& file) const override;
    std::optional<Verdict> verdictShown() const override { return solved().verdict; }
    std::vector<const char*> designInputs() const override {
        return {"/job/engine_number", "/job/customer", "/job/date"};
    }
    std::vector<std::string> replacedInputs() const override;
    bool setViewOption(const QString& key, const QString& value) override;
    QString jobName() const override;

    /// Of the crankshaft, as far as no doubt blocks it.
    const bob_weights::Result& solution() const { return solved().allowed.shaft; }
    /// Of the plugs, likewise; null without plugs.
    const v8_plugs::Result* plugs() const {
        return solved().allowed.plugs ? &*solved().allowed.plugs : nullptr;
    }
    /// The plugs with weigh-in, limits and readings of the job; null without plugs.
    const v8_plugs::Input* plugsInput() const {
        return solved().found.plugs_input ? &*solved().found.plugs_input : nullptr;
    }
    const std::vector<workshop::Doubt>& doubts() const { return solved().found.doubts; }
    workshop::Withheld withheld() const { return solved().found.withheld(); }
    /// Parts not weighed yet count as nominal.
    bool isProvisional() const { return solved().found.is_provisional(); }
    JobDesk* desk() { return &desk_; }
    /// Entries that the form rejects now and that results depend on.
    /// @param places  pointers of the values before them that may be left out; nothing is saved
    ///                beside others
    void setRejected(const QStringList& rejected, const std::vector<std::string>& places = {});
    /// The answer is of the values before them.
    bool isOutdated() const override { return !rejected_.isEmpty() && hasAnswer(); }
    bool leavesOutRejected() const override { return true; }
    void leaveOutRejected() override;
    void leaveOutRejected(Json& input) const override;
    QString mustBeCorrected() const override;
    QString stopText() const override;
    /// The job without an answer, as a doubt would stop it: nothing can be set or drilled by the
    /// values before rejected entries. These values are left out.
    std::unique_ptr<WorkshopModel> stoppedBy(const QString& why) const;
    /// What page and clipboard show of the correction: this job, or while it is outdated the
    /// stopped one.
    const WorkshopModel& shown() const;

    // ------------------------------------------------------------------------------- changes
    QString edit(const QString& name, const std::function<void(Input&)>& mutate,
                 const QString& title = {});
    QString editField(const std::string& pointer, const FieldValue& value,
                      const QString& name) override;
    /// Chooses the type, with as many rods on a bob weight as are usual for it.
    QString chooseType(int type);
    /// Changes the correction; it begins with the first value and ends with the last.
    QString editCorrection(const QString& name,
                           const std::function<void(bob_weights::Correction&)>& mutate);
    QString editTolerance(const QString& name,
                          const std::function<void(bob_weights::Tolerance&)>& mutate);
    /// Changes the weights, one for each cylinder of the engine; without any there is no sheet.
    /// Weights of plugs are used from the first on, until the user chooses otherwise.
    QString editWeights(const QString& name,
                        const std::function<void(bob_weights::WeighIn&)>& mutate);
    void swapRodEnds();

    // Runs of the machine.
    std::size_t newestRun() const;  ///< that is corrected: 0 before drilling
    /// What follows from a run; null while nothing does.
    const bob_weights::RunResult* runResult(std::size_t run) const;
    /// True where both of its readings are whole.
    bool isRunRead() const;
    bool isPlanned() const;
    /// Empty without one.
    bob_weights::Reading reading(std::size_t run, std::size_t plane) const;
    /// Where the readings of a plane are in the case, as a pointer to what follows it.
    std::string readingPlace(std::size_t run, std::size_t plane) const;
    /// The first reading of the run after the newest makes that the newest; without any there is no
    /// run.
    QString editReading(const QString& name, std::size_t run, std::size_t plane, bool isAngle,
                        std::optional<double> value);
    /// Declares the newest invalid readings valid for the present crankshaft and bob weight, and
    /// with them those read together with them.
    void confirmReadings();
    /// The shop has the present plan on paper or in the journal: its holes are recorded as drilled,
    /// whatever is entered before the next run.
    void keepPlan();
    /// Nothing was drilled by the plan that was kept.
    void usePresentPlan();
    /// Why they are invalid; empty while all are valid.
    QString otherRunText() const;

    /// The default of new jobs.
    void keepMachine();
    bool isShopsMachine() const;

    // --------------------------------------------------------------------------------- plugs
    bool hasPlugs() const { return input().plugs.has_value(); }
    bool mayHavePlugs() const { return workshop::may_have_plugs(input().engine); }
    /// Whether the crankshaft has sludge-trap plugs. Values that the other form lacks return with
    /// it.
    void setHasPlugs(bool there);
    QString editPlugs(const QString& name, const std::function<void(v8_plugs::Input&)>& mutate);
    QStringList engineNames() const;
    /// Takes an engine over by its place in engineNames().
    void chooseEngine(int index);
    /// Place of the present engine in engineNames(); -1 for one of another name.
    int engineIndex() const;
    /// Of an engine that is no preset.
    QString ownEngineName() const;
    /// It is no preset then, and has the name.
    void nameEngine(const QString& name);
    /// Where the engine's values come from, and what the user should know of them.
    QString engineNote() const;
    /// Says whether the engine has the plugs of the group; those that come are the preset's.
    void setPlugs(const QString& name, v8_plugs::EngineGroup group, bool present);
    /// Takes the nominal masses for the bob weight from the nominal parts of the weigh-in sheet.
    void fillNominalMasses();
    /// False where there are no such parts, or the masses are theirs.
    bool canFillNominalMasses() const;
    void keepTolerance();
    bool isShopsTolerance() const;

    // ----------------------------------------------------------------------------- the parts
    // The sheet as cells: a column for each kind of part, a row for each cylinder; above them rows
    // for the nominal mass and for the permitted spread. A cell is a mass in kg, or nothing.
    static constexpr int firstCylinder = 2;  ///< its row
    int weightRows() const { return firstCylinder + input().engine.cylinders; }
    static const Field& weightField(int row);
    std::optional<double> weight(int row, int column) const;
    void setWeight(const QString& name, int row, int column, std::optional<double> mass);
    /// Writes a block of cells, as a spreadsheet does, in one step; a cell without text keeps its
    /// value, and one rejected cell rejects the block.
    /// @return an empty string, or the fault
    QString pasteWeights(int row, int column, const std::vector<QStringList>& cells);
    WeighedColumn columnNote(shop::Part part) const;
    void moveParts();
    void moveBack();
    /// Parts are elsewhere than they were weighed, and it is known where that was.
    bool canMoveBack() const;

    // ---------------------------------- texts in the language of the page, or of the card "V-8,
    // 90°", "4 in line", "Boxer, 6".
    static QString engineName(const Words& words, const bob_weights::Engine& engine);
    /// As the machine is set up to call it.
    QString planeName(std::size_t plane, const Words& words = {}) const;
    /// What the angles of the readings are of.
    QString spotName(const Words& words) const;
    /// "Before", "Run 1".
    static QString runName(const Words& words, std::size_t run);
    QString machineText(const Words& words = {}) const;

    /// The bob weight; where unknown, the reason or the missing values.
    QString headline(const Words& words = {}) const;
    /// The withheld result, to be seen and not to be used; empty without one.
    QString doubtfulText() const;
    QString hangText(const Words& words = {}) const;  ///< where it is hung
    QString factorText(const Words& words = {}) const;
    /// What may remain, and where that comes from.
    QString limitText(const Words& words = {}) const;
    /// The lines of the bob weight, their subtotals and sum: printed numbers add up.
    Results lineResults(const Words& words = {}) const;

    /// Values typed or weighed, but not used (yet).
    QStringList notCounted(const Words& words = {}) const;
    QString rejectedText() const;
    /// Faults and notes beside the verdict, a sentence each.
    /// @param withDoubts  and what the verdict says of doubts
    QStringList troubles(const Words& words = {}, bool withDoubts = false) const;

    /// Whether the crankpins differ, so that the bob weight is only their mean.
    bool isMean() const;
    /// Which cylinders each crankpin carries, "1+5"; empty where they do not share out.
    QStringList cylindersOfCrankpins() const;
    /// Each crankpin's own bob weight.
    QString weighInText(const Words& words = {}) const;
    /// The same after the sets are moved; empty where none is to be.
    QString placedText(const Words& words) const;
    /// "Weigh again first: piston of cylinder 3; rod of cylinder 5."; empty where the weights are
    /// plausible.
    QString weighAgain(const Words& words = {}) const;
    /// Which sets to move; null where no column counts, or weights are doubted.
    const shop::Matched* placing() const {
        return solution().placing ? &*solution().placing : nullptr;
    }
    QString assignmentText(const Words& words = {}) const;
    /// Why it misses the goal, unproven parts, and the assumptions.
    QStringList assignmentRemarks() const;
    /// From which cylinder each set comes; a dot where it was weighed there.
    Results assignmentResults(const Words& words = {}) const;
    /// What the placing makes of spread, force and couple.
    Results effectResults(const Words& words = {}) const;
    /// Metal to remove from each part to reach the lightest of its column, for columns that differ;
    /// by the numbers of the parts, wherever they are moved. Columns with doubtful weights are left
    /// out: no part is ground by a slip of the keys.
    Results takeOffResults(const Words& words = {}) const;

    Results planeResults(const Words& words = {}) const;
    /// @param plane  its holes alone, without its name
    Results holeResults(const Words& words = {}, std::optional<std::size_t> plane = {}) const;
    Results drilledResults(const Words& words = {}) const;
    /// A hole or slug of the record after a run: "After Run 1: ⌀ 10 mm".
    QString drilledName(std::size_t run, const bob_weights::DrilledHole& hole) const;
    QString drilledName(const Words& words, std::size_t run) const;
    Results runResults() const;  ///< nothing where there is but one run
    /// What the machine read, where that was not in the planes; empty where it was.
    QString asReadNote() const;
    /// What the depths are measured to; empty without holes.
    QString holeNote(const Words& words = {}) const;
    /// What the holes are planned for: the drill's point, the metals; empty without holes.
    QString metalsText(const Words& words) const;

    /// Whether the crankshaft passes or what to do; what that lacks where it is not known.
    QString correctionText() const;

    // Of the plugs; empty without. The instruction; the missing values where it is unknown. Where
    // the method neglects something relevant, it is a possibility.
    QString adviceText(const Words& words = {}) const;
    /// How to bore, or why it cannot be bored.
    QString boringText(const Words& words = {}) const;
    QString excessText() const;
    /// What the shift of the plug's centre of mass is worth beside the tolerance, by the paper's
    /// range and by the planned bore.
    QString shiftText(const Words& words = {}) const;
    QString checkText() const;  ///< after equals nominal
    bool isFitted(v8_plugs::OptionId id) const;
    QString toleranceText() const;
    QString plugWeightText() const;
    Results optionResults() const;

    // ------------------------------------------------------------------------------- journal
    QString verdictNow() const;
    JournalJob journalEntry() const;
    /// Adopts a job's case, as it was or to be the sheet of another one: what says whose it is, and
    /// all that was weighed and read, is new then. Nothing has changed where it throws.
    /// @throws InputError
    void takeJob(const CaseFile& file, bool isCopy);
    /// False while no weight and no reading of the job is on the sheet.
    bool hasNumbers() const;
    QString answerLacks() const;  ///< a sentence; empty where nothing is lacking
    /// Whether the sheet's engine equals a job's in all but its name.
    /// @throws InputError
    bool isEngineOf(const CaseFile& job) const;
    /// Empties the sheet for the next job of the same engine.
    void newJob();

  Q_SIGNALS:
    /// Which sheet of the form to show: job, parts, weigh-in, plugs, machine, correction.
    void sheetChosen(int sheet);
    /// The engine differs from the previous job's, and lost the values of its crankshaft.
    void crankForgotten();
    /// A recovery copy was loaded, beside which entries were not accepted.
    void broughtWithoutRejected(const QString& rejected);

  protected:
    void aboutToLoad() override;
    void taken() override;

  private:
    bool hasAnswer() const;
    std::size_t firstRun() const;
    /// That hangs on the crankpins, doubted or not.
    std::optional<double> bobWeightNow() const { return solved().found.shaft.bob_weight; }
    /// Why there are not such an engine and such plugs; empty where there may be.
    static QString engineTrouble(const Input& next);
    /// The input without the values before rejected entries.
    Input withoutRejected() const;
    static QString provisional(const Words& words, const QString& answer);
    QString readingsMissing() const;
    /// Parts were moved on a sheet of another number of cylinders, whose set numbers say nothing.
    bool isOriginUnknown() const;
    /// The values that the answer lacks: "oil in a crankpin mₘ", "oil coefficient kₘ".
    QStringList missingForPlugs(const Words& words, bool withBobWeight) const;
    /// Rules broken by engine and plug.
    QStringList plugTroubles(const Words& words) const;
    /// Whether the plugs are in the shaft while it hangs there, and what to hang in the other case.
    QString plugsWhileHung(const Words& words) const;
    QString optionTip(const v8_plugs::SolvedOption& option) const;
    void notePlugs(JournalJob& job) const;
    /// The engine with the nominal masses that follow from its nominal parts.
    v8_plugs::Engine withNominalMasses() const;

    /// What the job of another engine of the kind keeps: nothing that was weighed or read.
    Input nextOf(const Input& before) const;

    bool isLoading_ = false;
    /// For readings without one: the case's as loaded.
    std::optional<double> bobWeightAsLoaded_;
    Input beforeEditing_;             ///< of a field; else before the last change
    std::optional<Input> otherForm_;  ///< the state before plugs were added or removed
    std::optional<Input> carried_;    ///< what the job began with of the job before
    QStringList rejected_;
    std::vector<std::string> rejectedAt_;
    mutable std::unique_ptr<WorkshopModel> stopped_;  ///< shown() by those
    mutable int stoppedAt_ = 0;                       ///< solutions() then
    JobDesk desk_;
};

extern template class CaseModel<WorkshopScene>;

}  // namespace ravnoves

#pragma once

#include <QList>
#include <QStringList>
#include <QVector>
#include <map>

#include "text/result_row.h"
#include "v8-plugs/input.h"
#include "v8-plugs/model/plugs_parts.h"
#include "v8-plugs/solver.h"
#include "workshop/model/weigh_in_table.h"
#include "workshop/model/words.h"
#include "workshop/model/workshop_model.h"

namespace ravnoves {

/// What CaseModel knows of the scene.
struct V8PlugsScene {
    using Input = v8_plugs::Input;
    using Solved = v8_plugs::Result;
    Input defaultInput() const;
    void startJob(Input& input) const;
    static QString defaultTitle() { return {}; }
    /// Its job is another thing, and what the preset does not know may be filled in.
    static bool isSameEngine(const Input& input, const Input& named);
    static Input read(const Json& input, const CaseContext& context);
    static Json write(const Input& input);
    /// Refuses nothing: what is missing or broken is named in the solution.
    static Solved solve(const Input& input);
    static Json solvedJson(const Json& input, const CaseContext& context);

    bool dated;
};

/// The state of the V-8 workshop page.
///
/// The sheet may be half filled: what is missing stays empty and is named, what can be computed is
/// computed. A change that breaks a rule between fields (more off a plug than it weighs, a bore
/// wider than the thread) is taken over and named in troubles().
class V8PlugsModel : public WorkshopModel<V8PlugsScene> {
    Q_OBJECT

  public:
    /// @param journalPath  the journal's file; empty: none is kept (pictures, tests)
    explicit V8PlugsModel(const QString& journalPath, QObject* parent = nullptr);

    QString sceneName() const override { return QStringLiteral("v8-plugs"); }
    std::span<const PagePart> parts() const override { return plugsParts(); }
    Content part(std::string_view id) const override { return plugsPart(*this, id); }
    std::unique_ptr<SceneModel> another(bool /*runsJobs*/) const override {
        return std::make_unique<V8PlugsModel>(QString());
    }
    std::vector<std::string> replacedInputs() const override;
    bool setViewOption(const QString& key, const QString& value) override;

    QString editField(const std::string& pointer, const FieldValue& value,
                      const QString& name) override;

    /// Changes the weights. They count from the first on, until the user says otherwise; where none
    /// is left, what was typed counts again.
    QString editWeights(const QString& name, const std::function<void(v8_plugs::WeighIn&)>& mutate);

    // ------------------------------------------------------------------------------- engines
    /// Reads the user's own engines again: another program may have kept one.
    void reloadEngines();
    /// Presets of the paper, then the user's own.
    QStringList engineNames() const;
    /// Takes an engine over by its place in engineNames().
    void chooseEngine(int index);
    /// Place of the present engine in engineNames(); -1 where it is neither.
    int engineIndex() const;
    /// True where the user keeps an engine of that name, whatever its capitals.
    bool hasOwnEngine(const QString& name) const;
    /// Keeps the present engine under the name among the user's own, in place of one that has it.
    /// @return an empty string, or what went wrong
    QString saveEngineAs(const QString& name);
    /// The same return.
    QString renameEngine(const QString& from, const QString& to);
    QString removeEngine(const QString& name);
    bool isOwnEngine(int index) const;
    /// True where the sheet's values are not those kept under the engine's name.
    bool ownEngineChanged() const;
    /// Where the engine's values come from, and what the user should know of them.
    QString engineNote() const;
    /// Says whether the engine has the plugs of the group. The values of those that come back are
    /// what stood there, else what the engine's own data have.
    void setPlugs(const QString& name, v8_plugs::EngineGroup group, bool present);
    /// Takes the nominal masses for the bob weight from the nominal parts of the weigh-in sheet.
    void fillNominalMasses();
    /// False where there are no such parts, or the masses are theirs.
    bool canFillNominalMasses() const;
    /// Makes the tolerance the one that new jobs begin with.
    void keepTolerance();
    bool isShopsTolerance() const;
    /// What came from the job before and is still as it was: "engine, plug sizes". Empty: nothing.
    QString carriedOver() const;

    // -------------------------------------------------------------------- what the page shows
    QString adviceText() const;  ///< what to do; what is missing where that is not known
    QString boringText() const;
    QStringList troubles() const;  ///< rules broken, masses that do not fit, spreads too wide
    QString excessText() const;
    QString shiftText() const;
    QString checkText() const;  ///< after equals nominal
    QString hangText() const;   ///< bob weight to 0.1 g
    QString plugsText() const;  ///< where the plugs are while it hangs there
    QString rodFactorText() const;
    QString toleranceText() const;  ///< whose it is
    QString machineLimitsText() const;
    QString missingText() const;
    QString isoText() const;
    QString plugWeightText() const;
    /// What was typed or weighed, but does not count (yet).
    QStringList notCounted() const;

    Results optionResults() const;
    /// The table of the options has room for the fewest words alone.
    void setShortNames(bool areShort);
    Results bobWeightResults() const;
    Results planeResults() const;
    QString weighAgain() const override;
    std::optional<matching_text::Shown> matchingShown() const override;
    Results takeOffResults() const;
    void moveParts();
    /// The weights go back to where they were weighed.
    void moveBack();
    /// The readings hold for the bob weight that there is now.
    void confirmReadings();
    /// What is wrong with readings of another bob weight; empty where nothing.
    QString otherReadingsText() const;
    Results crankpinResults() const;
    /// Mean, spread and warning of one column of the weigh-in sheet.
    WeighedColumn columnNote(v8_plugs::Part part) const;

    // ------------------------------------------------------------------------------- journal
    /// Empties the sheet for the next job; the engine stays.
    void newJob();

  Q_SIGNALS:
    void enginesChanged();
    /// Which sheet of the form to show: job, engine, weigh-in, plug, machine.
    void sheetChosen(int sheet);

  private:
    void aboutToLoad() override {
        carried_.reset();
        plugsBefore_.clear();
        WorkshopModel::aboutToLoad();
    }
    void takeJob(const CaseFile& file, bool isCopy) override;
    /// It is for the crankshaft that there is.
    bool isFitted(v8_plugs::OptionId id) const;
    QString optionTip(const v8_plugs::Option& option) const;
    /// What the paper prints, or the user keeps, of the present engine; nothing where neither does.
    std::optional<v8_plugs::Engine> keptEngine() const;
    QString engineNameTrouble(const QString& name) const;

    JournalJob journalEntry() const override;
    bool hasNumbers() const override;
    bool isEngineOf(const CaseFile& job) const override;
    QString answerLacks() const override { return solution().advice ? QString() : adviceText(); }
    std::optional<double> bobWeight() const override { return solution().hung(); }
    void noteBobWeight(v8_plugs::Input& input, double bobWeight) const override;
    void noteShaft(v8_plugs::Input& input, const v8_plugs::Input& before) const override;
    void forgetReadings(v8_plugs::Input& input) const override;
    v8_plugs::Input nextOf(const v8_plugs::Input& before) const override;

    Words words_;
    bool areNamesShort_ = false;
    QList<JournalEngine> ownEngines_;
    std::optional<v8_plugs::Input> carried_;                        ///< what a new job began with
    std::map<v8_plugs::EngineGroup, v8_plugs::Input> plugsBefore_;  ///< those taken out
};

extern template class CaseModel<V8PlugsScene>;
extern template class WorkshopModel<V8PlugsScene>;

}  // namespace ravnoves

#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case-file/case_context.h"
#include "case-file/field_index.h"
#include "case-file/json_fwd.h"
#include "model/part.h"
#include "model/variants.h"

namespace ravnoves {

struct CaseFile;
class InputError;
class ReferenceCase;

/// An input that is swept over its range, and the result over it.
struct SweepChoice {
    std::string input, result;                 ///< pointers
    std::optional<double> from = {}, to = {};  ///< in the unit of the input's key
};

/// The state of one page without any widget: its input, its results, its history.
///
/// Widgets bind to a model and never keep a value of their own; so a page is tested without a
/// window, and the command line and the page cannot disagree.
class SceneModel : public QObject {
    Q_OBJECT

  public:
    explicit SceneModel(QObject* parent = nullptr);
    /// A destroyed history signals that it is clean. Its listeners, first the model of the scene,
    /// are destroyed or half destroyed by then.
    ~SceneModel() override { history_.blockSignals(true); }

    /// The scene's word in case files.
    virtual QString sceneName() const = 0;
    /// In the window, of a scene that has a case file.
    static QString titleOf(const std::string& scene);
    QString sceneTitle() const { return titleOf(sceneName().toStdString()); }
    /// False for a page whose state is no case: there is no file.
    virtual bool hasCaseFile() const { return true; }
    /// The case's present "input" object.
    virtual Json inputJson() const = 0;
    /// Unused parts of the input, for the case to keep; null without any.
    virtual Json keptJson() const;
    /// The place of the case beside its file, a job in the journal, for the recovery copy; null:
    /// none.
    virtual Json placeJson() const;
    /// The case is back at its place: a recovery copy was loaded.
    virtual void takePlace(const Json& /*place*/) {}
    /// The present case: scene, title, notes, input and kept parts.
    CaseFile caseFile() const;
    /// Writes defaults into the model's input for numbers at these pointers below "input", so that
    /// they can be varied. Given values are kept, and numbers without a default are not added.
    void giveDefaults(Json& input, const std::vector<std::string>& pointers) const;
    /// Adopts these parts of a case as one step of the history. A fault leaves all unchanged.
    /// @param isNamed  the title is a preset's or an example's, and follows the engine; else it is
    ///                 the user's
    /// @throws InputError
    virtual void loadFile(const CaseFile& file, const CaseContext& context,
                          bool isNamed = false) = 0;
    /// The case as a new one begins with it.
    virtual CaseFile asNew(const CaseFile& file) const;
    void loadCase(const Json& input, const CaseContext& context, const QString& title);
    /// Another input under the present title and notes.
    /// @param name  of the step
    virtual void loadInput(const Json& input, const CaseContext& context,
                           const QString& name = openName());
    /// What the page shows, in its order, the first the most important.
    virtual std::span<const PagePart> parts() const { return {}; }
    /// Makes one of them from the present input and the view options.
    virtual Content part(std::string_view /*id*/) const { return {}; }
    /// Begins what takes longer than a frame of a part, where someone looks; shownChanged()
    /// follows.
    virtual void needPart(std::string_view /*id*/) {}
    /// The same of all.
    void needParts();
    /// A new model of the same scene.
    /// @param runsJobs  it computes in the background what takes long, as this one does
    virtual std::unique_ptr<SceneModel> another(bool /*runsJobs*/) const { return nullptr; }
    /// Another input in place of the present one, without a step of the history: for a model of the
    /// caller's own, in any thread.
    /// @throws InputError
    virtual void showInput(const Json& /*input*/) {}
    /// The verdict; empty where the scene has none.
    virtual std::optional<Verdict> verdictShown() const { return std::nullopt; }
    /// Results are of the values before rejected entries.
    virtual bool isOutdated() const { return hasRejected(); }
    /// Whether nothing may be done by the values before them: a saved case does not have them.
    virtual bool leavesOutRejected() const { return false; }
    /// Removes them then, as a step of the history.
    virtual void leaveOutRejected() {}
    /// The same in a copy of the input.
    virtual void leaveOutRejected(Json& /*input*/) const {}
    /// Names those that cannot be left out: nothing can be saved before they are corrected.
    virtual QString mustBeCorrected() const { return {}; }
    /// Why nothing may be done by the answer, as the first line of a copy; empty where it may.
    virtual QString stopText() const { return {}; }
    /// The variant that the case is seen against.
    ReferenceCase& referenceCase();
    /// The "result" object, the same that the command line prints.
    virtual Json resultJson() const = 0;
    /// The fields of the input with their present values, for forms; all that a case may have, or
    /// what this one has; or the one of these with a pointer.
    virtual std::vector<FieldEntry> describedFields(std::string_view /*only*/ = {}) const {
        return {};
    }
    virtual std::vector<FieldEntry> fields(std::string_view /*only*/ = {}) const { return {}; }
    /// Pointers of the typed values that do not count, since others are in their place.
    virtual std::vector<std::string> replacedInputs() const { return {}; }
    /// Pointers of the objects with usual values where the case does not have them.
    virtual std::vector<std::string> usualObjects() const { return {}; }
    /// The name of the layout, where the scene has several; else empty.
    virtual QString layoutText() const { return {}; }
    /// Pointers of the inputs that say which design it is, beside its layout.
    virtual std::vector<const char*> designInputs() const { return {}; }
    /// The description of a field that the scene has.
    FieldEntry describedField(std::string_view pointer) const;
    /// Why an input is rejected, the places by their labels.
    QString explain(const InputError& error) const;
    /// Sets one field by its pointer below "input", as one step of the history that is named after
    /// it. Returns as CaseModel::edit().
    virtual QString editField(const std::string& /*pointer*/, const FieldValue& /*value*/,
                              const QString& /*name*/) {
        return {};
    }
    /// The same at every move of a hand, as CaseModel::drag().
    virtual QString dragField(const std::string& /*pointer*/, const FieldValue& /*value*/,
                              const QString& /*name*/) {
        return {};
    }

    /// A setting of the page that is not in the case file (crank angle of the picture and so on).
    /// @return false where the page has no such setting
    virtual bool setViewOption(const QString& key, const QString& value);

    /// Shows what another model of the scene shows beside its input.
    virtual void takeView(const SceneModel& /*other*/) {}

    /// Sets one value by its key or path in the case file ("shaft_angle_deg",
    /// "spring/stiffness_N_m"), else a view option. The text is JSON or a bare word.
    /// @throws InputError
    void setByKey(const QString& key, const QString& value);

    static QString openName() { return tr("Open case"); }
    QString title() const { return texts_.title; }
    /// A title as the user reads it.
    static QString titleText(const QString& title);
    QString titleShown() const { return titleText(texts_.title); }
    /// What a case without a file is known by before its title: the number of a job's engine.
    virtual QString jobName() const { return {}; }
    void setTitle(const QString& title);
    QString notes() const { return texts_.notes; }
    /// Title and notes as the user wants them, as one step of the history.
    void editText(const QString& title, const QString& notes);
    const CaseContext& context() const { return context_; }

    // Variants: inputs that are kept beside the present one. A change is one step of the history, a
    // choice of the one shown is no step.
    const QList<Variant>& variants() const { return texts_.variants.list; }
    /// Place of the variant that the present input is seen against; −1: none.
    int reference() const { return texts_.variants.reference; }
    void chooseReference(int place);
    /// Keeps the present input and makes it the reference. A name that is empty or taken gives way
    /// to the next letter.
    void keepVariant(const QString& name = {});
    void removeVariant(int place);
    // These return an empty string, or why it cannot be done.
    QString renameVariant(int place, const QString& name);
    /// The variant's input becomes the present one.
    virtual QString takeVariant(int /*place*/) { return {}; }
    /// The variant's input as the model would write it; a rejected one unchanged.
    virtual Json variantInput(int place) const;
    /// Which files a variant is of that have changed since it was kept, as a sentence; empty where
    /// none has.
    QString changedFilesText(int variant) const;

    /// The scattered inputs and the watched results: "study" of the case file as JSON text; empty
    /// without one. It may be rejected.
    const std::string& study() const { return texts_.study; }
    /// Another study, as one step of the history.
    void changeStudy(const QString& name, const std::string& study);

    /// What the user sweeps, as long as the case is open: the file has no place for it.
    const SweepChoice& sweepChoice() const { return sweepChoice_; }
    void setSweepChoice(const SweepChoice& choice) { sweepChoice_ = choice; }

    /// A widget reports whether it has a rejected text now. That is in no history, and newer than
    /// every step: undo takes it back first, wherever it is.
    void noteRejected(QObject* where, bool isRejected);
    bool hasRejected() const { return !rejectedIn_.isEmpty(); }
    const QList<QObject*>& rejectedIn() const { return rejectedIn_; }

    QUndoStack* history() { return &history_; }
    const QUndoStack* history() const { return &history_; }
    /// The next change is a step of its own in the history, whatever its name.
    void finishDrag() {
        ++step_;
        lastName_.clear();
        rest();
    }
    /// True from a step of a drag to rest() or finishDrag(): what would jump to and fro rests.
    bool isMoved() const { return moved_; }
    /// The hand rests; the drag may continue: a next step of the drag is still one with those
    /// before.
    void rest() {
        if (std::exchange(moved_, false)) {
            Q_EMIT rested();
        }
    }

    // An editing of a field, from its first key to Enter, Escape or the loss of the focus: typing
    // takes effect at once, and all of it is one step of the history.
    void beginEditing();
    /// @param isRejected  the typed text is still there, rejected, and so is the reason
    void endEditing(bool isRejected = false);
    bool isEditing() const { return editing_; }
    /// True where the editing has changed the input.
    bool isTyped() const;
    /// Restores the state before the editing, without a step.
    /// @return false where it has changed nothing
    virtual bool takeBack();
    virtual void editingEnds() {}
    /// The text typed until now is saved: Escape returns to it, though the editing continues.
    /// @return why it cannot be saved; else empty
    QString keepForSaving() {
        finishDrag();
        QString why = mustBeCorrected();
        if (why.isEmpty()) {
            leaveOutRejected();
            Q_EMIT typedKept();
        }
        return why;
    }
    bool hasChanges() const { return !history_.isClean(); }
    void undo();
    void redo();

    /// Grows with each solution of an input that is another, or that is solved otherwise.
    int solutions() const { return solutions_; }

  Q_SIGNALS:
    /// Input and result are new.
    void changed();
    /// A drag has ended, or pauses: what rested meanwhile follows.
    void rested();
    /// The text typed until now is saved.
    void typedKept();
    void titleChanged(const QString& title);
    /// Changes to undo, to redo or to save.
    void historyChanged();
    /// Whether any field has a rejected entry.
    void rejectedInChanged();
    /// A change was rejected; empty when that is over.
    void rejected(const QString& why);
    /// The variants, or which of them is the reference.
    void variantsChanged();
    void studyChanged();
    /// What the pictures show beside the input.
    void viewChanged();
    /// What parts show is new, though neither input nor view is: a job has come to its end.
    void shownChanged();
    /// Another job is on the sheet: it has no file.
    void restarted();
    /// The state has changed as a whole: undone, redone, loaded, a preset, a variant. Unlike a
    /// change of one value, that ends rejected texts in all fields.
    void broughtIn();

  protected:
    void setContext(const CaseContext& context) { context_ = context; }
    void countSolution() { ++solutions_; }
    const CaseTexts& texts() const { return texts_; }
    /// Other ones; while the variants are the same, the reference is kept.
    void setTexts(const CaseTexts& next);
    /// The same as one step of the history.
    virtual void changeTexts(const QString& /*name*/, const CaseTexts& next) { setTexts(next); }
    /// Number of the step that a change of this name belongs to, for InputCommand.
    int stepOf(const QString& name);
    /// The input changes otherwise than by the editing: the next typing is a step of its own.
    void leaveEditing() { editing_ = false; }
    /// Reports why a change is rejected; an empty text: it no longer matters.
    void setRejection(const QString& why);
    // For setViewOption().
    // @throws InputError for a text that is no number
    static double readNumber(const QString& key, const QString& value);
    /// Place of the value among the words. @throws InputError that names them
    static int oneOf(const QString& key, const QString& value, const QStringList& words);
    /// Ends the title of an engine that was a preset or an example, and is not any more. In every
    /// language the same, as a file has it; titleText() says it.
    static constexpr QLatin1String changedMark{" (changed)"};

  private:
    void changeVariants(const QString& name, const Variants& variants);
    void forgetRejectedIn(QObject* where);

    CaseTexts texts_;
    SweepChoice sweepChoice_;
    int solutions_ = 0;
    int step_ = 0;
    QString lastName_;
    bool moved_ = false;
    bool editing_ = false;
    bool hasRejection_ = false;
    CaseContext context_;
    ReferenceCase* referenceCase_ = nullptr;  ///< from when it is asked for
    QList<QObject*> rejectedIn_;              ///< the newest last
    QUndoStack history_;
};

}  // namespace ravnoves

#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "case-file/input_error.h"
#include "model/background_job.h"
#include "model/enough_memory.h"
#include "model/input_command.h"
#include "model/scene_model.h"
#include "numerics/demand.h"
#include "numerics/vector_state.h"
#include "text/error_text.h"
#include "text/message_text.h"

namespace ravnoves {

/// The model of a scene whose state is a case: its input, what was solved from it, and the one way
/// in which an input changes. `Scene` says what differs from scene to scene:
///
///     using Input = …;   // copied and compared
///     using Solved = …;  // what the page shows of it
///     Input defaultInput() const;
///     QString defaultTitle() const;
///     Input read(const Json&, const CaseContext&) const;  // throws InputError
///     Json write(const Input&) const;
///     // where an input keeps what it does not use, as "kept" of the case:
///     void keep(Input&, const Json& kept, const CaseContext&) const;  // throws InputError
///     Json kept(const Input&) const;
///     // where not all of an input makes it another engine:
///     bool isSameEngine(const Input&, const Input&) const;
///     Solved solve(const Input&) const;  // throws InputError for an input that is refused
///     // where an input may be so large that the window would stand still while it is solved:
///     static std::size_t size(const Input&);        // what the time grows with, for example rows
///     static constexpr std::size_t largestAtOnce;   // the largest that is solved at once
///     static bool isLong(const Json&, const CaseContext&);  // to read
///     static void check(const Input&);              // refuses what solve() would, at once
///     void took(const Solved&) const;               // solved perhaps by a copy of the scene
///
/// An input is solved once, when it comes, and again only when the history comes back to it. A
/// large input is solved in a thread: a change is awaited (isSolving()), while what is loaded,
/// undone or redone is waited for and the window lives on without keys and mouse.
template <typename Scene>
class CaseModel : public SceneModel {
  public:
    using Input = typename Scene::Input;
    using Solved = typename Scene::Solved;

    ~CaseModel() override {
        if (job_) {
            BackgroundJob::letGo(std::move(job_));
        }
    }

    const Input& input() const { return input_; }

    /// Another limit than the scene's, for tests.
    void setLargestAtOnce(std::size_t size) { largestAtOnce_ = size; }
    bool isSolving() const override { return !awaited_.empty(); }
    void stopSolving() override;
    bool isLarge() const override {
        return isLarge(input_) || (isSolving() && isLarge(awaited_.back().input));
    }

    /// Changes the input by `mutate` as one step of the history, in an editing as part of its step.
    /// @param title  the case's from now on; none: it stays
    /// @return an empty string, or what is wrong with it; the old input holds then
    QString edit(const QString& name, const std::function<void(Input&)>& mutate,
                 const QString& title = {}) {
        return change(name, mutate, title, false);
    }
    /// The same for what changes at every move of a hand: drags of one name that follow each other
    /// are one step, until finishDrag().
    QString drag(const QString& name, const std::function<void(Input&)>& mutate) {
        return change(name, mutate, {}, true);
    }

    bool isTyped() const override { return typed_.has_value(); }
    bool takeBack() override {
        const bool isDropped =
            !awaited_.empty() && awaited_.back().editing == editingNumber() && dropAwaited();
        if (!typed_) {
            return isDropped;
        }
        restore(State(typed_->before));
        sayRefused({});
        Q_EMIT historyChanged();
        return true;
    }
    void keepTyped() override {
        if (typed_) {
            const Typed typed = std::move(*typed_);
            typed_.reset();
            isApplied_ = true;
            push(typed.name, typed.before, state(), -1);
        }
    }

    std::vector<FieldEntry> describedFields(std::string_view only = {}) const override {
        return describe_fields<Input>(only);
    }
    std::vector<FieldEntry> fields(std::string_view only = {}) const override {
        return list_fields(input_, only);
    }
    QString editField(const std::string& pointer, const FieldValue& value,
                      const QString& name) override {
        return edit(name, [&](Input& input) { setField(input, pointer, value); });
    }
    QString dragField(const std::string& pointer, const FieldValue& value,
                      const QString& name) override {
        return drag(name, [&](Input& input) { setField(input, pointer, value); });
    }

    void editText(const QString& title, const QString& notes) override {
        State next = state();
        next.title = title;
        next.notes = notes;
        if (next == state()) {
            return;
        }
        if (title != this->title()) {
            next.named.reset();
        }
        keepTyped();
        push(textName(), state(), std::move(next), -1);
    }

    void changeStudy(const QString& name, const std::string& study) override {
        if (study == this->study()) {
            return;
        }
        keepTyped();
        leaveEditing();
        const State before = state();
        setStudy(study);
        isApplied_ = true;  // nothing is to be solved
        push(name, before, state(), -1);
    }

    // In case_model_json.h.
    /// The input that a change would make, for the copy that a crash leaves; null where it would be
    /// refused.
    Json inputAfter(const std::function<void(Input&)>& mutate) const;
    Json inputJson() const override;
    Json latestInputJson() const override;
    QString changeVariants(const QString& name, const Variants& next,
                           const std::optional<std::string>& input) override;
    QString inputTrouble(const std::string& input) const override;
    Json keptJson() const override;
    void loadFile(const CaseFile& file, const CaseContext& context, const Json* named) override;
    void loadInput(const Json& input, const CaseContext& context) override;
    SolveApart solvesApart() override;
    void loadDefault() override {
        load(newName(), {scene_.defaultInput(),
                         scene_.defaultTitle(),
                         {},
                         defaultName(),
                         context().directory,
                         {},
                         {}});
    }

  protected:
    explicit CaseModel(Scene scene, QObject* parent)
        : SceneModel(parent),
          scene_(std::move(scene)),
          input_(scene_.defaultInput()),
          solved_(solveIn(scene_, input_)),
          named_(defaultName()) {
        setTitle(scene_.defaultTitle());
    }

    static void setField(Input& input, const std::string& pointer, const FieldValue& value) {
        RAVNOVES_DEMAND(set_field(input, pointer, value), "a form's field is in the input");
    }
    /// Another case comes in; it is known to be good, but not yet here.
    virtual void aboutToLoad() {}
    /// Input and result are new, and all have heard of it.
    virtual void taken() {}

    Scene& scene() { return scene_; }
    const Scene& scene() const { return scene_; }
    const Solved& solved() const { return solved_; }
    /// For a part of the input that a scene follows without solving all anew.
    Input& inputInPlace() { return input_; }
    Solved& solvedInPlace() { return solved_; }
    /// After a change of what the scene solves beside the input.
    void solveAgain() {
        solved_ = solve(input_);
        countSolution();
        Q_EMIT changed();
    }
    /// Begins a history of its own with an input.
    void restart(const Input& input) {
        forgetAwaited();
        typed_.reset();
        setVariants({});
        setStudy({});
        history()->clear();
        finishDrag();
        apply(Input(input), solve(input));
    }
    /// True in an editing: the change of this name that follows is part of it, and settle() comes
    /// after it. Anything else that changes meanwhile is a step of its own.
    bool joinEditing(const QString& name) {
        if (!isEditing()) {
            return false;
        }
        if (typed_ && typed_->name != name) {
            keepTyped();
            leaveEditing();
            return false;
        }
        if (!typed_) {
            typed_ = Typed{name, state()};
        }
        return true;
    }
    void settle() {
        if (typed_->before == state()) {
            typed_.reset();
        }
        Q_EMIT historyChanged();
    }

  private:
    /// The preset or example that the title names, and goes with.
    struct Named {
        QString title;
        Input input;
    };
    /// What a step of the history brings back.
    struct State {
        Input input;
        QString title;
        QString notes;
        std::shared_ptr<const Named> named;
        std::filesystem::path directory;  ///< of the files that the case names
        Variants variants;
        std::string study;  ///< JSON text; empty where there is none
        friend bool operator==(const State&, const State&) = default;
    };
    /// What an editing that goes on has changed.
    struct Typed {
        QString name;
        State before;
    };

    /// A change that is being solved.
    struct Awaited {
        QString name;
        Input input;
        std::optional<QString> title;  ///< that it gives the case
        int step;                      ///< as push() takes it
        int editing;                   ///< number of the editing that it is part of; 0: none
    };

    template <typename Loading>
    void loadWith(Loading loading);
    Input readInput(const Json& json, const Json& kept, const CaseContext& context);
    static Solved solveIn(const Scene& scene, const Input& input) {
        clear_vector_state();  // painting may have left it in use
        return withinMemory([&] { return scene.solve(input); });
    }
    /// Now; a large input in a thread that is waited for.
    Solved solve(const Input& input) {
        if (!isLarge(input)) {
            return solveIn(scene_, input);
        }
        const Waiting waiting(this);
        return solveBeside(scene_, input);
    }
    static Solved solveBeside(const Scene& scene, const Input& input);
    bool isLarge(const Input& input) const {
        if constexpr (requires { Scene::size(input); }) {
            return Scene::size(input) > largestAtOnce_;
        } else {
            return false;
        }
    }
    static constexpr std::size_t usualLargest() {
        if constexpr (requires { Scene::largestAtOnce; }) {
            return Scene::largestAtOnce;
        } else {
            return std::numeric_limits<std::size_t>::max();
        }
    }
    QString await(const QString& name, const Input& input, const QString& title, bool merges);
    void solveAwaited();
    void takeAwaited(Solved&& solved);
    void refuseAwaited(const InputError& error);
    bool dropAwaited() override;
    bool prepareStep(const QUndoCommand* step, bool isUndo) override;
    void forgetAwaited();
    void tellSolving() {
        Q_EMIT solvingChanged();
        Q_EMIT historyChanged();
    }
    State state() const {
        return {input_, title(), notes(), named_, context().directory, variantState(), study()};
    }
    std::shared_ptr<const Named> nameOf(const QString& title, const Input& input) const {
        return std::make_shared<const Named>(Named{title, input});
    }
    std::shared_ptr<const Named> defaultName() const {
        return nameOf(scene_.defaultTitle(), scene_.defaultInput());
    }
    /// Whether an input is still the engine that the title names.
    bool isEngine(const Input& input, const Input& named) const {
        if constexpr (requires { scene_.isSameEngine(input, named); }) {
            if (scene_.isSameEngine(input, named)) {
                return true;
            }
        }
        return input == named;
    }
    /// The title that a preset or an example gives an input that may have changed since.
    QString namedTitle(const Input& input) const {
        return isEngine(input, named_->input) || named_->title.isEmpty()
                   ? named_->title
                   : changedTitle(named_->title);
    }
    /// The title goes with the input, unless it is the user's.
    void retitle(State& next) const {
        if (named_ && next.title == namedTitle(input_)) {
            next.title = namedTitle(next.input);
        }
    }
    QString change(const QString& name, const std::function<void(Input&)>& mutate,
                   const QString& title, bool merges) {
        try {
            return withinMemory([&] { return changeTo(name, mutate, title, merges); });
        } catch (const InputError& error) {
            prepared_.reset();
            QString why = explain(error);
            sayRefused(why);
            return why;
        }
    }
    QString changeTo(const QString& name, const std::function<void(Input&)>& mutate,
                     const QString& title, bool merges) {
        State next = state();
        if (isSolving()) {
            next.input = awaited_.back().input;
        }
        mutate(next.input);
        if (isSolving() || isLarge(next.input)) {
            return await(name, next.input, title, merges);
        }
        if (!title.isEmpty()) {
            next.title = title;
            next.named = nameOf(title, next.input);
        } else {
            retitle(next);
        }
        if (next.input == input_ && next.title == this->title()) {
            return {};
        }
        prepared_ = solve(next.input);
        if (joinEditing(name)) {
            take(next);
            settle();
        } else {
            push(name, state(), std::move(next), merges ? stepOf(name) : -1);
        }
        return {};
    }
    void load(const QString& name, State next) {
        withinMemory([&] {
            auto solved = solve(next.input);  // throws before anything changes
            forgetAwaited();
            keepTyped();
            prepared_ = std::move(solved);
        });
        aboutToLoad();
        if (next.input == input_ && next.title == title() && next.notes == notes() &&
            next.variants == variantState() && next.study == study()) {
            restore(next);  // no step, but what a field shows of a refused text goes
        } else {
            push(name, state(), std::move(next), -1);
        }
    }
    /// @param step  changes with the same number are one; −1: a step of its own
    void push(const QString& name, State before, State after, int step) {
        if (step < 0) {
            finishDrag();
        }
        history()->push(new InputCommand<State>(name, std::move(before), std::move(after), step,
                                                [this](const State& state) { restore(state); }));
    }
    void restore(const State& state) {
        if (std::exchange(isApplied_, false)) {
            return;
        }
        typed_.reset();
        take(state);
    }
    void take(const State& state) {
        Input input = state.input;  // what may fail comes before anything changes
        Solved solved = prepared_         ? *std::exchange(prepared_, std::nullopt)
                        : input == input_ ? std::move(solved_)
                                          : solve(input);
        setContext({state.directory});
        named_ = state.named;
        setNotes(state.notes);
        setTitle(state.title);
        setVariants(state.variants);
        setStudy(state.study);
        apply(std::move(input), std::move(solved));
    }
    void apply(Input&& input, Solved&& solved) {
        if (!(input == input_)) {
            countSolution();
        }
        solved_ = std::move(solved);
        input_ = std::move(input);
        if constexpr (requires { scene_.took(solved_); }) {
            scene_.took(solved_);
        }
        sayRefused({});
        Q_EMIT changed();
        taken();
    }

    Scene scene_;
    Input input_;
    Solved solved_;
    std::shared_ptr<const Named> named_;  ///< none: the title is the user's
    std::optional<Solved> prepared_;      ///< of the change that is being made
    std::optional<Typed> typed_;
    std::vector<Awaited> awaited_;  ///< each builds on the one before
    std::unique_ptr<BackgroundJob> job_;
    std::size_t largestAtOnce_ = usualLargest();
    bool isApplied_ = false;  ///< what the step that is pushed changes holds already
};

}  // namespace ravnoves

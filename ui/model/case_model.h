#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "case-file/input_error.h"
#include "model/enough_memory.h"
#include "model/input_command.h"
#include "model/scene_model.h"
#include "numerics/demand.h"
#include "numerics/vector_state.h"

namespace ravnoves {

/// The model of a scene whose state is a case: its input, the solution, and the one way in which an
/// input changes. `Scene` has the differences between scenes:
///
///     using Input = …;   // copied and compared
///     using Solved = …;  // shown by the page
///     Input defaultInput() const;
///     QString defaultTitle() const;
///     Input read(const Json&, const CaseContext&) const;  // throws InputError
///     Json write(const Input&) const;
///     // where an input keeps unused parts, as "kept" of the case:
///     void keep(Input&, const Json& kept, const CaseContext&) const;  // throws InputError
///     Json kept(const Input&) const;
///     // where not all of an input makes it another engine:
///     bool isSameEngine(const Input&, const Input&) const;
///     Solved solve(const Input&) const;  // throws InputError for an input that is rejected
///
/// An input is solved once, when set, and again only when the history returns to it.
template <typename Scene>
class CaseModel : public SceneModel {
  public:
    using Input = typename Scene::Input;
    using Solved = typename Scene::Solved;

    const Input& input() const { return input_; }

    /// Changes the input by `mutate` as one step of the history, in an editing as part of its step.
    /// @param title  the case's new one; none: unchanged
    /// @return an empty string, or the fault; the old input is kept then
    QString edit(const QString& name, const std::function<void(Input&)>& mutate,
                 const QString& title = {}) {
        return change(name, mutate, title, isEditing());
    }
    /// The same for what changes at every move of a hand: drags of one name that follow each other
    /// are one step, until finishDrag().
    QString drag(const QString& name, const std::function<void(Input&)>& mutate) {
        return change(name, mutate, {}, true);
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

    // In case_model_json.h.
    Json inputJson() const override;
    QString takeVariant(int place) override;
    Json keptJson() const override;
    Json variantInput(int place) const override;
    void loadFile(const CaseFile& file, const CaseContext& context, bool isNamed = false) override;
    void loadInput(const Json& input, const CaseContext& context,
                   const QString& name = openName()) override;
    void showInput(const Json& input) override;

  protected:
    explicit CaseModel(Scene scene, QObject* parent)
        : SceneModel(parent),
          scene_(std::move(scene)),
          input_(scene_.defaultInput()),
          solved_(solve(input_)),
          named_(defaultName()) {
        setTitle(scene_.defaultTitle());
    }

    static void setField(Input& input, const std::string& pointer, const FieldValue& value) {
        RAVNOVES_DEMAND(set_field(input, pointer, value), "a form's field is in the input");
    }
    void changeTexts(const QString& name, const CaseTexts& texts) override {
        State next = state();
        next.texts = texts;
        if (texts.title != title()) {
            next.named.reset();
        }
        make(name, std::move(next));
    }
    /// Another case comes in; it is known to be good, but not yet here.
    virtual void aboutToLoad() {}
    /// Input and result are new, and all listeners were notified.
    virtual void taken() {}

    Scene& scene() { return scene_; }
    const Scene& scene() const { return scene_; }
    const Solved& solved() const { return solved_; }
    /// For a part of the input that a scene follows without solving all again.
    Input& inputInPlace() { return input_; }
    Solved& solvedInPlace() { return solved_; }
    /// Begins a history of its own with an input.
    void restart(const Input& input) {
        leaveEditing();
        setTexts({title(), notes(), {}, {}});
        history()->clear();
        finishDrag();
        apply(Input(input), solve(input));
    }

  private:
    /// The preset or example of the title, with its input.
    struct Named {
        QString title;
        Input input;
    };
    /// What a step of the history brings back.
    struct State {
        Input input;
        CaseTexts texts;
        std::shared_ptr<const Named> named;
        std::filesystem::path directory;  ///< of the files that the case names
        friend bool operator==(const State&, const State&) = default;
    };

    Input readInput(const Json& json, const Json& kept, const CaseContext& context) const;
    Solved solve(const Input& input) const {
        clear_vector_state();  // painting may have left it in use
        return withinMemory([&] { return scene_.solve(input); });
    }
    State state() const { return {input_, texts(), named_, context().directory}; }
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
                   : named_->title + changedMark;
    }
    /// The title follows the input, unless it is the user's.
    void retitle(State& next) const {
        if (named_ && next.texts.title == namedTitle(input_)) {
            next.texts.title = namedTitle(next.input);
        }
    }
    QString change(const QString& name, const std::function<void(Input&)>& mutate,
                   const QString& title, bool merges) {
        try {
            withinMemory([&] {
                State next = state();
                mutate(next.input);
                if (!title.isEmpty()) {
                    next.texts.title = title;
                    next.named = nameOf(title, next.input);
                } else {
                    retitle(next);
                }
                if (!(next.input == input_) || next.texts.title != this->title()) {
                    Solved solved = solve(next.input);
                    push(name, std::move(next), std::move(solved), merges ? stepOf(name) : -1);
                }
            });
            return {};
        } catch (const InputError& error) {
            QString why = explain(error);
            setRejection(why);
            return why;
        }
    }
    /// A step that changes anything but the input, where it changes something.
    void make(const QString& name, State next) {
        if (!(next == state())) {
            leaveEditing();
            push(name, std::move(next), std::nullopt, -1);
        }
    }
    void load(const QString& name, State next) {
        Solved solved = solve(next.input);  // throws before anything changes
        aboutToLoad();
        if (next.input == input_ && next.texts == texts()) {
            take(next,
                 std::move(solved));  // no step, but a field drops its rejected text
        } else {
            push(name, std::move(next), std::move(solved), -1);
        }
    }
    /// @param solved  of the input, where that is another
    /// @param step    changes with the same number are one; −1: a step of its own
    void push(const QString& name, State after, std::optional<Solved> solved, int step) {
        if (step < 0) {
            finishDrag();
        }
        State before = state();
        take(after, std::move(solved));
        history()->push(new InputCommand<State>(name, std::move(before), std::move(after), step,
                                                [this](const State& state) { goTo(state); }));
    }
    /// Undone or redone.
    void goTo(State state) {
        if constexpr (requires { scene_.keepBeside(state.input, input_); }) {
            scene_.keepBeside(state.input, input_);  // what has left the program is not undone
        }
        take(state, {});
    }
    void take(const State& state, std::optional<Solved> solved) {
        if (!solved && !(state.input == input_)) {
            solved = solve(state.input);  // what may fail comes before anything changes
        }
        const bool isRenamed = state.texts.title != title() || state.texts.notes != notes();
        Input input = state.input;
        setContext({state.directory});
        named_ = state.named;
        setTexts(state.texts);
        if (solved) {
            apply(std::move(input), *std::move(solved));
        } else if (isRenamed) {
            Q_EMIT changed();
        }
    }
    void apply(Input&& input, Solved&& solved) {
        if (!(input == input_)) {
            countSolution();
        }
        solved_ = std::move(solved);
        input_ = std::move(input);
        setRejection({});
        Q_EMIT changed();
        taken();
    }

    Scene scene_;
    Input input_;
    Solved solved_;
    std::shared_ptr<const Named> named_;  ///< none: the title is the user's
};

}  // namespace ravnoves

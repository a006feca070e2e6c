#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "case-file/field_visitor.h"
#include "case-file/input_error.h"
#include "model/input_command.h"
#include "model/scene_model.h"
#include "numerics/demand.h"
#include "numerics/vector_state.h"
#include "text/error_text.h"

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
///     Solved solve(const Input&) const;  // throws InputError for an input that is refused
///
/// A change is solved once, when it is made, and again only when the history comes back to it.
template <typename Scene>
class CaseModel : public SceneModel {
  public:
    using Input = typename Scene::Input;
    using Solved = typename Scene::Solved;

    const Input& input() const { return input_; }

    /// Changes the input by `mutate` as one step of the history; changes with the same name that
    /// follow each other become one step, until finishDrag().
    /// @return an empty string, or what is wrong with it; the old input holds then
    QString edit(const QString& name, const std::function<void(Input&)>& mutate) {
        Input next = input_;
        mutate(next);
        if (next == input_) {
            return {};
        }
        try {
            prepared_ = solve(next);
        } catch (const InputError& error) {
            QString why = explain(next, error);
            Q_EMIT refused(why);
            return why;
        }
        push(name, std::move(next), stepOf(name));
        return {};
    }

    std::vector<FieldEntry> describedFields() const override { return describe_fields<Input>(); }
    std::vector<FieldEntry> fields() const override { return list_fields(input_); }
    QString editField(const std::string& pointer, const FieldValue& value,
                      const QString& name) override {
        return edit(name, [&](Input& input) {
            RAVNOVES_DEMAND(set_field(input, pointer, value), "a form's field is in the input");
        });
    }

    // In case_model_json.h.
    Json inputJson() const override;
    void loadInput(const Json& json, const CaseContext& context) override;
    void loadDefault() override {
        load(newName(), scene_.defaultInput());
        setTitle(scene_.defaultTitle());
    }

  protected:
    explicit CaseModel(Scene scene, QObject* parent)
        : SceneModel(parent),
          scene_(std::move(scene)),
          input_(scene_.defaultInput()),
          solved_(solve(input_)) {
        setTitle(scene_.defaultTitle());
    }

    /// Why an input is refused, in the user's words.
    virtual QString explain(const Input& /*refused*/, const InputError& error) const {
        return errorText(error);
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
        Q_EMIT changed();
    }
    /// Begins a history of its own with an input.
    void restart(const Input& input) {
        history()->clear();
        finishDrag();
        apply(input);
    }

  private:
    Solved solve(const Input& input) const {
        clear_vector_state();  // painting may have left it in use
        return scene_.solve(input);
    }
    void load(const QString& name, Input next) {
        prepared_ = solve(next);  // throws before anything changes
        aboutToLoad();
        finishDrag();
        if (next == input_) {
            apply(next);  // no step, but what a field shows of a refused text goes
        } else {
            push(name, std::move(next), -1);
        }
    }
    void push(const QString& name, Input next, int step) {
        history()->push(new InputCommand<Input>(name, input_, std::move(next), step,
                                                [this](const Input& input) { apply(input); }));
    }
    void apply(const Input& input) {
        solved_ = prepared_ ? std::move(*prepared_) : solve(input);
        prepared_.reset();
        input_ = input;
        Q_EMIT changed();
        taken();
    }

    Scene scene_;
    Input input_;
    Solved solved_;
    std::optional<Solved> prepared_;  ///< of the change that is being made
};

}  // namespace ravnoves

#pragma once

#include <QUndoCommand>
#include <functional>
#include <utility>

namespace ravnoves {

/// A step of the history; steps of the same non-negative number join: a drag, an editing.
class NumberedStep : public QUndoCommand {
  public:
    int number() const { return number_; }
    /// Its undo removes it from the history.
    void dropWithUndo() { dropsWithUndo_ = true; }

  protected:
    NumberedStep(const QString& text, int number) : QUndoCommand(text), number_(number) {}
    bool dropsWithUndo() const { return dropsWithUndo_; }

  private:
    int number_;
    bool dropsWithUndo_ = false;
};

/// One undoable change of a scene's input, made already: the whole input before and after. Inputs
/// are small, so one generic command serves every field of every scene.
template <typename Input>
class InputCommand : public NumberedStep {
  public:
    using Apply = std::function<void(const Input&)>;

    InputCommand(const QString& text, Input before, Input after, int number, Apply apply)
        : NumberedStep(text, number),
          before_(std::move(before)),
          after_(std::move(after)),
          apply_(std::move(apply)) {}

    void undo() override {
        apply_(before_);
        setObsolete(dropsWithUndo());
    }
    void redo() override {
        if (!std::exchange(isMade_, false)) {
            apply_(after_);
        }
    }
    int id() const override { return 1; }

    bool mergeWith(const QUndoCommand* other) override {
        // Ids are equal, but each scene's stack has only its own commands.
        const auto* next = dynamic_cast<const InputCommand*>(other);
        if (next == nullptr || number() < 0 || next->number() != number()) {
            return false;
        }
        after_ = next->after_;
        setObsolete(after_ == before_);  // the hand came back
        return true;
    }

  private:
    Input before_;
    Input after_;
    Apply apply_;
    bool isMade_ = true;  ///< by whom pushes it
};

}  // namespace ravnoves

#pragma once

#include <QUndoCommand>
#include <functional>
#include <utility>

namespace ravnoves {

/// One undoable change of a scene's input, made already: the whole input before and after. Inputs
/// are small, so one generic command serves every field of every scene. Steps of the same
/// non-negative number join: a drag, an editing.
template <typename Input>
class InputCommand : public QUndoCommand {
  public:
    using Apply = std::function<void(const Input&)>;

    InputCommand(const QString& text, Input before, Input after, int number, Apply apply)
        : QUndoCommand(text),
          number_(number),
          before_(std::move(before)),
          after_(std::move(after)),
          apply_(std::move(apply)) {}

    void undo() override { apply_(before_); }
    void redo() override {
        if (!std::exchange(isMade_, false)) {
            apply_(after_);
        }
    }
    int id() const override { return number_; }

    bool mergeWith(const QUndoCommand* other) override {
        const auto* next = dynamic_cast<const InputCommand*>(other);
        if (next == nullptr) {  // one of a part of the input
            return false;
        }
        after_ = next->after_;
        setObsolete(after_ == before_);  // the hand came back
        return true;
    }

  private:
    int number_;
    Input before_;
    Input after_;
    Apply apply_;
    bool isMade_ = true;  ///< by whom pushes it
};

}  // namespace ravnoves

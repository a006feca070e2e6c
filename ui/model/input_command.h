#pragma once

#include <QUndoCommand>
#include <functional>
#include <utility>

namespace ravnoves {

/// One undoable change of a scene's input: the whole input before and after. Inputs are small, so
/// one generic command serves every field of every scene. Changes with the same non-negative merge
/// number become one step (a slider drag).
template <typename Input>
class InputCommand : public QUndoCommand {
  public:
    using Apply = std::function<void(const Input&)>;

    InputCommand(const QString& text, Input before, Input after, int mergeNumber, Apply apply)
        : QUndoCommand(text),
          before_(std::move(before)),
          after_(std::move(after)),
          mergeNumber_(mergeNumber),
          apply_(std::move(apply)) {}

    void undo() override { apply_(before_); }
    void redo() override { apply_(after_); }
    int id() const override { return 1; }
    const Input& before() const { return before_; }
    const Input& after() const { return after_; }

    bool mergeWith(const QUndoCommand* other) override {
        // Ids are equal, but another scene's stack never holds this one's commands.
        const auto* next = dynamic_cast<const InputCommand*>(other);
        if (next == nullptr || mergeNumber_ < 0 || next->mergeNumber_ != mergeNumber_) {
            return false;
        }
        after_ = next->after_;
        setObsolete(after_ == before_);  // Escape brought the old value back
        return true;
    }

  private:
    Input before_;
    Input after_;
    int mergeNumber_;
    Apply apply_;
};

}  // namespace ravnoves

#pragma once

#include <functional>

#include "widgets/entry_field.h"

namespace ravnoves {

/// A field for text that must have a form (a date, a thread).
class CheckedField : public ValueEntry<QString> {
    Q_OBJECT

  public:
    /// The fault of a text; empty without one. Not called for an empty text.
    using Check = std::function<QString(const QString& text)>;

    explicit CheckedField(Check check, QWidget* parent = nullptr)
        : ValueEntry(parent), check_(std::move(check)) {}

  Q_SIGNALS:
    /// The user typed something valid, or emptied the field.
    void valueEdited(const QString& text);

  protected:
    Reading read(const QString& typed) const override {
        return {typed, typed.isEmpty() ? QString() : check_(typed)};
    }
    QString written() const override { return value(); }
    void passOn() override { Q_EMIT valueEdited(value()); }

  private:
    Check check_;
};

}  // namespace ravnoves

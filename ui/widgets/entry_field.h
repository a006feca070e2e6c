#pragma once

#include <QLineEdit>

namespace ravnoves {

/// The base of every field that reads a value out of typed text.
///
/// The value follows while one types, but only a whole valid text counts: as soon as the text is
/// refused, the value from before the editing holds again. A refused text is never thrown away and
/// never becomes another value by itself: it stays, with a red frame and with trouble() in words,
/// until it is mended, Escape brings the old value back, or another value is set. Escape undoes
/// the whole editing, valid values on the way as well.
class EntryField : public QLineEdit {
    Q_OBJECT

  public:
    explicit EntryField(QWidget* parent = nullptr);

    /// What is wrong with the text now, in words; empty where nothing is.
    QString trouble() const { return trouble_; }
    /// From the first key to Enter, Escape or the loss of the focus.
    bool isEditing() const { return editing_; }
    /// The text that explains the field; the rule for its values is added.
    void setHint(const QString& hint);

  Q_SIGNALS:
    void troubleChanged(const QString& trouble);
    /// What is passed on between these two is one change to the user, hence one step to undo.
    void editingBegun();
    void editingEnded();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

    /// Remembers the value, for Escape.
    virtual void keepValue() = 0;
    /// Makes the remembered value hold again.
    virtual void bringBack() = 0;
    virtual void readText() = 0;
    /// The value as text.
    virtual QString written() const = 0;
    /// The rule for values in the tooltip; may be empty.
    virtual QString rule() const { return {}; }

    void setTrouble(const QString& trouble);
    void showValue();
    void endEditing();
    /// Makes tooltip and description anew.
    void describe();

  private:
    QString hint_;
    QString trouble_;
    bool editing_ = false;
};

/// An EntryField for values of one type.
template <typename Value>
class ValueEntry : public EntryField {
  public:
    using EntryField::EntryField;

    const Value& value() const { return value_; }

    /// Shows a value. A text that the user is at, or that was refused, stays where the value below
    /// it is still the same.
    void setValue(const Value& value) {
        const bool before = same(value, value_);
        if (before && (isEditing() || !trouble().isEmpty())) {
            return;
        }
        if (!before) {
            value_ = value;
        }
        if (isEditing() && trouble().isEmpty() && text().isEmpty()) {
            return;  // what an emptied field means must not join the next digit
        }
        setTrouble({});
        if (text() != written()) {
            showValue();
        }
        endEditing();
    }

  protected:
    struct Reading {
        Value value{};
        QString trouble;  ///< why the text is refused; else empty
    };

    virtual Reading read(const QString& typed) const = 0;
    /// Tells the world that the user gave a value.
    virtual void passOn() = 0;
    virtual bool same(const Value& a, const Value& b) const { return a == b; }

    void keepValue() override { kept_ = value_; }
    void bringBack() override { take(kept_); }
    void readText() override {
        const Reading reading = read(text().trimmed());
        if (reading.trouble.isEmpty()) {
            setTrouble({});
            take(reading.value);
            return;
        }
        bringBack();
        if (isEditing()) {
            setTrouble(reading.trouble);
        }
    }

  private:
    void take(const Value& value) {
        if (!same(value, value_)) {
            value_ = value;
            passOn();
        }
    }

    Value value_{};
    Value kept_{};  ///< from before the editing
};

}  // namespace ravnoves

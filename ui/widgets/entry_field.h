#pragma once

#include <QLineEdit>
#include <QPointer>
#include <optional>
#include <utility>

#include "model/scene_model.h"

namespace ravnoves {

/// The base of every field that reads a value out of typed text.
///
/// The value follows while one types, but only a whole valid text counts: as soon as the text is
/// rejected, the value before the editing applies again. A rejected text is never discarded and
/// never becomes another value by itself: it remains, with a red frame and with trouble() as text,
/// until it is corrected, Escape restores the old value, or another value is set. Escape undoes the
/// whole editing since it was saved, with its valid values. Other values may make a rejected text
/// valid: while they change, trouble() shows that, and afterwards the text is tried again, as a
/// step of its own.
///
/// A click that gives it the focus selects all, as Tab does: typing then replaces the text, and
/// joins no digits. The next click sets the cursor.
///
/// Undo and redo are the text's while it is not the value, else the document's.
class EntryField : public QLineEdit {
    Q_OBJECT

  public:
    explicit EntryField(QWidget* parent = nullptr);

    /// The fault of the present text; empty without one.
    QString trouble() const { return trouble_; }
    /// From the first key to Enter, Escape or the loss of the focus.
    bool isEditing() const { return editing_; }
    /// The whole number where its text is shortened; else empty. The tip says it.
    virtual QString wholeText() const { return {}; }
    /// The line below: the fault, or else how the text was read.
    QString said() const { return !trouble_.isEmpty() ? trouble_ : howRead_; }
    /// The text that explains the field; the rule for its values is added.
    void setHint(const QString& hint);
    /// Its value may be outdated: it has a yellow frame, unless an entry is wrong.
    void setDoubtful(bool isDoubtful);
    /// The field's label as core has it, for texts in other languages; empty without one.
    void setLabel(const Text& label) { label_ = label; }
    const Text& label() const { return label_; }
    bool isDoubtful() const { return isDoubtful_; }
    /// Whether results depend on it; where not, they stay up to date while its text is rejected.
    void setIsOfResult(bool isOfResult) { isOfResult_ = isOfResult; }
    bool isOfResult() const { return isOfResult_; }
    /// The values of an editing are one step of this model's history, and a value that the model
    /// rejects is a rejected text.
    void setModel(SceneModel* model);

  Q_SIGNALS:
    /// The message about the text has changed.
    void troubleChanged();

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

    /// False where one rather adds to the text than types another.
    virtual bool isReplaced() const { return true; }
    /// Remembers the value, for Escape.
    virtual void keepValue() = 0;
    /// Restores the remembered value.
    virtual void bringBack() = 0;
    virtual void readText() = 0;
    /// The value as text.
    virtual QString written() const = 0;
    /// The rule for values in the tooltip; may be empty.
    virtual QString rule() const { return {}; }

    /// @param isOfModel  other values of the model may make it valid
    void setTrouble(const QString& trouble, bool isOfModel = false);
    /// How a text was read that may mean something else; said until the value is another.
    void showHowRead(const QString& note);
    void showValue();
    /// Another value is below the text that waits.
    void keepBelow() {
        keepValue();
        shown_ = written();
    }
    /// The text is the value's, and the field has no focus.
    bool isAtRest() const { return !editing_ && trouble_.isEmpty() && text() == shown_; }
    void endEditing();
    /// The rule has changed that rejected the text: it is read again, as after other values.
    void readLater();
    /// Restores the model's state before the editing.
    /// @return false without a model, or where the editing has changed nothing there
    bool takeModelBack() { return model_ != nullptr && model_->takeBack(); }
    /// Runs what passes a value on. @return why the model rejected it; else empty
    template <typename Passing>
    QString passedOn(Passing passing) {
        isPassing_ = true;
        passing();
        isPassing_ = false;
        return std::exchange(rejection_, {});
    }
    /// Makes tooltip and description again.
    void describe();

  private:
    void beginEditing();
    /// Reads the rejected text as if it were typed now.
    void tryAgain();
    /// Other values have changed since its text was rejected.
    void noteStale();
    /// Reads it automatically, once other values have changed and no editing is under way.
    void tryLater();
    void tryStale();
    void showTrouble(const QString& trouble);

    QPointer<SceneModel> model_;
    Text label_{};
    QString hint_;
    QString trouble_;
    QString howRead_;
    QString rejection_;
    QString shown_;  ///< text of the value that was shown last
    bool editing_ = false;
    bool isEntered_ = false;  ///< by a click that is not over
    bool isPassing_ = false;
    bool isDoubtful_ = false;
    bool isOfResult_ = true;
    bool isOfModel_ = false;  ///< the trouble: nothing has changed since
    bool isStale_ = false;    ///< the trouble: something has
};

/// An EntryField for values of one type.
template <typename Value>
class ValueEntry : public EntryField {
  public:
    using EntryField::EntryField;

    const Value& value() const { return value_; }

    /// Shows a value. A text that the user is at, or that was rejected, stays where the value below
    /// it is still the same.
    void setValue(const Value& value) {
        if (value == value_ && isAtRest()) {
            return;  // most fields, at every step of a drag
        }
        const bool before = same(value, value_);
        if (before && (isEditing() || !trouble().isEmpty())) {
            return;
        }
        const bool wasNone = isNone(value_);
        if (!before) {
            value_ = value;
            showHowRead({});
        }
        if ((wasNone || isNone(value_)) && !trouble().isEmpty()) {
            keepBelow();
            return;  // the value was moved elsewhere; the text typed for it still waits
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
        QString trouble;    ///< why the text is rejected; else empty
        QString howRead{};  ///< where it may mean something else
    };

    virtual Reading read(const QString& typed) const = 0;
    /// Tells the world that the user gave a value.
    virtual void passOn() = 0;
    virtual bool same(const Value& a, const Value& b) const { return a == b; }
    /// True where nothing is given.
    virtual bool isNone(const Value& /*value*/) const { return false; }

    void keepValue() override {
        kept_ = value_;
        isTaken_ = false;
    }
    void bringBack() override {
        if (!same(kept_, value_)) {
            value_ = kept_;
            if (!takeModelBack() && isTaken_) {
                passedOn([this] { passOn(); });
            }
            isTaken_ = false;
        }
    }
    void readText() override {
        const Reading reading = read(text().trimmed());
        showHowRead(reading.howRead);
        if (!reading.trouble.isEmpty()) {
            reject(reading.trouble);
            return;
        }
        setTrouble({});
        if (same(reading.value, kept_)) {
            bringBack();
        } else if (!same(reading.value, value_)) {
            value_ = reading.value;
            const QString rejection = passedOn([this] { passOn(); });
            if (rejection.isEmpty()) {
                isTaken_ = true;
            } else {
                reject(rejection, true);
            }
        }
    }

  private:
    void reject(const QString& why, bool isOfModel = false) {
        bringBack();
        if (isEditing()) {
            setTrouble(why, isOfModel);
        }
    }

    Value value_{};
    Value kept_{};          ///< from before the editing
    bool isTaken_ = false;  ///< another value than that has been passed on, and was not rejected
};

/// Limits a field of text to that many characters, or to its present length; where a paste is cut,
/// a tip shows it.
void limitLength(QLineEdit* field, int longest);

/// "Cut: at most 80 characters."
QString cutText(int longest);

/// Prompts for a name of at most 200 characters.
/// @return empty after Cancel
std::optional<QString> askName(QWidget* parent, const QString& title, const QString& label,
                               const QString& name);

}  // namespace ravnoves

#pragma once

#include <QComboBox>
#include <QPointer>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "case-file/field_index.h"
#include "model/scene_model.h"
#include "widgets/form_section.h"

class QCheckBox;
class QVBoxLayout;

namespace ravnoves {

/// A form over the fields of a scene's input: a row is named by its pointer below "input", and the
/// rest follows from the field's description in core: label and mnemonic, unit, range, tooltip,
/// placeholder, name for screen readers, name of the undo step.
///
/// Typing takes effect at once; an editing from the first key to Enter, Escape or the loss of the
/// focus is one step of the history, and Escape leaves none. Rows follow the model.
class Form : public QWidget {
    Q_OBJECT

  public:
    explicit Form(SceneModel* model, QWidget* parent = nullptr);

    /// Begins a titled section; the rows that follow are in it.
    FormSection* section(const QString& title);
    /// The section that rows are added to now.
    FormSection* current() const { return current_; }
    /// The column of the sections and the widgets between them.
    QVBoxLayout* column() const { return column_; }

    /// A row for a number (or a whole number) of the input.
    NumberField* number(const char* pointer);
    /// A row for a choice of words, or for a whole number that is one of two; why it is rejected
    /// is under it.
    /// @param write  for more than setting the field: takes the word's place (or the number) and
    ///               returns as SceneModel::editField()
    using Choose = std::function<QString(int)>;
    QComboBox* choice(const char* pointer, Choose write = {});
    /// A row for yes or no; returns the box to tick.
    QWidget* flag(const char* pointer);
    /// A row for a text.
    /// @param longest  characters; a longer one is rejected, 0: any
    EntryField* text(const char* pointer, int longest = 0);

    // Rows for values that are no fields: read from the model, in SI, and written by `write`.
    // Rejected values return to the old one.
    using Read = std::function<std::optional<double>()>;
    using Write = std::function<void(std::optional<double>)>;
    NumberField* number(const Field& field, Read read, Write write);
    QComboBox* choice(const QString& name, const QString& label, const QStringList& words,
                      const QString& hint, std::function<int()> read,
                      std::function<void(int)> write);
    QCheckBox* box(const QString& name, const QString& label, const QString& hint,
                   std::function<bool()> read, std::function<void(bool)> write);

    // The same for a field outside of the rows, for example in a grid. It may be destroyed before
    // the form.
    void bind(NumberField* field, const std::string& pointer);
    /// The data of the box's items are the values; `trouble` may be null.
    void bind(QComboBox* box, const std::string& pointer, TroubleLine* trouble = nullptr,
              Choose write = {});
    void bind(NumberField* field, const Field& description, Read read, Write write);
    /// Of a number in the field's unit.
    void bind(NumberField* field, Read read, Write write);
    void bind(QComboBox* box, std::function<int()> read, std::function<void(int)> write);

    /// Calls `show` now and whenever the input changes.
    void follow(std::function<void()> show);

    /// An entry is rejected now.
    bool hasRejected() const;
    /// Pointers of the rejected numbers that may be empty.
    std::vector<std::string> rejectedPlaces() const;

  protected:
    /// The pointer of a field; empty where it has none.
    virtual std::string placeOf(const EntryField* field) const;
    SceneModel* model() const { return model_; }
    void showAll();

  private:
    using Show = std::function<void(const FieldValue& value)>;
    struct Row {
        std::string pointer;
        Show show;
        QPointer<QWidget> field;
    };

    void add(const std::string& pointer, QWidget* field, Show show);
    FieldEntry entryOf(const std::string& pointer) const;

    SceneModel* model_;
    QVBoxLayout* column_;
    FormSection* current_ = nullptr;
    std::vector<Row> rows_;
    std::vector<std::function<void()>> followers_;
};

/// Shows in an empty field, grey, the value that applies: "auto 88"; its unit is beside it.
/// @param value  in the field's unit; empty where the field's own words are enough
/// @param digits  significant ones shown
void showAssumed(Form* form, NumberField* field, std::function<std::optional<double>()> value,
                 int digits = 4);

}  // namespace ravnoves

#pragma once

#include <QComboBox>
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

/// A form over the fields of a scene's input: a row is named by its pointer below "input", and all
/// else follows from the field's description in core: label and mnemonic, unit, range, tooltip,
/// placeholder, name for screen readers, name of the undo step.
///
/// What is typed shows its effect at once; an editing from the first key to Enter, Escape or the
/// loss of the focus is one step of the history, and Escape leaves none. Rows follow the model.
class Form : public QWidget {
    Q_OBJECT

  public:
    explicit Form(SceneModel* model, QWidget* parent = nullptr);

    /// Begins a titled section; the rows that follow are in it.
    FormSection* section(const QString& title);
    /// The section that rows are added to now.
    FormSection* current() const { return current_; }

    /// A row for a number (or a whole number) of the input.
    NumberField* number(const char* pointer);
    /// A row for a choice of words, or for a whole number that is one of two; why it is refused
    /// stands under it.
    /// @param write  for more than setting the field: takes the word's place (or the number) and
    ///               returns as SceneModel::editField()
    QComboBox* choice(const char* pointer, std::function<QString(int)> write = {});
    /// A row for yes or no; returns the box to tick.
    QWidget* flag(const char* pointer);
    /// A row for a text.
    QLineEdit* text(const char* pointer);

    /// A row for a number that is no field by itself: read from the model, and written by `write`,
    /// in the field's unit.
    NumberField* number(const Field& field, std::function<std::optional<double>()> read,
                        std::function<void(std::optional<double>)> write);

    /// Binds a number that stands elsewhere than in a row of its own, for example in a grid.
    void bind(NumberField* field, std::function<std::optional<double>()> read,
              std::function<void(std::optional<double>)> write);
    /// A row for yes or no that is no field by itself.
    QCheckBox* box(const QString& name, const QString& label, const QString& hint,
                   std::function<bool()> read, std::function<void(bool)> write);

    /// Calls `show` now and whenever the input changes.
    void follow(std::function<void()> show);

    /// Entries that are refused now: "Crank radius r, mm: The value must be greater than 0 mm."
    QStringList refused() const;

  private:
    struct Row {
        std::string pointer;
        std::function<void(const FieldValue& value)> show;
        QWidget* field;
    };

    void add(const char* pointer, QWidget* field, std::function<void(const FieldValue&)> show);
    void showAll();

    SceneModel* model_;
    QVBoxLayout* column_;
    FormSection* current_ = nullptr;
    std::vector<Row> rows_;
    std::vector<std::function<void()>> followers_;
};

}  // namespace ravnoves

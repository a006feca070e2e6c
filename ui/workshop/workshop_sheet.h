#pragma once

#include <QCheckBox>
#include <QList>
#include <map>

#include "text/typed_number.h"
#include "theme/theme.h"
#include "widgets/form.h"
#include "workshop/model/workshop_model.h"

class QGridLayout;
class QKeyEvent;
class QLabel;
class QPushButton;

namespace ravnoves {

/// A sheet of the workshop's form: large fields bound to the input, in the order in which one fills
/// them.
class WorkshopSheet : public Form {
    Q_OBJECT

  public:
    static constexpr int fieldHeight = 34;  ///< pixels; a target that a thumb finds

    explicit WorkshopSheet(WorkshopModel* model, QWidget* parent = nullptr);

    /// Every field in the order of Enter. Tab follows their making: along the rows of a grid.
    const QList<QWidget*>& order() const { return order_; }
    /// The name of a field in another language than the window's.
    QString nameIn(const Words& words, const EntryField& field) const;

    /// Its readings are of another bob weight or crankshaft: its tab is yellow, and so are their
    /// fields.
    virtual bool isDoubtful() const { return false; }

  Q_SIGNALS:
    /// One more is in the order.
    void fieldAdded(QWidget* field);

  protected:
    /// Rows as a Form's, large enough to be read at arm's length and hit with a gloved finger.
    template <typename... Arguments>
    NumberField* number(Arguments&&... arguments) {
        NumberField* field = Form::number(std::forward<Arguments>(arguments)...);
        if constexpr (sizeof...(Arguments) > 1) {
            field->setOptional(true);  // a field by its pointer may be optional by itself
        }
        return large(field);
    }
    template <typename... Arguments>
    QComboBox* choice(Arguments&&... arguments) {
        QComboBox* box = ordered(Form::choice(std::forward<Arguments>(arguments)...));
        enlarge(box);
        return box;
    }
    template <typename... Arguments>
    QCheckBox* box(Arguments&&... arguments) {
        QCheckBox* box = ordered(Form::box(std::forward<Arguments>(arguments)...));
        box->setMinimumHeight(Theme::withText(fieldHeight - 6));
        return box;
    }
    void showWhile(QWidget* widget, std::function<bool()> isShown);
    void enableWhile(QWidget* widget, std::function<bool()> isEnabled);
    /// @param longest  limit of the typed text, characters
    void text(const char* pointer, int longest = 80);
    static constexpr int longestNotes = 1000;
    /// A text that must have a form, and its meaning for the input.
    struct CheckedText {
        /// The text in the form that is kept; empty where it has none.
        std::function<QString(const QString& typed)> normal;
        /// Says why a text is rejected.
        std::function<QString(const QString& typed)> rejection;
        std::function<QString()> read;
        /// Makes it a step of the history of that name.
        std::function<void(const QString& name, const QString& normal)> write;
        /// How the kept form is shown; empty: unchanged.
        std::function<QString(const QString& normal)> shown = {};
        bool isOfResult = true;  ///< EntryField::isOfResult()
    };
    /// Its row; its faults are below the field.
    EntryField* checked(const Field& description, const CheckedText& text);
    /// A row of numbers, as readNumberList() takes them; each is described by the field.
    /// @param isUsual  readNumberList()
    void numberList(
        const Field& description, const std::function<std::vector<double>()>& read,
        std::function<void(const QString& name, const std::vector<double>& values)> write,
        bool (*isUsual)(double si) = nullptr);
    /// A line of text over the whole width that follows the model; hidden without one.
    QLabel* line(int pixelSize, std::function<QString()> text);
    /// A field is yellow while it has a reading of another bob weight.
    void doubt(EntryField* field, std::function<bool()> isDoubtful);
    /// The same while its value is doubted, by the word of the rule.
    void doubt(EntryField* field, std::string_view word);
    /// Takes a field into the order.
    template <typename Widget>
    Widget* ordered(Widget* field) {
        order_ << field;
        Q_EMIT fieldAdded(field);
        return field;
    }
    /// Row and column of a widget.
    static std::optional<std::pair<int, int>> placeIn(const QGridLayout& grid, QWidget* widget);
    /// The arrows go to the neighbours of the grid's cells, as in a spreadsheet.
    void followArrows(QGridLayout* grid);
    bool eventFilter(QObject* watched, QEvent* event) override;
    void enlarge(QWidget* field);
    /// As wide as a text: its words are read whole.
    /// @param width  designed pixels
    QComboBox* wide(QComboBox* box, int width = 290);
    /// Begins a section that is there with plugs alone, or without them alone.
    void plugsSection(bool there, const QString& title);
    /// The values of a group of the engine with plugs.
    void engineValues(v8_plugs::EngineGroup group);
    /// A line of buttons.
    QPushButton* button(const char* name, const QString& label, const QString& tip,
                        std::function<void()> press);
    /// A grid over the whole width with its headings, and the line for its rejected entries.
    std::pair<QGridLayout*, TroubleLine*> grid(const QStringList& headings);
    using Name = std::function<QString(const Words& words)>;
    using Place = std::function<std::string()>;
    /// A field of a grid; its name may follow the model.
    /// @param place  its pointer below "input" now; empty without one
    NumberField* cell(const Field& field, const QString& key, const Name& name,
                      const Place& place = {});
    std::string placeOf(const EntryField* field) const override;
    /// Ends the sheet: labels without a mnemonic get one that no other label or button has.
    void finish();

    WorkshopModel* model_;

  private:
    NumberField* large(NumberField* field);
    /// @return true for an arrow that leaves the field of a grid
    static bool goInGrid(const QGridLayout& grid, QWidget* from, const QKeyEvent& key);

    std::map<const EntryField*, std::pair<Name, Place>> named_;
    QList<QWidget*> order_;
    QList<QGridLayout*> grids_;
};

/// A button as high as the fields of a sheet.
QPushButton* largeButton(const char* name, const QString& text, QWidget* parent,
                         int height = WorkshopSheet::fieldHeight);

}  // namespace ravnoves

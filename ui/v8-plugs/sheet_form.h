#pragma once

#include <QList>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "v8-plugs/input.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace ravnoves {

class CheckedField;
class FormSection;
class NumberField;
class V8PlugsModel;

/// One sheet of the job's form: large fields bound to the input, in the order in which one fills
/// them. A sheet builds its fields in its constructor and calls showInput() at its end; afterwards
/// the fields follow the model by themselves.
class SheetForm : public QWidget {
    Q_OBJECT

  public:
    static constexpr int fieldHeight = 34;  ///< pixels; a target that a thumb finds

    explicit SheetForm(V8PlugsModel* model, QWidget* parent = nullptr);

    /// Every field in the order of Tab and Enter.
    const QList<QWidget*>& order() const { return order_; }

    /// Entries that were refused and do not count: the field's name and what is wrong.
    QStringList refused() const;

    /// Makes a field large enough to be read at arm's length and hit with a gloved finger.
    static void enlarge(QWidget* field);
    /// A wrapping label whose text can be copied.
    static QLabel* wrapped(QWidget* parent, int pixelSize, bool bold = false);

  protected:
    /// A number of the input: its field, where it is read, how it is changed.
    NumberField* number(FormSection* section, const QString& label, const FieldSpec& spec,
                        const QString& hint, std::function<std::optional<double>()> read,
                        std::function<void(v8_plugs::Input&, std::optional<double>)> write);
    /// A line of text in the job's head, no longer than the job card has room for.
    QLineEdit* text(FormSection* section, const QString& label, const QString& name,
                    std::string v8_plugs::JobHeader::*member, const QString& hint,
                    int longest = 80);
    /// A text that must have a form, and what it means to the input.
    struct CheckedText {
        /// The text in the form that is kept; empty where it has none.
        std::function<QString(const QString& typed)> normal;
        /// Says why a text is refused.
        std::function<QString(const QString& typed)> refusal;
        std::function<QString()> read;
        std::function<void(v8_plugs::Input&, const QString& normal)> write;
    };
    /// Its field; what is wrong with it stands below the field.
    CheckedField* checked(FormSection* section, const QString& label, const QString& name,
                          const QString& hint, CheckedText text);
    /// A choice; `choose` is called with the place of what the user picks.
    QComboBox* choice(FormSection* section, const QString& label, const QString& name,
                      const QStringList& items, const QString& hint,
                      std::function<void(int)> choose);
    /// Runs now and whenever the input has changed.
    void follow(std::function<void()> show);

    V8PlugsModel* model_;
    QVBoxLayout* column_;
    QList<QWidget*> order_;

  private:
    std::vector<std::function<void()>> followers_;
};

}  // namespace ravnoves

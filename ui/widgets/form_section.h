#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QWidget>

#include "case-file/field.h"
#include "theme/theme.h"
#include "widgets/number_field.h"

namespace ravnoves {

/// A line with the reasons for rejected texts of fields; hidden without any. It changes only while
/// no button of the mouse is down: a press that leaves a field still meets its target.
class TroubleLine : public QLabel {
    Q_OBJECT

  public:
    explicit TroubleLine(QWidget* parent = nullptr);

    /// @param named  several fields share the line: it says which one is meant
    void watch(EntryField* field, bool named = true);
    /// @param isTrouble  false: no fault, a report
    void say(const QString& text, bool isTrouble = true);

  private:
    void showText();

    QList<EntryField*> fields_;
    bool waits_ = false;  ///< for the button of the mouse
};

/// The width in which a choice shows its longest entry; other fields their size hint.
int widthFor(const QWidget* field);

/// A cell of a grid or of a list: lines and columns name it, not a label of its own.
void makeCell(QWidget* field);

/// A titled group of inputs: label, field, unit, one row each, aligned over the whole form; the
/// fault of a field is below it as text.
class FormSection : public QWidget {
    Q_OBJECT

  public:
    explicit FormSection(const QString& title, QWidget* parent = nullptr);

    /// A row with a number as core describes it. The label's & gives the mnemonic; it is the
    /// field's buddy.
    NumberField* addNumber(const Field& field);
    /// A row with any widget; unit and hint may be empty.
    void addWidget(const QString& label, QWidget* field, const QString& unit = {},
                   const QString& hint = {});
    /// A widget over the whole width.
    void addWide(QWidget* widget);
    /// A row that shows a computed value; returns the value's label.
    QLabel* addResult(const QString& label, const QString& hint = {});

  private:
    QGridLayout* grid_;
    int row_ = 0;
};

/// What a widget is, as its tip and as what Shift+F1 says.
void explain(QWidget* widget, const QString& hint);

/// A form, or another part of a page, that scrolls where it is larger than its place.
QScrollArea* scrolled(QWidget* form, QWidget* parent = nullptr);
/// A colour of the theme by its meaning: &Theme::warning.
using Ink = QColor (Theme::*)() const;
/// Gives a label's text an ink, whose colour follows the theme.
void colourText(QLabel* label, Ink ink);
/// A muted, wrapping caption.
QLabel* captionLabel(const QString& text, QWidget* parent = nullptr);
/// The same whose text can be copied.
QLabel* copyableCaption(const char* name, QWidget* parent);
/// A wrapping label whose text can be copied.
QLabel* copyableLabel(const char* name, int pixelSize, QWidget* parent, bool bold = false);
/// Shows a text, or hides the label of an empty one.
void showOrHide(QLabel* label, const QString& text);
/// A section heading in the type scale.
QLabel* headingLabel(const QString& text, QWidget* parent = nullptr);

}  // namespace ravnoves

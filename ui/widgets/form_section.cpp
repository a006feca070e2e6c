#include "widgets/form_section.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPainter>
#include <QPointer>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QTimer>
#include <algorithm>

#include "text/message_text.h"
#include "text/number_text.h"
#include "text/tip_text.h"
#include "theme/theme.h"
#include "widgets/answer_label.h"
#include "widgets/entry_field.h"

namespace ravnoves {

namespace {

/// Takes the focus only to scroll what has no field of its own, and shows that it has it.
class Scrolled final : public QScrollArea {
  public:
    Scrolled(QWidget* content, QWidget* parent) : QScrollArea(parent) {
        setFrameShape(QFrame::NoFrame);
        setWidgetResizable(true);
        setWidget(content);
        setFocusPolicy(Qt::NoFocus);
        setViewportMargins(1, 1, 1, 1);
        // Qt does this only for what has the focus from inside.
        connect(qApp, &QApplication::focusChanged, this, [this](QWidget* old, QWidget* now) {
            const bool isHere = now != nullptr && now->window() == window();
            if (isHere && now != left_ && QApplication::mouseButtons() == Qt::NoButton &&
                widget()->isAncestorOf(now)) {
                ensureWidgetVisible(now, 0, Theme::gap);
            }
            if (isHere) {
                left_ = nullptr;
            } else if (old != nullptr && widget()->isAncestorOf(old)) {
                left_ = old;
            }
        });
    }

    QSize minimumSizeHint() const override {
        constexpr int minHeight = 60;
        const int bar = verticalScrollBar()->sizeHint().width();
        return {widget()->minimumSizeHint().width() + bar + 2, Theme::withText(minHeight)};
    }

  protected:
    bool event(QEvent* event) override {
        const bool done = QScrollArea::event(event);
        if (event->type() == QEvent::Paint && hasFocus()) {
            QPainter painter(this);
            painter.setPen(Theme::instance().accent());
            painter.drawRect(rect().adjusted(0, 0, -1, -1));
        } else if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize) {
            giveRoom();
            const bool isOver = verticalScrollBar()->maximum() > 0;
            setFocusPolicy(isOver && !hasStop() ? Qt::StrongFocus : Qt::NoFocus);
            const auto* text = qobject_cast<QLabel*>(widget());
            text = text != nullptr ? text : widget()->findChild<QLabel*>();
            // Each setting is told to screen readers.
            if (const QString name = text != nullptr ? text->text() : QString();
                name != accessibleName()) {
                setAccessibleName(name);
            }
        } else if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) {
            update();
        }
        return done;
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) {
            giveRoom();
        }
        return QScrollArea::eventFilter(watched, event);
    }

  private:
    /// That had the focus when another window got it: it gets it back where the user left it.
    QPointer<QWidget> left_;

    /// A scroll area knows nothing of texts that wrap: without their height it squeezes the rows.
    void giveRoom() {
        const QLayout* layout = widget()->layout();
        const bool wraps =
            layout != nullptr ? layout->hasHeightForWidth() : widget()->hasHeightForWidth();
        if (!wraps) {
            setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
            return;
        }
        const auto needed = [&](int width) {
            return layout != nullptr ? layout->minimumHeightForWidth(width)
                                     : widget()->heightForWidth(width);
        };
        // A bar takes of the width: what needs one only for that gets none. But fields stay where
        // they are while one types in them, whatever is said below. Qt gives a form the height that
        // it wants, not only what it needs.
        const QSize whole = maximumViewportSize();
        const bool fits = widget()->findChild<EntryField*>() == nullptr &&
                          std::max(needed(whole.width()),
                                   widget()->heightForWidth(whole.width())) <= whole.height();
        setVerticalScrollBarPolicy(fits ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
        const int height = needed(fits ? whole.width() : viewport()->width());
        if (layout != nullptr && widget()->minimumHeight() != height) {
            widget()->setMinimumHeight(height);
        }
    }

    bool hasStop() const {
        return std::ranges::any_of(widget()->findChildren<QWidget*>(), [](const QWidget* each) {
            return (each->focusPolicy() & Qt::TabFocus) != 0;
        });
    }
};

}  // namespace

QScrollArea* scrolled(QWidget* form, QWidget* parent) {
    return new Scrolled(form, parent);
}

void colourText(QLabel* label, Ink ink) {
    const QString name = QStringLiteral("ink");
    delete label->findChild<QObject*>(name, Qt::FindDirectChildrenOnly);  // that of before
    auto* follower = new QObject(label);
    follower->setObjectName(name);
    const auto show = [label, ink] {
        QPalette palette = label->palette();
        palette.setColor(QPalette::WindowText, (Theme::instance().*ink)());
        label->setPalette(palette);
    };
    QObject::connect(&Theme::instance(), &Theme::changed, follower, show);
    show();
}

void explain(QWidget* widget, const QString& hint) {
    widget->setToolTip(tipText(hint));
    widget->setWhatsThis(hint);
}

namespace {

QString withoutMnemonic(QString label) {
    return label.remove(QLatin1Char('&'));
}

/// A name beside a field. On a screen of many pixels a text is painted somewhat wider than it is
/// measured, and goes on a second line: it has the height for that.
class NameLabel final : public QLabel {
  public:
    using QLabel::QLabel;

    int heightForWidth(int width) const override {
        return QLabel::heightForWidth(std::max(1, width - Theme::withText(slack)));
    }
    static constexpr int slack = 4;  ///< designed pixels
};

constexpr int numberColumn = 84;  ///< designed pixels
constexpr int unitColumn = 40;    ///< the widest unit, so that all sections line up

/// A name with a choice or a text beside it; below it where there is no room for both.
class NamedRow final : public QWidget {
  public:
    NamedRow(QLabel* name, QWidget* field, QWidget* parent)
        : QWidget(parent), grid_(new QGridLayout(this)), name_(name), field_(field) {
        grid_->setContentsMargins(0, 0, 0, 0);
        grid_->setHorizontalSpacing(Theme::space);
        grid_->setVerticalSpacing(Theme::gap / 2);
        grid_->setColumnStretch(0, 1);
        grid_->addWidget(name_, 0, 0);
        grid_->addWidget(field_, 0, 1);
    }

    QSize minimumSizeHint() const override {
        const int minimum =
            std::max(name_->minimumSizeHint().width(), field_->minimumSizeHint().width());
        return {minimum, QWidget::minimumSizeHint().height()};
    }

  protected:
    bool event(QEvent* event) override {
        const bool done = QWidget::event(event);
        // Choices may have been added.
        if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize) {
            arrange();
        }
        return done;
    }

  private:
    void arrange() {
        const int words = name_->fontMetrics().horizontalAdvance(withoutMnemonic(name_->text())) +
                          Theme::withText(NameLabel::slack) + 1;
        const int numbers = Theme::withText(numberColumn + unitColumn) + Theme::space;
        // What one types in scrolls: it leaves the name one line.
        const bool isText = qobject_cast<const QLineEdit*>(field_) != nullptr;
        const int whole = std::max(widthFor(field_), numbers);
        const int minimum = std::max(numbers, field_->minimumWidth());
        const int wanted =
            isText ? std::clamp(width() - words - Theme::space, minimum, std::max(whole, minimum))
                   : whole;
        const bool folded = width() < words + Theme::space + wanted;
        if (folded != folded_) {
            folded_ = folded;
            grid_->removeWidget(field_);
            grid_->addWidget(field_, folded ? 1 : 0, folded ? 0 : 1);
            updateGeometry();
        }
        for (const auto& [column, needed] : {std::pair(0, words), std::pair(1, wanted)}) {
            // Set again it asks for a layout again, which comes here again.
            if (const int to = folded ? 0 : needed; grid_->columnMinimumWidth(column) != to) {
                grid_->setColumnMinimumWidth(column, to);
            }
        }
    }

    QGridLayout* grid_;
    QLabel* name_;
    QWidget* field_;
    bool folded_ = false;
};

}  // namespace

int widthFor(const QWidget* field) {
    const auto* box = qobject_cast<const QComboBox*>(field);
    if (box == nullptr) {
        return field->sizeHint().width();
    }
    const QFontMetrics metrics = box->fontMetrics();
    QSize longest(0, metrics.height());
    for (int i = 0; i < box->count(); ++i) {
        longest.setWidth(std::max(longest.width(), metrics.horizontalAdvance(box->itemText(i))));
    }
    QStyleOptionComboBox option;
    option.initFrom(box);
    return box->style()->sizeFromContents(QStyle::CT_ComboBox, &option, longest, box).width();
}

QLabel* captionLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setFont(Theme::font(Theme::smallSize));
    colourText(label, &Theme::mutedText);
    return label;
}

QLabel* copyableCaption(const char* name, QWidget* parent) {
    QLabel* label = copyableLabel(name, Theme::smallSize, parent);
    colourText(label, &Theme::mutedText);
    return label;
}

QLabel* copyableLabel(const char* name, int pixelSize, QWidget* parent, bool bold) {
    auto* label = new AnswerLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setFont(Theme::font(pixelSize, bold));
    return label;
}

void showOrHide(QLabel* label, const QString& text) {
    label->setText(unbroken(text));
    label->setVisible(!text.isEmpty());
}

QLabel* headingLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setFont(Theme::font(Theme::baseSize, true));
    return label;
}

TroubleLine::TroubleLine(QWidget* parent) : QLabel(parent) {
    setWordWrap(true);
    setFont(Theme::font(Theme::smallSize));
    hide();
}

void TroubleLine::watch(EntryField* field, bool named) {
    fields_ << field;
    connect(field, &EntryField::troubleChanged, this, [this, named] {
        QStringList lines;
        bool isTrouble = false;
        for (const EntryField* each : std::as_const(fields_)) {
            isTrouble = isTrouble || !each->trouble().isEmpty();
            if (!each->said().isEmpty()) {
                lines << (named ? each->accessibleName() + QStringLiteral(": ") + each->said()
                                : each->said());
            }
        }
        say(lines.join(QLatin1Char('\n')), isTrouble);
    });
}

void TroubleLine::say(const QString& text, bool isTrouble) {
    colourText(this, isTrouble ? &Theme::error : &Theme::mutedText);
    setText(text);
    if (text.isEmpty() != isHidden() && !waits_) {
        waits_ = true;
        showText();
    }
}

void TroubleLine::showText() {
    if (QGuiApplication::mouseButtons() != Qt::NoButton) {
        constexpr int soonMs = 20;
        setMinimumHeight(isHidden() ? 0 : height());
        QTimer::singleShot(soonMs, this, &TroubleLine::showText);
        return;
    }
    waits_ = false;
    setMinimumHeight(0);
    setVisible(!text().isEmpty());
}

void makeCell(QWidget* field) {
    field->setProperty("isCell", true);
}

FormSection::FormSection(const QString& title, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, Theme::space);
    column->setSpacing(Theme::gap);
    if (!title.isEmpty()) {
        QLabel* heading = headingLabel(title, this);
        heading->setWordWrap(true);  // no title makes the form wider than its place
        column->addWidget(heading);
    }
    grid_ = new QGridLayout;
    grid_->setHorizontalSpacing(Theme::space);
    grid_->setVerticalSpacing(Theme::gap);
    grid_->setColumnStretch(0, 1);
    grid_->setColumnMinimumWidth(1, Theme::withText(numberColumn));
    grid_->setColumnMinimumWidth(2, Theme::withText(unitColumn));
    column->addLayout(grid_);
}

NumberField* FormSection::addNumber(const Field& field) {
    auto* number = new NumberField(field, this);
    number->setMaximumWidth(Theme::withText(96));
    addWidget(shownText(field.label), number, number->unit());
    return number;
}

void FormSection::addWidget(const QString& label, QWidget* field, const QString& unit,
                            const QString& hint) {
    auto* name = new NameLabel(unbroken(label), this);
    name->setBuddy(field);
    name->setWordWrap(true);
    if (!hint.isEmpty()) {
        explain(field, hint);
    }
    explain(name, field->toolTip());
    QString spoken = withoutMnemonic(label);
    if (!unit.isEmpty()) {
        spoken += QStringLiteral(", ") + unit;
    }
    field->setAccessibleName(spoken);
    if (unit.isEmpty() && qobject_cast<NumberField*>(field) == nullptr) {
        grid_->addWidget(new NamedRow(name, field, this), row_, 0, 1, 3);
    } else {
        grid_->addWidget(name, row_, 0);
        // A field narrower than its column is at its unit, under the fields of other sections.
        const bool narrow = unit.isEmpty() || field->maximumWidth() < QWIDGETSIZE_MAX;
        grid_->addWidget(field, row_, 1, narrow ? Qt::AlignRight : Qt::Alignment());
    }
    if (!unit.isEmpty()) {
        auto* unitLabel = new QLabel(unit, this);
        colourText(unitLabel, &Theme::mutedText);
        grid_->addWidget(unitLabel, row_, 2);
    }
    ++row_;
    if (auto* entry = qobject_cast<EntryField*>(field)) {
        auto* trouble = new TroubleLine(this);
        trouble->watch(entry, false);
        grid_->addWidget(trouble, row_++, 0, 1, 3);
    }
}

void FormSection::addWide(QWidget* widget) {
    grid_->addWidget(widget, row_++, 0, 1, 3);
}

QLabel* FormSection::addResult(const QString& label, const QString& hint) {
    auto* name = new NameLabel(unbroken(label), this);
    name->setWordWrap(true);
    auto* value = new QLabel(this);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    explain(value, hint);
    explain(name, hint);
    value->setAccessibleName(withoutMnemonic(label));
    colourText(name, &Theme::mutedText);
    grid_->addWidget(name, row_, 0);
    grid_->addWidget(value, row_, 1, 1, 2);
    ++row_;
    return value;
}

}  // namespace ravnoves

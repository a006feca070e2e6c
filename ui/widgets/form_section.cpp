#include "widgets/form_section.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPainter>
#include <QPointer>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <algorithm>

#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/theme.h"
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

    QSize sizeHint() const override {
        const QSize hint = QScrollArea::sizeHint();
        return lineHeight() == 0 ? hint : QSize(hint.width(), std::max(asked_, minimumHeight()));
    }
    QSize minimumSizeHint() const override {
        const int bar = verticalScrollBar()->sizeHint().width();
        return {widget()->minimumSizeHint().width() + bar + 2, Theme::withText(leastHeight)};
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
            showWholeLines();
            setFocusPolicy(isOver() && !hasStop() ? Qt::StrongFocus : Qt::NoFocus);
            const auto* text = qobject_cast<QLabel*>(widget());
            text = text != nullptr ? text : widget()->findChild<QLabel*>();
            // Each setting is told to screen readers.
            if (const QString name = text != nullptr ? text->text() : QString();
                name != accessibleName()) {
                setAccessibleName(name);
            }
        }
        return done;
    }
    bool viewportEvent(QEvent* event) override {
        const bool done = QScrollArea::viewportEvent(event);
        if (event->type() == QEvent::LayoutRequest) {  // the text has another height
            showWholeLines();
        }
        return done;
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) {
            giveRoom();
        } else if (watched != widget() && event->type() == QEvent::Resize && lineHeight() > 0) {
            askForHeight();  // the column's room
        }
        return QScrollArea::eventFilter(watched, event);
    }
    void focusInEvent(QFocusEvent* event) override {
        QScrollArea::focusInEvent(event);
        update();
    }
    void focusOutEvent(QFocusEvent* event) override {
        QScrollArea::focusOutEvent(event);
        update();
    }

  private:
    static constexpr int leastHeight = 60;

    /// A scroll area knows nothing of texts that wrap: without their height it squeezes the rows.
    void giveRoom() {
        const QLayout* layout = widget()->layout();
        const bool isForm = layout != nullptr && layout->hasHeightForWidth();
        if (!isForm && (layout != nullptr || !widget()->hasHeightForWidth() || lineHeight() > 0)) {
            setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
            return;
        }
        const auto needed = [&](int width) {
            return isForm ? layout->minimumHeightForWidth(width) : widget()->heightForWidth(width);
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
        if (isForm && widget()->minimumHeight() != height) {
            widget()->setMinimumHeight(height);
        }
    }

    /// Of a text that scrolls by itself; 0 for a form.
    int lineHeight() const { return property("lineHeight").toInt(); }

    void showWholeLines() {
        const int line = lineHeight();
        if (line == 0) {
            return;
        }
        askForHeight();
        const int room = height() - 2;
        const bool scrolls = textHeight() > room;
        const int below = scrolls && room > line ? 1 + room % line : 1;
        if (viewportMargins().bottom() != below) {
            setViewportMargins(1, 1, 1, below);
        }
        verticalScrollBar()->setSingleStep(line);
    }

    int textHeight(int wider = 0) const {
        return widget()->heightForWidth(std::max(1, width() + wider - 2));
    }

    /// All its height where the column that it is in has room for that, without a scroll bar, or
    /// has none even for its least.
    void askForHeight() {
        if (around_ == nullptr) {
            for (QWidget* each = parentWidget(); each != nullptr && around_ == nullptr;
                 each = each->parentWidget()) {
                around_ = qobject_cast<QScrollArea*>(each);
            }
            if (around_ == nullptr) {
                return;
            }
            around_->viewport()->installEventFilter(this);
        }
        QWidget* column = around_->widget();
        for (QWidget* each = this; each != column; each = each->parentWidget()) {
            each->updateGeometry();  // no layout keeps what it was told before
        }
        // What the column's layout gives it at least.
        const int least = std::max(minimumHeight(), minimumSizeHint().height());
        const int now = std::max(sizeHint().height(), least);
        // As if the column had no bar: one that came and went with the answer would ask for ever.
        const QSize room = around_->maximumViewportSize();
        const int wider = std::max(0, room.width() - column->width());
        const int free = room.height() - (column->heightForWidth(column->width() + wider) - now);
        const int whole = std::max(least, textHeight(wider) + 2);
        // Where the column scrolls anyway, the text need not as well.
        const int asked = free < least ? whole : std::clamp(free, least, whole);
        if (asked != now) {
            asked_ = asked;
            updateGeometry();
        }
    }

    /// That had the focus when another window got it: it gets it back where the user left it.
    QPointer<QWidget> left_;
    QPointer<QScrollArea> around_;  ///< that the column of the text scrolls in
    int asked_ = 0;                 ///< height

    bool isOver() const { return verticalScrollBar()->maximum() > 0; }
    bool hasStop() const {
        const auto inside = widget()->findChildren<QWidget*>();
        return std::any_of(inside.begin(), inside.end(), [](const QWidget* each) {
            return (each->focusPolicy() & Qt::TabFocus) != 0;
        });
    }
};

}  // namespace

QScrollArea* scrolled(QWidget* form, QWidget* parent) {
    return new Scrolled(form, parent);
}

namespace {

/// The ink of a label; it belongs to it.
class LabelInk final : public QObject {
  public:
    static LabelInk* of(QLabel* label) {
        const QString name = QStringLiteral("ink");
        auto* ink = label->findChild<QObject*>(name, Qt::FindDirectChildrenOnly);
        return ink != nullptr ? static_cast<LabelInk*>(ink) : new LabelInk(label, name);
    }
    void set(Ink ink) {
        ink_ = ink;
        apply();
    }

  private:
    LabelInk(QLabel* label, const QString& name) : QObject(label), label_(label) {
        setObjectName(name);
        connect(&Theme::instance(), &Theme::changed, this, &LabelInk::apply);
    }
    void apply() {
        const QColor colour = (Theme::instance().*ink_)();
        QPalette palette = label_->palette();
        if (palette.color(QPalette::WindowText) != colour) {
            palette.setColor(QPalette::WindowText, colour);
            label_->setPalette(palette);
        }
    }

    QLabel* label_;
    Ink ink_ = &Theme::text;
};

}  // namespace

void colourText(QLabel* label, Ink ink) {
    LabelInk::of(label)->set(ink);
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

/// A name with a choice or a text beside it, which is as wide as what it may show; below it where
/// there is no room for both.
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
        arrange();
    }

    QSize minimumSizeHint() const override {
        return {std::max(widestWord(), field_->minimumSizeHint().width()),
                QWidget::minimumSizeHint().height()};
    }

  protected:
    void resizeEvent(QResizeEvent* event) override {
        QWidget::resizeEvent(event);
        arrange();
        // Once the other rows have their widths.
        QMetaObject::invokeMethod(
            this, [this] { arrange(); }, Qt::QueuedConnection);
    }
    bool event(QEvent* event) override {
        const bool done = QWidget::event(event);
        if (event->type() == QEvent::LayoutRequest) {  // choices were added
            arrange();
        }
        return done;
    }

  private:
    int textWidth() const {
        return name_->fontMetrics().horizontalAdvance(withoutMnemonic(name_->text())) +
               Theme::withText(NameLabel::slack) + 1;
    }
    int widestWord() const {
        int widest = 0;
        for (const QString& word : withoutMnemonic(name_->text()).split(QLatin1Char(' '))) {
            widest = std::max(widest, name_->fontMetrics().horizontalAdvance(word));
        }
        return widest + 2;
    }

    bool isText() const { return qobject_cast<const QLineEdit*>(field_) != nullptr; }
    bool isChoice() const { return qobject_cast<const QComboBox*>(field_) != nullptr; }
    int wanted() const {
        const int line = Theme::withText(numberColumn) + Theme::space + Theme::withText(unitColumn);
        const int hint = std::max(widthFor(field_), line);
        // What one types in scrolls: it leaves the name one line.
        return isText() ? std::clamp(width() - textWidth() - Theme::space,
                                     std::max(line, field_->minimumWidth()),
                                     std::max(hint, field_->minimumWidth()))
                        : hint;
    }
    /// The choices of a form are as wide as one another, where their names leave them the room.
    int widthOfAll() const {
        int widest = 0;
        const QWidget* section = parentWidget();
        const QWidget* form = section->isWindow() ? section : section->parentWidget();
        for (const QWidget* each : form->findChildren<QWidget*>()) {
            const auto* row = dynamic_cast<const NamedRow*>(each);
            if (row != nullptr && row->isChoice() && row->isVisibleTo(form)) {
                const int own = row->wanted();
                const bool fits = row->textWidth() + Theme::space + own <= row->width();
                widest = std::max(widest, fits ? own : 0);
            }
        }
        return widest;
    }

    void arrange() {
        const int own = wanted();
        const int all = isChoice() ? widthOfAll() : 0;
        const int wanted = all > own && textWidth() + Theme::space + all <= width() ? all : own;
        // The name of a choice may take two lines.
        const int beside = isChoice() ? widestWord() : textWidth();
        const bool folded = width() < beside + Theme::space + wanted;
        if (folded != folded_) {
            folded_ = folded;
            grid_->removeWidget(field_);
            grid_->addWidget(field_, folded ? 1 : 0, folded ? 0 : 1);
            updateGeometry();
        }
        if (const int least = folded ? 0 : wanted; grid_->columnMinimumWidth(1) != least) {
            grid_->setColumnMinimumWidth(1, least);
        }
        if (const int least = folded || !isText() ? 0 : textWidth();
            grid_->columnMinimumWidth(0) != least) {
            grid_->setColumnMinimumWidth(0, least);
        }
    }

    QGridLayout* grid_;
    QLabel* name_;
    QWidget* field_;
    bool folded_ = false;
};

/// A unit stands beside a number, and beside an empty field that waits for one: "any" has none, and
/// "0.4 ℓ₀" has its own.
class UnitBeside final : public QObject {
  public:
    UnitBeside(QLineEdit* field, QLabel* unit) : QObject(unit), field_(field), unit_(unit) {
        QSizePolicy policy = unit->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        unit->setSizePolicy(policy);
        field->installEventFilter(this);
        connect(field, &QLineEdit::textChanged, this, &UnitBeside::show);
        show();
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        // A field tells no one of another placeholder: it is painted anew.
        if (watched == field_ &&
            (event->type() == QEvent::EnabledChange || event->type() == QEvent::Paint)) {
            show();
        }
        return QObject::eventFilter(watched, event);
    }

  private:
    void show() {
        const QString instead = field_->placeholderText();
        // "needed" and "?" wait for a number of that unit.
        const bool waits = instead == shownText({"V8", "needed"}) || instead == QLatin1String("?");
        const bool bare = field_->text().isEmpty() && !field_->hasFocus() && !instead.isEmpty() &&
                          !waits && !readFormNumber(instead);
        if (bare != unit_->isHidden()) {
            unit_->setHidden(bare);
        }
    }

    QLineEdit* field_;
    QLabel* unit_;
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

ChangingLabel* changingCaption(QWidget* parent) {
    auto* label = new ChangingLabel(parent);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);  // in a drag it may have more room
    label->setFont(Theme::font(Theme::smallSize));
    colourText(label, &Theme::mutedText);
    return label;
}

QLabel* copyableCaption(const char* name, QWidget* parent) {
    QLabel* label = captionLabel({}, parent);
    label->setObjectName(QLatin1String(name));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QLabel* copyableLabel(const char* name, int pixelSize, QWidget* parent, bool bold) {
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setFont(Theme::font(pixelSize, bold));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

void sayOrHide(QLabel* label, const QString& text) {
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
        for (const EntryField* each : std::as_const(fields_)) {
            if (!each->trouble().isEmpty()) {
                lines << (named ? each->accessibleName() + QStringLiteral(": ") + each->trouble()
                                : each->trouble());
            }
        }
        say(lines.join(QLatin1Char('\n')));
    });
}

void TroubleLine::say(const QString& text, bool isTrouble) {
    colourText(this, isTrouble ? &Theme::error : &Theme::mutedText);
    setText(text);
    if (text.isEmpty() != isHidden()) {
        if (QGuiApplication::mouseButtons() == Qt::NoButton) {
            showText();
        } else if (!waits_) {
            waits_ = true;
            setMinimumHeight(isHidden() ? 0 : height());
            qApp->installEventFilter(this);
        }
    }
}

bool TroubleLine::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonRelease) {
        waits_ = false;
        qApp->removeEventFilter(this);
        QMetaObject::invokeMethod(this, &TroubleLine::showText, Qt::QueuedConnection);
    }
    return QLabel::eventFilter(watched, event);
}

void TroubleLine::showText() {
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
        field->setToolTip(hint);
    }
    name->setToolTip(field->toolTip());
    QString spoken = withoutMnemonic(label);
    if (!unit.isEmpty()) {
        spoken += QStringLiteral(", ") + unit;
    }
    field->setAccessibleName(spoken);
    const bool isNumber = qobject_cast<NumberField*>(field) != nullptr;
    if (unit.isEmpty() && !isNumber) {
        grid_->addWidget(new NamedRow(name, field, this), row_, 0, 1, 3);
    } else if (unit.isEmpty()) {
        grid_->addWidget(name, row_, 0);
        grid_->addWidget(field, row_, 1, Qt::AlignRight);  // under those that have a unit
    } else {
        grid_->addWidget(name, row_, 0);
        // A field narrower than its column stands at its unit, under the fields of other sections.
        const bool narrow = field->maximumWidth() < QWIDGETSIZE_MAX;
        grid_->addWidget(field, row_, 1, narrow ? Qt::AlignRight : Qt::Alignment());
        auto* unitLabel = new QLabel(unit, this);
        colourText(unitLabel, &Theme::mutedText);
        grid_->addWidget(unitLabel, row_, 2);
        if (auto* entry = qobject_cast<QLineEdit*>(field)) {
            new UnitBeside(entry, unitLabel);
        }
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
    value->setToolTip(hint);
    name->setToolTip(hint);
    value->setAccessibleName(withoutMnemonic(label));
    colourText(name, &Theme::mutedText);
    grid_->addWidget(name, row_, 0);
    grid_->addWidget(value, row_, 1, 1, 2);
    ++row_;
    return value;
}

}  // namespace ravnoves

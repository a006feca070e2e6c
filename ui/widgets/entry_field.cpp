#include "widgets/entry_field.h"

#include <QFocusEvent>
#include <QHelpEvent>
#include <QInputDialog>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <utility>

#include "text/tip_text.h"
#include "theme/theme.h"

namespace ravnoves {

EntryField::EntryField(QWidget* parent) : QLineEdit(parent) {
    constexpr int longest = 1000;  // letters; a table that is pasted by a slip of the keys has more
    limitLength(this, longest);
    connect(this, &QLineEdit::textEdited, this, [this] {
        beginEditing();
        if (text() == shown_) {
            bringBack();  // the value may have more digits than are shown
            setTrouble({});
            showHowRead({});
        } else {
            readText();
        }
        if (!trouble_.isEmpty() && model_ != nullptr) {
            model_->noteRejected(this, true);  // another text is rejected now
        }
    });
    connect(this, &QLineEdit::editingFinished, this, [this] {
        if (trouble_.isEmpty()) {
            showValue();
        }
        endEditing();
    });
}

void EntryField::setModel(SceneModel* model) {
    model_ = model;
    connect(model, &SceneModel::rejected, this, [this](const QString& why) {
        if (isPassing_) {
            rejection_ = why;
        }
    });
    connect(model, &SceneModel::changed, this, [this] {
        if (isOfModel_ && !editing_) {
            noteStale();
        }
    });
    connect(model, &SceneModel::changed, this, &EntryField::tryLater);
    connect(model, &SceneModel::historyChanged, this, &EntryField::tryLater);
    connect(model, &SceneModel::rested, this, &EntryField::tryLater);
    connect(model, &SceneModel::typedKept, this, [this] {
        if (editing_ && trouble_.isEmpty()) {
            keepValue();
            shown_ = text();
        }
    });
    connect(model, &SceneModel::broughtIn, this, [this] {
        if (!trouble_.isEmpty()) {
            setTrouble({});
            showValue();
            endEditing();
        }
    });
}

void EntryField::setHint(const QString& hint) {
    hint_ = hint;
    describe();
}

void EntryField::setDoubtful(bool isDoubtful) {
    if (isDoubtful != isDoubtful_) {
        isDoubtful_ = isDoubtful;
        update();
    }
}

void EntryField::showValue() {
    shown_ = written();
    setMaxLength(std::max(maxLength(), static_cast<int>(shown_.size())));
    setText(shown_);
    setCursorPosition(0);
}

void EntryField::beginEditing() {
    if (!editing_) {
        editing_ = true;
        keepValue();
        if (model_ != nullptr) {
            model_->beginEditing();
        }
    }
}

void EntryField::tryAgain() {
    beginEditing();
    readText();
}

void EntryField::noteStale() {
    isOfModel_ = false;
    isStale_ = true;
    showTrouble(
        tr("Not accepted before other values changed; press Enter to try again: %1").arg(trouble_));
}

void EntryField::readLater() {
    if (!isStale_) {
        noteStale();
    }
    tryLater();
}

void EntryField::tryLater() {
    // Queued: what changes is a step of the history by then, and the focus where it goes.
    if (isStale_) {
        QMetaObject::invokeMethod(this, &EntryField::tryStale, Qt::QueuedConnection);
    }
}

void EntryField::tryStale() {
    if (!isStale_ || editing_ ||
        (model_ != nullptr && (model_->isEditing() || model_->isMoved()))) {
        return;
    }
    tryAgain();
    if (trouble_.isEmpty()) {
        showValue();
        if (hasFocus()) {
            selectAll();  // as the focus found it
        }
    }
    endEditing();
}

void EntryField::endEditing() {
    if (std::exchange(editing_, false)) {
        if (model_ != nullptr) {
            model_->endEditing(!trouble_.isEmpty());
        }
    }
}

void EntryField::setTrouble(const QString& trouble, bool isOfModel) {
    isOfModel_ = isOfModel;
    isStale_ = false;
    if (trouble == trouble_) {
        return;
    }
    if (model_ != nullptr) {
        model_->noteRejected(this, !trouble.isEmpty());
    }
    showTrouble(trouble);
}

void EntryField::showTrouble(const QString& trouble) {
    trouble_ = trouble;
    describe();
    Q_EMIT troubleChanged();
    update();
}

void EntryField::showHowRead(const QString& note) {
    if (std::exchange(howRead_, note) != note) {
        Q_EMIT troubleChanged();
    }
}

void EntryField::describe() {
    QStringList tip{trouble_, hint_, rule()};
    tip.removeAll(QString());
    if (!hint_.isEmpty() || !rule().isEmpty()) {
        setToolTip(tipText(tip.join(QLatin1Char('\n'))));
        setWhatsThis(toolTip());
    }
    setAccessibleDescription(trouble_.isEmpty() ? hint_ : trouble_);
}

bool EntryField::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        constexpr int margins = 8;
        const bool isHintCut = text().isEmpty() && fontMetrics().horizontalAdvance(
                                                       placeholderText()) > width() - margins;
        QStringList lines{isHintCut ? placeholderText() : wholeText(), toolTip()};
        lines.removeAll(QString());
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                           lines.join(QLatin1Char('\n')), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool undoes = key->matches(QKeySequence::Undo);
        const bool redoes =
            key->matches(QKeySequence::Redo) || key->keyCombination() == (Qt::CTRL | Qt::Key_Y);
        if ((undoes && !(isUndoAvailable() && text() != written())) ||
            (redoes && !isRedoAvailable())) {
            event->ignore();
            return true;  // the document's
        }
    }
    return QLineEdit::event(event);
}

void EntryField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && (editing_ || !trouble_.isEmpty())) {
        if (editing_) {
            bringBack();
        }
        setTrouble({});
        showHowRead({});
        showValue();
        endEditing();
        return;
    }
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && !trouble_.isEmpty()) {
        tryAgain();  // other values may have corrected it
        if (!trouble_.isEmpty()) {
            selectAll();  // what is typed next takes its place
        }
    }
    if (event->modifiers().testFlag(Qt::AltModifier) && !event->text().isEmpty() &&
        event->text().front().isPrint()) {
        event->ignore();  // a key of the window, also where the window has no use for it now
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void EntryField::focusInEvent(QFocusEvent* event) {
    isEntered_ = isReplaced() && event->reason() == Qt::MouseFocusReason;
    QLineEdit::focusInEvent(event);
}

void EntryField::mouseReleaseEvent(QMouseEvent* event) {
    QLineEdit::mouseReleaseEvent(event);
    if (std::exchange(isEntered_, false) && !hasSelectedText()) {
        selectAll();
    }
}

void EntryField::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LocaleChange && trouble_.isEmpty()) {
        showValue();
        describe();
    } else if (event->type() == QEvent::EnabledChange && !isEnabledTo(parentWidget()) &&
               !trouble_.isEmpty()) {
        setTrouble({});  // nobody could correct it
        showValue();
        endEditing();
    }
    QLineEdit::changeEvent(event);
}

void EntryField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (!trouble_.isEmpty() || isDoubtful_) {
        const Theme& theme = Theme::instance();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(trouble_.isEmpty() ? theme.warning() : theme.error(), 2.0));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 2, 2);
    }
}

QString cutText(int longest) {
    return EntryField::tr("Cut: at most %1 characters.").arg(longest);
}

void limitLength(QLineEdit* field, int longest) {
    field->setMaxLength(std::max(longest, static_cast<int>(field->text().size())));
    QObject::connect(field, &QLineEdit::inputRejected, field, [field] {
        QToolTip::showText(field->mapToGlobal(QPoint(0, field->height())),
                           cutText(field->maxLength()), field);
    });
}

std::optional<QString> askName(QWidget* parent, const QString& title, const QString& label,
                               const QString& name) {
    QInputDialog dialog(parent);
    dialog.setWindowTitle(title);
    dialog.setLabelText(label);
    dialog.setTextValue(name);
    constexpr int longest = 200;
    if (auto* field = dialog.findChild<QLineEdit*>()) {
        limitLength(field, longest);
    }
    return dialog.exec() == QDialog::Accepted ? std::optional(dialog.textValue()) : std::nullopt;
}

}  // namespace ravnoves

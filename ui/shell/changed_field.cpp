#include "shell/changed_field.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QPointer>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTimer>
#include <algorithm>
#include <vector>

#include "page/scene_page.h"
#include "theme/theme.h"
#include "widgets/entry_field.h"
#include "widgets/page_columns.h"

namespace ravnoves {

namespace {

struct Shown {
    QPointer<QWidget> field;
    QString text;
};

bool isField(const QWidget* widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    return qobject_cast<const EntryField*>(widget) != nullptr ||
           qobject_cast<const QComboBox*>(widget) != nullptr ||
           (button != nullptr && button->isCheckable());
}

QString shownIn(const QWidget* field) {
    if (const auto* entry = qobject_cast<const EntryField*>(field)) {
        return entry->text();
    }
    if (const auto* list = qobject_cast<const QComboBox*>(field)) {
        return list->currentText();
    }
    return qobject_cast<const QAbstractButton*>(field)->isChecked() ? QStringLiteral("1")
                                                                    : QString();
}

/// Nothing but a tab hides it.
bool canBeShown(const QWidget* field, const QWidget* page) {
    for (; field != page; field = field->parentWidget()) {
        const bool isInTab = qobject_cast<QStackedWidget*>(field->parentWidget()) != nullptr;
        if (!isInTab && field->isHidden()) {
            return false;
        }
    }
    return true;
}

void scrollTo(QWidget* field) {
    for (QWidget* each = field->parentWidget(); each != nullptr; each = each->parentWidget()) {
        if (auto* scroll = qobject_cast<QScrollArea*>(each)) {
            scroll->ensureWidgetVisible(field, 0, 2 * Theme::margin);
        }
    }
}

void show(QWidget* field) {
    showTabOf(field);
    scrollTo(field);
    // What was hidden is laid out later.
    QTimer::singleShot(0, field, [field] { scrollTo(field); });
}

}  // namespace

void showWhatChanges(ScenePage& page, const std::function<void(SceneModel&)>& step) {
    std::vector<Shown> before;
    for (QWidget* each : page.findChildren<QWidget*>()) {
        if (isField(each)) {
            before.push_back({each, shownIn(each)});
        }
    }
    step(*page.model());
    std::erase_if(before, [&](const Shown& was) {
        return was.field == nullptr || !was.field->isEnabled() || shownIn(was.field) == was.text ||
               !canBeShown(was.field, &page);
    });
    if (before.empty()) {
        return;
    }
    const auto seen = std::find_if(before.begin(), before.end(), [](const Shown& was) {
        return !was.field->visibleRegion().isEmpty();
    });
    QWidget* field = (seen != before.end() ? *seen : before.front()).field;
    const QWidget* at = page.window()->focusWidget();
    const bool wasHidden = !field->isVisible();
    show(field);
    if (wasHidden || (at != nullptr && page.isAncestorOf(at) && isField(at))) {
        field->setFocus(Qt::OtherFocusReason);
    }
}

}  // namespace ravnoves

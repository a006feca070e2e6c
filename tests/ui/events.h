#pragma once

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QMessageBox>
#include <QMouseEvent>
#include <QTabWidget>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <QWidget>
#include <algorithm>

#include "comes.h"  // IWYU pragma: export

namespace ravnoves::test {

/// A turn of the wheel by `notches` over a point of a widget.
inline void turnWheel(QWidget* widget, const QPoint& at, int notches,
                      Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWheelEvent event(at, widget->mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton,
                      modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
}

/// Moves the pointer over a widget; QTest's own moves have no button down.
inline void movePointer(QWidget* widget, const QPointF& to, Qt::MouseButtons buttons = {}) {
    QMouseEvent event(QEvent::MouseMove, to, widget->mapToGlobal(to), Qt::NoButton, buttons,
                      Qt::NoModifier);
    QApplication::sendEvent(widget, &event);
}

/// Drags from one place of a widget to another in so many steps.
inline void drag(QWidget* widget, const QPoint& from, const QPoint& to, int steps = 10) {
    QTest::mousePress(widget, Qt::LeftButton, {}, from);
    for (int step = 1; step <= steps; ++step) {
        movePointer(widget, from + (to - from) * step / steps, Qt::LeftButton);
    }
    QTest::mouseRelease(widget, Qt::LeftButton, {}, to);
}

/// The widget of that name below another; where there is none, the test fails.
template <typename Widget>
Widget* named(const QWidget& parent, const char* name) {
    auto* found = parent.findChild<Widget*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
}

/// Types over what is in a field.
template <typename Field>
void typeOver(Field* field, const QString& text) {
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
}

/// The same, and presses Enter.
template <typename Field>
void type(Field* field, const QString& text) {
    typeOver(field, text);
    QTest::keyClick(field, Qt::Key_Return);
}

/// Shows a widget at a size and waits until it is drawn.
inline void showAt(QWidget& widget, const QSize& size) {
    widget.resize(size);
    widget.show();
    QApplication::processEvents();
    QApplication::processEvents();
}

/// Brings each tab of a page to the front in turn, and looks.
template <typename Look>
void onEveryTab(const QWidget& page, Look look) {
    for (QTabWidget* tabs : page.findChildren<QTabWidget*>()) {
        for (int i = 0; i < tabs->count(); ++i) {
            tabs->setCurrentIndex(i);
            QApplication::processEvents();
            look();
        }
    }
}

/// Points at a place of a widget until what it says there holds: a view made again under the
/// pointer reads nothing until the pointer moves again, and its place may be another.
template <typename Place, typename Holds>
bool pointUntil(QWidget* widget, Place place, Holds holds) {
    return comes([&] {
        const QPointF at = place();
        QTest::mouseMove(widget, at.toPoint() + QPoint(1, 0));
        QTest::mouseMove(widget, at.toPoint());
        return holds();
    });
}

/// Presses a key in a window that comes to the front: a message may have been there.
inline void pressIn(QWidget& window, Qt::Key key,
                    Qt::KeyboardModifiers modifiers = Qt::ControlModifier) {
    QApplication::processEvents();
    ASSERT_TRUE(becomesActive(window));
    QTest::keyClick(&window, key, modifiers);
}

/// The first action of a window that fits; where there is none, the test fails.
template <typename Fits>
QAction* actionWhere(const QWidget& window, Fits fits) {
    const QList<QAction*> all = window.findChildren<QAction*>();
    const auto found = std::find_if(all.begin(), all.end(), fits);
    EXPECT_NE(found, all.end());
    return found == all.end() ? nullptr : *found;
}
inline QAction* actionNamed(const QWidget& window, const QString& begins) {
    SCOPED_TRACE(begins.toStdString());
    return actionWhere(window, [&](const QAction* action) {
        return action->text().remove(QLatin1Char('&')).startsWith(begins);
    });
}
inline QAction* actionOfKeys(const QWidget& window, const QKeySequence& keys) {
    SCOPED_TRACE(keys.toString().toStdString());
    return actionWhere(window, [&](const QAction* action) { return action->shortcut() == keys; });
}

/// Acts once on the next modal dialog of that kind, as soon as it is there.
/// @param context  while it lives
template <typename Dialog, typename Act>
void whenModal(QObject* context, Act act) {
    QTimer::singleShot(10, context, [context, act] {
        if (auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget())) {
            act(dialog);
        } else {
            whenModal<Dialog>(context, act);
        }
    });
}

/// Clicks the button of the next question that has these words, and passes on what is asked.
template <typename Hear>
void answerWith(QObject* context, const QString& words, Hear hear) {
    whenModal<QMessageBox>(context, [=](QMessageBox* box) {
        hear(box->text());
        for (QAbstractButton* button : box->buttons()) {
            if (button->text().remove(QLatin1Char('&')) == words) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        ADD_FAILURE() << "no button " << words.toStdString();
        box->reject();
    });
}

}  // namespace ravnoves::test

#include "pictures/wheel_guard.h"

#include <QApplication>
#include <QComboBox>
#include <QFocusEvent>
#include <QPointer>
#include <QSlider>

namespace ravnoves {

namespace {

/// Where the user went last, by a click, a key or its letter. What merely has the focus, for it is
/// the first of a page that came to the front, is not turned: nobody meant it.
QPointer<QWidget> wentTo;

class WheelGuard : public QObject {
  public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (!watched->isWidgetType()) {
            return false;
        }
        auto* widget = static_cast<QWidget*>(watched);
        switch (event->type()) {
            case QEvent::Polish:
                if (isGuarded(widget) && widget->focusPolicy() == Qt::WheelFocus) {
                    widget->setFocusPolicy(
                        Qt::StrongFocus);  // the wheel does not give it the focus
                }
                return false;
            case QEvent::FocusIn:
                goTo(widget, static_cast<QFocusEvent*>(event)->reason());
                return false;
            case QEvent::Wheel:
                // A closed list shows one word alone: what a notch makes of it is seen too late.
                if (!isGuarded(widget) || (isWheelOf(widget) && !isList(widget))) {
                    return false;
                }
                event->ignore();
                return true;
            case QEvent::MouseButtonPress:
            case QEvent::KeyPress:
                if (widget->hasFocus()) {
                    wentTo = widget;
                }
                return false;
            default:
                return false;
        }
    }

  private:
    static bool isList(const QWidget* widget) {
        return qobject_cast<const QComboBox*>(widget) != nullptr;
    }
    static bool isGuarded(const QWidget* widget) {
        return isList(widget) || qobject_cast<const QSlider*>(widget) != nullptr;
    }
    static void goTo(QWidget* widget, Qt::FocusReason reason) {
        switch (reason) {
            case Qt::MouseFocusReason:
            case Qt::TabFocusReason:
            case Qt::BacktabFocusReason:
            case Qt::ShortcutFocusReason:
                wentTo = widget;
                break;
            case Qt::ActiveWindowFocusReason:
            case Qt::PopupFocusReason:
            case Qt::MenuBarFocusReason:
                break;  // it comes back to where it was
            default:
                if (wentTo == widget) {
                    wentTo = nullptr;
                }
        }
    }
};

}  // namespace

void guardWheel() {
    static QPointer<WheelGuard> guard;
    if (guard.isNull()) {
        guard = new WheelGuard(qApp);
        qApp->installEventFilter(guard);
    }
}

bool isWheelOf(const QWidget* widget) {
    return widget->hasFocus() && wentTo == widget;
}

}  // namespace ravnoves

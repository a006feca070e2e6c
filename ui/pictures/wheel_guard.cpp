#include "pictures/wheel_guard.h"

#include <QApplication>
#include <QComboBox>
#include <QFocusEvent>
#include <QPointer>
#include <QSlider>

namespace ravnoves {

namespace {

/// The wheel turns the field that the user went to, by a click, a key or its letter. One that
/// merely has the focus, for it is the first of a page that came to the front, is not turned:
/// nobody meant it.
class WheelGuard : public QObject {
  public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        const bool isList = qobject_cast<QComboBox*>(watched) != nullptr;
        if (!isList && qobject_cast<QSlider*>(watched) == nullptr) {
            return false;
        }
        auto* widget = static_cast<QWidget*>(watched);
        switch (event->type()) {
            case QEvent::Polish:
                if (widget->focusPolicy() == Qt::WheelFocus) {
                    widget->setFocusPolicy(
                        Qt::StrongFocus);  // the wheel does not give it the focus
                }
                return false;
            case QEvent::FocusIn: {
                const FocusWay way = focusWay(static_cast<QFocusEvent*>(event)->reason());
                if (way != FocusWay::back) {
                    chosen_ = way == FocusWay::went ? widget : nullptr;
                }
                return false;
            }
            case QEvent::Wheel:
                // A closed list shows one word alone: what a notch makes of it is seen too late.
                if (widget->hasFocus() && chosen_ == widget && !isList) {
                    return false;
                }
                event->ignore();
                return true;
            case QEvent::MouseButtonPress:
            case QEvent::KeyPress:
                chosen_ = widget;
                return false;
            default:
                return false;
        }
    }

  private:
    QPointer<QWidget> chosen_;
};

}  // namespace

FocusWay focusWay(Qt::FocusReason reason) {
    switch (reason) {
        case Qt::MouseFocusReason:
        case Qt::TabFocusReason:
        case Qt::BacktabFocusReason:
        case Qt::ShortcutFocusReason:
            return FocusWay::went;
        case Qt::ActiveWindowFocusReason:
        case Qt::PopupFocusReason:
        case Qt::MenuBarFocusReason:
            return FocusWay::back;
        default:
            return FocusWay::other;
    }
}

void guardWheel() {
    static QPointer<WheelGuard> guard;
    if (guard.isNull()) {
        guard = new WheelGuard(qApp);
        qApp->installEventFilter(guard);
    }
}

}  // namespace ravnoves

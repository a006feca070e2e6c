#include "widgets/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QPointer>
#include <QSlider>

namespace ravnoves {

namespace {

class WheelGuard : public QObject {
  public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        const QEvent::Type type = event->type();
        if (type != QEvent::Wheel && type != QEvent::Polish) {
            return false;
        }
        if (qobject_cast<QComboBox*>(watched) == nullptr &&
            qobject_cast<QAbstractSpinBox*>(watched) == nullptr &&
            qobject_cast<QSlider*>(watched) == nullptr) {
            return false;
        }
        auto* widget = static_cast<QWidget*>(watched);
        if (type == QEvent::Polish) {
            if (widget->focusPolicy() == Qt::WheelFocus) {
                widget->setFocusPolicy(Qt::StrongFocus);  // the wheel does not give it the focus
            }
            return false;
        }
        if (widget->hasFocus()) {
            return false;
        }
        event->ignore();
        return true;
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

}  // namespace ravnoves

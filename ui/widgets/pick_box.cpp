#include "widgets/pick_box.h"

#include <QAbstractItemView>
#include <QKeyEvent>
#include <QWheelEvent>
#include <utility>

namespace ravnoves {

PickBox::PickBox(QString prompt, QWidget* parent) : QComboBox(parent), prompt_(std::move(prompt)) {
    clearEntries();
    connect(this, &QComboBox::activated, this, [this](int index) {
        const QVariant data = itemData(index);
        setCurrentIndex(0);
        if (data.isValid()) {
            Q_EMIT picked(data);
        }
    });
}

void PickBox::clearEntries() {
    clear();
    addItem(prompt_);
}

void PickBox::keyPressEvent(QKeyEvent* event) {
    const QString text = event->text();
    const bool isText = !text.isEmpty() && text.front().isPrint() &&
                        (event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == 0;
    switch (event->key()) {
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
        case Qt::Key_Home:
        case Qt::Key_End:
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
        case Qt::Key_F4:
            showPopup();
            return;
        default:
            break;
    }
    if (isText) {
        showPopup();
        view()->keyboardSearch(text);
    } else {
        event->ignore();
    }
}

void PickBox::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

}  // namespace ravnoves

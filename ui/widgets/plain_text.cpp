#include "widgets/plain_text.h"

#include <QCursor>
#include <QEvent>
#include <QLabel>
#include <QScreen>
#include <algorithm>

#include "widgets/application_filter.h"

namespace ravnoves {

namespace {

/// A label is polished before its size is asked for, hence before it reads its text.
class PlainText : public QObject {
  public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Polish) {
            if (auto* label = qobject_cast<QLabel*>(watched);
                label != nullptr && label->textFormat() == Qt::AutoText) {
                label->setTextFormat(Qt::PlainText);
                wrapTip(*label);
            }
        } else if (event->type() == QEvent::Resize) {
            // Another text in a tip that is seen.
            if (auto* label = qobject_cast<QLabel*>(watched);
                label != nullptr && label->isWindow() && wrapTip(*label)) {
                const QRect before = label->geometry();
                label->resize(label->sizeHint() + QSize(1, 0));
                putBeside(*label, before);
            }
        }
        return false;
    }

  private:
    /// Qt has placed the tip by its width in one line: left of the pointer, where there was no
    /// room.
    static void putBeside(QLabel& tip, const QRect& before) {
        constexpr int apart = 2;  // pixels
        const QPoint pointer = QCursor::pos();
        if (tip.screen() == nullptr) {
            return;
        }
        const QRect screen = tip.screen()->geometry();
        int x = tip.x();
        // That of the pointer, and not yet right of it.
        if (pointer.x() >= before.left() && pointer.x() <= before.right() + 4 * apart) {
            const int right = pointer.x() + apart;
            x = right + tip.width() <= screen.right() + 1
                    ? right
                    : std::max(screen.left(), pointer.x() - apart - tip.width());
        }
        const bool hasRoom = tip.y() + tip.height() <= screen.bottom() + 1;
        tip.move(x, hasRoom ? tip.y()
                            : std::max(screen.top(), std::min(pointer.y(), screen.bottom()) -
                                                         apart - tip.height()));
    }

    /// Qt leaves a line of a plain tip as long as it is. @return whether it was too long
    static bool wrapTip(QLabel& label) {
        if (label.wordWrap() || !label.inherits("QTipLabel")) {
            return false;
        }
        constexpr int longest = 80;  // letters
        const QFontMetrics metrics = label.fontMetrics();
        if (metrics.size(0, label.text()).width() <= longest * metrics.averageCharWidth()) {
            return false;
        }
        label.setWordWrap(true);
        return true;
    }
};

}  // namespace

void keepTextPlain() {
    filterApplication<PlainText>();
}

}  // namespace ravnoves

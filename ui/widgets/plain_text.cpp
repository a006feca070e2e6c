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
        const int pointer = QCursor::pos().x();
        if (tip.screen() == nullptr || pointer < before.left() ||
            pointer > before.right() + 4 * apart) {
            return;  // it is not that of the pointer, or stands right of it
        }
        const QRect screen = tip.screen()->geometry();
        const int right = pointer + apart;
        const int left = std::max(screen.left(), pointer - apart - tip.width());
        const int above = std::max(screen.top(), QCursor::pos().y() - apart - tip.height());
        tip.move(right + tip.width() <= screen.right() + 1 ? right : left,
                 tip.y() + tip.height() <= screen.bottom() + 1 ? tip.y() : above);
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

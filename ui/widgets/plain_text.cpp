#include "widgets/plain_text.h"

#include <QEvent>
#include <QLabel>

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
                label->resize(label->sizeHint() + QSize(1, 0));
            }
        }
        return false;
    }

  private:
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

#include "widgets/plain_text.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>
#include <QPointer>

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
            }
        }
        return false;
    }
};

}  // namespace

void keepTextPlain() {
    static QPointer<PlainText> filter;
    if (filter.isNull()) {
        filter = new PlainText(qApp);
        qApp->installEventFilter(filter);
    }
}

}  // namespace ravnoves

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
            }
        }
        return false;
    }
};

}  // namespace

void keepTextPlain() {
    filterApplication<PlainText>();
}

}  // namespace ravnoves

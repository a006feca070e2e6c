#include "theme/one_painter.h"

#include <QRunnable>
#include <QThreadPool>
#include <QtGlobal>
#include <functional>
#include <utility>

namespace ravnoves {

void paintInOneThread() {
    if (qEnvironmentVariableIsEmpty("QT_NO_GUI_THREADPOOL")) {
        qputenv("QT_NO_GUI_THREADPOOL", "1");
    }
}

}  // namespace ravnoves

#if QT_VERSION < QT_VERSION_CHECK(6, 5, 0)
// Qt 6.4 does not know that variable. Its painting hands functions to the pool of the program and
// waits for them: a translucent piston of a hundred pixels costs two threads. So the program has
// this member of its own, which the linker takes in place of Qt's: what the pool of the program is
// given as a function is done at once. Nothing else in Qt gives it functions, nor do we; runnables,
// and functions in other pools, go the usual way.
void QThreadPool::start(std::function<void()> work, int priority) {
    if (!work) {
        return;
    }
    if (this == globalInstance()) {
        work();
    } else {
        start(QRunnable::create(std::move(work)), priority);
    }
}
#endif

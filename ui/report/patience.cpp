#include "report/patience.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QThread>

namespace ravnoves {

void Patience::wait() const {
    QCoreApplication::processEvents(isCancelled_ ? QEventLoop::AllEvents
                                                 : QEventLoop::ExcludeUserInputEvents);
    if (isCancelled_ && isCancelled_()) {
        throw ReportCancelled();
    }
}

void Patience::waitWhile(const std::function<bool()>& isBusy, qint64 longest) const {
    QElapsedTimer waited;
    waited.start();
    for (wait(); isBusy() && waited.elapsed() < longest; wait()) {
        QThread::msleep(10);
    }
}

}  // namespace ravnoves

#include "report/patience.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QThread>
#include <utility>

namespace ravnoves {

Patience::Patience(std::function<bool()> isCancelled,
                   std::function<void(const QString&, double)> tell)
    : isCancelled_(std::move(isCancelled)), tell_(std::move(tell)) {}

void Patience::tell(const QString& stage, double part) const {
    if (tell_) {
        tell_(stage, part);
    }
}

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

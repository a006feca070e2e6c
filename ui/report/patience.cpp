#include "report/patience.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>
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

void Patience::wait(int longest) const {
    const QEventLoop::ProcessEventsFlags flags =
        isCancelled_ ? QEventLoop::AllEvents : QEventLoop::ExcludeUserInputEvents;
    if (longest > 0) {
        // processEvents() with a time looks for events without a pause instead of waiting.
        QEventLoop loop;
        QTimer::singleShot(longest, &loop, [] {});
        loop.processEvents(flags | QEventLoop::WaitForMoreEvents);
    } else {
        QCoreApplication::processEvents(flags);
    }
    if (isCancelled_ && isCancelled_()) {
        throw ReportCancelled();
    }
}

void Patience::waitWhile(const std::function<bool()>& isBusy, qint64 longest) const {
    QElapsedTimer waited;
    waited.start();
    wait();
    while (isBusy() && waited.elapsed() < longest) {
        wait(20);
    }
}

}  // namespace ravnoves

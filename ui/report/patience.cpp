#include "report/patience.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>
#include <cmath>
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

Patience Patience::of(double from, double to) const {
    return Patience(isCancelled_, [tell = tell_, from, to](const QString& stage, double part) {
        if (tell) {
            tell(stage, std::lerp(from, to, part));
        }
    });
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

}  // namespace ravnoves

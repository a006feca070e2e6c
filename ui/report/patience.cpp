#include "report/patience.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <utility>

namespace ravnoves {

Patience::Patience(std::function<bool()> isCancelled) : isCancelled_(std::move(isCancelled)) {}

void Patience::wait(int longest) const {
    const QEventLoop::ProcessEventsFlags flags =
        isCancelled_ ? QEventLoop::AllEvents : QEventLoop::ExcludeUserInputEvents;
    if (longest > 0) {
        QCoreApplication::processEvents(flags | QEventLoop::WaitForMoreEvents, longest);
    } else {
        QCoreApplication::processEvents(flags);
    }
    if (isCancelled_ && isCancelled_()) {
        throw ReportCancelled();
    }
}

}  // namespace ravnoves

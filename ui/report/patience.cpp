#include "report/patience.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <utility>

namespace ravnoves {

Patience::Patience(InDialog inDialog, std::function<bool()> isCancelled)
    : inDialog_(std::move(inDialog)), isCancelled_(std::move(isCancelled)) {}

void Patience::turn() const {
    wait(0);
}

void Patience::wait(int longest) const {
    QEventLoop::ProcessEventsFlags flags =
        inDialog_ && inDialog_() ? QEventLoop::AllEvents : QEventLoop::ExcludeUserInputEvents;
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

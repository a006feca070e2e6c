#include "widgets/background_job.h"

#include <QMetaObject>

namespace ravnoves {

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {
    pool_.setMaxThreadCount(1);
}

BackgroundJob::~BackgroundJob() {
    if (stop_) {
        *stop_ = true;
    }
    pool_.clear();
    pool_.waitForDone();  // its queued calls find no receiver and are dropped
}

void BackgroundJob::start(Work work) {
    if (stop_) {
        *stop_ = true;
    }
    stop_ = std::make_shared<std::atomic<bool>>(false);
    setRunning(true);
    pool_.start([this, work = std::move(work), stop = stop_] {
        if (*stop) {
            return;
        }
        const auto apply = work([this, stop](double part) {
            QMetaObject::invokeMethod(
                this,
                [this, stop, part] {
                    if (!*stop) {
                        Q_EMIT progressed(part);
                    }
                },
                Qt::QueuedConnection);
            return !*stop;
        });
        QMetaObject::invokeMethod(
            this,
            [this, stop, apply] {
                if (*stop) {
                    return;  // replaced or cancelled meanwhile
                }
                if (apply) {
                    apply();
                }
                setRunning(false);
                Q_EMIT finished();
            },
            Qt::QueuedConnection);
    });
}

void BackgroundJob::cancel() {
    if (stop_) {
        *stop_ = true;
    }
    setRunning(false);
}

void BackgroundJob::setRunning(bool running) {
    if (running_ != running) {
        running_ = running;
        Q_EMIT runningChanged(running);
    }
}

}  // namespace ravnoves

#include "model/background_job.h"

#include <QPointer>
#include <exception>
#include <system_error>
#include <utility>

#include "numerics/vector_state.h"
#include "text/error_text.h"

namespace ravnoves {

namespace {

constexpr qint64 reportMs = 5;  ///< between two reports of progress

}  // namespace

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {
    pause_.setSingleShot(true);
    pause_.setTimerType(Qt::PreciseTimer);  // a coarse one ends a twentieth before
    connect(&pause_, &QTimer::timeout, this, &BackgroundJob::launch);
}

BackgroundJob::~BackgroundJob() {
    if (stop_) {
        *stop_ = true;
    }
    if (thread_.joinable()) {
        thread_.join();
    }
}

void BackgroundJob::setPatience(int patienceMs, int pauseMs, bool untilRest) {
    patienceMs_ = patienceMs;
    untilRest_ = untilRest;
    pause_.setInterval(pauseMs);
}

void BackgroundJob::start(Work work) {
    pending_ = std::move(work);
    setRunning(true);
    if (stop_) {
        if (clock_.elapsed() > patienceMs_) {
            *stop_ = true;
        }
    } else if (patienceMs_ < 0) {
        launch();
    } else if (untilRest_ || !pause_.isActive()) {
        pause_.start();
    }
}

void BackgroundJob::launch() {
    if (!pending_ || stop_) {
        return;
    }
    stop_ = std::make_shared<std::atomic<bool>>(false);
    clock_.start();
    if (thread_.joinable()) {
        thread_.join();  // it has told its end
    }
    const auto work = std::make_shared<Work>(std::exchange(pending_, nullptr));
    const auto runs = [this, work, stop = stop_] { run(*work, stop); };
    try {
        thread_ = std::thread(runs);
    } catch (const std::system_error&) {
        runs();  // no memory for its stack, or as many threads as this user may have
    }
}

void BackgroundJob::run(Work& work, const std::shared_ptr<std::atomic<bool>>& stop) {
    stopOfWork_ = stop;
    QElapsedTimer sinceReport;
    sinceReport.start();
    const auto report = [&](double part) {
        if (sinceReport.elapsed() >= reportMs) {
            sinceReport.restart();
            post([this, stop, part] {
                if (!*stop) {
                    Q_EMIT progress(part);
                }
            });
        }
        return !*stop;
    };
    std::function<void()> apply;
    clear_vector_state();
    try {
        apply = work(report);
    } catch (...) {
        apply = [this, thrown = std::current_exception()] { Q_EMIT failed(errorText(thrown)); };
    }
    work = nullptr;  // what it holds goes in this thread
    post([this, stop, apply = std::move(apply)] { done(*stop, apply); });
}

void BackgroundJob::post(std::function<void()> telling) {
    {
        const std::lock_guard lock(mutex_);
        reports_.push_back(std::move(telling));
    }
    QMetaObject::invokeMethod(this, &BackgroundJob::tell, Qt::QueuedConnection);
}

void BackgroundJob::tellSoFar(std::function<void()> telling) {
    post([stop = stopOfWork_, telling = std::move(telling)] {
        if (!*stop) {
            telling();
        }
    });
}

void BackgroundJob::tell() {
    const QPointer<BackgroundJob> self(this);
    while (self) {  // what is told may end it
        std::function<void()> telling;
        {
            const std::lock_guard lock(mutex_);
            if (reports_.empty()) {
                return;
            }
            telling = std::move(reports_.front());
            reports_.erase(reports_.begin());
        }
        telling();
    }
}

void BackgroundJob::done(const std::atomic<bool>& stopped, const std::function<void()>& apply) {
    const bool whole = !stopped;
    stop_.reset();
    if (whole && apply) {
        apply();
    }
    if (pending_ && !stop_) {
        if (patienceMs_ < 0) {
            launch();
        } else {
            pause_.start();
        }
    } else if (!stop_) {
        setRunning(false);
    }
    if (whole) {
        Q_EMIT finished();
    }
}

void BackgroundJob::cancel() {
    pending_ = nullptr;
    pause_.stop();
    if (stop_) {
        *stop_ = true;
    }
    setRunning(false);
}

void BackgroundJob::stop() {
    cancel();
    if (thread_.joinable()) {
        thread_.join();
    }
    tell();
}

void BackgroundJob::setRunning(bool running) {
    if (running_ != running) {
        running_ = running;
        Q_EMIT runningChanged(running);
    }
}

}  // namespace ravnoves

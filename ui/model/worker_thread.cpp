#include "model/worker_thread.h"

#include <QMetaObject>
#include <QPointer>
#include <chrono>
#include <system_error>
#include <utility>

namespace ravnoves {

WorkerThread::WorkerThread(QObject* parent) : QObject(parent) {}

WorkerThread::~WorkerThread() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void WorkerThread::begin(Task task) {
    {
        const std::lock_guard lock(mutex_);
        tasks_.push_back(std::move(task));
    }
    if (!thread_.joinable()) {
        try {
            thread_ = std::thread([this] { work(); });
        } catch (const std::system_error&) {
            workHere();  // no memory for its stack, or as many threads as this user may have
        }
    }
    changed_.notify_all();
}

void WorkerThread::post(Telling telling) {
    {
        const std::lock_guard lock(mutex_);
        done_.push_back(std::move(telling));
    }
    QMetaObject::invokeMethod(this, &WorkerThread::tell, Qt::QueuedConnection);
}

void WorkerThread::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return ends_ || !tasks_.empty(); });
        if (tasks_.empty()) {
            return;
        }
        isWorking_ = true;
        doFirst(lock);
        isWorking_ = false;
        changed_.notify_all();
    }
}

void WorkerThread::workHere() {
    std::unique_lock lock(mutex_);
    while (!tasks_.empty()) {
        doFirst(lock);
    }
}

void WorkerThread::doFirst(std::unique_lock<std::mutex>& lock) {
    {
        const Task task = std::move(tasks_.front());
        tasks_.pop_front();
        lock.unlock();
        if (Telling telling = task()) {
            post(std::move(telling));
        }
    }
    lock.lock();
}

void WorkerThread::tell() {
    const QPointer<WorkerThread> self(this);
    std::unique_lock lock(mutex_);
    while (!done_.empty()) {
        const Telling telling = std::move(done_.front());
        done_.pop_front();
        lock.unlock();
        telling();
        if (!self) {
            return;  // it was told that it is not needed any more
        }
        lock.lock();
    }
}

bool WorkerThread::wait(int ms) {
    bool done = false;
    {
        std::unique_lock lock(mutex_);
        done = changed_.wait_for(lock, std::chrono::milliseconds(ms),
                                 [this] { return tasks_.empty() && !isWorking_; });
    }
    tell();
    return done;
}

}  // namespace ravnoves

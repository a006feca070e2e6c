#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace ravnoves {

/// Tasks that run one after the other in a thread of its own; what comes of them is told in the
/// thread of this object. What passes between the two goes through one mutex, where a checker of
/// threads sees it (preset `tsan`). The thread begins with the first task; where the machine gives
/// none, that of this object does the work.
class WorkerThread : public QObject {
    Q_OBJECT

  public:
    using Telling = std::function<void()>;
    /// Runs in the thread and returns what is to be told; empty: nothing.
    using Task = std::function<Telling()>;

    explicit WorkerThread(QObject* parent = nullptr);
    /// What was begun comes to its end; nothing more is told.
    ~WorkerThread() override;

    /// The task throws nothing.
    void begin(Task task);
    /// From within a task: to be told before it ends.
    void post(Telling telling);
    /// Waits until all that was begun is done and told. @return false where it takes longer
    bool wait(int ms);

  private:
    void work();
    void workHere();
    void doFirst(std::unique_lock<std::mutex>& lock);
    void tell();

    std::mutex mutex_;  ///< of what follows
    std::condition_variable changed_;
    std::deque<Task> tasks_;
    std::deque<Telling> done_;
    bool isWorking_ = false;  ///< a task is under way
    bool ends_ = false;
    std::thread thread_;
};

}  // namespace ravnoves

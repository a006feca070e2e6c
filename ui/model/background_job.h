#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace ravnoves {

/// Runs one computation at a time off the GUI thread, with progress and cancel. The latest start
/// replaces the running one. One mutex guards what a thread reports, where a checker of threads
/// sees it (preset `tsan`). Without a thread from the machine, this object's does the work.
class BackgroundJob : public QObject {
    Q_OBJECT

  public:
    /// Called by the work with the part that is done, 0…1; false means stop.
    using Progress = std::function<bool(double)>;
    /// Runs in the worker thread and returns a function for the GUI thread; empty where it was
    /// cancelled. Its exceptions become failed().
    using Work = std::function<std::function<void()>(const Progress&)>;

    explicit BackgroundJob(QObject* parent = nullptr);
    ~BackgroundJob() override;

    /// For work that is started again with every step of a drag: a run no older than `patienceMs`
    /// comes to its end and delivers before the newest start follows, after a pause that leaves the
    /// machine to the drag's frames. An older run is stopped.
    /// @param untilRest  the pause is one after the last start: nothing runs while the hand moves
    void setPatience(int patienceMs, int pauseMs, bool untilRest = false);
    void start(Work work);
    /// Stops the run and discards its result.
    void cancel();
    /// The same, and waits until its thread is idle: until the work next reports its progress.
    void stop();
    bool isRunning() const { return running_; }
    /// From the work: runs this in the thread of this object unless the work is stopped by then.
    void tellSoFar(std::function<void()> telling);

  Q_SIGNALS:
    void progress(double part);
    void runningChanged(bool running);
    /// A run ended and its result is in use.
    void finished();
    /// A run ended with an exception, in the language of the program; finished() follows.
    void failed(const QString& why);

  private:
    void launch();
    /// In the thread of the work.
    void run(Work& work, const std::shared_ptr<std::atomic<bool>>& stop);
    /// From there: to be told in the thread of this object.
    void post(std::function<void()> telling);
    void tell();
    void done(const std::atomic<bool>& stopped, const std::function<void()>& apply);
    void setRunning(bool running);

    QTimer pause_;
    QElapsedTimer clock_;                      ///< of the work under way
    std::shared_ptr<std::atomic<bool>> stop_;  ///< of the present work; null without any
    Work pending_;                             ///< to follow
    int patienceMs_ = -1;
    bool untilRest_ = false;
    bool running_ = false;
    std::mutex mutex_;  ///< of reports_
    std::vector<std::function<void()>> reports_;
    std::thread thread_;                             ///< of one run
    std::shared_ptr<std::atomic<bool>> stopOfWork_;  ///< the thread's own
};

}  // namespace ravnoves

#pragma once

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>

namespace ravnoves {

/// Runs one computation at a time off the GUI thread, with progress and cancel; a new start
/// replaces the one that runs.
class BackgroundJob : public QObject {
    Q_OBJECT

  public:
    /// Called by the work with the part that is done, 0…1; false means stop.
    using Progress = std::function<bool(double)>;
    /// Runs in the worker thread and returns what is to be done with its result on the GUI thread;
    /// empty where it was cancelled.
    using Work = std::function<std::function<void()>(const Progress&)>;

    explicit BackgroundJob(QObject* parent = nullptr);
    ~BackgroundJob() override;

    void start(Work work);
    void cancel();
    bool isRunning() const { return running_; }

  Q_SIGNALS:
    void progressed(double part);
    void runningChanged(bool running);
    /// The last start came to its end and its result was taken over.
    void finished();

  private:
    void setRunning(bool running);

    QThreadPool pool_;
    std::shared_ptr<std::atomic<bool>> stop_;  ///< of the work that runs
    bool running_ = false;
};

}  // namespace ravnoves

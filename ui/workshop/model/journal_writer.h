#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <optional>

#include "model/worker_thread.h"
#include "workshop/model/journal.h"

namespace ravnoves {

/// Writes jobs and drafts into a journal that another Journal of this program has opened, one after
/// the other in a thread of its own: neither a slow disk nor another program that holds the journal
/// keeps the window from its keys. How a write ended is told in the thread of this object.
class JournalWriter : public QObject {
    Q_OBJECT

  public:
    /// How a draft ended.
    enum class Kept {
        Yes,
        Busy,  ///< another program is writing: to be tried again soon
        No
    };
    using JobTold = std::function<void(Journal::Saved, const JournalJob&, const QString& why)>;
    using DraftTold = std::function<void(Kept, const QString& why)>;

    /// @param session  whose drafts these are
    JournalWriter(const QString& path, const QString& session, QObject* parent = nullptr);
    /// What was begun comes to its end, but for what another program keeps waiting.
    ~JournalWriter() override;

    /// Opens its own journal and waits for that as long as Journal does; where it is open, another
    /// Journal is so at once. `said`: why not, or what happened to the file.
    using OpenTold = std::function<void(bool isOpen, bool isBusy, const QString& said)>;
    void open(OpenTold told);
    /// @param endsDraft  the session's draft has done its work once the job is saved
    void saveJob(const JournalJob& job, bool endsDraft, JobTold told);
    void saveDraft(const JournalDraft& draft, DraftTold told);
    void discardDraft(const QString& session);
    /// Waits until all that was begun is done and told. @return false where it takes longer
    bool wait(int ms) { return worker_.wait(ms); }

  Q_SIGNALS:
    /// A write begins to wait for that of another program.
    void waits();
    /// As Journal::reopened().
    void reopened(const QString& message);

  private:
    /// The journal as the thread has it, open if it can be.
    Journal& opened();

    const QString path_;
    const QString session_;
    std::atomic<bool> giveUp_ = false;
    std::optional<Journal> journal_;  ///< the thread's
    WorkerThread worker_;
};

}  // namespace ravnoves

#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>

#include "case-file/case_file.h"
#include "shop/job_header.h"
#include "shop/model/journal.h"
#include "shop/model/words.h"

namespace ravnoves {

class WorkshopModel;

/// The place of a job during the work: in the journal, and the language of its card. For a crash it
/// is kept as any case (model/recovery.h).
class JobDesk : public QObject {
    Q_OBJECT

  public:
    /// @param journalPath  the journal's file; empty: none is kept (pictures, tests)
    JobDesk(WorkshopModel* model, const QString& journalPath);

    /// Opens the journal; called once the page is shown. False: no journal, see journalTrouble().
    bool openJournal();
    Journal* journal() { return journal_.get(); }
    /// The backup offered in place of a damaged journal; empty without one.
    QString offeredBackup() const { return journal_ ? journal_->offeredBackup() : QString(); }
    bool isOpen() const { return journal_ && journal_->isOpen(); }
    /// The faults and news of the journal; empty without any.
    QString journalTrouble() const { return journalTrouble_; }
    void setJournalTrouble(const QString& text);

    /// Id of the job on the sheet; 0 where it is not in the journal.
    qint64 jobId() const { return jobId_; }
    int jobRevision() const { return jobRevision_; }
    /// Saving takes the place of that job of the journal; 0: of none.
    void setJob(qint64 id = 0, int revision = 0);
    /// `take` brings another job onto the sheet; a new one (0) is of no file.
    void replaceJob(qint64 id, int revision, const std::function<void()>& take);
    /// The engine of the job in the journal that saving would overwrite, where the sheet has
    /// another engine's or crankshaft's number or another kind of engine; empty else.
    QString otherEngine();
    /// The job in the journal that has the numbers and the day of the sheet, where the sheet came
    /// from elsewhere: from a file, or after a crash. One that is as the sheet is needs no question
    /// and becomes the sheet's.
    std::optional<JournalJob> sameJob();
    /// The verdict of the finished job in the journal that saving would put a withheld one in the
    /// place of; empty where it would not.
    QString verdictToLose();
    /// A job that is in no journal yet, and has nothing by which it could be found there.
    bool isNameless() const;
    /// True where the journal has the sheet in its present state, though a case file may not.
    bool isJournaled() const { return isJournaled_; }
    /// Saves the job on the sheet, finished or to be continued another day. One without an answer,
    /// or without a name to find it by, is not finished; an empty one is not saved.
    /// @return a sentence for the status bar; `ok` is whether it is saved
    QString saveJob(bool* ok = nullptr, bool isFinished = true);
    /// The same returns: a sentence.
    QString backUpJournal(const QString& file);
    /// For a worker: brings jobs back into the journal by a connection of its own. @return a
    /// sentence
    static QString restoreJournal(const QString& journal, const QString& file,
                                  const std::atomic<bool>& cancelled);
    /// What came with it is looked at.
    void takeRestored();
    /// Opens a job. @return an empty string, or what went wrong
    /// @param isCopy  its parts for another engine of the kind, as a new job
    QString openJob(qint64 id, bool isCopy = false);

    /// What the case of a job is known by: both numbers and the customer, where it has them. Empty
    /// for other cases.
    static QStringList wordsOf(const CaseFile& file);
    /// What the journal keeps of the head of a job card.
    static JournalJob entryOf(const shop::JobHeader& head);
    /// Who did the job that was saved last on this computer.
    static QString rememberedTechnician();

    /// Language of the job card: empty for the program's.
    QString cardLanguage() const { return cardLanguage_; }
    void setCardLanguage(const QString& code);
    Words cardWords() const;

  Q_SIGNALS:
    void journalTroubleChanged(const QString& text);

  private:
    /// A name alone makes no other engine.
    bool isSameEngine(const JournalJob& there, const JournalJob& here) const;
    void moveDrafts();
    void moveEngines();
    void takeSaved(const JournalJob& job);
    QString savedText(Journal::Saved saved, const JournalJob& job) const;
    QByteArray formText() const;
    bool isSameForm(const QByteArray& form) const;

    WorkshopModel* model_;
    QString cardLanguage_;
    QString journalPath_;
    std::unique_ptr<Journal> journal_;
    QString journalTrouble_;
    qint64 jobId_ = 0;
    int jobRevision_ = 0;
    bool isJournaled_ = false;
};

/// What lists of the journal's jobs say of one.
struct ListedJob {
    QString engine;
    QString result;
};
ListedJob listedJob(const Words& words, const JournalJob& job);

}  // namespace ravnoves

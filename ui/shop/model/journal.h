#pragma once

#include <QByteArray>
#include <QDate>
#include <QDateTime>
#include <QList>
#include <QLocale>
#include <QObject>
#include <QString>
#include <QVariant>
#include <atomic>
#include <optional>
#include <utility>

class QSqlDatabase;
class QSqlError;
class QSqlQuery;

namespace ravnoves {

/// A job as the journal keeps it. `form` is the case file of the job, from which the page shows it
/// again; the other values are what lists and searches show.
struct JournalJob {
    qint64 id = 0;     ///< 0 for a job that is not in the journal yet
    int revision = 0;  ///< counts the changes of a job; 0 for a new one
    QString scene;     ///< whose case `form` is
    QString engineNumber;
    QString crankshaftNumber;
    QString customer;
    QString technician;
    QString engine;  ///< name of the engine's type
    QDate date;
    QString process;                       ///< "manufacture" or "repair"
    std::optional<double> unbalancedMass;  ///< g
    QString recommended;                 ///< an option's name, "none-needed", "not-compensated" or
                                         ///< empty
    std::optional<double> reduction;     ///< g per plug
    std::optional<double> bobWeight;     ///< g, after the option
    std::optional<double> frontReading;  ///< g·mm, what the machine read at last
    std::optional<double> rearReading;   ///< g·mm
    QString verdict;                     ///< verdictWord()
    bool isFinished = true;              ///< false: put aside, to be continued
    QDateTime saved;                     ///< UTC
    QByteArray form;                     ///< JSON text, UTF-8

    /// Numbers of engine and crankshaft, and customer, as far as it has them: by these it is found.
    QStringList names() const;
    /// Of engine and crankshaft; a dash where it has none.
    QString numbers() const;

    friend bool operator==(const JournalJob&, const JournalJob&) = default;
};

/// An unfinished job that a version before the store of model/recovery.h kept for a crash.
struct JournalDraft {
    QString session;
    QString scene;
    qint64 jobId = 0;  ///< the job it changes; 0 for a new one
    int jobRevision = 0;
    QString engineNumber;
    QByteArray form;
};

/// An engine of the user's own, as a version that had a store of them kept it.
struct JournalEngine {
    QString name;
    QByteArray values;  ///< values that the scene keeps, JSON text
};

/// What came out of a backup.
struct JournalRestored {
    int added = 0;  ///< jobs that were not in the journal any more
    int known = 0;  ///< jobs that are there as they were
};

struct JournalQuery {
    /// In the numbers, customer, technician or engine, or a day or month ("2024-05"); empty: all.
    QString text;
    int limit = -1;  ///< the newest ones; -1: all
    bool unfinishedOnly = false;
};

/// The workshop's journal: an SQLite database in the user's data folder.
///
/// Every change is one transaction, on disk when the call returns (WAL with synchronous = FULL).
/// Several programs may have the same journal open: each waits a moment for the other's write, and
/// a job that was changed elsewhere meanwhile is never overwritten. Once a day it is backed up
/// beside itself. A file that SQLite finds damaged is renamed and a new one begun: the newest
/// backup is offered. Another program's database is rejected, and so is a journal with anything in
/// it that this program did not put there (triggers, views, other tables).
class Journal : public QObject {
    Q_OBJECT

  public:
    /// How save() ended.
    enum class Saved {
        Yes,
        AsCopy,  ///< the job had been changed elsewhere meanwhile: saved as a new job
        No       ///< lastError() says why
    };

    /// @param path  the database file; its folder is made where it is missing
    explicit Journal(const QString& path = defaultPath(), QObject* parent = nullptr);
    ~Journal() override;

    /// journal.sqlite in the user's data folder; empty where no journal is kept.
    static QString defaultPath();
    /// Switches the journal off for this run (pictures of the program must not touch it).
    static void setKept(bool kept);

    /// Opens or creates the database. False where the journal cannot be used: lastError().
    bool open();
    /// Opens a journal that is there to be looked into: nothing is made, backed up, renewed or set
    /// aside, and one that would need it is not opened.
    bool look();
    bool isOpen() const;
    const QString& path() const { return path_; }
    /// The reason, for the user; empty after success.
    const QString& lastError() const { return error_; }
    /// What the user should know of the opening: a damaged file was set aside. Empty else.
    const QString& openMessage() const { return openMessage_; }
    /// The backup that can be restored in its place; empty without one.
    const QString& offeredBackup() const { return offered_; }

    /// Adds the job (id 0) or changes it. On success job.id, revision and saved are set.
    Saved save(JournalJob& job);
    std::optional<JournalJob> job(qint64 id);
    /// Newest first.
    QList<JournalJob> search(const JournalQuery& query);
    bool remove(qint64 id);

    /// Those whose program no longer runs, the newest hundred.
    QList<JournalDraft> orphanedDrafts();
    bool discardDraft(const QString& session);

    QList<JournalEngine> engines();
    bool removeEngine(const QString& name);

    /// Writes all that is in the journal to a file of its own, which restore() reads; a file that
    /// is there already stays whole when anything fails.
    bool backUp(const QString& file);
    /// Adds the jobs and engines of a backup that are not in the journal, all of them or none.
    /// Nothing where it is no journal, is damaged or is cancelled: lastError().
    /// @param cancelled  set from another thread
    std::optional<JournalRestored> restore(const QString& file,
                                           const std::atomic<bool>* cancelled = nullptr);

    /// The jobs as CSV (RFC 4180, UTF-8 with byte-order mark), written so that a file already there
    /// stays whole when anything fails. Decimal sign and separator are those that a spreadsheet of
    /// the locale expects: point and comma, or comma and semicolon.
    bool exportCsv(const QString& file, const QList<JournalJob>& jobs);
    static QString csvText(const QList<JournalJob>& jobs, const QLocale& locale = QLocale());

  private:
    QSqlDatabase database() const;
    bool isReady();
    std::optional<std::pair<quint64, quint64>> fileIdentity() const;
    Saved saveOnce(JournalJob& job);
    bool keepsAsSaved(const JournalJob& job);
    bool connectDatabase();
    bool openDatabase();
    void closeDatabase();
    bool prepareSchema();
    bool isWhole();
    void backUpDaily();
    bool makeTables();
    bool fromVersionOne();
    bool runAll(const QStringList& statements);
    bool isDamaged();
    bool putAside(const QString& why);
    /// Runs a statement with values for its ?; nothing where it fails, see lastError().
    std::optional<QSqlQuery> ask(const QString& sql, const QVariantList& values,
                                 const QString& cannot);
    bool runText(const QString& sql, const QString& what);
    bool fail(const QString& what, const QString& why);
    /// The same for a fault of the database.
    bool failBy(const QString& what, const QSqlError& fault);

    QString path_;
    QString connection_;
    QString error_;
    QString openMessage_;
    QString offered_;
    bool isBusy_ = false;  ///< the last fault was that another program writes
    std::optional<std::pair<quint64, quint64>> identity_;  // device and inode of the open file
};

}  // namespace ravnoves

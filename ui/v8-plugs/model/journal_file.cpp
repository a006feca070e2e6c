// The journal's file: opened, made, checked, set aside where it is damaged.

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDeadlineTimer>
#include <QDir>
#include <QFileInfo>
#include <QSqlDatabase>
#include <QThread>
#include <algorithm>
#include <cerrno>

#include "v8-plugs/model/journal.h"
#include "v8-plugs/model/journal_rows.h"

namespace ravnoves {

namespace {

constexpr int schemaVersion = 1;
constexpr int applicationId = 0x52415650;  // "RAVP"

/// Lets one program at a time through. The lock is the system's: it goes with its program, however
/// that ends. (The file alone tells nothing, and stays: a QLockFile that was made but not yet
/// written when its program was killed would never again be stale.)
class Gate {
  public:
    explicit Gate(const QString& file)
        : handle_(::open(QFile::encodeName(file).constData(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    }
    ~Gate() {
        if (handle_ >= 0) {
            ::close(handle_);
        }
    }
    Gate(const Gate&) = delete;
    Gate& operator=(const Gate&) = delete;

    /// @return false where another program still holds it after `patience` ms, or there is no file
    bool pass(int patience) const {
        QDeadlineTimer deadline(patience);
        while (handle_ >= 0) {
            if (::flock(handle_, LOCK_EX | LOCK_NB) == 0) {
                return true;
            }
            if (errno != EWOULDBLOCK && errno != EINTR) {
                return false;
            }
            if (deadline.hasExpired()) {
                return false;
            }
            QThread::msleep(5);
        }
        return false;
    }

  private:
    int handle_;
};

}  // namespace

bool Journal::open() {
    error_.clear();
    openMessage_.clear();
    setAside_.clear();
    closeDatabase();
    const QFileInfo info(path_);
    if (!QDir().mkpath(info.absolutePath())) {
        return fail(tr("The journal's folder %1 cannot be made.").arg(info.absolutePath()), {});
    }
    // One program at a time looks whether the file is whole, so that two cannot set it aside.
    const Gate gate(path_ + QStringLiteral(".opening"));
    if (!gate.pass(journal_rows::patience)) {
        return fail(tr("The journal %1 cannot be opened: its folder cannot be written, or another "
                       "program is busy with it.")
                        .arg(path_),
                    {});
    }
    bool usable = openDatabase();
    if (!usable && isDamaged()) {
        usable = putAside(error_) && openDatabase();
    }
    if (!usable) {
        const QString why = error_;
        closeDatabase();
        error_ = why;
        return false;
    }
    if (!setAside_.isEmpty()) {
        const int saved = takeOver(setAside_);
        openMessage_ =
            tr("The journal was damaged. The damaged file was kept as %1, and a new journal was "
               "begun. Jobs taken over from it: %2.")
                .arg(setAside_)
                .arg(saved);
    }
    identity_ = fileIdentity();
    sessionLock_ = std::make_unique<QLockFile>(lockPath(session_));
    sessionLock_->setStaleLockTime(0);
    sessionLock_->tryLock(0);
    error_.clear();
    return true;
}

std::optional<std::pair<quint64, quint64>> Journal::fileIdentity() const {
    struct stat status {};
    if (stat(QFile::encodeName(path_).constData(), &status) != 0) {
        return std::nullopt;
    }
    return std::pair<quint64, quint64>(status.st_dev, status.st_ino);
}

bool Journal::reopen() {
    const bool opened = open();
    Q_EMIT reopened(openMessage_);
    return opened;
}

/// Another program that found the file damaged has moved it away: what is written from now on must
/// go to the journal that everyone reads, not to the file set aside.
bool Journal::isReady() {
    if (!isOpen()) {
        return fail(tr("The journal is not open."), {});
    }
    return fileIdentity() == identity_ || reopen();
}

bool Journal::openDatabase() {
    closeDatabase();
    {
        QSqlDatabase db = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), connection_);
        db.setDatabaseName(path_);
        db.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(journal_rows::patience));
        if (!db.open()) {
            return fail(tr("The journal %1 cannot be opened.").arg(path_), db.lastError().text());
        }
    }
    const QString cannot = tr("The journal %1 cannot be read.").arg(path_);
    // FULL syncs the log at every commit: a job that was saved survives a power cut.
    return runText(QStringLiteral("PRAGMA journal_mode = WAL"), cannot) &&
           runText(QStringLiteral("PRAGMA synchronous = FULL"), cannot) && prepareSchema();
}

void Journal::closeDatabase() {
    sessionLock_.reset();
    if (QSqlDatabase::contains(connection_)) {
        database().close();
        QSqlDatabase::removeDatabase(connection_);
    }
}

bool Journal::prepareSchema() {
    const QString cannot = tr("The journal %1 cannot be read.").arg(path_);
    int version = -1;
    {
        QSqlQuery query(database());
        if (!query.exec(QStringLiteral("PRAGMA user_version")) || !query.next()) {
            return fail(cannot, query.lastError().text());
        }
        version = query.value(0).toInt();
    }
    if (version > schemaVersion) {
        return fail(
            tr("The journal %1 was written by a newer program; update to open it.").arg(path_), {});
    }
    {
        QSqlQuery query(database());
        if (!query.exec(QStringLiteral("PRAGMA quick_check")) || !query.next()) {
            return fail(cannot, query.lastError().text());
        }
        if (query.value(0).toString() != QLatin1String("ok")) {
            return fail(cannot, query.value(0).toString());
        }
    }
    // IMMEDIATE: two programs that start together make the tables one after the other.
    static const QStringList statements{
        QStringLiteral("BEGIN IMMEDIATE"),
        QStringLiteral("CREATE TABLE IF NOT EXISTS job ("
                       " id INTEGER PRIMARY KEY AUTOINCREMENT,"
                       " revision INTEGER NOT NULL,"
                       " engine_number TEXT NOT NULL,"
                       " customer TEXT NOT NULL,"
                       " technician TEXT NOT NULL,"
                       " engine TEXT NOT NULL,"
                       " job_date TEXT NOT NULL,"
                       " process TEXT NOT NULL,"
                       " unbalanced_mass_g REAL,"
                       " recommended TEXT NOT NULL,"
                       " reduction_g REAL,"
                       " bob_weight_g REAL,"
                       " saved INTEGER NOT NULL,"
                       " form TEXT NOT NULL,"
                       " search TEXT NOT NULL)"),
        QStringLiteral("CREATE INDEX IF NOT EXISTS job_date ON job (job_date)"),
        QStringLiteral("CREATE INDEX IF NOT EXISTS job_engine_number ON job (engine_number)"),
        QStringLiteral("CREATE TABLE IF NOT EXISTS draft ("
                       " session TEXT PRIMARY KEY,"
                       " job_id INTEGER NOT NULL,"
                       " job_revision INTEGER NOT NULL,"
                       " engine_number TEXT NOT NULL,"
                       " saved INTEGER NOT NULL,"
                       " form TEXT NOT NULL)"),
        QStringLiteral("CREATE TABLE IF NOT EXISTS engine ("
                       " name TEXT PRIMARY KEY,"
                       " engine_values TEXT NOT NULL)"),
        QStringLiteral("PRAGMA application_id = %1").arg(applicationId),
        QStringLiteral("PRAGMA user_version = %1").arg(schemaVersion),
        QStringLiteral("COMMIT")};
    if (version == schemaVersion) {
        // A file of this version has these columns, or it is not the journal it says it is.
        QSqlQuery query(database());
        return query.exec(
                   QStringLiteral("SELECT %1, search FROM job LIMIT 1").arg(journal_rows::columns))
                   ? true
                   : fail(cannot, query.lastError().text());
    }
    {
        QSqlQuery query(database());
        if (!query.exec(QStringLiteral("SELECT count(*) FROM sqlite_master")) || !query.next()) {
            return fail(cannot, query.lastError().text());
        }
        if (version == 0 && query.value(0).toInt() > 0 &&
            !database().tables().contains(QStringLiteral("job"))) {
            return fail(tr("%1 is a database of another program; it was left as it is.").arg(path_),
                        {});
        }
    }
    for (const QString& statement : statements) {
        if (!runText(statement, cannot)) {
            const QString why = error_;
            QSqlQuery(database()).exec(QStringLiteral("ROLLBACK"));
            error_ = why;
            return false;
        }
    }
    return true;
}

bool Journal::isDamaged() {
    if (!isOpen()) {
        return false;  // not there, or not allowed: nothing to set aside
    }
    QSqlQuery query(database());
    if (!query.exec(QStringLiteral("PRAGMA quick_check"))) {
        return journal_rows::saysDamaged(query.lastError());
    }
    return query.next() && query.value(0).toString() != QLatin1String("ok");
}

bool Journal::putAside(const QString& why) {
    closeDatabase();
    const QFileInfo info(path_);
    const QString stem =
        QDir(info.absolutePath())
            .filePath(info.completeBaseName() + QStringLiteral("-damaged-") +
                      QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")));
    QString target = stem + QStringLiteral(".sqlite");
    for (int n = 2; QFileInfo::exists(target); ++n) {
        target = stem + QStringLiteral("-%1.sqlite").arg(n);
    }
    if (!QFile::rename(path_, target)) {
        return fail(tr("The journal %1 is damaged and cannot be set aside; nothing was changed.")
                        .arg(path_),
                    why);
    }
    // The log belongs to the file: what was saved last may be in it.
    for (const char* suffix : {"-wal", "-shm"}) {
        const QString side = path_ + QLatin1String(suffix);
        if (QFileInfo::exists(side) && !QFile::rename(side, target + QLatin1String(suffix))) {
            QFile::remove(side);
        }
    }
    setAside_ = target;
    return true;
}

int Journal::takeOver(const QString& damaged) {
    const QString connection = connection_ + QStringLiteral("-damaged");
    QList<JournalJob> jobs;
    QList<JournalEngine> engines;
    {
        QSqlDatabase db = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), connection);
        db.setDatabaseName(damaged);
        db.setConnectOptions(QStringLiteral("QSQLITE_OPEN_READONLY"));
        if (db.open()) {
            QSqlQuery query(db);
            query.setForwardOnly(true);
            // From both ends: a damaged page stops a walk through the table.
            for (const char* order : {"ASC", "DESC"}) {
                if (query.exec(QStringLiteral("SELECT %1 FROM job ORDER BY id %2")
                                   .arg(journal_rows::columns, QLatin1String(order)))) {
                    while (query.next()) {
                        const JournalJob job = journal_rows::read(query);
                        const bool known =
                            std::any_of(jobs.cbegin(), jobs.cend(),
                                        [&](const JournalJob& j) { return j.id == job.id; });
                        if (!known && job.id > 0 && !job.form.isEmpty()) {
                            jobs << job;
                        }
                    }
                }
            }
            if (query.exec(QStringLiteral("SELECT name, engine_values FROM engine"))) {
                while (query.next()) {
                    engines << JournalEngine{query.value(0).toString(),
                                             query.value(1).toString().toUtf8()};
                }
            }
            query.clear();
            db.close();
        }
    }
    QSqlDatabase::removeDatabase(connection);
    std::sort(jobs.begin(), jobs.end(),
              [](const JournalJob& a, const JournalJob& b) { return a.id < b.id; });
    int count = 0;
    identity_ = fileIdentity();
    const bool together = database().transaction();  // one sync for all
    for (JournalJob job : jobs) {
        const QDateTime saved = job.saved;
        job.id = 0;
        if (saveOnce(job) == Saved::Yes) {
            ++count;
            QSqlQuery query(database());
            query.prepare(QStringLiteral("UPDATE job SET saved = ? WHERE id = ?"));
            query.addBindValue(journal_rows::stamp(saved));
            query.addBindValue(job.id);
            query.exec();
        }
    }
    for (const JournalEngine& engine : engines) {
        saveEngine(engine);
    }
    if (together && !database().commit()) {
        return 0;
    }
    return count;
}

}  // namespace ravnoves

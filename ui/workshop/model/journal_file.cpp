// The journal's file: opened, made, checked, set aside where it is damaged.

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDeadlineTimer>
#include <QDir>
#include <QFileInfo>
#include <QSqlDatabase>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <map>
#include <set>

#include "workshop/model/journal.h"
#include "workshop/model/journal_rows.h"

namespace ravnoves {

namespace {

constexpr int schemaVersion = 2;           // 1 knew the V-8 plugs alone
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

    enum class Passed { Yes, Busy, No };
    /// Waits while `goOn` says so. @return Busy where another program still holds it then, No where
    /// there is no file
    Passed pass(const std::function<bool()>& goOn) const {
        while (handle_ >= 0) {
            if (::flock(handle_, LOCK_EX | LOCK_NB) == 0) {
                return Passed::Yes;
            }
            if (errno != EWOULDBLOCK && errno != EINTR) {
                return Passed::No;
            }
            if (!goOn()) {
                return Passed::Busy;
            }
        }
        return Passed::No;
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
    const QDeadlineTimer deadline(patience_);
    const Gate::Passed passed = gate.pass([&] {
        const bool goesOn = !deadline.hasExpired() && !(giveUp_ != nullptr && *giveUp_);
        if (goesOn) {
            pause();
        }
        return goesOn;
    });
    waiting_ = false;
    busy_ = passed == Gate::Passed::Busy;
    if (passed != Gate::Passed::Yes) {
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
        openMessage_ = tr("The journal was damaged. The damaged file was kept as %1, and a new "
                          "journal was begun.")
                           .arg(setAside_) +
                       QLatin1Char(' ') + takeOver(setAside_);
    }
    identity_ = fileIdentity();
    if (!writesForAnother_) {
        sessionLock_ = std::make_unique<QLockFile>(lockPath(session_));
        sessionLock_->setStaleLockTime(0);
        sessionLock_->tryLock(0);
        removeStaleLocks();
    }
    error_.clear();
    return true;
}

/// What killed programs left, once their drafts are gone; the lock of one that runs cannot be
/// taken.
void Journal::removeStaleLocks() {
    const QFileInfo info(path_);
    const QDir folder(info.absolutePath());
    for (const QFileInfo& file :
         folder.entryInfoList({info.fileName() + QStringLiteral(".*.running")}, QDir::Files)) {
        if (file.filePath() == QFileInfo(lockPath(session_)).absoluteFilePath()) {
            continue;
        }
        QLockFile lock(file.filePath());
        lock.setStaleLockTime(0);
        lock.tryLock(0);  // goes with the lock
        // One that was never written says nothing of its program, which had no time for a draft.
        if (!lock.isLocked() && file.size() == 0 &&
            file.lastModified().secsTo(QDateTime::currentDateTime()) > 60) {
            QFile::remove(file.filePath());
        }
    }
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
        db.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=10"));
        if (!db.open()) {
            return fail(tr("The journal %1 cannot be opened.").arg(path_),
                        journal_rows::faultText(db.lastError()));
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
        if (!execute(query, [&] { return query.exec(QStringLiteral("PRAGMA user_version")); }) ||
            !query.next()) {
            busy_ = journal_rows::saysBusy(query.lastError());
            return fail(cannot, journal_rows::faultText(query.lastError()));
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
            return fail(cannot, journal_rows::faultText(query.lastError()));
        }
        if (query.value(0).toString() != QLatin1String("ok")) {
            return fail(cannot, query.value(0).toString());
        }
    }
    if (version == schemaVersion) {
        // A file of this version has these columns, or it is not the journal it says it is.
        QSqlQuery query(database());
        return query.exec(
                   QStringLiteral("SELECT %1, search FROM job LIMIT 1").arg(journal_rows::columns))
                   ? true
                   : fail(cannot, journal_rows::faultText(query.lastError()));
    }
    if (version == 0) {
        QSqlQuery query(database());
        if (!query.exec(QStringLiteral("SELECT count(*) FROM sqlite_master")) || !query.next()) {
            return fail(cannot, journal_rows::faultText(query.lastError()));
        }
        if (query.value(0).toInt() > 0 && !database().tables().contains(QStringLiteral("job"))) {
            return fail(tr("%1 is a database of another program; it was left as it is.").arg(path_),
                        {});
        }
    }
    // The programs that open it come through the gate one by one.
    if (runText(QStringLiteral("BEGIN IMMEDIATE"), cannot) &&
        (version == 1 ? fromVersionOne() : makeTables()) &&
        runText(QStringLiteral("PRAGMA user_version = %1").arg(schemaVersion), cannot) &&
        runText(QStringLiteral("COMMIT"), cannot)) {
        return true;
    }
    const QString why = error_;
    QSqlQuery(database()).exec(QStringLiteral("ROLLBACK"));
    error_ = why;
    return false;
}

bool Journal::makeTables() {
    static const QStringList statements{
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
                       " search TEXT NOT NULL,"
                       " scene TEXT NOT NULL DEFAULT 'v8-plugs',"
                       " crankshaft_number TEXT NOT NULL DEFAULT '',"
                       " front_reading_g_mm REAL,"
                       " rear_reading_g_mm REAL,"
                       " verdict TEXT NOT NULL DEFAULT '',"
                       " is_finished INTEGER NOT NULL DEFAULT 1)"),
        QStringLiteral("CREATE INDEX IF NOT EXISTS job_date ON job (job_date)"),
        QStringLiteral("CREATE INDEX IF NOT EXISTS job_engine_number ON job (engine_number)"),
        QStringLiteral("CREATE TABLE IF NOT EXISTS draft ("
                       " session TEXT PRIMARY KEY,"
                       " job_id INTEGER NOT NULL,"
                       " job_revision INTEGER NOT NULL,"
                       " engine_number TEXT NOT NULL,"
                       " saved INTEGER NOT NULL,"
                       " form TEXT NOT NULL,"
                       " scene TEXT NOT NULL DEFAULT 'v8-plugs')"),
        QStringLiteral("CREATE TABLE IF NOT EXISTS engine ("
                       " name TEXT PRIMARY KEY,"
                       " engine_values TEXT NOT NULL)"),
        QStringLiteral("PRAGMA application_id = %1").arg(applicationId)};
    return runAll(statements);
}

/// Adds what version 2 has; what the jobs' forms know of it is found by searches then.
bool Journal::fromVersionOne() {
    static const QStringList statements{
        QStringLiteral("ALTER TABLE job ADD COLUMN scene TEXT NOT NULL DEFAULT 'v8-plugs'"),
        QStringLiteral("ALTER TABLE job ADD COLUMN crankshaft_number TEXT NOT NULL DEFAULT ''"),
        QStringLiteral("ALTER TABLE job ADD COLUMN front_reading_g_mm REAL"),
        QStringLiteral("ALTER TABLE job ADD COLUMN rear_reading_g_mm REAL"),
        QStringLiteral("ALTER TABLE job ADD COLUMN verdict TEXT NOT NULL DEFAULT ''"),
        QStringLiteral("ALTER TABLE job ADD COLUMN is_finished INTEGER NOT NULL DEFAULT 1"),
        QStringLiteral("ALTER TABLE draft ADD COLUMN scene TEXT NOT NULL DEFAULT 'v8-plugs'")};
    if (!runAll(statements)) {
        return false;
    }
    const QString cannot = tr("The journal %1 cannot be read.").arg(path_);
    QSqlQuery rows(database());
    rows.setForwardOnly(true);
    if (!rows.exec(QStringLiteral("SELECT %1 FROM job").arg(journal_rows::columnsOfVersionOne))) {
        return fail(cannot, journal_rows::faultText(rows.lastError()));
    }
    QList<JournalJob> jobs;
    while (rows.next()) {
        jobs << journal_rows::read(rows);
    }
    for (const JournalJob& job : jobs) {
        QSqlQuery query(database());
        query.prepare(QStringLiteral("UPDATE job SET (%1) = (%2) WHERE id = ?")
                          .arg(journal_rows::written, journal_rows::places));
        journal_rows::bind(query, job);
        query.addBindValue(job.id);
        if (!run(query, cannot)) {
            return false;
        }
    }
    return true;
}

bool Journal::runAll(const QStringList& statements) {
    const QString cannot = tr("The journal %1 cannot be read.").arg(path_);
    return std::all_of(statements.cbegin(), statements.cend(),
                       [&](const QString& statement) { return runText(statement, cannot); });
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

namespace {

/// What can still be read of a damaged file.
struct Rescued {
    std::map<qint64, JournalJob> jobs;  ///< by id
    qsizetype missing = 0;              ///< known by their numbers alone
    QList<JournalEngine> engines;
};

/// Row by row: a damaged page costs what is on it, not what lies behind it.
Rescued rescue(const QSqlDatabase& database) {
    Rescued found;
    QSqlQuery query(database);
    query.setForwardOnly(true);
    const bool isNew =
        query.exec(QStringLiteral("SELECT %1 FROM job LIMIT 0").arg(journal_rows::columns));
    const QString select =
        QStringLiteral("SELECT %1 FROM job ")
            .arg(isNew ? journal_rows::columns : journal_rows::columnsOfVersionOne);
    const auto take = [&] {
        const JournalJob job = journal_rows::read(query);
        if (job.id > 0 && !job.form.isEmpty()) {
            found.jobs.emplace(job.id, job);
        }
    };
    // The ids from the indexes, which lie elsewhere in the file, and from both ends of the table.
    std::set<qint64> ids;
    for (const char* index : {"job_date", "job_engine_number"}) {
        const QLatin1String column(qstrcmp(index, "job_date") == 0 ? "job_date" : "engine_number");
        for (const char* order : {"ASC", "DESC"}) {
            if (query.exec(QStringLiteral("SELECT id FROM job INDEXED BY %1 ORDER BY %2 %3")
                               .arg(QLatin1String(index), column, QLatin1String(order)))) {
                while (query.next()) {
                    ids.insert(query.value(0).toLongLong());
                }
            }
        }
    }
    for (const char* order : {"ASC", "DESC"}) {
        if (query.exec(select + QStringLiteral("ORDER BY id ") + QLatin1String(order))) {
            while (query.next()) {
                take();
            }
        }
    }
    // Between the ends that could be walked every number may be a job, known or not.
    qint64 last = 0;
    if (query.exec(QStringLiteral("SELECT seq FROM sqlite_sequence WHERE name = 'job'")) &&
        query.next()) {
        last = query.value(0).toLongLong();
    }
    for (const auto& [id, job] : found.jobs) {
        ids.insert(id);
    }
    ids.erase(ids.begin(), ids.lower_bound(1));
    constexpr qint64 mostTried = 1'000'000;  // a number that is no number of jobs
    if (!ids.empty() && last < *ids.rbegin()) {
        last = *ids.rbegin();
    }
    for (qint64 id = 1; id <= std::min(last, mostTried); ++id) {
        if (!found.jobs.contains(id) && query.prepare(select + QStringLiteral("WHERE id = ?"))) {
            query.addBindValue(id);
            if (query.exec() && query.next()) {
                take();
            }
            // No such row is no damage: a job that was removed.
            if (query.lastError().isValid()) {
                ids.insert(id);
            }
        }
    }
    found.missing = static_cast<qsizetype>(
        std::count_if(ids.begin(), ids.end(), [&](qint64 id) { return !found.jobs.contains(id); }));
    if (query.exec(QStringLiteral("SELECT name, engine_values FROM engine"))) {
        while (query.next()) {
            found.engines << JournalEngine{query.value(0).toString(),
                                           query.value(1).toString().toUtf8()};
        }
    }
    return found;
}

}  // namespace

JournalRestored Journal::addFrom(const QString& file) {
    const QString connection = connection_ + QStringLiteral("-other");
    Rescued found;
    {
        QSqlDatabase db = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), connection);
        db.setDatabaseName(file);
        db.setConnectOptions(QStringLiteral("QSQLITE_OPEN_READONLY"));
        if (db.open()) {
            found = rescue(db);
            db.close();
        }
    }
    QSqlDatabase::removeDatabase(connection);
    identity_ = fileIdentity();
    // What is there as it was, by the time of its saving and its form.
    std::set<std::pair<qint64, QString>> known;
    auto there = ask(QStringLiteral("SELECT saved, form FROM job"), {}, {});
    while (there && there->next()) {
        known.emplace(there->value(0).toLongLong(), there->value(1).toString());
    }
    there.reset();
    JournalRestored done;
    done.missing = found.missing;
    const bool together = database().transaction();  // one sync for all
    for (auto& [id, job] : found.jobs) {
        const QDateTime saved = job.saved;
        if (known.contains({saved.toMSecsSinceEpoch(), QString::fromUtf8(job.form)})) {
            ++done.known;
            continue;
        }
        job.id = 0;
        if (saveOnce(job) == Saved::Yes) {
            ++done.added;
            ask(QStringLiteral("UPDATE job SET saved = ? WHERE id = ?"),
                {journal_rows::stamp(saved), job.id}, {});
        }
    }
    QStringList names;
    for (const JournalEngine& engine : engines()) {
        names << engine.name;
    }
    for (const JournalEngine& engine : found.engines) {
        if (!names.contains(engine.name)) {
            saveEngine(engine);
        }
    }
    if (together && !database().commit()) {
        done.missing += done.added;
        done.added = 0;
    }
    return done;
}

/// @return how many jobs came over and how many did not, in words
QString Journal::takeOver(const QString& damaged) {
    const JournalRestored done = addFrom(damaged);
    return withUnread(tr("Jobs taken over from it: %1.").arg(done.added), done);
}

QString Journal::withUnread(const QString& came, const JournalRestored& done) {
    return done.missing == 0
               ? came
               : came + QLatin1Char(' ') + tr("Jobs that could not be read: %1.").arg(done.missing);
}

bool Journal::backUp(const QString& file) {
    const QString cannot = tr("The backup %1 could not be written.").arg(file);
    const QString part = file + QStringLiteral(".part");
    QFile::remove(part);
    if (!ask(QStringLiteral("VACUUM INTO ?"), {part}, cannot)) {
        QFile::remove(part);
        return false;
    }
    if (std::rename(QFile::encodeName(part).constData(), QFile::encodeName(file).constData()) !=
        0) {
        QFile::remove(part);
        return fail(cannot, {});
    }
    return true;
}

std::optional<JournalRestored> Journal::restore(const QString& file) {
    if (!isReady()) {
        return std::nullopt;
    }
    const QString cannot = tr("%1 is no backup of a journal.").arg(file);
    if (QFileInfo(file) == QFileInfo(path_)) {
        fail(cannot, {});
        return std::nullopt;
    }
    const JournalRestored done = addFrom(file);
    if (done.added + done.known + done.missing == 0) {
        fail(cannot, {});
        return std::nullopt;
    }
    error_.clear();
    return done;
}

}  // namespace ravnoves

// The journal's file: opened, made, checked, set aside where it is damaged.

#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>

#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QSqlDatabase>
#include <QTemporaryDir>
#include <QThread>
#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "case-file/text_file.h"
#include "shop/model/journal.h"
#include "shop/model/journal_rows.h"
#include "shop/model/words.h"
#include "text/message_text.h"

namespace ravnoves {

namespace {

constexpr int schemaVersion = 2;           // 1 knew the V-8 plugs alone
constexpr int applicationId = 0x52415650;  // "RAVP"

constexpr int busyTimeout = 2000;  // ms, for another program's write
constexpr int backupsKept = 7;

/// /proc/kmsg and its like are files to who asks, and make their reader wait. Asked without opening
/// it: a database that is opened and closed beside SQLite loses the locks that that holds.
bool isOfTheSystem(const QString& path) {
    struct statfs system {};
    if (statfs(QFile::encodeName(path).constData(), &system) != 0) {
        return false;
    }
    constexpr std::array kinds{PROC_SUPER_MAGIC, SYSFS_MAGIC, DEBUGFS_MAGIC, TRACEFS_MAGIC};
    return std::find(kinds.begin(), kinds.end(), system.f_type) != kinds.end();
}

/// What would be waited for: the database, or a file that SQLite looks for beside it, that is a
/// pipe or a device. Empty where there is none.
QString noFileOf(const QString& path) {
    for (const char* suffix : {"", "-journal", "-wal", "-shm"}) {
        const QFileInfo info(path + QLatin1String(suffix));
        if (info.exists() && !info.isDir() && (!info.isFile() || isOfTheSystem(info.filePath()))) {
            return info.filePath();
        }
    }
    return {};
}

}  // namespace

bool Journal::open() {
    error_.clear();
    openMessage_.clear();
    closeDatabase();
    const QFileInfo info(path_);
    if (!QDir().mkpath(info.absolutePath())) {
        return fail(tr("The journal's folder %1 cannot be created.").arg(info.absolutePath()), {});
    }
    isBusy_ = false;
    bool usable = openDatabase();
    // While it begins a log SQLite waits for no other program that does so, too.
    QElapsedTimer waited;
    waited.start();
    while (!usable && std::exchange(isBusy_, false) && waited.elapsed() < busyTimeout) {
        constexpr unsigned long step = 20;  // ms
        closeDatabase();
        QThread::msleep(step);
        usable = openDatabase();
    }
    if (!usable && isDamaged()) {
        usable = putAside(error_) && openDatabase();
    }
    if (!usable) {
        const QString why = error_;
        closeDatabase();
        error_ = why;
        return false;
    }
    backUpDaily();
    error_.clear();
    return true;
}

namespace {

/// The daily backups beside the journal, the newest first.
QFileInfoList backupsOf(const QString& path) {
    const QFileInfo info(path);
    return QDir(info.absolutePath())
        .entryInfoList({info.completeBaseName() + QStringLiteral("-backup-*.sqlite")}, QDir::Files,
                       QDir::Name | QDir::Reversed);
}

}  // namespace

/// An empty journal, such as one that was just begun, takes no place of what was kept.
void Journal::backUpDaily() {
    QSqlQuery query(database());
    if (!query.exec(QStringLiteral("SELECT 1 FROM job LIMIT 1")) || !query.next()) {
        return;
    }
    query.finish();
    const QFileInfo info(path_);
    const QString file =
        QDir(info.absolutePath())
            .filePath(info.completeBaseName() + QStringLiteral("-backup-") +
                      QDate::currentDate().toString(Qt::ISODate) + QStringLiteral(".sqlite"));
    if (!QFileInfo::exists(file) && backUp(file)) {
        for (const QFileInfo& old : backupsOf(path_).mid(backupsKept)) {
            QFile::remove(old.filePath());
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

/// Another program that found the file damaged has moved it away: what is written from now on must
/// go to the journal that everyone reads, not to the file set aside.
bool Journal::isReady() {
    if (!isOpen()) {
        return fail(tr("The journal is not open."), {});
    }
    return fileIdentity() == identity_ || open();
}

bool Journal::connectDatabase() {
    closeDatabase();
    if (const QString pipe = noFileOf(path_); !pipe.isEmpty()) {
        return fail(tr("The journal %1 cannot be opened.").arg(path_),
                    pipe + QLatin1Char(' ') + messageText(not_a_file));
    }
    {
        QSqlDatabase db = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), connection_);
        db.setDatabaseName(path_);
        db.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(busyTimeout));
        if (!db.open()) {
            return failBy(tr("The journal %1 cannot be opened.").arg(path_), db.lastError());
        }
    }
    identity_ = fileIdentity();
    // What is in the file cannot call functions of the program that opens it.
    return runText(QStringLiteral("PRAGMA trusted_schema = OFF"),
                   tr("The journal %1 cannot be read.").arg(path_));
}

bool Journal::openDatabase() {
    // FULL syncs the log at every commit: a job that was saved survives a power cut.
    return connectDatabase() &&
           runText(QStringLiteral("PRAGMA synchronous = FULL"),
                   tr("The journal %1 cannot be read.").arg(path_)) &&
           prepareSchema();
}

void Journal::closeDatabase() {
    if (QSqlDatabase::contains(connection_)) {
        database().close();
        QSqlDatabase::removeDatabase(connection_);
    }
}

namespace {

/// What a journal says of itself.
struct Head {
    int application = 0;
    int version = 0;
    bool isEmpty = true;
    bool isOurs = true;  ///< nothing in it but the tables and indexes of a journal
};

/// Nothing where it cannot be read: the query says why.
std::optional<Head> headOf(QSqlQuery& query) {
    Head head;
    if (!query.exec(QStringLiteral("SELECT type, name, sql FROM sqlite_master"))) {
        return std::nullopt;
    }
    static const QStringList known{QStringLiteral("table job"), QStringLiteral("table draft"),
                                   QStringLiteral("table engine"), QStringLiteral("index job_date"),
                                   QStringLiteral("index job_engine_number")};
    while (query.next()) {
        head.isEmpty = false;
        const QString type = query.value(0).toString();
        const QString name = query.value(1).toString();
        const bool isSystems = name.startsWith(QLatin1String("sqlite_")) &&
                               (type == QLatin1String("table") || type == QLatin1String("index"));
        const bool isVirtual = query.value(2).toString().startsWith(QLatin1String("CREATE VIRTUAL"),
                                                                    Qt::CaseInsensitive);
        head.isOurs = head.isOurs && !isVirtual &&
                      (isSystems || known.contains(type + QLatin1Char(' ') + name));
    }
    // After the tables: whoever makes them meanwhile names the program in the same transaction.
    for (const auto& [pragma, value] : {std::pair{"PRAGMA application_id", &head.application},
                                        std::pair{"PRAGMA user_version", &head.version}}) {
        if (!query.exec(QLatin1String(pragma)) || !query.next()) {
            return std::nullopt;
        }
        *value = query.value(0).toInt();
    }
    // Version 1 did not name its program, nor what was made of it.
    head.isOurs = head.isOurs && (head.application == applicationId ||
                                  (head.application == 0 && (head.isEmpty || head.version > 0)));
    return head;
}

}  // namespace

bool Journal::look() {
    bool isJournal = false;
    if (QFileInfo(path_).isFile() && connectDatabase()) {
        QSqlQuery query(database());
        const std::optional<Head> head = headOf(query);
        isJournal = head && head->isOurs && head->version == schemaVersion;
    }
    if (!isJournal) {
        closeDatabase();
    }
    return isJournal;
}

namespace {

/// The answer of SQLite's own check; nothing where the query cannot be run.
std::optional<QString> checkBy(QSqlQuery& query) {
    return query.exec(QStringLiteral("PRAGMA quick_check")) && query.next()
               ? std::optional(query.value(0).toString())
               : std::nullopt;
}
const QString whole = QStringLiteral("ok");

}  // namespace

bool Journal::isWhole() {
    const QString cannot = tr("The journal %1 cannot be read.").arg(path_);
    QSqlQuery query(database());
    const auto found = checkBy(query);
    return found ? found == whole || fail(cannot, *found) : failBy(cannot, query.lastError());
}

bool Journal::prepareSchema() {
    const QString cannot = tr("The journal %1 cannot be read.").arg(path_);
    std::optional<Head> head;
    {
        QSqlQuery query(database());
        head = headOf(query);
        if (!head) {
            return failBy(cannot, query.lastError());
        }
    }
    if (!head->isOurs) {
        return fail(tr("%1 belongs to another program or was changed by one; it was not changed.")
                        .arg(path_),
                    {});
    }
    const int version = head->version;
    if (version > schemaVersion) {
        return fail(
            tr("The journal %1 was written by a newer program; update to open it.").arg(path_), {});
    }
    // Writes into the file: not before it is known to be ours.
    if (!runText(QStringLiteral("PRAGMA journal_mode = WAL"), cannot) || !isWhole()) {
        return false;
    }
    const QString named = QStringLiteral("PRAGMA application_id = %1").arg(applicationId);
    if (version > 0 && head->application == 0 && !runText(named, cannot)) {
        return false;
    }
    if (version == schemaVersion) {
        // A file of this version has these columns, or it is not the journal it says it is.
        QSqlQuery query(database());
        return query.exec(
                   QStringLiteral("SELECT %1, search FROM job LIMIT 1").arg(journal_rows::columns))
                   ? true
                   : failBy(cannot, query.lastError());
    }
    // Of two programs that begin it at once the second finds the tables there.
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
    auto rows = ask(QStringLiteral("SELECT %1 FROM job").arg(journal_rows::columnsOfVersionOne), {},
                    cannot);
    QList<JournalJob> jobs;
    while (rows && rows->next()) {
        jobs << journal_rows::read(*rows);
    }
    return rows && std::all_of(jobs.cbegin(), jobs.cend(), [&](const JournalJob& job) {
               return ask(QStringLiteral("UPDATE job SET (%1) = (%2) WHERE id = ?")
                              .arg(journal_rows::written, journal_rows::places),
                          journal_rows::valuesOf(job) << job.id, cannot)
                   .has_value();
           });
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
    const auto found = checkBy(query);
    return found ? found != whole : journal_rows::meansDamaged(query.lastError());
}

bool Journal::putAside(const QString& why) {
    closeDatabase();
    if (fileIdentity() != identity_) {
        return true;  // another program was quicker
    }
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
        return fail(
            tr("The journal %1 is damaged and cannot be renamed; it was not changed.").arg(path_),
            why);
    }
    // The log belongs to the file: what was saved last may be in it.
    for (const char* suffix : {"-wal", "-shm"}) {
        const QString side = path_ + QLatin1String(suffix);
        if (QFileInfo::exists(side) && !QFile::rename(side, target + QLatin1String(suffix))) {
            QFile::remove(side);
        }
    }
    openMessage_ = tr("The journal was damaged. The file is now %1, and a new journal was created.")
                       .arg(target);
    for (const QFileInfo& backup : backupsOf(path_).mid(0, 1)) {
        offered_ = backup.filePath();
        openMessage_ += QLatin1Char(' ') +
                        tr("Its last backup is from %1.")
                            .arg(Words().day(backup.lastModified().date().toString(Qt::ISODate)));
    }
    return true;
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

std::optional<JournalRestored> Journal::restore(const QString& file,
                                                const std::atomic<bool>* cancelled) {
    const QString cannot = tr("%1 is not a backup of a journal, or is damaged.").arg(file);
    // A copy is opened as a journal is, also one of an older version: the backup is not changed.
    const QTemporaryDir folder;
    Journal other(folder.filePath(QStringLiteral("journal.sqlite")));
    const auto copy = [&](const char* suffix) {
        const QString target = other.path_ + QLatin1String(suffix);
        return QFile::copy(file + QLatin1String(suffix), target) &&
               QFile::setPermissions(target, QFile::ReadOwner | QFile::WriteOwner);
    };
    if (!isReady() || QFileInfo(file) == QFileInfo(path_) || !noFileOf(file).isEmpty() ||
        !copy("")) {
        fail(cannot, {});
        return std::nullopt;
    }
    copy("-wal");  // where it has one
    const bool isOpen = other.openDatabase();
    const auto jobs = static_cast<int>(isOpen ? other.search({}).size() : 0);
    const bool isRead = isOpen && other.error_.isEmpty();
    other.closeDatabase();
    if (!isRead || !ask(QStringLiteral("ATTACH ? AS backup"), {other.path_}, cannot)) {
        fail(cannot, {});
        return std::nullopt;
    }
    // What is there as it was, by the time of its saving and its form, is not added.
    std::optional<QSqlQuery> added;
    const bool isKept =
        runText(QStringLiteral("BEGIN IMMEDIATE"), cannot) &&
        runText(QStringLiteral("INSERT INTO main.engine SELECT name, engine_values"
                               " FROM backup.engine WHERE true ON CONFLICT (name) DO NOTHING"),
                cannot) &&
        (added = ask(QStringLiteral("INSERT INTO main.job (revision, %1) SELECT 1, %1"
                                    " FROM backup.job WHERE (saved, form) NOT IN"
                                    " (SELECT saved, form FROM main.job) ORDER BY id")
                         .arg(journal_rows::written),
                     {}, cannot)) &&
        (cancelled == nullptr || !*cancelled) && runText(QStringLiteral("COMMIT"), cannot);
    QSqlQuery after(database());
    if (!isKept) {
        after.exec(QStringLiteral("ROLLBACK"));
    }
    after.exec(QStringLiteral("DETACH backup"));
    if (!isKept) {
        fail(tr("Nothing was restored."), {});
        return std::nullopt;
    }
    error_.clear();
    return JournalRestored{added->numRowsAffected(), jobs - added->numRowsAffected()};
}

}  // namespace ravnoves

#include "v8-plugs/journal.h"

#include <sys/stat.h>

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QSaveFile>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QStandardPaths>
#include <QUuid>
#include <QVariant>
#include <algorithm>

#include "case-file/range.h"

namespace ravnoves {

namespace {

constexpr int schemaVersion = 1;
constexpr int applicationId = 0x52415650;  // "RAVP"
constexpr int waitMilliseconds = 15000;    // for another program's write

// SQLite's primary result codes.
constexpr int sqliteCorrupt = 11;
constexpr int sqliteNotADatabase = 26;

const QString jobColumns = QStringLiteral(
    "id, revision, engine_number, customer, technician, engine, job_date, process, "
    "unbalanced_mass_g, recommended, reduction_g, bob_weight_g, saved, form");

bool saysDamaged(const QSqlError& error) {
    bool ok = false;
    const int code = error.nativeErrorCode().toInt(&ok) & 0xFF;
    return ok && (code == sqliteCorrupt || code == sqliteNotADatabase);
}

/// Lower case in every alphabet, so that a search finds "змз" in "ЗМЗ": SQLite folds ASCII only.
QString folded(const QString& text) {
    return text.toCaseFolded();
}

QString searchText(const JournalJob& job) {
    return folded(job.engineNumber + QLatin1Char('\n') + job.customer + QLatin1Char('\n') +
                  job.technician + QLatin1Char('\n') + job.engine);
}

/// The text with the pattern signs of LIKE taken literally.
QString likePattern(QString text) {
    text.replace(QLatin1Char('\\'), QLatin1String("\\\\"));
    text.replace(QLatin1Char('%'), QLatin1String("\\%"));
    text.replace(QLatin1Char('_'), QLatin1String("\\_"));
    return QLatin1Char('%') + text + QLatin1Char('%');
}

QVariant orNull(const std::optional<double>& value) {
    return value ? QVariant(*value) : QVariant(QMetaType::fromType<double>());
}

std::optional<double> orNothing(const QVariant& value) {
    return value.isNull() ? std::nullopt : std::optional(value.toDouble());
}

/// Milliseconds since 1970 sort as numbers and read the same in every locale.
QVariant stamp(const QDateTime& time) {
    return time.toMSecsSinceEpoch();
}
QDateTime fromStamp(const QVariant& value) {
    return QDateTime::fromMSecsSinceEpoch(value.toLongLong(), Qt::UTC);
}

/// The empty text, not NULL, for a QString that was never set.
QString bare(const QString& text) {
    return text.isNull() ? QLatin1String("") : text;
}

JournalJob readJob(const QSqlQuery& query) {
    JournalJob job;
    job.id = query.value(0).toLongLong();
    job.revision = query.value(1).toInt();
    job.engineNumber = query.value(2).toString();
    job.customer = query.value(3).toString();
    job.technician = query.value(4).toString();
    job.engine = query.value(5).toString();
    job.date = QDate::fromString(query.value(6).toString(), Qt::ISODate);
    job.process = query.value(7).toString();
    job.unbalancedMass = orNothing(query.value(8));
    job.recommended = query.value(9).toString();
    job.reduction = orNothing(query.value(10));
    job.bobWeight = orNothing(query.value(11));
    job.saved = fromStamp(query.value(12));
    job.form = query.value(13).toString().toUtf8();
    return job;
}

void bindJob(QSqlQuery& query, const JournalJob& job) {
    query.bindValue(QStringLiteral(":engine_number"), bare(job.engineNumber));
    query.bindValue(QStringLiteral(":customer"), bare(job.customer));
    query.bindValue(QStringLiteral(":technician"), bare(job.technician));
    query.bindValue(QStringLiteral(":engine"), bare(job.engine));
    query.bindValue(QStringLiteral(":job_date"), bare(job.date.toString(Qt::ISODate)));
    query.bindValue(QStringLiteral(":process"), bare(job.process));
    query.bindValue(QStringLiteral(":unbalanced_mass_g"), orNull(job.unbalancedMass));
    query.bindValue(QStringLiteral(":recommended"), bare(job.recommended));
    query.bindValue(QStringLiteral(":reduction_g"), orNull(job.reduction));
    query.bindValue(QStringLiteral(":bob_weight_g"), orNull(job.bobWeight));
    query.bindValue(QStringLiteral(":saved"), stamp(job.saved));
    query.bindValue(QStringLiteral(":form"), bare(QString::fromUtf8(job.form)));
    query.bindValue(QStringLiteral(":search"), searchText(job));
}

QString csvField(const QString& text) {
    static const QString special = QStringLiteral(",\"\r\n;\t");
    for (const QChar c : text) {
        if (special.contains(c)) {
            QString quoted = text;
            quoted.replace(QLatin1Char('"'), QLatin1String("\"\""));
            return QLatin1Char('"') + quoted + QLatin1Char('"');
        }
    }
    return text;
}

QString csvNumber(const std::optional<double>& value) {
    return value ? QString::fromStdString(format_number(*value)) : QString();
}

}  // namespace

Journal::Journal(const QString& path, QObject* parent)
    : QObject(parent),
      path_(path),
      connection_(QStringLiteral("journal-") + QUuid::createUuid().toString(QUuid::Id128)),
      session_(QUuid::createUuid().toString(QUuid::Id128)) {}

Journal::~Journal() {
    closeDatabase();
}

namespace {
bool journalKept = true;
}

void Journal::setKept(bool kept) {
    journalKept = kept;
}

QString Journal::defaultPath() {
    if (!journalKept) {
        return {};
    }
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
        .filePath(QStringLiteral("journal.sqlite"));
}

QSqlDatabase Journal::database() const {
    return QSqlDatabase::database(connection_, false);
}

bool Journal::isOpen() const {
    return QSqlDatabase::contains(connection_) && database().isOpen();
}

bool Journal::fail(const QString& what, const QString& why) {
    error_ = why.isEmpty() ? what : what + QStringLiteral(" (") + why + QLatin1Char(')');
    return false;
}

bool Journal::run(QSqlQuery& query, const QString& what) {
    if (query.exec()) {
        error_.clear();
        damaged_ = false;
        return true;
    }
    damaged_ = saysDamaged(query.lastError());
    return fail(what, query.lastError().text());
}

bool Journal::runText(const QString& sql, const QString& what) {
    QSqlQuery query(database());
    if (query.exec(sql)) {
        return true;
    }
    return fail(what, query.lastError().text());
}

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
    QLockFile gate(path_ + QStringLiteral(".opening"));
    gate.setStaleLockTime(0);  // only a lock whose program is gone is stale
    if (!gate.tryLock(waitMilliseconds)) {
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
        db.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(waitMilliseconds));
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
        return query.exec(QStringLiteral("SELECT %1, search FROM job LIMIT 1").arg(jobColumns))
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
        return saysDamaged(query.lastError());
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
                                   .arg(jobColumns, QLatin1String(order)))) {
                    while (query.next()) {
                        const JournalJob job = readJob(query);
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
            query.addBindValue(stamp(saved));
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

Journal::Saved Journal::save(JournalJob& job) {
    if (!isReady()) {
        return Saved::No;
    }
    Saved saved = saveOnce(job);
    if (saved == Saved::No && damaged_ && reopen()) {
        saved = saveOnce(job);
    }
    return saved;
}

Journal::Saved Journal::saveOnce(JournalJob& job) {
    const QString cannot = tr("The job could not be saved.");
    job.saved = QDateTime::currentDateTimeUtc();
    bool asCopy = false;
    if (job.id != 0) {
        QSqlQuery query(database());
        query.prepare(QStringLiteral(
            "UPDATE job SET revision = revision + 1, engine_number = :engine_number,"
            " customer = :customer, technician = :technician, engine = :engine,"
            " job_date = :job_date, process = :process, unbalanced_mass_g = :unbalanced_mass_g,"
            " recommended = :recommended, reduction_g = :reduction_g,"
            " bob_weight_g = :bob_weight_g, saved = :saved, form = :form, search = :search"
            " WHERE id = :id AND revision = :revision"));
        bindJob(query, job);
        query.bindValue(QStringLiteral(":id"), job.id);
        query.bindValue(QStringLiteral(":revision"), job.revision);
        if (!run(query, cannot)) {
            return Saved::No;
        }
        if (query.numRowsAffected() == 1) {
            ++job.revision;
            return Saved::Yes;
        }
        asCopy = true;  // changed or removed elsewhere: neither version is lost
    }
    QSqlQuery query(database());
    query.prepare(QStringLiteral(
        "INSERT INTO job (revision, engine_number, customer, technician, engine, job_date, process,"
        " unbalanced_mass_g, recommended, reduction_g, bob_weight_g, saved, form, search)"
        " VALUES (1, :engine_number, :customer, :technician, :engine, :job_date, :process,"
        " :unbalanced_mass_g, :recommended, :reduction_g, :bob_weight_g, :saved, :form,"
        " :search)"));
    bindJob(query, job);
    if (!run(query, cannot)) {
        return Saved::No;
    }
    job.id = query.lastInsertId().toLongLong();
    job.revision = 1;
    return asCopy ? Saved::AsCopy : Saved::Yes;
}

std::optional<JournalJob> Journal::job(qint64 id) {
    if (!isReady()) {
        return std::nullopt;
    }
    QSqlQuery query(database());
    query.prepare(QStringLiteral("SELECT %1 FROM job WHERE id = ?").arg(jobColumns));
    query.addBindValue(id);
    if (!run(query, tr("The job could not be read."))) {
        return std::nullopt;
    }
    if (!query.next()) {
        fail(tr("The job is no longer in the journal."), {});
        return std::nullopt;
    }
    return readJob(query);
}

QList<JournalJob> Journal::search(const JournalQuery& wanted) {
    if (!isReady()) {
        return {};
    }
    QSqlQuery query(database());
    query.setForwardOnly(true);
    query.prepare(QStringLiteral("SELECT %1 FROM job"
                                 " WHERE search LIKE :pattern ESCAPE '\\'"
                                 " AND (:from = '' OR job_date >= :from)"
                                 " AND (:to = '' OR (job_date <> '' AND job_date <= :to))"
                                 " ORDER BY job_date DESC, id DESC LIMIT :limit")
                      .arg(jobColumns));
    query.bindValue(QStringLiteral(":pattern"), likePattern(folded(wanted.text.trimmed())));
    query.bindValue(QStringLiteral(":from"), bare(wanted.from.toString(Qt::ISODate)));
    query.bindValue(QStringLiteral(":to"), bare(wanted.to.toString(Qt::ISODate)));
    query.bindValue(QStringLiteral(":limit"), wanted.limit);
    QList<JournalJob> jobs;
    if (run(query, tr("The journal could not be searched."))) {
        while (query.next()) {
            jobs << readJob(query);
        }
    }
    return jobs;
}

bool Journal::remove(qint64 id) {
    if (!isReady()) {
        return false;
    }
    QSqlQuery query(database());
    query.prepare(QStringLiteral("DELETE FROM job WHERE id = ?"));
    query.addBindValue(id);
    return run(query, tr("The job could not be removed."));
}

QString Journal::lockPath(const QString& session) const {
    return path_ + QLatin1Char('.') + session + QStringLiteral(".running");
}

bool Journal::saveDraft(const JournalDraft& draft) {
    if (!isReady()) {
        return false;
    }
    QSqlQuery query(database());
    query.prepare(QStringLiteral(
        "INSERT INTO draft (session, job_id, job_revision, engine_number, saved, form)"
        " VALUES (?, ?, ?, ?, ?, ?)"
        " ON CONFLICT (session) DO UPDATE SET job_id = excluded.job_id,"
        " job_revision = excluded.job_revision, engine_number = excluded.engine_number,"
        " saved = excluded.saved, form = excluded.form"));
    query.addBindValue(draft.session.isEmpty() ? session_ : draft.session);
    query.addBindValue(draft.jobId);
    query.addBindValue(draft.jobRevision);
    query.addBindValue(bare(draft.engineNumber));
    query.addBindValue(stamp(QDateTime::currentDateTimeUtc()));
    query.addBindValue(bare(QString::fromUtf8(draft.form)));
    return run(query, tr("The draft could not be saved."));
}

bool Journal::discardDraft(const QString& session) {
    if (!isReady()) {
        return false;
    }
    QSqlQuery query(database());
    query.prepare(QStringLiteral("DELETE FROM draft WHERE session = ?"));
    query.addBindValue(session);
    return run(query, tr("The draft could not be removed."));
}

QList<JournalDraft> Journal::orphanedDrafts() {
    QList<JournalDraft> drafts;
    if (!isReady()) {
        return drafts;
    }
    QSqlQuery query(database());
    query.setForwardOnly(true);
    query.prepare(
        QStringLiteral("SELECT session, job_id, job_revision, engine_number, saved, form"
                       " FROM draft WHERE session <> ? ORDER BY saved DESC"));
    query.addBindValue(session_);
    if (!run(query, tr("The drafts could not be read."))) {
        return drafts;
    }
    while (query.next()) {
        JournalDraft draft{query.value(0).toString(), query.value(1).toLongLong(),
                           query.value(2).toInt(),    query.value(3).toString(),
                           fromStamp(query.value(4)), query.value(5).toString().toUtf8()};
        // The lock of a program that runs cannot be taken; that of a crashed one can.
        QLockFile lock(lockPath(draft.session));
        lock.setStaleLockTime(0);
        if (lock.tryLock(0)) {
            drafts << draft;
        }
    }
    return drafts;
}

bool Journal::saveEngine(const JournalEngine& engine) {
    if (!isReady()) {
        return false;
    }
    QSqlQuery query(database());
    query.prepare(
        QStringLiteral("INSERT INTO engine (name, engine_values) VALUES (?, ?)"
                       " ON CONFLICT (name) DO UPDATE SET engine_values = excluded.engine_values"));
    query.addBindValue(engine.name);
    query.addBindValue(bare(QString::fromUtf8(engine.values)));
    return run(query, tr("The engine could not be saved."));
}

bool Journal::removeEngine(const QString& name) {
    if (!isReady()) {
        return false;
    }
    QSqlQuery query(database());
    query.prepare(QStringLiteral("DELETE FROM engine WHERE name = ?"));
    query.addBindValue(name);
    return run(query, tr("The engine could not be removed."));
}

QList<JournalEngine> Journal::engines() {
    QList<JournalEngine> list;
    if (!isReady()) {
        return list;
    }
    QSqlQuery query(database());
    query.prepare(QStringLiteral("SELECT name, engine_values FROM engine ORDER BY name"));
    if (run(query, tr("The engines could not be read."))) {
        while (query.next()) {
            list << JournalEngine{query.value(0).toString(), query.value(1).toString().toUtf8()};
        }
    }
    return list;
}

QString Journal::csvText(const QList<JournalJob>& jobs) {
    QString text = QStringLiteral(
        "id,engine_number,date,customer,technician,engine,process,unbalanced_mass_g,recommended,"
        "reduction_g_per_plug,bob_weight_g,saved_utc\r\n");
    for (const JournalJob& job : jobs) {
        const QStringList fields{QString::number(job.id),        csvField(job.engineNumber),
                                 job.date.toString(Qt::ISODate), csvField(job.customer),
                                 csvField(job.technician),       csvField(job.engine),
                                 csvField(job.process),          csvNumber(job.unbalancedMass),
                                 csvField(job.recommended),      csvNumber(job.reduction),
                                 csvNumber(job.bobWeight),       job.saved.toString(Qt::ISODate)};
        text += fields.join(QLatin1Char(',')) + QLatin1String("\r\n");
    }
    return text;
}

bool Journal::exportCsv(const QString& file, const QList<JournalJob>& jobs) {
    QSaveFile out(file);
    const QByteArray text = QByteArrayLiteral("\xEF\xBB\xBF") + csvText(jobs).toUtf8();
    if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size() || !out.commit()) {
        return fail(tr("%1 could not be written.").arg(file), out.errorString());
    }
    error_.clear();
    return true;
}

}  // namespace ravnoves

#include "v8-plugs/model/journal.h"

#include <QDir>
#include <QSqlDatabase>
#include <QStandardPaths>
#include <QUuid>

#include "v8-plugs/model/journal_rows.h"

namespace ravnoves {

using journal_rows::bare;
using journal_rows::fromStamp;
using journal_rows::stamp;

namespace {

bool journalKept = true;

constexpr int draftPatience = 50;  // ms

/// Waits less long for another program's write while it lives.
class PatienceFor {
  public:
    PatienceFor(const QSqlDatabase& database, int milliseconds) : database_(database) {
        set(milliseconds);
    }
    ~PatienceFor() { set(journal_rows::patience); }
    PatienceFor(const PatienceFor&) = delete;
    PatienceFor& operator=(const PatienceFor&) = delete;

  private:
    void set(int milliseconds) {
        QSqlQuery(database_).exec(QStringLiteral("PRAGMA busy_timeout = %1").arg(milliseconds));
    }
    QSqlDatabase database_;
};

/// The text with the pattern signs of LIKE taken literally.
QString likePattern(QString text) {
    text.replace(QLatin1Char('\\'), QLatin1String("\\\\"));
    text.replace(QLatin1Char('%'), QLatin1String("\\%"));
    text.replace(QLatin1Char('_'), QLatin1String("\\_"));
    return QLatin1Char('%') + text + QLatin1Char('%');
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
        busy_ = false;
        return true;
    }
    busy_ = journal_rows::saysBusy(query.lastError());
    damaged_ = journal_rows::saysDamaged(query.lastError());
    return fail(what, query.lastError().text());
}

bool Journal::runText(const QString& sql, const QString& what) {
    QSqlQuery query(database());
    if (query.exec(sql)) {
        return true;
    }
    return fail(what, query.lastError().text());
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
        journal_rows::bind(query, job);
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
    journal_rows::bind(query, job);
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
    query.prepare(QStringLiteral("SELECT %1 FROM job WHERE id = ?").arg(journal_rows::columns));
    query.addBindValue(id);
    if (!run(query, tr("The job could not be read."))) {
        return std::nullopt;
    }
    if (!query.next()) {
        fail(tr("The job is no longer in the journal."), {});
        return std::nullopt;
    }
    return journal_rows::read(query);
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
                      .arg(journal_rows::columns));
    query.bindValue(QStringLiteral(":pattern"),
                    likePattern(journal_rows::folded(wanted.text.trimmed())));
    query.bindValue(QStringLiteral(":from"), bare(wanted.from.toString(Qt::ISODate)));
    query.bindValue(QStringLiteral(":to"), bare(wanted.to.toString(Qt::ISODate)));
    query.bindValue(QStringLiteral(":limit"), wanted.limit);
    QList<JournalJob> jobs;
    if (run(query, tr("The journal could not be searched."))) {
        while (query.next()) {
            jobs << journal_rows::read(query);
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
    // A draft is written while the user types: it does not wait for another program's write as a
    // job does, it is tried again.
    const PatienceFor patience(database(), draftPatience);
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

bool Journal::renameEngine(const QString& from, const QString& to) {
    if (!isReady()) {
        return false;
    }
    QSqlQuery query(database());
    query.prepare(QStringLiteral("UPDATE engine SET name = ? WHERE name = ?"));
    query.addBindValue(to);
    query.addBindValue(from);
    const QString cannot = tr("The engine could not be renamed.");
    if (!run(query, cannot)) {
        return false;
    }
    return query.numRowsAffected() == 1 || fail(cannot, tr("it is no longer kept"));
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

}  // namespace ravnoves

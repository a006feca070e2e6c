#include "shop/model/journal.h"

#include <QDir>
#include <QLockFile>
#include <QSqlDatabase>
#include <QStandardPaths>
#include <QUuid>
#include <utility>

#include "shop/model/journal_rows.h"
#include "shop/model/words.h"

namespace ravnoves {

namespace {

bool journalKept = true;

/// The text with the pattern signs of LIKE taken literally.
QString literal(QString text) {
    text.replace(QLatin1Char('\\'), QLatin1String("\\\\"));
    text.replace(QLatin1Char('%'), QLatin1String("\\%"));
    return text.replace(QLatin1Char('_'), QLatin1String("\\_"));
}

}  // namespace

QStringList JournalJob::names() const {
    QStringList list{engineNumber, crankshaftNumber, customer};
    list.removeAll(QString());
    return list;
}

QString JournalJob::numbers() const {
    QStringList numbers{engineNumber, crankshaftNumber};
    numbers.removeAll(QString());
    return numbers.isEmpty() ? QStringLiteral("–") : numbers.join(QStringLiteral(" / "));
}

Journal::Journal(const QString& path, QObject* parent)
    : QObject(parent),
      path_(path),
      connection_(QStringLiteral("journal-") + QUuid::createUuid().toString(QUuid::Id128)) {}

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

bool Journal::failBy(const QString& what, const QSqlError& fault) {
    isBusy_ = journal_rows::meansBusy(fault);
    return fail(what, journal_rows::faultText(fault));
}

bool Journal::runText(const QString& sql, const QString& what) {
    QSqlQuery query(database());
    return query.exec(sql) || failBy(what, query.lastError());
}

Journal::Saved Journal::save(JournalJob& job) {
    if (!isReady()) {
        return Saved::No;
    }
    const Saved saved = saveOnce(job);
    return saved == Saved::No || keepsAsSaved(job) ? saved : Saved::No;
}

/// Whether the row reads as it was written.
bool Journal::keepsAsSaved(const JournalJob& job) {
    const auto kept = this->job(job.id);
    return (kept && kept->form == job.form && kept->revision == job.revision) ||
           fail(tr("The job could not be saved in the journal."), tr("the saved data differ"));
}

Journal::Saved Journal::saveOnce(JournalJob& job) {
    const QString cannot = tr("The job could not be saved in the journal.");
    job.saved = QDateTime::currentDateTimeUtc();
    bool asCopy = false;
    if (job.id != 0) {
        const auto changed =
            ask(QStringLiteral("UPDATE job SET revision = revision + 1, (%1) = (%2)"
                               " WHERE id = ? AND revision = ?")
                    .arg(journal_rows::written, journal_rows::places),
                journal_rows::valuesOf(job) << job.id << job.revision, cannot);
        if (!changed) {
            return Saved::No;
        }
        if (changed->numRowsAffected() == 1) {
            ++job.revision;
            return Saved::Yes;
        }
        asCopy = true;  // changed or removed elsewhere: neither version is lost
    }
    const auto added = ask(QStringLiteral("INSERT INTO job (revision, %1) VALUES (1, %2)")
                               .arg(journal_rows::written, journal_rows::places),
                           journal_rows::valuesOf(job), cannot);
    if (!added) {
        return Saved::No;
    }
    job.id = added->lastInsertId().toLongLong();
    job.revision = 1;
    return asCopy ? Saved::AsCopy : Saved::Yes;
}

std::optional<QSqlQuery> Journal::ask(const QString& sql, const QVariantList& values,
                                      const QString& cannot) {
    if (!isReady()) {
        return std::nullopt;
    }
    QSqlQuery query(database());
    query.setForwardOnly(true);
    query.prepare(sql);
    for (const QVariant& value : values) {
        query.addBindValue(value);
    }
    if (!query.exec()) {
        failBy(cannot, query.lastError());
        return std::nullopt;
    }
    error_.clear();
    return query;
}

std::optional<JournalJob> Journal::job(qint64 id) {
    auto found = ask(QStringLiteral("SELECT %1 FROM job WHERE id = ?").arg(journal_rows::columns),
                     {id}, tr("The job could not be read."));
    if (found && !found->next()) {
        fail(tr("The job was removed from the journal."), {});
        return std::nullopt;
    }
    return found ? std::optional(journal_rows::read(*found)) : std::nullopt;
}

QList<JournalJob> Journal::search(const JournalQuery& wanted) {
    const QString text = wanted.text.trimmed();
    const QDate day = readDay(text);
    constexpr int month = 7;  // letters
    const QVariant days = day.isValid()          ? day.toString(Qt::ISODate)
                          : text.size() == month ? literal(text) + QLatin1Char('%')
                                                 : QVariant();
    auto found = ask(QStringLiteral("SELECT %1 FROM job"
                                    " WHERE (search LIKE ? ESCAPE '\\' OR"
                                    " job_date LIKE ? ESCAPE '\\')"
                                    " AND is_finished <= ?"
                                    " ORDER BY job_date DESC, id DESC LIMIT ?")
                         .arg(journal_rows::columns),
                     {QLatin1Char('%') + literal(journal_rows::folded(text)) + QLatin1Char('%'),
                      days, wanted.unfinishedOnly ? 0 : 1, wanted.limit},
                     tr("The journal could not be searched."));
    QList<JournalJob> jobs;
    while (found && found->next()) {
        jobs << journal_rows::read(*found);
    }
    return jobs;
}

bool Journal::remove(qint64 id) {
    return ask(QStringLiteral("DELETE FROM job WHERE id = ?"), {id},
               tr("The job could not be removed."))
        .has_value();
}

bool Journal::discardDraft(const QString& session) {
    return ask(QStringLiteral("DELETE FROM draft WHERE session = ?"), {session},
               tr("The draft could not be removed."))
        .has_value();
}

QList<JournalDraft> Journal::orphanedDrafts() {
    QList<JournalDraft> drafts;
    auto found =
        ask(QStringLiteral("SELECT session, scene, job_id, job_revision, engine_number, form"
                           " FROM draft ORDER BY saved DESC LIMIT 100"),
            {}, tr("The drafts could not be read."));
    while (found && found->next()) {
        JournalDraft draft{found->value(0).toString(),   found->value(1).toString(),
                           found->value(2).toLongLong(), found->value(3).toInt(),
                           found->value(4).toString(),   found->value(5).toString().toUtf8()};
        // The lock of a program that runs cannot be taken; that of a crashed one can.
        QLockFile lock(path_ + QLatin1Char('.') + draft.session + QStringLiteral(".running"));
        lock.setStaleLockTime(0);
        if (lock.tryLock(0)) {
            drafts << draft;
        }
    }
    return drafts;
}

bool Journal::removeEngine(const QString& name) {
    return ask(QStringLiteral("DELETE FROM engine WHERE name = ?"), {name},
               tr("The engine could not be removed."))
        .has_value();
}

QList<JournalEngine> Journal::engines() {
    auto found = ask(QStringLiteral("SELECT name, engine_values FROM engine ORDER BY name"), {},
                     tr("The engines could not be read."));
    QList<JournalEngine> list;
    while (found && found->next()) {
        list << JournalEngine{found->value(0).toString(), found->value(1).toString().toUtf8()};
    }
    return list;
}

}  // namespace ravnoves

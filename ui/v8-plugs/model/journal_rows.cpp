#include "v8-plugs/model/journal_rows.h"

namespace ravnoves::journal_rows {

namespace {

// SQLite's primary result codes.
constexpr int sqliteBusy = 5;
constexpr int sqliteCorrupt = 11;
constexpr int sqliteNotADatabase = 26;

/// -1 where there is none.
int primaryCode(const QSqlError& error) {
    bool ok = false;
    const int code = error.nativeErrorCode().toInt(&ok) & 0xFF;
    return ok ? code : -1;
}

QString searchText(const JournalJob& job) {
    return folded(job.engineNumber + QLatin1Char('\n') + job.customer + QLatin1Char('\n') +
                  job.technician + QLatin1Char('\n') + job.engine);
}

QVariant orNull(const std::optional<double>& value) {
    return value ? QVariant(*value) : QVariant(QMetaType::fromType<double>());
}

std::optional<double> orNothing(const QVariant& value) {
    return value.isNull() ? std::nullopt : std::optional(value.toDouble());
}

}  // namespace

const QString columns = QStringLiteral(
    "id, revision, engine_number, customer, technician, engine, job_date, process, "
    "unbalanced_mass_g, recommended, reduction_g, bob_weight_g, saved, form");

QString folded(const QString& text) {
    return text.toCaseFolded();
}

QVariant stamp(const QDateTime& time) {
    return time.toMSecsSinceEpoch();
}
QDateTime fromStamp(const QVariant& value) {
    return QDateTime::fromMSecsSinceEpoch(value.toLongLong(), Qt::UTC);
}

QString bare(const QString& text) {
    return text.isNull() ? QLatin1String("") : text;
}

JournalJob read(const QSqlQuery& query) {
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

void bind(QSqlQuery& query, const JournalJob& job) {
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

bool saysBusy(const QSqlError& error) {
    return primaryCode(error) == sqliteBusy;
}

bool saysDamaged(const QSqlError& error) {
    const int code = primaryCode(error);
    return code == sqliteCorrupt || code == sqliteNotADatabase;
}

}  // namespace ravnoves::journal_rows

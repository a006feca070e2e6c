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
const QString written = columns.section(QStringLiteral(", "), 2) + QStringLiteral(", search");
const QString places = QStringLiteral("?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?");

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
    for (const QVariant& value :
         {QVariant(bare(job.engineNumber)), QVariant(bare(job.customer)),
          QVariant(bare(job.technician)), QVariant(bare(job.engine)),
          QVariant(bare(job.date.toString(Qt::ISODate))), QVariant(bare(job.process)),
          orNull(job.unbalancedMass), QVariant(bare(job.recommended)), orNull(job.reduction),
          orNull(job.bobWeight), stamp(job.saved), QVariant(bare(QString::fromUtf8(job.form))),
          QVariant(searchText(job))}) {
        query.addBindValue(value);
    }
}

bool saysBusy(const QSqlError& error) {
    return primaryCode(error) == sqliteBusy;
}

bool saysDamaged(const QSqlError& error) {
    const int code = primaryCode(error);
    return code == sqliteCorrupt || code == sqliteNotADatabase;
}

}  // namespace ravnoves::journal_rows

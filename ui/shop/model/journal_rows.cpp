#include "shop/model/journal_rows.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QSqlRecord>

#include "shop/model/journal.h"

namespace ravnoves::journal_rows {

namespace {

// SQLite's primary result codes.
constexpr int sqliteBusy = 5;
constexpr int sqliteLocked = 6;
constexpr int sqliteReadOnly = 8;
constexpr int sqliteInput = 10;
constexpr int sqliteCorrupt = 11;
constexpr int sqliteFull = 13;
constexpr int sqliteCannotOpen = 14;
constexpr int sqliteNotADatabase = 26;

/// -1 where there is none.
int primaryCode(const QSqlError& error) {
    bool ok = false;
    const int code = error.nativeErrorCode().toInt(&ok) & 0xFF;
    return ok ? code : -1;
}

QString searchText(const JournalJob& job) {
    return folded(QStringList{job.engineNumber, job.crankshaftNumber, job.customer, job.technician,
                              job.engine}
                      .join(QLatin1Char('\n')));
}

QVariant orNull(const std::optional<double>& value) {
    return value ? QVariant(*value) : QVariant(QMetaType::fromType<double>());
}

/// The empty text, not NULL, for a QString that was never set.
QString bare(const QString& text) {
    return text.isNull() ? QLatin1String("") : text;
}

std::optional<double> orNothing(const QVariant& value) {
    return value.isNull() ? std::nullopt : std::optional(value.toDouble());
}

}  // namespace

const QString columnsOfVersionOne = QStringLiteral(
    "id, revision, engine_number, customer, technician, engine, job_date, process, "
    "unbalanced_mass_g, recommended, reduction_g, bob_weight_g, saved, form");
const QString columns =
    columnsOfVersionOne +
    QStringLiteral(
        ", scene, crankshaft_number, front_reading_g_mm, rear_reading_g_mm, verdict, "
        "is_finished");
const QString written = columns.section(QStringLiteral(", "), 2) + QStringLiteral(", search");
const QString places = QStringLiteral("?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?");

QString folded(const QString& text) {
    return text.toCaseFolded();
}

void completeFromForm(JournalJob& job) {
    const QJsonObject input =
        QJsonDocument::fromJson(job.form).object().value(QLatin1String("input")).toObject();
    const QJsonObject machine = input.value(QLatin1String("balancing")).toObject();
    const auto reading = [&](QLatin1String key) {
        const QJsonValue value = machine.value(key);
        return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
    };
    job.scene = QStringLiteral("v8-plugs");
    job.crankshaftNumber = input.value(QLatin1String("job"))
                               .toObject()
                               .value(QLatin1String("crankshaft_number"))
                               .toString();
    job.frontReading = reading(QLatin1String("front_reading_g_mm"));
    job.rearReading = reading(QLatin1String("rear_reading_g_mm"));
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
    job.saved = QDateTime::fromMSecsSinceEpoch(query.value(12).toLongLong(), Qt::UTC);
    job.form = query.value(13).toString().toUtf8();
    if (query.record().count() <= 14) {
        completeFromForm(job);
        return job;
    }
    job.scene = query.value(14).toString();
    job.crankshaftNumber = query.value(15).toString();
    job.frontReading = orNothing(query.value(16));
    job.rearReading = orNothing(query.value(17));
    job.verdict = query.value(18).toString();
    job.isFinished = query.value(19).toBool();
    return job;
}

QVariantList valuesOf(const JournalJob& job) {
    return QVariantList() << bare(job.engineNumber) << bare(job.customer) << bare(job.technician)
                          << bare(job.engine) << bare(job.date.toString(Qt::ISODate))
                          << bare(job.process) << orNull(job.unbalancedMass)
                          << bare(job.recommended) << orNull(job.reduction) << orNull(job.bobWeight)
                          << job.saved.toMSecsSinceEpoch() << bare(QString::fromUtf8(job.form))
                          << bare(job.scene) << bare(job.crankshaftNumber)
                          << orNull(job.frontReading) << orNull(job.rearReading)
                          << bare(job.verdict) << (job.isFinished ? 1 : 0) << searchText(job);
}

bool meansDamaged(const QSqlError& error) {
    const int code = primaryCode(error);
    return code == sqliteCorrupt || code == sqliteNotADatabase;
}

bool meansBusy(const QSqlError& error) {
    const int code = primaryCode(error);
    return code == sqliteBusy || code == sqliteLocked;
}

QString faultText(const QSqlError& error) {
    switch (primaryCode(error)) {
        case sqliteFull:
            return Journal::tr("the disk is full");
        case sqliteReadOnly:
            return Journal::tr("the journal is read-only");
        case sqliteInput:
            return Journal::tr("disk error");
        case sqliteCannotOpen:
            return Journal::tr("the file cannot be opened");
        case sqliteBusy:
        case sqliteLocked:
            return Journal::tr("another program is writing to the journal");
        case sqliteCorrupt:
        case sqliteNotADatabase:
            return Journal::tr("the file is damaged");
        default:
            // The database's own word: the driver's says no more than what was tried.
            return error.databaseText().isEmpty() ? error.text() : error.databaseText();
    }
}

}  // namespace ravnoves::journal_rows

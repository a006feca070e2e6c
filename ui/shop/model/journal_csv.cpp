// The journal's list for a spreadsheet.

#include <algorithm>

#include "case-file/decimal.h"
#include "shop/model/journal.h"
#include "text/csv_format.h"
#include "text/write_file.h"

namespace ravnoves {

namespace {

/// A text that a person typed. What a spreadsheet would take for a formula is made a text.
QString safeText(const QString& typed) {
    static const QString formula = QStringLiteral("=+-@\t\r");
    QString safe = typed;
    if (!safe.isEmpty() && formula.contains(safe.front())) {
        safe.prepend(QLatin1Char('\''));
    }
    static const QString special = QStringLiteral(",;\"\r\n\t");
    if (std::any_of(safe.cbegin(), safe.cend(), [](QChar c) { return special.contains(c); })) {
        safe.replace(QLatin1Char('"'), QLatin1String("\"\""));
        safe = QLatin1Char('"') + safe + QLatin1Char('"');
    }
    return safe;
}

}  // namespace

QString Journal::csvText(const QList<JournalJob>& jobs, const QLocale& locale) {
    const CsvFormat format(locale);
    const auto line = [&](const QStringList& fields) {
        return fields.join(format.separator) + QLatin1String("\r\n");
    };
    // With the decimals of the job card.
    const auto number = [&](const std::optional<double>& value, int decimals) {
        return value ? QString::fromStdString(fixed_decimals(*value, decimals))
                           .replace(QLatin1Char('.'), format.point)
                     : QString();
    };
    static const QStringList columns =
        QStringLiteral(
            "id engine_number date customer technician engine process unbalanced_mass_g "
            "recommended reduction_g_per_plug bob_weight_g crankshaft_number verdict "
            "front_reading_g_mm rear_reading_g_mm scene finished saved_utc")
            .split(QLatin1Char(' '));
    QString text = line(columns);
    for (const JournalJob& job : jobs) {
        text += line(
            {QString::number(job.id), safeText(job.engineNumber), job.date.toString(Qt::ISODate),
             safeText(job.customer), safeText(job.technician), safeText(job.engine),
             safeText(job.process), number(job.unbalancedMass, 3), safeText(job.recommended),
             number(job.reduction, 3), number(job.bobWeight, 1), safeText(job.crankshaftNumber),
             safeText(job.verdict), number(job.frontReading, 1), number(job.rearReading, 1),
             safeText(job.scene), job.isFinished ? QStringLiteral("yes") : QStringLiteral("no"),
             job.saved.toString(Qt::ISODate)});
    }
    return text;
}

bool Journal::exportCsv(const QString& file, const QList<JournalJob>& jobs) {
    error_ = writeFile(file, [&] { return CsvFormat::file(csvText(jobs)); });
    return error_.isEmpty();
}

}  // namespace ravnoves

// The journal's list for a spreadsheet.

#include <algorithm>

#include "case-file/decimal.h"
#include "shop/model/journal.h"
#include "text/csv_format.h"
#include "text/write_file.h"

namespace ravnoves {

namespace {

/// One line of the list after the other, in the form of a language.
class CsvWriter {
  public:
    explicit CsvWriter(const QLocale& locale) : format_(locale) {}

    /// A text that a person typed. What a spreadsheet would take for a formula is made a text.
    QString text(const QString& typed) const {
        static const QString formula = QStringLiteral("=+-@\t\r");
        QString safe = typed;
        if (!safe.isEmpty() && formula.contains(safe.front())) {
            safe.prepend(QLatin1Char('\''));
        }
        static const QString special = QStringLiteral(",;\"\r\n\t");
        const bool quoted =
            std::any_of(safe.cbegin(), safe.cend(), [](QChar c) { return special.contains(c); });
        if (quoted) {
            safe.replace(QLatin1Char('"'), QLatin1String("\"\""));
            safe = QLatin1Char('"') + safe + QLatin1Char('"');
        }
        return safe;
    }

    /// With the decimals of the job card.
    QString number(const std::optional<double>& value, int decimals) const {
        return value ? QString::fromStdString(fixed_decimals(*value, decimals))
                           .replace(QLatin1Char('.'), format_.point)
                     : QString();
    }

    QString line(const QStringList& fields) const {
        return fields.join(format_.separator) + QLatin1String("\r\n");
    }

  private:
    CsvFormat format_;
};

}  // namespace

QString Journal::csvText(const QList<JournalJob>& jobs, const QLocale& locale) {
    const CsvWriter csv(locale);
    static const QStringList columns =
        QStringLiteral(
            "id engine_number date customer technician engine process unbalanced_mass_g "
            "recommended reduction_g_per_plug bob_weight_g crankshaft_number verdict "
            "front_reading_g_mm rear_reading_g_mm scene finished saved_utc")
            .split(QLatin1Char(' '));
    QString text = csv.line(columns);
    for (const JournalJob& job : jobs) {
        text += csv.line(
            {QString::number(job.id), csv.text(job.engineNumber), job.date.toString(Qt::ISODate),
             csv.text(job.customer), csv.text(job.technician), csv.text(job.engine),
             csv.text(job.process), csv.number(job.unbalancedMass, 3), csv.text(job.recommended),
             csv.number(job.reduction, 3), csv.number(job.bobWeight, 1),
             csv.text(job.crankshaftNumber), csv.text(job.verdict), csv.number(job.frontReading, 1),
             csv.number(job.rearReading, 1), csv.text(job.scene),
             job.isFinished ? QStringLiteral("yes") : QStringLiteral("no"),
             job.saved.toString(Qt::ISODate)});
    }
    return text;
}

bool Journal::exportCsv(const QString& file, const QList<JournalJob>& jobs) {
    error_ = writeFile(file, [&] { return CsvFormat::file(csvText(jobs)); });
    return error_.isEmpty();
}

}  // namespace ravnoves

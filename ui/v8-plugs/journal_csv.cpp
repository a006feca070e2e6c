// The journal's list for a spreadsheet.

#include <QSaveFile>

#include "case-file/range.h"
#include "v8-plugs/journal.h"

namespace ravnoves {

namespace {

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

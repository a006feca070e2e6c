// Writes jobs into a journal until it is killed, and says on standard output what has been saved:
// "job ID MARK" after each job.

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <cstdio>

#include "shop/model/journal.h"

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() < 4) {
        std::fprintf(stderr, "usage: journal_writer FILE MARK COUNT\n");
        return 2;
    }
    ravnoves::Journal journal(arguments.at(1));
    if (!journal.open()) {
        std::fprintf(stderr, "%s\n", qPrintable(journal.lastError()));
        return 1;
    }
    const QString mark = arguments.at(2);
    const int count = arguments.at(3).toInt();
    for (int i = 0; i < count; ++i) {
        const QString tag = mark + QLatin1Char('-') + QString::number(i);
        const QJsonObject form{{QStringLiteral("tag"), tag},
                               {QStringLiteral("padding"), QString(20000, QLatin1Char('x'))}};
        const QByteArray text = QJsonDocument(form).toJson(QJsonDocument::Compact);
        ravnoves::JournalJob job;
        job.engineNumber = tag;
        job.customer = QStringLiteral("Мастерская");
        job.date = QDate(2024, 5, 31);
        job.form = text;
        if (journal.save(job) != ravnoves::Journal::Saved::Yes) {
            std::fprintf(stderr, "%s\n", qPrintable(journal.lastError()));
            return 1;
        }
        std::printf("job %lld %s\n", static_cast<long long>(job.id), qPrintable(tag));
        std::fflush(stdout);
    }
    return 0;
}

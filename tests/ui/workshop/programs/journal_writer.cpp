// Writes jobs and drafts into a journal until it is killed, and says on standard output what has
// been saved: "job ID MARK" after each job, "draft MARK" after each draft. With "hold" it begins to
// write, says "held", and ends the write when its standard input ends.

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <cstdio>

#include "workshop/model/journal.h"

namespace {

int hold(const QString& file) {
    QSqlDatabase db = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"));
    db.setDatabaseName(file);
    if (!db.open() || !QSqlQuery(db).exec(QStringLiteral("BEGIN IMMEDIATE"))) {
        return 1;
    }
    std::puts("held");
    std::fflush(stdout);
    while (std::getchar() != EOF) {
    }
    QSqlQuery(db).exec(QStringLiteral("ROLLBACK"));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 3 && arguments.at(2) == QStringLiteral("hold")) {
        return hold(arguments.at(1));
    }
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
        ravnoves::JournalDraft draft;
        draft.form = text;
        bool kept = journal.saveDraft(draft);
        while (!kept && journal.wasBusy()) {
            kept = journal.saveDraft(draft);  // as the page does a little later
        }
        if (!kept) {
            std::fprintf(stderr, "%s\n", qPrintable(journal.lastError()));
            return 1;
        }
        std::printf("draft %s\n", qPrintable(tag));
        std::fflush(stdout);
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

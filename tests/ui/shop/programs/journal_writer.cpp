// Writes so many jobs into a journal that others write into, too.

#include <QCoreApplication>
#include <cstdio>

#include "shop/model/journal.h"

int main(int argc, char** argv) {
    QCoreApplication app(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    ravnoves::Journal journal(arguments.value(1));
    bool isSaved = journal.open();
    for (int i = 0; isSaved && i < arguments.value(2).toInt(); ++i) {
        ravnoves::JournalJob job;
        job.engineNumber = QString::number(i);
        job.form = QByteArray(20'000, 'x');
        isSaved = journal.save(job) == ravnoves::Journal::Saved::Yes;
    }
    if (!isSaved) {
        std::fprintf(stderr, "%s\n", qPrintable(journal.lastError()));
    }
    return isSaved ? 0 : 1;
}

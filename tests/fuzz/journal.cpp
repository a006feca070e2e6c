// A damaged journal: opened, or restored from. What cannot be read is set aside, and the journal is
// there for the next job in any case.

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <cstddef>
#include <cstdint>

#include "shop/model/journal.h"
#include "window_target.h"

namespace {

using namespace ravnoves;

JournalJob job(int number) {
    JournalJob made;
    made.scene = QStringLiteral("workshop");
    made.engineNumber = QStringLiteral("53-%1").arg(number);
    made.customer = QString(20 * number, QLatin1Char('x'));
    made.date = QDate(2026, 1, number);
    made.bobWeight = 2000.0 + number;
    made.form = QByteArrayLiteral(R"({"ravnoves":1,"scene":"workshop","input":{}})");
    return made;
}

QByteArray journalOfThree(const QString& path) {
    {
        Journal journal(path);
        require(journal.open(), "a new journal opens");
        for (int number = 1; number <= 3; ++number) {
            JournalJob added = job(number);
            require(journal.save(added) == Journal::Saved::Yes, "a job is saved");
        }
    }
    QFile file(path);
    require(file.open(QIODevice::ReadOnly), "the journal is a file");
    return file.readAll();
}

/// Three bytes of the input are a place in the file and what is changed there; where it begins with
/// "=" the rest is the whole file.
QByteArray damaged(QByteArray file, const std::uint8_t* data, std::size_t size) {
    if (size > 0 && data[0] == '=') {
        return QByteArray(reinterpret_cast<const char*>(data + 1),
                          static_cast<qsizetype>(size - 1));
    }
    for (std::size_t k = 0; k + 3 <= size; k += 3) {
        const qsizetype at = (data[k] * 256 + data[k + 1]) % file.size();
        file[at] = static_cast<char>(file[at] ^ data[k + 2]);
    }
    return size % 3 == 1 ? file.left(file.size() * data[size - 1] / 255) : file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    needApplication();
    static QTemporaryDir folder;
    static const QByteArray whole = journalOfThree(folder.filePath(QStringLiteral("whole.sqlite")));

    const QString own = folder.filePath(QStringLiteral("own"));
    require(QDir().mkpath(own), "there is a folder");
    const QString path = own + QStringLiteral("/journal.sqlite");
    {
        QFile file(path);
        require(file.open(QIODevice::WriteOnly), "the file is written");
        file.write(damaged(whole, data, size));
    }
    const QString backup = own + QStringLiteral("/backup.sqlite");
    require(QFile::copy(path, backup), "the backup is written");
    {
        Journal journal(path);
        JournalJob added = job(9);
        if (journal.open()) {
            journal.search({});
            journal.engines();
            if (journal.save(added) == Journal::Saved::No) {
                require(!journal.lastError().isEmpty(), "a refusal has words");
            }
        } else {
            require(!journal.lastError().isEmpty(), "a refusal has words");
        }
    }
    {
        Journal journal(own + QStringLiteral("/fresh.sqlite"));
        require(journal.open(), "a new journal opens");
        const auto restored = journal.restore(backup);
        require(restored || !journal.lastError().isEmpty(), "a refusal has words");
        require(!restored || journal.search({}).size() == restored->added,
                "what was added is there");
        JournalJob added = job(9);
        require(journal.save(added) != Journal::Saved::No, "the next job is saved");
    }
    require(QDir(own).removeRecursively(), "the folder goes");
    return 0;
}

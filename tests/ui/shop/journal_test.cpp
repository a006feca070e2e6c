#include "shop/model/journal.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <algorithm>
#include <atomic>

#include "files.h"
#include "shop/model/journal_rows.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class JournalTest : public ::testing::Test {
  protected:
    QString path(const QString& name = u"journal.sqlite"_s) const {
        return QDir(folder_.path()).filePath(name);
    }
    QStringList files(const QString& pattern) const {
        return QDir(folder_.path()).entryList({pattern}, QDir::Files);
    }

    static JournalJob exampleJob(const QString& number) {
        JournalJob job;
        job.scene = u"v8-plugs"_s;
        job.engineNumber = number;
        job.crankshaftNumber = u"КВ-17"_s;
        job.frontReading = 12.3456;
        job.verdict = u"passes"_s;
        job.customer = u"Автобаза № 3"_s;
        job.technician = u"O'Brien; \"Bob\""_s;
        job.engine = u"4.25 l"_s;
        job.date = QDate(2024, 5, 31);
        job.process = u"repair"_s;
        job.unbalancedMass = 4.3225;
        job.recommended = u"steel-machined"_s;
        job.reduction = 1.8315677966101696;
        job.bobWeight = 2326.5844;
        job.form = R"({"format":"ravnoves-case","title":"Ё"})";
        return job;
    }

    QTemporaryDir folder_;
};

/// With an open journal.
class OpenJournal : public JournalTest {
  protected:
    OpenJournal() { EXPECT_TRUE(journal.open()) << qPrintable(journal.lastError()); }
    JournalJob save(const QString& number) {
        JournalJob job = exampleJob(number);
        EXPECT_EQ(journal.save(job), Journal::Saved::Yes);
        return job;
    }

    Journal journal{path()};
};

/// Runs SQL in the file of a journal, as another program would.
void meddle(const QString& file, const QStringList& statements) {
    {
        QSqlDatabase other = QSqlDatabase::addDatabase(u"QSQLITE"_s, u"other"_s);
        other.setDatabaseName(file);
        ASSERT_TRUE(other.open());
        QSqlQuery query(other);
        for (const QString& statement : statements) {
            ASSERT_TRUE(query.exec(statement))
                << qPrintable(statement) << qPrintable(query.lastError().text());
        }
    }
    QSqlDatabase::removeDatabase(u"other"_s);
}

TEST_F(JournalTest, KeepsEveryValueOfAJob) {
    JournalJob job = exampleJob(u"53-11-0042"_s);
    {
        Journal journal(path(u"new/folder/journal.sqlite"_s));
        ASSERT_TRUE(journal.open()) << qPrintable(journal.lastError());
        EXPECT_EQ(journal.save(job), Journal::Saved::Yes);
    }
    Journal journal(path(u"new/folder/journal.sqlite"_s));
    ASSERT_TRUE(journal.open());
    const auto found = journal.job(job.id);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, job);
    EXPECT_EQ(found->revision, 1);
    EXPECT_LT(found->saved.secsTo(QDateTime::currentDateTimeUtc()), 60);
    JournalJob empty;
    EXPECT_EQ(journal.save(empty), Journal::Saved::Yes);
    EXPECT_FALSE(journal.job(empty.id)->unbalancedMass);
    EXPECT_FALSE(journal.job(empty.id)->date.isValid());
}

TEST_F(OpenJournal, SearchesByNumberCustomerAndDate) {
    const auto add = [&](const QString& number, const QString& customer, const QDate& date) {
        JournalJob job = exampleJob(number);
        job.customer = customer;
        job.date = date;
        EXPECT_EQ(journal.save(job), Journal::Saved::Yes);
    };
    add(u"ЗМЗ-001"_s, u"Иванов"_s, QDate(2024, 1, 10));
    add(u"ЗМЗ-002"_s, u"Петров"_s, QDate(2024, 2, 10));
    add(u"zil 100%"_s, u"Smith_Co"_s, QDate(2024, 3, 10));
    add(u"not a date"_s, u"Иванова"_s, QDate());
    const auto numbers = [&](const QString& text) {
        QStringList found;
        for (const JournalJob& job : journal.search({.text = text})) {
            found << job.engineNumber;
        }
        return found;
    };
    EXPECT_EQ(numbers(u"змз"_s), (QStringList{u"ЗМЗ-002"_s, u"ЗМЗ-001"_s}));
    EXPECT_EQ(numbers(u"  ИВАНОВ "_s), (QStringList{u"ЗМЗ-001"_s, u"not a date"_s}));
    EXPECT_EQ(numbers(u"100%"_s), (QStringList{u"zil 100%"_s}));
    EXPECT_EQ(numbers(u"кв-17"_s).size(), 4);  // the crankshaft's number
    EXPECT_EQ(numbers(u"%"_s), (QStringList{u"zil 100%"_s}));
    EXPECT_EQ(numbers(u"smith_"_s), (QStringList{u"zil 100%"_s}));
    EXPECT_EQ(numbers(u"'; DROP TABLE job; --"_s), QStringList());
    for (const QString& day : {u"2024-02-10"_s, u"2024-02"_s, u"10.02.2024"_s, u" 10.2.24"_s}) {
        EXPECT_EQ(numbers(day), (QStringList{u"ЗМЗ-002"_s})) << qPrintable(day);
    }
    EXPECT_TRUE(numbers(u"2024"_s).isEmpty()) << "it may be a number of an engine";
    EXPECT_EQ(numbers({}).size(), 4);
}

TEST_F(OpenJournal, ChangesAJobAndNeverOverwritesAnother) {
    Journal second(path());
    ASSERT_TRUE(second.open());
    JournalJob mine = save(u"A"_s);
    JournalJob theirs = second.job(mine.id).value();
    theirs.customer = u"theirs"_s;
    ASSERT_EQ(second.save(theirs), Journal::Saved::Yes);
    mine.customer = u"mine"_s;
    const qint64 old = mine.id;
    EXPECT_EQ(journal.save(mine), Journal::Saved::AsCopy);
    EXPECT_NE(mine.id, old);
    EXPECT_EQ(journal.job(old)->customer, u"theirs"_s);
    EXPECT_EQ(second.job(mine.id)->customer, u"mine"_s);
    // Removed elsewhere: saved again rather than lost.
    ASSERT_TRUE(second.remove(mine.id));
    EXPECT_EQ(journal.save(mine), Journal::Saved::AsCopy);
    EXPECT_EQ(journal.search({}).size(), 2);
}

TEST_F(OpenJournal, ExportsCsvThatASpreadsheetReads) {
    save(u"1,5\n2"_s);
    const QString file = path(u"out.csv"_s);
    test::writeFile(file, "old");
    ASSERT_TRUE(journal.exportCsv(file, journal.search({})));
    const QByteArray bytes = test::contentOf(file);
    EXPECT_TRUE(bytes.startsWith("\xEF\xBB\xBFid,engine_number,"));
    const QString text = QString::fromUtf8(bytes.mid(3));
    EXPECT_TRUE(text.contains(
        u"\r\n1,\"1,5\n2\",2024-05-31,Автобаза № 3,\"O'Brien; \"\"Bob\"\"\",4.25 l,repair,4.322,"
        u"steel-machined,1.832,2326.6,КВ-17,passes,12.3,,v8-plugs,yes,"_s))
        << qPrintable(text);
    // A place that cannot be written is said, and nothing else changes.
    EXPECT_FALSE(journal.exportCsv(path(u"nowhere/out.csv"_s), {}));
    EXPECT_TRUE(journal.lastError().contains(u"nowhere"_s));
}

TEST_F(JournalTest, FaultsAreSaidInWords) {
    const auto said = [](const char* code) {
        return journal_rows::faultText(QSqlError(u"Unable to fetch row"_s, u"of the database"_s,
                                                 QSqlError::StatementError,
                                                 QString::fromLatin1(code)));
    };
    EXPECT_EQ(said("13"), u"the disk is full"_s);
    EXPECT_EQ(said("778"), u"disk error"_s);  // IOERR_WRITE
    EXPECT_EQ(said("1"), u"of the database"_s);
}

TEST_F(JournalTest, CsvFollowsTheLanguageAndHoldsNoFormulas) {
    JournalJob job = exampleJob(u"=HYPERLINK(\"http://x\")"_s);
    job.id = 7;
    job.customer = u"+7 495 123"_s;
    job.technician = u"@SUM(A1)"_s;
    job.engine = u"-1,5"_s;
    const QString english = Journal::csvText({job}, QLocale(QLocale::English));
    EXPECT_TRUE(
        english.contains(u"\r\n7,\"'=HYPERLINK(\"\"http://x\"\")\",2024-05-31,'+7 495 "
                         u"123,'@SUM(A1),\"'-1,5\",repair,"
                         "4.322,steel-machined,1.83"_s))
        << qPrintable(english);
    const QString russian = Journal::csvText({job}, QLocale(QLocale::Russian));
    EXPECT_TRUE(russian.startsWith(u"id;engine_number;date;"_s)) << qPrintable(russian);
    EXPECT_TRUE(russian.contains(u";repair;4,322;steel-machined;1,83"_s)) << qPrintable(russian);
    // A reduction below nothing is a number, not a text.
    job.unbalancedMass = -0.5;
    EXPECT_TRUE(Journal::csvText({job}, QLocale::c()).contains(u",repair,-0.500,"_s));
}

TEST_F(OpenJournal, WritesAreOnDiskWhenTheCallReturns) {
    // A killed program cannot show this; a power cut would.
    QSqlQuery query(QSqlDatabase::database(QSqlDatabase::connectionNames().constFirst()));
    ASSERT_TRUE(query.exec(u"PRAGMA journal_mode"_s) && query.next());
    EXPECT_EQ(query.value(0).toString(), u"wal"_s);
    ASSERT_TRUE(query.exec(u"PRAGMA synchronous"_s) && query.next());
    EXPECT_EQ(query.value(0).toInt(), 2);  // FULL: the log is synced at every commit
}

TEST_F(JournalTest, AFileOfTheFirstVersionOpensAndIsSearched) {
    meddle(path(),
           {u"CREATE TABLE job (id INTEGER PRIMARY KEY AUTOINCREMENT, revision INTEGER NOT NULL,"
            " engine_number TEXT NOT NULL, customer TEXT NOT NULL, technician TEXT NOT NULL,"
            " engine TEXT NOT NULL, job_date TEXT NOT NULL, process TEXT NOT NULL,"
            " unbalanced_mass_g REAL, recommended TEXT NOT NULL, reduction_g REAL,"
            " bob_weight_g REAL, saved INTEGER NOT NULL, form TEXT NOT NULL,"
            " search TEXT NOT NULL)"_s,
            u"CREATE TABLE draft (session TEXT PRIMARY KEY, job_id INTEGER NOT NULL,"
            " job_revision INTEGER NOT NULL, engine_number TEXT NOT NULL,"
            " saved INTEGER NOT NULL, form TEXT NOT NULL)"_s,
            u"CREATE TABLE engine (name TEXT PRIMARY KEY, engine_values TEXT NOT NULL)"_s,
            u"INSERT INTO draft VALUES ('gone', 0, 0, '7', 1, '{}')"_s,
            u"INSERT INTO job VALUES (5, 2, '53-11', 'Smith', '', '4.25 l', '2023-05-31',"
            " 'repair', 4.3, 'steel-machined', 1.8, 2326.5, 1000,"
            " '{\"input\":{\"job\":{\"crankshaft_number\":\"КВ-9\"},"
            "\"balancing\":{\"rear_reading_g_mm\":8}}}', '53-11 smith')"_s,
            u"INSERT INTO job VALUES (6, 1, 'torn', '', '', '', '', '', NULL, '', NULL, NULL,"
            " 2000, 'no form', 'torn')"_s,
            u"PRAGMA user_version = 1"_s});
    for (int times = 0; times < 2; ++times) {  // brought up to date once
        Journal journal(path());
        ASSERT_TRUE(journal.open()) << qPrintable(journal.lastError());
        EXPECT_TRUE(journal.openMessage().isEmpty());
        const auto found = journal.search({.text = u"кв-9"_s});
        ASSERT_EQ(found.size(), 1);
        EXPECT_EQ(found.constFirst().id, 5);
        EXPECT_EQ(found.constFirst().revision, 2);
        EXPECT_EQ(found.constFirst().rearReading, 8.0);
        EXPECT_EQ(found.constFirst().saved.toMSecsSinceEpoch(), 1000);
        EXPECT_EQ(journal.search({}).size(), 2);
        EXPECT_EQ(journal.orphanedDrafts().size(), 1);
    }
}

TEST_F(OpenJournal, OfManyDraftsTheNewestHundredAreLookedAt) {
    meddle(path(), {u"WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n LIMIT 2000)"
                    " INSERT INTO draft SELECT i, 0, 0, '', i, '{}', 'workshop' FROM n"_s});
    const auto drafts = journal.orphanedDrafts();
    ASSERT_EQ(drafts.size(), 100);
    EXPECT_EQ(drafts.constFirst().session, u"2000"_s);
}

TEST_F(JournalTest, WithSomethingOfAnotherProgramInItIsRejected) {
    const QStringList viewOfJobs{
        u"ALTER TABLE job RENAME TO kept"_s,
        u"CREATE VIEW job AS WITH RECURSIVE n(id) AS (SELECT 1 UNION ALL SELECT id + 1 FROM n)"
        " SELECT id, 1 AS revision FROM n"_s};
    const QList<QStringList> changes{
        {u"CREATE TRIGGER lose AFTER INSERT ON job BEGIN DELETE FROM job; END"_s},
        viewOfJobs,
        {u"CREATE TABLE other (x)"_s},
        {u"PRAGMA application_id = 7"_s}};
    for (const QStringList& change : changes) {
        const QString file = path(u"foreign.sqlite"_s);
        {
            Journal journal(file);
            ASSERT_TRUE(journal.open());
            JournalJob job = exampleJob(u"one"_s);
            ASSERT_EQ(journal.save(job), Journal::Saved::Yes);
        }
        meddle(file, change);
        Journal journal(file);
        EXPECT_FALSE(journal.open()) << qPrintable(change.first());
        EXPECT_TRUE(journal.lastError().contains(u"another program"_s));
        JournalJob job = exampleJob(u"two"_s);
        EXPECT_EQ(journal.save(job), Journal::Saved::No);
        // Nor is anything taken from it.
        Journal own(path());
        ASSERT_TRUE(own.open());
        EXPECT_FALSE(own.restore(file));
        EXPECT_TRUE(own.lastError().contains(u"not a backup"_s)) << qPrintable(own.lastError());
        EXPECT_TRUE(own.search({}).isEmpty());
        EXPECT_TRUE(files(u"*damaged*"_s).isEmpty());
        for (const QString& name : files(u"foreign*"_s)) {
            QFile::remove(path(name));
        }
    }
}

TEST_F(JournalTest, ADatabaseOfAnotherProgramKeepsItsBytes) {
    for (const QString& more :
         {u"CREATE VIEW job AS SELECT * FROM q"_s,
          u"CREATE TRIGGER lose AFTER INSERT ON q BEGIN DELETE FROM q; END"_s}) {
        const QString file = path(u"other.sqlite"_s);
        QFile::remove(file);
        meddle(file, {u"CREATE TABLE q (a)"_s, more});
        const QByteArray before = test::contentOf(file);
        Journal journal(file);
        EXPECT_FALSE(journal.open()) << qPrintable(more);
        EXPECT_EQ(test::contentOf(file), before) << qPrintable(more);
    }
}

/// In its place, or where SQLite looks for what belongs to it: neither is waited for.
TEST_F(JournalTest, APipeIsRejected) {
    for (const char* suffix : {"", "-journal", "-wal", "-shm"}) {
        const QString file = path(u"pipe.sqlite"_s);
        if (*suffix != 0) {
            Journal journal(file);
            ASSERT_TRUE(journal.open());
        }
        const QString pipe = file + QLatin1String(suffix);
        QFile::remove(pipe);
        ASSERT_EQ(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        Journal journal(file);
        EXPECT_FALSE(journal.open()) << suffix;
        EXPECT_TRUE(journal.lastError().contains(u"pipe"_s)) << qPrintable(journal.lastError());
        Journal own(path());
        ASSERT_TRUE(own.open());
        EXPECT_FALSE(own.restore(file)) << suffix;
        EXPECT_TRUE(own.lastError().contains(u"not a backup"_s)) << qPrintable(own.lastError());
        for (const char* each : {"", "-journal", "-wal", "-shm"}) {
            QFile::remove(file + QLatin1String(each));
        }
    }
    // A file of the system that makes its reader wait.
    Journal own(path());
    ASSERT_TRUE(own.open());
    EXPECT_FALSE(own.restore(u"/proc/kmsg"_s));
}

TEST_F(OpenJournal, AJobThatTheFileDoesNotKeepIsNotSaved) {
    meddle(path(), {u"CREATE TRIGGER lose AFTER INSERT ON job BEGIN DELETE FROM job; END"_s});
    JournalJob job = exampleJob(u"lost"_s);
    EXPECT_EQ(journal.save(job), Journal::Saved::No);
    EXPECT_FALSE(journal.lastError().isEmpty());
}

TEST_F(JournalTest, ADamagedFileIsReplacedByItsDailyBackup) {
    const auto fill = [&](int jobs) {
        Journal journal(path());
        ASSERT_TRUE(journal.open());
        for (int i = 0; i < jobs; ++i) {
            JournalJob job = exampleJob(u"number %1"_s.arg(i));
            ASSERT_EQ(journal.save(job), Journal::Saved::Yes);
        }
    };
    fill(20);
    EXPECT_TRUE(files(u"*backup*"_s).isEmpty()) << "nothing to keep yet";
    fill(1);
    ASSERT_EQ(files(u"journal-backup-*.sqlite"_s).size(), 1);
    fill(0);
    EXPECT_EQ(files(u"journal-backup-*.sqlite"_s).size(), 1) << "once a day";
    // Old ones go, the newest seven stay.
    for (int day = 10; day < 20; ++day) {
        QFile::copy(path(files(u"*backup*"_s).last()),
                    path(u"journal-backup-2024-05-%1.sqlite"_s.arg(day)));
    }
    QFile::remove(path(files(u"*backup*"_s).last()));
    fill(0);
    EXPECT_EQ(files(u"journal-backup-*.sqlite"_s).size(), 7);

    test::writeFile(path(), "not a database at all");
    Journal journal(path());
    ASSERT_TRUE(journal.open()) << qPrintable(journal.lastError());
    EXPECT_TRUE(journal.search({}).isEmpty());
    ASSERT_FALSE(journal.offeredBackup().isEmpty());
    EXPECT_TRUE(journal.openMessage().contains(u"Its last backup"_s));
    std::atomic<bool> cancelled = true;
    EXPECT_FALSE(journal.restore(journal.offeredBackup(), &cancelled));
    EXPECT_TRUE(journal.search({}).isEmpty());
    const auto done = journal.restore(journal.offeredBackup());
    ASSERT_TRUE(done) << qPrintable(journal.lastError());
    EXPECT_EQ(done->added, 21);
    EXPECT_EQ(journal.search({}).size(), 21);
    EXPECT_EQ(journal.restore(journal.offeredBackup())->known, 21) << "none comes twice";
}

using Damage = void (*)(QByteArray& bytes);

class DamagedJournal : public JournalTest, public ::testing::WithParamInterface<Damage> {};

TEST_P(DamagedJournal, IsSetAsideWithAMessageAndNeverOverwritten) {
    {
        Journal journal(path());
        ASSERT_TRUE(journal.open());
        for (int i = 0; i < 200; ++i) {
            JournalJob job = exampleJob(u"number %1"_s.arg(i));
            job.form = QByteArray(4000, 'f');
            ASSERT_EQ(journal.save(job), Journal::Saved::Yes);
        }
    }
    QByteArray bytes = test::contentOf(path());
    ASSERT_GT(bytes.size(), 500000);
    GetParam()(bytes);
    test::writeFile(path(), bytes);
    Journal journal(path());
    ASSERT_TRUE(journal.open()) << qPrintable(journal.lastError());
    const QStringList aside = files(u"*damaged*.sqlite"_s);
    ASSERT_EQ(aside.size(), 1);
    EXPECT_TRUE(journal.openMessage().contains(aside.front()));
    EXPECT_EQ(test::contentOf(path(aside.front())), bytes);
    JournalJob job = exampleJob(u"after"_s);
    EXPECT_EQ(journal.save(job), Journal::Saved::Yes);
    // Damaged again in the same second: another name.
    Journal again(path(u"second.sqlite"_s));
    test::writeFile(path(u"second.sqlite"_s),
                    "not a database at all, but long enough to have a head");
    ASSERT_TRUE(again.open());
    EXPECT_EQ(files(u"second-damaged*"_s).size(), 1);
}

constexpr Damage damages[] = {
    [](QByteArray& bytes) { bytes = "This is a letter, not a database. " + QByteArray(5000, 'z'); },
    [](QByteArray& bytes) { bytes.replace(0, 4096, QByteArray(4096, '\0')); },  // the head is lost
    [](QByteArray& bytes) { bytes.replace(300000, 40000, QByteArray(40000, '\x5A')); },
    [](QByteArray& bytes) { bytes.truncate(bytes.size() / 2); }};
INSTANTIATE_TEST_SUITE_P(Kinds, DamagedJournal, ::testing::ValuesIn(damages));

TEST_F(OpenJournal, DamageWhileOpenIsNoticedAndTheJobIsSaved) {
    Journal other(path());
    ASSERT_TRUE(other.open());
    save(u"before"_s);
    // The other program finds it damaged and sets it aside; here it is played by a rename.
    QFile::rename(path(), path(u"moved.sqlite"_s));
    QFile::remove(path() + u"-wal"_s);
    QFile::remove(path() + u"-shm"_s);
    save(u"after"_s);
    Journal fresh(path());
    ASSERT_TRUE(fresh.open());
    ASSERT_EQ(fresh.search({}).size(), 1);
    EXPECT_EQ(fresh.search({}).constFirst().engineNumber, u"after"_s);
}

TEST_F(JournalTest, ForeignAndNewerFilesAreLeftAsTheyAre) {
    {
        Journal journal(path());
        ASSERT_TRUE(journal.open());
    }
    // user_version lies at offset 60 of the head, big endian.
    QByteArray bytes = test::contentOf(path());
    bytes[63] = 9;
    test::writeFile(path(), bytes);
    Journal newer(path());
    EXPECT_FALSE(newer.open());
    EXPECT_TRUE(newer.lastError().contains(u"newer program"_s)) << qPrintable(newer.lastError());
    EXPECT_TRUE(files(u"*damaged*"_s).isEmpty());
    JournalJob job;
    EXPECT_EQ(newer.save(job), Journal::Saved::No);
    // The head counts changes of the file even where nothing changed; the version stands.
    EXPECT_EQ(test::contentOf(path())[63], 9);
}

TEST_F(JournalTest, AFolderThatCannotBeWrittenIsSaid) {
    test::writeFile(path(u"file"_s), "x");
    Journal journal(path(u"file/journal.sqlite"_s));
    EXPECT_FALSE(journal.open());
    EXPECT_FALSE(journal.lastError().isEmpty());
    JournalJob job;
    EXPECT_EQ(journal.save(job), Journal::Saved::No);
    EXPECT_FALSE(journal.lastError().isEmpty());
    EXPECT_TRUE(journal.search({}).isEmpty());
}

TEST_F(JournalTest, FourProgramsAtOnceLoseNothing) {
    constexpr int programs = 4;
    constexpr int each = 25;
    std::vector<std::unique_ptr<QProcess>> writers;
    for (int i = 0; i < programs; ++i) {
        writers.push_back(std::make_unique<QProcess>());
        writers.back()->start(QStringLiteral(JOURNAL_WRITER), {path(), QString::number(each)});
    }
    for (const auto& writer : writers) {
        ASSERT_TRUE(writer->waitForFinished(120000));
        EXPECT_EQ(writer->exitCode(), 0) << writer->readAllStandardError().data();
    }
    Journal journal(path());
    ASSERT_TRUE(journal.open());
    EXPECT_TRUE(journal.openMessage().isEmpty());
    EXPECT_EQ(journal.search({}).size(), programs * each);
}

}  // namespace
}  // namespace ravnoves

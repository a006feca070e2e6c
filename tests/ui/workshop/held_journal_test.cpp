// Another program holds the journal while somebody works on the page.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>

#include "case-file/json.h"
#include "events.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/v8_plugs_page.h"
#include "widgets/number_field.h"
#include "workshop_page_test.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class HeldJournal : public test::WorkshopPageTest<V8PlugsPage> {
  protected:
    HeldJournal() {
        type("engine_number", u"53-11"_s);
        type("rod_big_end", u"1"_s);
    }

    QString path() const { return QDir(folder.path()).filePath(u"journal.sqlite"_s); }
    JobDesk& desk() { return *model->desk(); }
    void save() {
        page.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
        QTest::keyClick(&page, Qt::Key_F2);
    }
    void hold() {
        other.start(QStringLiteral(JOURNAL_WRITER), {path(), u"hold"_s});
        ASSERT_TRUE(other.waitForReadyRead(30'000));
        ASSERT_EQ(other.readAllStandardOutput(), "held\n");
    }
    void letGo() {
        other.closeWriteChannel();
        ASSERT_TRUE(other.waitForFinished());
    }
    bool isSaved() {
        return QTest::qWaitFor([this] { return !desk().isWaiting(); }, 20'000);
    }
    double savedMass() {
        const auto job = desk().journal()->job(desk().jobId());
        const Json form = Json::parse(job.value_or(JournalJob{}).form.toStdString());
        return form.at("input").at("mass_changes_g").value("rod_big_end", 0.0);
    }

    QProcess other;
};

TEST_F(HeldJournal, TakesKeysWhileAJobWaits) {
    QStringList said;
    QObject::connect(&page, &ScenePage::status, [&](const QString& text) { said << text; });
    ASSERT_NO_FATAL_FAILURE(hold());
    // The longest time that the window answered nothing.
    qint64 longest = 0;
    QElapsedTimer sinceTick;
    sinceTick.start();
    QTimer clock;
    QObject::connect(&clock, &QTimer::timeout,
                     [&] { longest = std::max(longest, sinceTick.restart()); });
    clock.start(5);

    save();
    EXPECT_TRUE(desk().isWaiting());
    type("rod_big_end", u"2"_s);
    EXPECT_EQ(test::named<NumberField>(page, "rod_big_end")->value(), 2.0);
    EXPECT_TRUE(QTest::qWaitFor([&] { return said.join(u' ').contains(u"Another program"_s); }));
    save();  // once is enough
    EXPECT_EQ(page.askToSave(), false);
    QTest::qWait(1000);
    EXPECT_TRUE(desk().isWaiting());
    EXPECT_EQ(desk().jobId(), 0);
    longest = std::max(longest, sinceTick.elapsed());
    clock.stop();
    EXPECT_LT(longest, 900);  // ms; it waited for seconds before
    ASSERT_NO_FATAL_FAILURE(letGo());
    ASSERT_TRUE(isSaved());

    // The job is as it was when it was to be saved; what was typed since is a change of it.
    EXPECT_TRUE(said.last().contains(u"saved in the journal"_s)) << said.last().toStdString();
    ASSERT_GT(desk().jobId(), 0);
    EXPECT_EQ(savedMass(), 1.0);
    EXPECT_TRUE(page.viewModel()->hasChanges());
    EXPECT_FALSE(desk().isJournaled());
    save();
    ASSERT_TRUE(isSaved());
    EXPECT_EQ(savedMass(), 2.0);
    EXPECT_TRUE(desk().isJournaled());
    EXPECT_EQ(desk().journal()->search({}).size(), 1);
}

TEST_F(HeldJournal, DraftsAreKeptAsSoonAsItIsFree) {
    ASSERT_NO_FATAL_FAILURE(hold());
    QElapsedTimer clock;
    clock.start();
    for (const char* mass : {"2", "3", "4"}) {
        type("rod_big_end", QLatin1String(mass));
    }
    EXPECT_LT(clock.elapsed(), 2000);
    QTest::qWait(500);
    ASSERT_NO_FATAL_FAILURE(letGo());
    QTest::qWait(500);
    Journal reader(path());
    ASSERT_TRUE(reader.open());
    // Of a session that runs: nobody is offered it, but it is there.
    desk().flushDraft();
    EXPECT_TRUE(reader.orphanedDrafts().isEmpty());
    EXPECT_TRUE(desk().journalTrouble().isEmpty()) << desk().journalTrouble().toStdString();
}

TEST_F(HeldJournal, WhoQuitsDoesNotWaitForEver) {
    ASSERT_NO_FATAL_FAILURE(hold());
    {
        // Who quits does not wait for another program for ever.
        V8PlugsModel model(path(), nullptr);
        ASSERT_TRUE(model.desk()->openJournal());
        model.edit(u"number"_s, [](v8_plugs::Input& input) { input.job.engine_number = "7"; });
        bool told = false;
        model.desk()->saveJob(true, [&](bool, const QString&) { told = true; });
        EXPECT_FALSE(told);
    }
    ASSERT_NO_FATAL_FAILURE(letGo());
    save();
    ASSERT_TRUE(isSaved());
    EXPECT_EQ(desk().journal()->search({}).size(), 1);
}

/// Another program that opens the journal and does not come to an end with it.
class HeldOpening {
  public:
    explicit HeldOpening(const QString& path)
        : handle_(::open(qPrintable(path + u".opening"_s), O_RDWR | O_CREAT, 0644)) {
        EXPECT_EQ(::flock(handle_, LOCK_EX), 0);
    }
    ~HeldOpening() { letGo(); }
    void letGo() {
        if (handle_ >= 0) {
            ::close(std::exchange(handle_, -1));
        }
    }

  private:
    int handle_;
};

TEST(HeldJournalsOpening, GoesOnInAThreadAndIsTold) {
    const QTemporaryDir folder;
    const QString path = QDir(folder.path()).filePath(u"journal.sqlite"_s);
    HeldOpening other(path);
    V8PlugsModel model(path, nullptr);
    JobDesk& desk = *model.desk();
    QElapsedTimer clock;
    clock.start();
    EXPECT_FALSE(desk.openJournal());
    EXPECT_TRUE(desk.journalTrouble().contains(u"Another program is busy"_s))
        << desk.journalTrouble().toStdString();
    EXPECT_FALSE(desk.openJournal());
    model.edit(u"number"_s, [](v8_plugs::Input& input) { input.job.engine_number = "7"; });
    EXPECT_LT(clock.elapsed(), 2000);  // ms; it waited for fifteen seconds before
    other.letGo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return desk.isOpen(); }, 20'000));
    EXPECT_EQ(desk.journalTrouble(), QString());
    bool isSaved = false;
    desk.saveJob(&isSaved);
    EXPECT_TRUE(isSaved);
}

TEST(HeldJournalsOpening, KeepsNobodyWhoQuits) {
    const QTemporaryDir folder;
    const QString path = QDir(folder.path()).filePath(u"journal.sqlite"_s);
    const HeldOpening other(path);
    QElapsedTimer clock;
    {
        V8PlugsModel model(path, nullptr);
        EXPECT_FALSE(model.desk()->openJournal());
        clock.start();
    }
    EXPECT_LT(clock.elapsed(), 2000);
}

}  // namespace
}  // namespace ravnoves

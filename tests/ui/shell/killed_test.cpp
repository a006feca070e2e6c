// The window is killed while it saves, again and again: nothing that was saved is lost, and nothing
// is half. RAVNOVES_KILLS says how often.

#include <gtest/gtest.h>
#include <signal.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRandomGenerator>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "model/case_document.h"
#include "model/recovery.h"
#include "shop/model/journal.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class KilledWindow : public ::testing::Test {
  protected:
    KilledWindow() {
        QFile::copy(u":/examples/tmz-650d.case.json"_s, file);
        QFile(file).setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    }

    /// What the window said last of a kind before it was killed; −1: nothing.
    struct Said {
        int next = -1;
        int saved = -1;
        int job = -1;
    };
    static void read(const QByteArray& output, Said& said) {
        const qsizetype end = output.lastIndexOf('\n');  // the last line may be cut
        for (const QByteArray& line : output.left(std::max<qsizetype>(end, 0)).split('\n')) {
            const int number = QString::fromLatin1(line).section(u' ', 1).toInt();
            (line.startsWith("next")   ? said.next
             : line.startsWith("case") ? said.saved
                                       : said.job) = number;
        }
    }

    QTemporaryDir folder;
    const QString file = folder.filePath(u"saved.case.json"_s);
    const QString data = folder.filePath(u"data/Ravnoves/Ravnoves"_s);
    const QString settings = folder.filePath(u"config/Ravnoves/Ravnoves.conf"_s);
};

TEST_F(KilledWindow, LosesNothingThatItSaved) {
    bool isNumber = false;
    int rounds = qEnvironmentVariableIntValue("RAVNOVES_KILLS", &isNumber);
    rounds = isNumber ? rounds : 8;
    QRandomGenerator random(20261122);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"XDG_DATA_HOME"_s, folder.filePath(u"data"_s));
    environment.insert(u"XDG_CONFIG_HOME"_s, folder.filePath(u"config"_s));
#ifdef RAVNOVES_FAKETIME
    const QString clock = QStringLiteral(RAVNOVES_FAKETIME);
#else
    const QString clock;
#endif
    Said all;
    int offered = 0;
    for (int round = 0; round < rounds; ++round) {
        SCOPED_TRACE(round);
        QProcessEnvironment its = environment;
        if (!clock.isEmpty() && round % 2 == 1) {
            // Everything that the window finds is of tomorrow.
            its.insert(u"LD_PRELOAD"_s, clock);
            its.insert(u"FAKETIME"_s, u"-1d"_s);
            its.insert(u"FAKETIME_DONT_FAKE_MONOTONIC"_s, u"1"_s);
        }
        QProcess window;
        window.setProcessEnvironment(its);
        window.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        window.start(QStringLiteral(WINDOW_SAVER), {file, QString::number(all.next + 1)});
        ASSERT_TRUE(window.waitForStarted());
        QByteArray output;
        while (!output.contains("job")) {
            ASSERT_TRUE(window.waitForReadyRead(60'000)) << output.toStdString();
            output += window.readAllStandardOutput();
        }
        {
            Recovery other(QDir(data).filePath(u"recovery"_s));
            EXPECT_TRUE(other.leftBehind().cases.isEmpty()) << "that window runs";
        }
        // Every other time long enough for a copy of what is not saved.
        QTest::qSleep(static_cast<int>(random.bounded(round % 2 == 0 ? 700U : 60U)));
        ASSERT_EQ(::kill(static_cast<pid_t>(window.processId()), SIGKILL), 0);
        ASSERT_TRUE(window.waitForFinished());
        ASSERT_EQ(window.exitStatus(), QProcess::CrashExit);
        output += window.readAllStandardOutput();
        read(output, all);

        // The case is whole: as it was said last, or as it was being saved.
        const CaseFile kept = CaseDocument::read(file);
        const int inFile = static_cast<int>(
            std::lround((kept.input.at("centre_distance_mm").get<double>() - 100.0) * 1e3));
        EXPECT_GE(inFile, all.saved);
        EXPECT_LE(inFile, all.next);
        // So is the job.
        Journal journal(QDir(data).filePath(u"journal.sqlite"_s));
        ASSERT_TRUE(journal.open()) << journal.lastError().toStdString();
        EXPECT_TRUE(journal.openMessage().isEmpty());
        const QList<JournalJob> jobs = journal.search({});
        ASSERT_FALSE(jobs.isEmpty());
        int inJournal = -1;
        for (const JournalJob& job : jobs) {
            inJournal = std::max(inJournal, job.technician.toInt());
            EXPECT_TRUE(job.form.endsWith('}')) << "half a job";
        }
        EXPECT_GE(inJournal, all.job);
        EXPECT_LE(inJournal, all.next);
        // The settings are written a moment after the job.
        const QSettings read(settings, QSettings::IniFormat);
        EXPECT_EQ(read.status(), QSettings::NoError);
        const int inSettings = read.value(u"workshop/technician"_s, -2).toInt();
        EXPECT_GE(inSettings, all.job - 1);
        EXPECT_LE(inSettings, all.next);
        // What was not saved is offered, and none of it is half.
        Recovery recovery(QDir(data).filePath(u"recovery"_s));
        const Recovery::Found found = recovery.leftBehind();
        EXPECT_TRUE(found.damaged.isEmpty()) << found.damaged.join(u' ').toStdString();
        for (const RecoveredCase& each : found.cases) {
            offered += each.content.scene == "elastic-hinge" ? 1 : 0;
            recovery.discard(each);
        }
    }
    EXPECT_GE(offered, rounds / 8);
    RecordProperty("cases_saved", all.saved);
}

}  // namespace
}  // namespace ravnoves

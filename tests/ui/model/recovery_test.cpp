// What is kept for a crash, and what others do to a file meanwhile.

#include "model/recovery.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "case-file/json.h"
#include "case-file/text_file.h"
#include "comes.h"
#include "files.h"
#include "full_disk.h"
#include "model/case_document.h"
#include "model/root_model.h"
#include "processor_time.h"

namespace ravnoves {
namespace {

constexpr int soon = 900;  // ms; less than a second

class RecoveryTest : public ::testing::Test {
  protected:
    QStringList kept() const {
        return QDir(keptIn()).entryList({QStringLiteral("*.json")}, QDir::Files);
    }
    QString keptIn() const { return folder.filePath(QStringLiteral("kept")); }
    QString file(const char* name) const { return folder.filePath(QString::fromUtf8(name)); }
    void watch(Recovery& recovery) { recovery.watch(&document); }

    QTemporaryDir folder;
    test::RootModel model;
    CaseDocument document{&model};
};

TEST_F(RecoveryTest, KeepsWhatIsNotSavedWithinASecond) {
    Recovery recovery(keptIn());
    watch(recovery);
    QTest::qWait(soon);
    EXPECT_TRUE(kept().isEmpty());
    model.set("square", 9.0);
    EXPECT_TRUE(test::comes([&] { return kept().size() == 1; }));
    // A hand that never rests is no reason to wait.
    const QString path = QDir(keptIn()).filePath(kept().constFirst());
    const QByteArray before = test::contentOf(path);
    bool isNew = false;
    for (int i = 0; i < soon / 20 && !isNew; ++i) {
        model.set("square", 10.0 + i);
        QTest::qWait(20);
        isNew = test::contentOf(path) != before;
    }
    EXPECT_TRUE(isNew);
}

TEST_F(RecoveryTest, WhatIsBeingTypedIsKept) {
    Recovery recovery(keptIn());
    watch(recovery);
    model.beginEditing();
    model.step("square", 16.0);
    EXPECT_TRUE(test::comes([&] { return kept().size() == 1; }));
    EXPECT_TRUE(model.isTyped());
}

TEST_F(RecoveryTest, NothingStaysAfterSavingClosingOrQuitting) {
    Recovery recovery(keptIn());
    const auto change = [&](double square) {
        model.set("square", square);
        ASSERT_TRUE(test::comes([&] { return kept().size() == 1; }));
    };
    watch(recovery);
    change(9.0);
    EXPECT_EQ(document.saveTo(file("a.case.json")), QString());
    EXPECT_TRUE(kept().isEmpty());
    change(16.0);
    model.undo();
    EXPECT_TRUE(kept().isEmpty()) << "it is as it was saved";
    change(25.0);
    recovery.release(&document);
    EXPECT_TRUE(kept().isEmpty());
    watch(recovery);
    change(36.0);
    recovery.releaseAll();
    EXPECT_TRUE(kept().isEmpty());
}

TEST_F(RecoveryTest, OffersWhatAProgramLeftThatRunsNoLonger) {
    ASSERT_EQ(document.saveTo(file("дело.case.json")), QString());
    auto crashed = std::make_unique<Recovery>(keptIn());
    watch(*crashed);
    model.place = 17;
    model.set("square", 9.0);
    ASSERT_TRUE(test::comes([&] { return kept().size() == 1; }));
    {
        Recovery other(keptIn());
        EXPECT_TRUE(other.leftBehind().cases.isEmpty()) << "that program runs";
    }
    crashed.reset();
    Recovery next(keptIn());
    Recovery::Found found = next.leftBehind();
    ASSERT_EQ(found.cases.size(), 1);
    const RecoveredCase& left = found.cases.constFirst();
    EXPECT_EQ(left.path, file("дело.case.json"));
    EXPECT_EQ(left.content.scene, "balance-shaft");
    EXPECT_EQ(left.content.input.at("crank_radius_mm"), 9.0);
    EXPECT_LT(left.saved.secsTo(QDateTime::currentDateTime()), 60);
    {
        Recovery third(keptIn());
        EXPECT_TRUE(third.leftBehind().cases.isEmpty()) << "offered by another window";
    }
    test::RootModel again;
    CaseDocument restored(&again);
    restored.restore(left.content, left);
    EXPECT_EQ(again.root(), 3.0);
    EXPECT_EQ(again.place, 17);
    EXPECT_TRUE(restored.needsSaving());
    EXPECT_FALSE(again.history()->canUndo());
    EXPECT_EQ(restored.path(), left.path);
    EXPECT_EQ(restored.disk().state(), FileOnDisk::State::Same);
    next.discard(left);
    EXPECT_TRUE(kept().isEmpty());
    EXPECT_TRUE(next.leftBehind().cases.isEmpty());
}

TEST_F(RecoveryTest, OfTwoThousandTheNewestHundredAreOffered) {
    Recovery::leave(document.model()->caseFile(), 17, keptIn());
    const QDir folder(keptIn());
    const QString one = folder.filePath(kept().constFirst());
    for (int i = 1; i < 2000; ++i) {
        QFile::copy(
            one, folder.filePath(QStringLiteral("%1-0001.json").arg(i, 32, 16, QLatin1Char('0'))));
    }
    Recovery next(keptIn());
    const test::ProcessorTime time;
    const Recovery::Found found = next.leftBehind();
    EXPECT_LT(time.seconds(), 2.0);
    EXPECT_EQ(found.cases.size(), Recovery::maximum);
    EXPECT_EQ(kept().size(), 2000) << "nothing goes unasked";
    for (const RecoveredCase& each : found.cases) {
        EXPECT_EQ(each.place, 17);
        next.discard(each);
    }
    EXPECT_EQ(next.leftBehind().cases.size(), Recovery::maximum) << "the next hundred";
    EXPECT_EQ(kept().size(), 2000 - Recovery::maximum);
    EXPECT_TRUE(QDir(keptIn()).entryList({QStringLiteral("*.lock")}).size() <= 1);
}

/// It is not waited for.
TEST_F(RecoveryTest, APipeInPlaceOfACaseIsPassedOver) {
    Recovery::leave(document.model()->caseFile(), 17, keptIn());
    const QString pipe =
        QDir(keptIn()).filePath(QString(32, QLatin1Char('a')) + QStringLiteral("-0001.json"));
    ASSERT_EQ(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
    Recovery next(keptIn());
    const Recovery::Found found = next.leftBehind();
    EXPECT_EQ(found.cases.size(), 1);
    EXPECT_TRUE(found.damaged.isEmpty());
}

TEST_F(RecoveryTest, WhatWasChangedSinceTheCrashIsSaid) {
    ASSERT_EQ(document.saveTo(file("a.case.json")), QString());
    const QByteArray known = document.disk().digest();
    test::RootModel other;
    other.set("square", 25.0);
    ASSERT_EQ(CaseDocument(&other).saveTo(file("a.case.json")), QString());
    RecoveredCase from;
    from.path = file("a.case.json");
    from.known = known;
    document.restore(document.model()->caseFile(), from);
    EXPECT_EQ(document.disk().state(), FileOnDisk::State::Changed);
}

TEST_F(RecoveryTest, AFileAtTheNameOfADeletedOneIsAnother) {
    ASSERT_EQ(document.saveTo(file("a.case.json")), QString());
    ASSERT_TRUE(QFile::remove(file("a.case.json")));
    document.checkFiles();
    document.keepMine();
    RecoveredCase from;
    from.path = file("a.case.json");
    from.known = document.disk().digest();
    test::RootModel other;
    ASSERT_EQ(CaseDocument(&other).saveTo(file("a.case.json")), QString());
    document.restore(document.model()->caseFile(), from);
    EXPECT_EQ(document.disk().state(), FileOnDisk::State::Changed);
}

TEST_F(RecoveryTest, ACaseOfANewerProgramIsKeptAside) {
    Recovery::leave(model.caseFile(), {}, keptIn());
    const QString path = QDir(keptIn()).filePath(kept().constFirst());
    Json json = parse_json(read_text_file(path.toStdString()));
    json["case"]["version"] = 99;
    write_text_file(path.toStdString(), json.dump());
    const Recovery::Found found = Recovery(keptIn()).leftBehind();
    EXPECT_TRUE(found.cases.isEmpty());
    ASSERT_EQ(found.damaged.size(), 1);
    EXPECT_TRUE(QFile::exists(found.damaged.constFirst()));
}

TEST_F(RecoveryTest, ADamagedFileIsKeptAside) {
    Recovery::leave(model.caseFile(), {}, keptIn());
    QFile damaged(QDir(keptIn()).filePath(kept().constFirst()));
    ASSERT_TRUE(damaged.open(QIODevice::ReadWrite));
    ASSERT_TRUE(damaged.resize(damaged.size() / 2));
    damaged.close();
    Recovery next(keptIn());
    const Recovery::Found found = next.leftBehind();
    EXPECT_TRUE(found.cases.isEmpty());
    ASSERT_EQ(found.damaged.size(), 1);
    EXPECT_TRUE(QFile::exists(found.damaged.constFirst()));
    EXPECT_TRUE(next.leftBehind().damaged.isEmpty()) << "said once";
}

TEST_F(RecoveryTest, WithoutItsLockNothingIsKept) {
    std::unique_ptr<Recovery> recovery;
    {
        const test::FullDisk full;
        recovery = std::make_unique<Recovery>(keptIn());
        QSignalSpy failed(recovery.get(), &Recovery::failed);
        watch(*recovery);
        model.set("square", 9.0);
        recovery->keep(&document);
        EXPECT_TRUE(kept().isEmpty());
        EXPECT_EQ(failed.size(), 1);
    }
    recovery->keep(&document);
    EXPECT_EQ(kept().size(), 1) << "there is room again";
    {
        Recovery other(keptIn());
        EXPECT_TRUE(other.leftBehind().cases.isEmpty()) << "that program runs";
    }
    recovery.reset();
    const test::FullDisk full;
    Recovery next(keptIn());
    const Recovery::Found found = next.leftBehind();
    ASSERT_EQ(found.cases.size(), 1) << "nobody has it, though it cannot be locked";
    next.discard(found.cases.constFirst());
    EXPECT_TRUE(kept().isEmpty());
}

TEST_F(RecoveryTest, WhatIsTooLargeToBeReadIsNotWritten) {
    const QString path = file("a.case.json");
    ASSERT_EQ(document.saveTo(path), QString());
    const qint64 size = QFileInfo(path).size();
    CaseFile large = document.model()->caseFile();
    large.notes = std::string((64U << 20U) + 1, 'n');
    document.open(large, path);
    EXPECT_TRUE(document.saveTo(path).contains(QStringLiteral("64 MiB")));
    Recovery recovery(keptIn());
    QSignalSpy failed(&recovery, &Recovery::failed);
    watch(recovery);
    model.set("square", 9.0);
    recovery.keep(&document);
    EXPECT_TRUE(kept().isEmpty());
    EXPECT_EQ(failed.size(), 1);
    EXPECT_EQ(QFileInfo(path).size(), size);
}

// ------------------------------------------------------------------------------ other programs

class DiskTest : public ::testing::Test {
  protected:
    DiskTest() {
        model.set("square", 9.0);
        EXPECT_EQ(document.saveTo(path), QString());
    }
    /// By another program, in place or as a new file under the name.
    void writeByOthers(double square) {
        test::RootModel other;
        other.set("square", square);
        EXPECT_EQ(CaseDocument(&other).saveTo(path), QString());
    }
    FileOnDisk::State look() {
        document.checkFiles();
        return document.disk().state();
    }
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("a.case.json"));
    test::RootModel model;
    CaseDocument document{&model};
};

TEST_F(DiskTest, ItsOwnSavingIsNoChange) {
    QSignalSpy said(&document, &CaseDocument::filesChanged);
    model.set("square", 16.0);
    EXPECT_EQ(document.saveTo(path), QString());
    look();
    EXPECT_EQ(said.size(), 0);
}

TEST_F(DiskTest, TheSameContentAgainIsNoChange) {
    writeByOthers(25.0);
    EXPECT_EQ(look(), FileOnDisk::State::Changed);
    writeByOthers(9.0);
    EXPECT_EQ(look(), FileOnDisk::State::Same);
}

TEST_F(DiskTest, ADeletedFileIsSaidAndWrittenAgain) {
    ASSERT_TRUE(QFile::remove(path));
    EXPECT_EQ(look(), FileOnDisk::State::Missing);
    document.keepMine();
    EXPECT_TRUE(document.needsSaving());
    EXPECT_EQ(document.disk().state(), FileOnDisk::State::Same);
    EXPECT_EQ(document.saveTo(path), QString());
    EXPECT_TRUE(QFile::exists(path));
}

TEST_F(DiskTest, AChangeWhileTheFileIsReadIsSeen) {
    QByteArray known;
    const CaseFile read = CaseDocument::read(path, &known);
    writeByOthers(25.0);
    document.open(read, path, known);
    EXPECT_EQ(document.disk().state(), FileOnDisk::State::Changed);
    // What is written is known without another look at the disk.
    EXPECT_EQ(document.saveTo(path), QString());
    EXPECT_EQ(document.disk().digest(), FileOnDisk::digestOf(test::contentOf(path).toStdString()));
}

TEST_F(DiskTest, MineIsKeptAgainstWhatWasSeenOnly) {
    writeByOthers(25.0);
    EXPECT_EQ(look(), FileOnDisk::State::Changed);
    writeByOthers(36.0);
    document.keepMine();
    EXPECT_EQ(document.disk().state(), FileOnDisk::State::Changed);
}

TEST_F(DiskTest, TheLastCopyNeedsSaving) {
    const auto isLast = [this] {
        look();
        return document.needsSaving();
    };
    writeByOthers(25.0);
    EXPECT_FALSE(isLast()) << "nothing was changed here";
    ASSERT_TRUE(QFile::resize(path, 20));
    EXPECT_TRUE(isLast());
    writeByOthers(9.0);
    EXPECT_FALSE(isLast());
    ASSERT_TRUE(QFile::remove(path));
    EXPECT_TRUE(isLast());
    EXPECT_EQ(document.saveTo(path), QString());
    EXPECT_FALSE(isLast());
}

}  // namespace
}  // namespace ravnoves

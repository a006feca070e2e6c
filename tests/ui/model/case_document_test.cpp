// A document between file and model.

#include "model/case_document.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <filesystem>

#include "case-file/case_file.h"
#include "model/root_model.h"

namespace ravnoves {
namespace {

class CaseDocumentTest : public ::testing::Test {
  protected:
    QString file(const char* name) const { return folder.filePath(QString::fromUtf8(name)); }
    void open(const QString& path) { document.open(CaseDocument::read(path), path); }
    /// A case file with the value.
    QString written(const char* name, double square) {
        test::RootModel other;
        other.set("square", square);
        other.setTitle(QStringLiteral("A title"));
        EXPECT_EQ(CaseDocument(&other).saveTo(file(name)), QString());
        return file(name);
    }

    QTemporaryDir folder;
    test::RootModel model;
    CaseDocument document{&model};
};

TEST_F(CaseDocumentTest, IsNamedByItsFileElseByItsTitle) {
    QSignalSpy named(&document, &CaseDocument::nameChanged);
    EXPECT_EQ(document.name(), QStringLiteral("Root of four"));
    model.setTitle(QStringLiteral("Another"));
    EXPECT_EQ(document.name(), QStringLiteral("Another"));
    EXPECT_EQ(named.size(), 1);
    open(written("nine.case.json", 9.0));
    EXPECT_EQ(document.name(), QStringLiteral("nine.case.json"));
    EXPECT_EQ(model.title(), QStringLiteral("A title"));
    EXPECT_EQ(model.context().directory, std::filesystem::path(folder.path().toStdString()));
    EXPECT_EQ(model.root(), 3.0);
}

TEST_F(CaseDocumentTest, NeedsSavingUntilItIsSaved) {
    open(written("nine.case.json", 9.0));
    EXPECT_FALSE(document.needsSaving());
    model.set("square", 16.0);
    EXPECT_TRUE(document.needsSaving());
    model.history()->undo();
    EXPECT_FALSE(document.needsSaving());
    model.set("square", 16.0);
    EXPECT_EQ(document.saveTo(document.path()), QString());
    EXPECT_FALSE(document.needsSaving());
    model.set("square", 25.0);
    open(document.path());
    EXPECT_EQ(model.root(), 4.0);
}

TEST_F(CaseDocumentTest, ABadFileChangesNothing) {
    open(written("nine.case.json", 9.0));
    model.set("square", 16.0);
    const QString bad = file("bad.case.json");
    EXPECT_THROW(open(bad), InputError);  // is not there
    document.saveTo(bad);
    QFile text(bad);
    ASSERT_TRUE(text.open(QIODevice::ReadWrite));
    const QByteArray changed = text.readAll().replace("16.0", "-1.0");
    text.seek(0);
    text.write(changed);
    text.close();
    EXPECT_THROW(open(bad), InputError);
    EXPECT_EQ(model.root(), 4.0);
    EXPECT_EQ(model.title(), QStringLiteral("A title"));
}

TEST_F(CaseDocumentTest, ProposesItsFileElseOneByItsScene) {
    EXPECT_EQ(document.proposedPath(), QStringLiteral("balance-shaft.case.json"));
    open(written("nine.case.json", 9.0));
    EXPECT_EQ(document.proposedPath(), file("nine.case.json"));
}

TEST_F(CaseDocumentTest, SaysWhatCannotBeWritten) {
    model.set("square", 9.0);
    const QString path = QStringLiteral("/dev/null/x.case.json");
    EXPECT_TRUE(document.saveTo(path).startsWith(path));
    EXPECT_TRUE(document.path().isEmpty());
    EXPECT_TRUE(document.needsSaving());
}

TEST_F(CaseDocumentTest, UndoNeverCrossesOpenOrBegin) {
    const QString nine = written("nine.case.json", 9.0);
    model.set("square", 16.0);
    open(nine);
    model.undo();
    EXPECT_EQ(model.root(), 3.0);
    EXPECT_EQ(model.history()->count(), 0);
    model.set("square", 16.0);
    document.begin(CaseDocument::read(nine));
    model.undo();
    EXPECT_EQ(model.root(), 3.0);
    EXPECT_TRUE(document.path().isEmpty());
    EXPECT_EQ(document.name(), QStringLiteral("A title"));
    EXPECT_FALSE(document.needsSaving());
}

TEST_F(CaseDocumentTest, WhatIsBeingTypedIsSaved) {
    open(written("nine.case.json", 9.0));
    QSignalSpy named(&document, &CaseDocument::nameChanged);
    model.beginEditing();
    model.step("square", 16.0);
    EXPECT_TRUE(document.needsSaving());
    EXPECT_EQ(named.size(), 1);
    EXPECT_EQ(document.saveTo(document.path()), QString());
    EXPECT_FALSE(document.needsSaving());
    model.endEditing();
    EXPECT_FALSE(document.needsSaving());
    EXPECT_EQ(CaseDocument::read(document.path()).input.at("crank_radius_mm"), 16.0);
}

TEST_F(CaseDocumentTest, RemembersTheLastFiles) {
    for (int i = 0; i < 10; ++i) {
        document.saveTo(folder.filePath(QStringLiteral("%1.case.json").arg(i)));
    }
    open(file("5.case.json"));
    const QStringList recent = CaseDocument::recentPaths();
    EXPECT_EQ(recent.size(), 8);
    EXPECT_EQ(recent[0], file("5.case.json"));
    EXPECT_EQ(recent[1], file("9.case.json"));
    EXPECT_EQ(recent.count(file("5.case.json")), 1);
    // No more of them, whoever has written the settings.
    QStringList many;
    for (int i = 0; i < 5000; ++i) {
        many << QString::number(i);
    }
    QSettings().setValue(QStringLiteral("files/recent"), many);
    EXPECT_EQ(CaseDocument::recentPaths(), many.mid(0, 8));
}

}  // namespace
}  // namespace ravnoves

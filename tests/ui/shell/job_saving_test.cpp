// A job of the workshop saved from the window: in the journal, or in its file.

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QStatusBar>
#include <QStatusTipEvent>

#include "case-file/case_file.h"
#include "case-file/text_file.h"
#include "shell/window_test.h"
#include "shop/model/journal.h"
#include "text/file_path.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class JobSavingTest : public test::WindowTest {
  protected:
    JobSavingTest() {
        for (const QString& part : {u""_s, u"-wal"_s, u"-shm"_s}) {
            QFile::remove(Journal::defaultPath() + part);
        }
        window->showScene(u"workshop"_s);
    }

    void type(const char* name, const QString& text) {
        test::type(test::named<QLineEdit>(*window->currentPage(), name), text);
    }
    QString said() const { return window->statusBar()->currentMessage(); }
    QString savingTip() const {
        const QAction* save = test::actionOfKeys(*window, QKeySequence::Save);
        EXPECT_EQ(save->statusTip(), save->toolTip());
        return save->toolTip();
    }
    /// The pointer comes over something with a tip, or leaves it.
    void passOver(const QString& tip) {
        QStatusTipEvent event(tip);
        QApplication::sendEvent(window.get(), &event);
    }
    static QStringList numbers() {
        Journal journal;
        QStringList found;
        if (journal.open()) {
            for (const JournalJob& job : journal.search({})) {
                found << job.engineNumber;
            }
        }
        return found;
    }
};

TEST_F(JobSavingTest, TheKeySavesInTheJournalWhereThereIsNoFile) {
    EXPECT_TRUE(savingTip().contains(u"journal"_s)) << savingTip().toStdString();
    type("engine_number", u"4711"_s);
    EXPECT_TRUE(document().needsSaving());
    press(Qt::Key_S);
    EXPECT_EQ(filesAsked, 0);
    EXPECT_EQ(numbers(), QStringList{u"4711"_s});
    EXPECT_EQ(document().path(), QString());
    // Nothing is asked when it goes: it is saved.
    EXPECT_FALSE(document().needsSaving());
    EXPECT_TRUE(window->documents().canClose());
    // What comes then is saved in the same job.
    type("customer", u"Ivanov"_s);
    EXPECT_TRUE(document().needsSaving());
    press(Qt::Key_S);
    EXPECT_EQ(numbers(), QStringList{u"4711"_s});
}

TEST_F(JobSavingTest, AFileIsSavedAsAFile) {
    type("engine_number", u"4712"_s);
    const QString path = file("job.case.json");
    typed = QStringList{path};
    press(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(filesAsked, 1);
    EXPECT_EQ(document().path(), path);
    EXPECT_TRUE(savingTip().contains(path)) << savingTip().toStdString();
    type("engine_number", u"4713"_s);
    press(Qt::Key_S);
    EXPECT_EQ(filesAsked, 1);
    EXPECT_FALSE(document().needsSaving());
    const Json written = parse_json(read_text_file(fsPath(path)));
    EXPECT_EQ(written.at("scene"), "workshop");
    EXPECT_EQ(written.at("input").at("job").at("engine_number"), "4713");
    EXPECT_EQ(numbers(), QStringList());
    // Another page has no journal.
    window->showScene(u"elastic-hinge"_s);
    EXPECT_EQ(savingTip(), u"Save case (Ctrl+S)"_s);
    press(Qt::Key_S);
    EXPECT_EQ(filesAsked, 2);
}

TEST_F(JobSavingTest, ThePointerHidesNoMessageOfSaving) {
    passOver(u"a tip"_s);
    EXPECT_EQ(said(), u"a tip"_s);
    type("engine_number", u"4711"_s);
    press(Qt::Key_S);
    const QString saved = said();
    EXPECT_TRUE(saved.contains(u"4711"_s)) << saved.toStdString();
    EXPECT_TRUE(saved.contains(u"unfinished"_s)) << "why it is";
    passOver(u"a tip"_s);
    EXPECT_EQ(said(), saved);
    passOver({});
    EXPECT_EQ(said(), saved);
    // Nor does what a page says of itself.
    type("customer", u"Ivanov"_s);
    EXPECT_EQ(said(), saved);
    QTest::qWait(4000);
    EXPECT_EQ(said(), saved);
    EXPECT_TRUE(test::comes([&] {
        passOver(u"a tip"_s);
        return said() == u"a tip"_s;
    }));
    // What is done then is said at once, in the place of what was done before.
    press(Qt::Key_S);
    EXPECT_EQ(said(), saved);
    const QString path = file("job.case.json");
    typed = QStringList{path};
    press(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(said().contains(path)) << said().toStdString();
    passOver({});
    EXPECT_TRUE(said().contains(path));
}

}  // namespace
}  // namespace ravnoves

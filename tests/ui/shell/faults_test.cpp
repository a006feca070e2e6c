// What a machine can do to a window that has work in it: a full disk, a folder that is gone, no
// printer. The window says so, goes on, and loses nothing.

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QPrintDialog>
#include <QTimer>
#include <functional>

#include "balance-shaft/model/balance_shaft_model.h"
#include "files.h"
#include "full_disk.h"
#include "shell/window_test.h"
#include "workshop/model/job_desk.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class Faults : public test::WindowTest {
  protected:
    Faults() {
        QDir().mkpath(QFileInfo(file).path());
        QFile::copy(u":/examples/tmz-650d.case.json"_s, file);
        QFile(file).setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        window->beginSession();
        EXPECT_EQ(window->openCase(file), QString());
    }

    double angleInFile() const {
        return CaseDocument::read(file).input.value("shaft_angle_deg", 0.0);
    }
    void change(int angle) { set(u"shaft_angle_deg=%1"_s.arg(angle)); }
    /// Presses a key and returns the messages that come up, each answered with Escape.
    QString said(Qt::Key key, Qt::KeyboardModifiers modifiers) {
        QStringList texts;
        const QObject guard;
        std::function<void()> look = [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                texts << box->text() + u' ' + box->informativeText();
                box->reject();
            }
            QTimer::singleShot(20, &guard, look);
        };
        QTimer::singleShot(20, &guard, look);
        press(key, modifiers);
        QTest::qWait(400);
        return texts.join(u'\n');
    }
    QString saveSaid() { return said(Qt::Key_S, Qt::ControlModifier); }

    const QString file = folder.filePath(u"disk/saved.case.json"_s);
};

TEST_F(Faults, AFullDiskLeavesTheFileAsItWas) {
    const QByteArray content = test::contentOf(file);
    {
        const test::FullDisk full(512);
        change(77);
        QTest::qWait(900);  // nor is there room for a copy of what is not saved
        const QString trouble = saveSaid();
        EXPECT_TRUE(trouble.contains(u"saved.case.json"_s)) << trouble.toStdString();
        EXPECT_TRUE(window->isWindowModified());
    }
    EXPECT_EQ(test::contentOf(file), content);
    EXPECT_EQ(QFileInfo(file).dir().entryList(QDir::Files).size(), 1);
    change(78);
    EXPECT_EQ(saveSaid(), QString());
    EXPECT_EQ(angleInFile(), 78);
    EXPECT_FALSE(window->isWindowModified());
}

TEST_F(Faults, AFullDiskKeepsTheJobOnTheSheet) {
    ASSERT_TRUE(window->showScene(u"workshop"_s));
    QTest::qWait(100);  // until the page is there for its keys
    auto* desk = window->findChild<JobDesk*>();
    ASSERT_NE(desk, nullptr);
    ASSERT_TRUE(desk->openJournal()) << desk->journalTrouble().toStdString();
    set(u"job/engine_number=53-11"_s);
    {
        const test::FullDisk full(512);
        const QString trouble = said(Qt::Key_F2, {});
        // Its log may still have room.
        EXPECT_NE(trouble.isEmpty(), desk->jobId() == 0) << trouble.toStdString();
    }
    EXPECT_EQ(said(Qt::Key_F2, {}), QString());
    EXPECT_TRUE(test::comes([&] { return desk->jobId() != 0; }));
    EXPECT_EQ(desk->journal()->openMessage(), QString());
}

TEST_F(Faults, WithoutAPrinterTheDialogsComeAndGo) {
    ASSERT_TRUE(window->showScene(u"workshop"_s));
    int dialogs = 0;
    for (QAction* action : window->currentPage()->sceneActions()) {
        if (action != nullptr && action->objectName() == u"print_card"_s) {
            test::whenModal<QPrintDialog>(window.get(), [&](QPrintDialog* dialog) {
                ++dialogs;
                dialog->reject();
            });
            action->trigger();
        }
    }
    EXPECT_EQ(dialogs, 1);
}

}  // namespace
}  // namespace ravnoves

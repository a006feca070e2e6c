// What a machine can do to a window that has work in it: a full disk, a folder that must not be
// written or is gone, no printer. The window says so, goes on, and loses nothing.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QPrintDialog>
#include <QTemporaryDir>
#include <QTimer>
#include <functional>
#include <memory>

#include "balance-shaft/model/balance_shaft_model.h"
#include "events.h"
#include "files.h"
#include "model/case_document.h"
#include "page/scene_page.h"
#include "shell/documents.h"
#include "shell/main_window.h"
#include "shell/screenshot.h"
#include "workshop/model/job_desk.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

/// A small disk of its own where this process may mount one; else only its size can be limited.
class SmallDisk {
  public:
    explicit SmallDisk(const QString& path) : path_(path) {
        QDir().mkpath(path);
        isMounted_ = unshare(CLONE_NEWNS) == 0 &&
                     mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                     mount("ravnoves", qPrintable(path), "tmpfs", 0, "size=1m") == 0;
    }
    ~SmallDisk() {
        makeRoom();
        if (isMounted_) {
            umount2(qPrintable(path_), MNT_DETACH);
        }
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    void fill() {
        if (isMounted_) {
            QFile filler(filling());
            ASSERT_TRUE(filler.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
            for (const qsizetype size : {65536, 512, 1}) {
                while (filler.write(QByteArray(size, 'x')) == size) {
                }
            }
            return;
        }
        getrlimit(RLIMIT_FSIZE, &before_);
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{512, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
        isLimited_ = true;
    }
    void makeRoom() {
        QFile::remove(filling());
        if (isLimited_) {
            setrlimit(RLIMIT_FSIZE, &before_);
            isLimited_ = false;
        }
    }
    /// @return false where that cannot be done here
    bool setReadOnly(bool readOnly) const {
        if (isMounted_) {
            return mount("ravnoves", qPrintable(path_), "tmpfs",
                         MS_REMOUNT | (readOnly ? static_cast<unsigned long>(MS_RDONLY) : 0UL),
                         "size=1m") == 0;
        }
        const auto readable = QFile::ReadOwner | QFile::ExeOwner;
        return geteuid() != 0 &&
               QFile(path_).setPermissions(readOnly ? readable : readable | QFile::WriteOwner);
    }

  private:
    QString filling() const { return path_ + u"/filling"_s; }

    QString path_;
    bool isMounted_ = false;
    bool isLimited_ = false;
    rlimit before_{};
};

class Faults : public ::testing::Test {
  protected:
    Faults() : disk(folder.filePath(u"disk"_s)) {
        qputenv("XDG_DATA_HOME", dataHome().toLocal8Bit());
        QDir().mkpath(dataHome());
        QFile::copy(u":/examples/tmz-650d.case.json"_s, file);
        QFile(file).setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        window = std::make_unique<MainWindow>();
        window->beginSession();
        test::showAt(*window, {1280, 800});
        window->activateWindow();
        EXPECT_EQ(window->openCase(file), QString());
    }
    ~Faults() override {
        disk.makeRoom();
        window.reset();
    }

    QString dataHome() const { return folder.filePath(u"disk/data"_s); }
    double angleInFile() const {
        return CaseDocument::read(file).input.value("shaft_angle_deg", 0.0);
    }
    void change(int angle) {
        ASSERT_EQ(applySetting(*window, u"shaft_angle_deg=%1"_s.arg(angle)), QString());
    }
    /// Presses a key and returns the messages that come up, each answered with Escape.
    QString said(
        Qt::Key key, Qt::KeyboardModifiers modifiers,
        const std::function<bool()>& isDone = [] { return true; }) {
        QStringList texts;
        auto guard = std::make_unique<QObject>();
        std::function<void()> look = [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                texts << box->text() + u' ' + box->informativeText();
                box->reject();
            }
            QTimer::singleShot(20, guard.get(), look);
        };
        QTimer::singleShot(20, guard.get(), look);
        window->activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(window.get()));
        QTest::keyClick(window.get(), key, modifiers);
        QTest::qWait(300);
        EXPECT_TRUE(test::comes(isDone));
        QTest::qWait(100);
        return texts.join(u'\n');
    }
    QString saveSaid() { return said(Qt::Key_S, Qt::ControlModifier); }
    /// Works as if nothing had been.
    void savesAgain(int angle) {
        change(angle);
        EXPECT_EQ(saveSaid(), QString());
        EXPECT_EQ(angleInFile(), angle);
        EXPECT_FALSE(window->isWindowModified());
    }

    QTemporaryDir folder;
    SmallDisk disk;
    const QString file = folder.filePath(u"disk/saved.case.json"_s);
    std::unique_ptr<MainWindow> window;
};

TEST_F(Faults, AFullDiskLeavesTheFileAsItWas) {
    const QByteArray content = test::contentOf(file);
    ASSERT_NO_FATAL_FAILURE(disk.fill());
    change(77);
    QTest::qWait(900);  // nor is there room for a copy of what is not saved
    const QString trouble = saveSaid();
    EXPECT_TRUE(trouble.contains(u"saved.case.json"_s)) << trouble.toStdString();
    EXPECT_TRUE(window->isWindowModified());
    disk.makeRoom();
    EXPECT_EQ(test::contentOf(file), content);
    EXPECT_EQ(QDir(folder.filePath(u"disk"_s)).entryList(QDir::Files).size(), 1);
    savesAgain(78);
}

TEST_F(Faults, AFullDiskKeepsTheJobOnTheSheet) {
    ASSERT_TRUE(window->showScene(u"workshop"_s));
    QTest::qWait(100);  // until the page is there for its keys
    auto* desk = window->findChild<JobDesk*>();
    ASSERT_NE(desk, nullptr);
    ASSERT_TRUE(desk->openJournal()) << desk->journalTrouble().toStdString();
    ASSERT_EQ(applySetting(*window, u"job/engine_number=53-11"_s), QString());
    ASSERT_NO_FATAL_FAILURE(disk.fill());
    const QString trouble = said(Qt::Key_F2, {});
    // Its log may still have room.
    EXPECT_NE(trouble.isEmpty(), desk->jobId() == 0) << trouble.toStdString();
    disk.makeRoom();
    EXPECT_EQ(said(Qt::Key_F2, {}), QString());
    EXPECT_TRUE(test::comes([&] { return desk->jobId() != 0; }));
    EXPECT_EQ(desk->journal()->search({}).size(), 1);
    EXPECT_EQ(desk->journal()->openMessage(), QString());
}

TEST_F(Faults, AReadOnlyFolderIsSaid) {
    SmallDisk other(folder.filePath(u"other"_s));
    const QString there = folder.filePath(u"other/there.case.json"_s);
    ASSERT_TRUE(QFile::copy(file, there));
    ASSERT_EQ(window->openCase(there), QString());
    if (!other.setReadOnly(true)) {
        GTEST_SKIP() << "no folder can be made read-only here";
    }
    change(77);
    const QString trouble = saveSaid();
    EXPECT_TRUE(trouble.contains(u"there.case.json"_s)) << trouble.toStdString();
    EXPECT_TRUE(window->isWindowModified());
    const auto inFile = [&] {
        return CaseDocument::read(there).input.value("shaft_angle_deg", 0.0);
    };
    EXPECT_NE(inFile(), 77);
    ASSERT_TRUE(other.setReadOnly(false));
    EXPECT_EQ(saveSaid(), QString());
    EXPECT_EQ(inFile(), 77);
    window->documents().closeCurrent();
}

TEST_F(Faults, AFolderThatVanishedIsSaidAndAnotherTaken) {
    const QString other = folder.filePath(u"elsewhere.case.json"_s);
    umount2(qPrintable(folder.filePath(u"disk"_s)), MNT_DETACH);
    ASSERT_TRUE(QDir(folder.filePath(u"disk"_s)).removeRecursively());
    change(77);
    QTest::qWait(900);
    const QString trouble = saveSaid();
    EXPECT_TRUE(window->isWindowModified());
    EXPECT_FALSE(trouble.isEmpty());
    EXPECT_EQ(window->documents().current().document->saveTo(other), QString());
    EXPECT_EQ(CaseDocument::read(other).input.value("shaft_angle_deg", 0.0), 77);
    EXPECT_FALSE(window->isWindowModified());
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

#include "shell/main_window.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QKeySequence>
#include <QLineEdit>
#include <QMap>
#include <QMenu>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QToolBar>
#include <QToolButton>

#include "events.h"
#include "page/scene_page.h"
#include "shell/help_window.h"
#include "shell/scene_list.h"
#include "shell/screenshot.h"
#include "text/language.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/number_field.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class MainWindowTest : public ::testing::Test {
  protected:
    MainWindowTest() { test::showAt(window, {1280, 800}); }

    QString file(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }

    QTemporaryDir folder;
    MainWindow window;
};

TEST_F(MainWindowTest, EverySceneOpensByKeyAndByName) {
    for (const SceneInfo& info : sceneList()) {
        EXPECT_TRUE(window.showScene(info.name)) << info.name.toStdString();
        EXPECT_EQ(window.currentScene(), info.name);
        EXPECT_FALSE(window.grab().isNull());
    }
    QTest::keyClick(&window, Qt::Key_1, Qt::ControlModifier);
    EXPECT_EQ(window.currentScene(), QStringLiteral("balance-shaft"));
    EXPECT_FALSE(window.showScene(QStringLiteral("balance-shift")));
}

TEST_F(MainWindowTest, TypingGoesToThePageThatIsSeen) {
    window.show();
    window.activateWindow();
    window.showScene(QStringLiteral("balance-shaft"));
    window.showScene(QStringLiteral("workshop"));
    QApplication::processEvents();
    auto* field = window.currentPage()->findChild<QLineEdit*>(QStringLiteral("engine_number"));
    ASSERT_NE(field, nullptr);
    field->setFocus();
    window.showStart();
    QApplication::processEvents();
    window.showScene(QStringLiteral("balance-shaft"));
    QApplication::processEvents();
    const QWidget* focus = QApplication::focusWidget();
    EXPECT_TRUE(focus == nullptr || focus->isVisible());
    EXPECT_FALSE(field->hasFocus());
}

TEST_F(MainWindowTest, CopiesResults) {
    QTest::keyClick(&window, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    const QString text = QApplication::clipboard()->text();
    EXPECT_TRUE(text.contains(QStringLiteral("range\t1208.0"))) << text.toStdString();
}

TEST_F(MainWindowTest, SettingsFromTheCommandLineAreChecked) {
    EXPECT_EQ(applySetting(window, QStringLiteral("centre_distance_mm=120")), QString());
    EXPECT_TRUE(applySetting(window, QStringLiteral("centre_distance_mm"))
                    .contains(QStringLiteral("key=value")));
    EXPECT_TRUE(applySetting(window, QStringLiteral("centre_distance_mm=-1"))
                    .contains(QStringLiteral("/input/centre_distance_mm")));
    EXPECT_TRUE(applySetting(window, QStringLiteral("centre_distence_mm=1"))
                    .contains(QStringLiteral("centre_distance_mm")));
}

TEST_F(MainWindowTest, PicturesAreTheSameEveryTime) {
    const QString first = file("a.png");
    const QString second = file("b.png");
    ASSERT_EQ(setWindowSize(window, QStringLiteral("1280x800")), QString());
    ASSERT_EQ(writeScreenshot(window, first), QString());
    MainWindow other;
    ASSERT_EQ(setWindowSize(other, QStringLiteral("1280x800")), QString());
    ASSERT_EQ(writeScreenshot(other, second), QString());
    const QImage a(first);
    EXPECT_EQ(a.size(), QSize(1280, 800));
    EXPECT_EQ(a, QImage(second));
    EXPECT_NE(setWindowSize(other, QStringLiteral("big")), QString());
    EXPECT_EQ(other.size(), QSize(1280, 800));
    EXPECT_NE(writeScreenshot(other, QStringLiteral("/dev/null/a.png")), QString());
}

TEST_F(MainWindowTest, PicturesWaitForWhatIsComputedInTheBackground) {
    ASSERT_TRUE(window.showScene(QStringLiteral("elastic-hinge")));
    ASSERT_EQ(applySetting(window, QStringLiteral("tab=motion")), QString());
    ASSERT_EQ(applySetting(window, QStringLiteral("lambda=0.35")), QString());
    EXPECT_TRUE(window.currentPage()->isBusy());
    ASSERT_EQ(writeScreenshot(window, file("motion.png")), QString());
    EXPECT_FALSE(window.currentPage()->isBusy());
}

TEST_F(MainWindowTest, AnUnknownTabIsAnsweredWithTheTabsThatThereAre) {
    ASSERT_TRUE(window.showScene(QStringLiteral("elastic-hinge")));
    const QString answer = applySetting(window, QStringLiteral("tab=motions"));
    EXPECT_TRUE(answer.contains(QStringLiteral("side-force"))) << answer.toStdString();
    EXPECT_TRUE(answer.contains(QStringLiteral("got motions"))) << answer.toStdString();
}

TEST_F(MainWindowTest, EveryActionHasATipAndEveryIconExists) {
    for (const QAction* action : window.findChildren<QAction*>()) {
        if (!action->text().isEmpty()) {
            EXPECT_FALSE(action->toolTip().isEmpty()) << action->text().toStdString();
        }
    }
    for (const SceneInfo& info : sceneList()) {
        EXPECT_FALSE(themedIcon(QStringLiteral("scene-") + info.name).isNull());
    }
}

/// A narrow window with a large text: the toolbar has more than one row holds.
class NarrowToolBarTest : public ::testing::Test {
  protected:
    NarrowToolBarTest() {
        Theme::instance().setTextScale(2.0);
        window = std::make_unique<MainWindow>();
        test::showAt(*window, {800, 700});
        bar = window->findChild<QToolBar*>(QStringLiteral("main-toolbar"));
        mark = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"));
    }
    ~NarrowToolBarTest() override {
        window.reset();
        Theme::instance().setTextScale(1.0);
    }
    void expand(Qt::Key scene) {
        QTest::keyClick(window.get(), scene, Qt::ControlModifier);
        settle();
        row = bar->height();
        ASSERT_TRUE(mark->isVisible());
        QTest::mouseClick(mark, Qt::LeftButton);
        settle();
        ASSERT_GT(bar->height(), row);
    }
    static void settle() {
        QTest::qWait(20);  // Qt lays out in several turns of the loop
    }
    /// One row, the mark where it hides something, and it hides nothing that has room.
    void expectFolded() {
        settle();
        EXPECT_EQ(bar->height(), row);
        int needed = 0;
        bool hides = false;
        for (QAction* action : bar->actions()) {
            const QWidget* widget = bar->widgetForAction(action);
            needed += widget->sizeHint().width();
            hides |= widget->isHidden() && !action->isSeparator();
        }
        EXPECT_EQ(mark->isVisible(), hides);
        EXPECT_EQ(hides, needed > bar->width() - 2 * Theme::space) << needed;
    }

    std::unique_ptr<MainWindow> window;
    QToolBar* bar = nullptr;
    QToolButton* mark = nullptr;
    int row = 0;  ///< its height
};

TEST_F(NarrowToolBarTest, FoldsWhenAnotherPageComes) {
    for (const Qt::Key other : {Qt::Key_1, Qt::Key_2, Qt::Key_4, Qt::Key_5}) {
        SCOPED_TRACE(other);
        ASSERT_NO_FATAL_FAILURE(expand(Qt::Key_3));
        QTest::keyClick(window.get(), other, Qt::ControlModifier);
        expectFolded();
    }
    ASSERT_NO_FATAL_FAILURE(expand(Qt::Key_3));
    QTest::keyClick(window.get(), Qt::Key_Home, Qt::AltModifier);
    expectFolded();
}

TEST_F(NarrowToolBarTest, FoldsWhenTheWindowIsEnlarged) {
    for (const int width : {830, 1000, 1300, 1600}) {
        SCOPED_TRACE(width);
        window->resize(800, 700);
        ASSERT_NO_FATAL_FAILURE(expand(Qt::Key_3));
        window->resize(width, 700);
        expectFolded();
    }
}

TEST_F(NarrowToolBarTest, FoldsWhenThePointerLeavesWhateverComesThen) {
    ASSERT_NO_FATAL_FAILURE(expand(Qt::Key_3));
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(bar, &leave);
    QTest::keyClick(window.get(), Qt::Key_1, Qt::ControlModifier);
    window->resize(1300, 700);
    expectFolded();
}

// The second of two with one letter is never reached by it.
TEST(MainWindowMenus, NoMenuHasAMnemonicTwice) {
    for (const QString& language : {u"en"_s, u"ru"_s}) {
        installLanguage(language);
        MainWindow window;
        for (const QMenu* menu : window.findChildren<QMenu*>()) {
            QMap<QKeySequence, QString> taken;
            for (const QAction* action : menu->actions()) {
                const QKeySequence letter = QKeySequence::mnemonic(action->text());
                if (letter.isEmpty()) {
                    continue;
                }
                EXPECT_FALSE(taken.contains(letter))
                    << language.toStdString() << ", " << menu->title().toStdString() << ": "
                    << action->text().toStdString() << " and " << taken[letter].toStdString();
                taken.insert(letter, action->text());
            }
        }
    }
    installLanguage(u"en"_s);
}

TEST(Help, EveryPageHasItsHelp) {
    for (const SceneInfo& info : sceneList()) {
        HelpWindow help(info.name);
        const QString text = help.findChild<QTextBrowser*>()->toPlainText();
        EXPECT_GT(text.size(), 200) << info.name.toStdString();
    }
}

/// A window that is destroyed with a field half typed, as at the end of a session of the desktop.
class MainWindowEndTest : public ::testing::Test {
  protected:
    MainWindowEndTest() {
        test::showAt(*window, {1280, 800});
        window->activateWindow();
        window->showScene(QStringLiteral("balance-shaft"));
        QObject::connect(window->currentPage()->model()->history(), &QUndoStack::cleanChanged,
                         [this] { ++said; });
    }

    std::unique_ptr<MainWindow> window = std::make_unique<MainWindow>();
    int said = 0;  ///< how often the history was clean or no longer so
};

TEST_F(MainWindowEndTest, AHistoryThatGoesSaysNothing) {
    ASSERT_EQ(applySetting(*window, QStringLiteral("shaft_angle_deg=120")), QString());
    ASSERT_EQ(said, 1);
    window.reset();
    EXPECT_EQ(said, 1);
}

TEST_F(MainWindowEndTest, WhatWasTypedArrivesWhileTheWindowIsWhole) {
    auto* field = window->findChild<NumberField*>(QStringLiteral("crank_radius_mm"));
    ASSERT_NE(field, nullptr);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("47"));
    QByteArray hearer;
    QObject::connect(field, &QLineEdit::editingFinished,
                     [&hearer, ending = static_cast<QObject*>(window.get())] {
                         hearer = ending->metaObject()->className();
                     });
    window.reset();
    EXPECT_EQ(hearer, "ravnoves::MainWindow");
}

}  // namespace
}  // namespace ravnoves

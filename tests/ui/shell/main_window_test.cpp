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

#include "events.h"
#include "page/scene_page.h"
#include "shell/screenshot.h"
#include "text/language.h"
#include "widgets/number_field.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class MainWindowTest : public ::testing::Test {
  protected:
    MainWindowTest() { test::showAt(window, {1280, 800}); }

    MainWindow window;
};

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

TEST_F(MainWindowTest, PicturesWaitForWhatIsComputedInTheBackground) {
    ASSERT_TRUE(window.showScene(QStringLiteral("elastic-hinge")));
    ASSERT_EQ(applySetting(window, QStringLiteral("tab=motion")), QString());
    ASSERT_EQ(applySetting(window, QStringLiteral("lambda=0.35")), QString());
    EXPECT_TRUE(window.currentPage()->isBusy());
    const QTemporaryDir folder;
    ASSERT_EQ(writeScreenshot(window, folder.filePath(u"motion.png"_s)), QString());
    EXPECT_FALSE(window.currentPage()->isBusy());
}

TEST_F(MainWindowTest, AnUnknownTabIsAnsweredWithTheTabsThatThereAre) {
    EXPECT_FALSE(window.showScene(QStringLiteral("balance-shift")));
    ASSERT_TRUE(window.showScene(QStringLiteral("elastic-hinge")));
    const QString answer = applySetting(window, QStringLiteral("tab=motions"));
    EXPECT_TRUE(answer.contains(QStringLiteral("side-force"))) << answer.toStdString();
    EXPECT_TRUE(answer.contains(QStringLiteral("got motions"))) << answer.toStdString();
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
    test::typeOver(field, QStringLiteral("47"));
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

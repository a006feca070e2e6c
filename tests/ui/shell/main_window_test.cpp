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
#include "theme/theme.h"
#include "widgets/number_field.h"
#include "widgets/verdict_line.h"

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

/// Beside the text it would leave a narrow column.
TEST(MainWindowLooks, TheButtonOfAVerdictIsBelowItsTextWhereThereIsLittleRoom) {
    installLanguage(u"ru"_s);
    for (const double text : {1.0, 1.5}) {
        Theme::instance().setTextScale(text);
        MainWindow window;
        test::showAt(window, {1024, 700});
        auto* verdict = window.currentPage()->findChild<VerdictLine*>();
        ASSERT_NE(verdict, nullptr);
        verdict->show({Severity::warning, Text{"не помещается: вал задевает шатун при 65,7°"}},
                      u"Поставить вал на 105 мм, 57°"_s);
        QApplication::processEvents();
        QApplication::processEvents();
        const QRect button = test::named<QPushButton>(*verdict, "verdict_act")->geometry();
        const auto* label = test::named<QLabel>(*verdict, "verdict");
        const QRect words(label->mapTo(verdict, QPoint()), label->size());
        EXPECT_GE(words.width(), verdict->width() / 3);
        EXPECT_TRUE(verdict->rect().contains(button));
        EXPECT_EQ(button.top() > words.bottom(), text > 1.0);
        EXPECT_EQ(button.left() > words.right(), text == 1.0);
    }
    Theme::instance().setTextScale(1.0);
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

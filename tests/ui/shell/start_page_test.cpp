#include "shell/start_page.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDir>
#include <QMenu>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <iterator>
#include <memory>

#include "case-file/json.h"
#include "events.h"
#include "model/case_document.h"
#include "page/scene_page.h"
#include "shell/documents.h"
#include "shell/main_window.h"
#include "shell/new_cases.h"
#include "shell/scene_list.h"
#include "text/language.h"
#include "text/preferences.h"
#include "theme/theme.h"
#include "widgets/entry_field.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

qsizetype exampleCount() {
    return QDir(QStringLiteral(RAVNOVES_EXAMPLES)).entryList({u"*.case.json"_s}).size();
}

class StartPageTest : public ::testing::Test {
  protected:
    StartPageTest() {
        QObject::connect(&page, &StartPage::sceneRequested,
                         [this](const QString& scene) { scenes << scene; });
        QObject::connect(&page, &StartPage::newRequested,
                         [this](const CaseFile& file) { files.push_back(file); });
        QObject::connect(&page, &StartPage::openRequested,
                         [this](const QString& path) { paths << path; });
        test::showAt(page, {920, 600});
    }

    QAbstractButton* card(const QString& scene) {
        return page.findChild<QAbstractButton*>(u"start-"_s + scene);
    }

    StartPage page;
    QStringList scenes;
    QStringList paths;
    std::vector<CaseFile> files;
};

TEST_F(StartPageTest, CutsNoWordWhateverTheText) {
    for (const char* language : {"en", "ru"}) {
        installLanguage(QString::fromLatin1(language));
        for (const double text : {1.0, 2.0}) {
            Theme::instance().setTextScale(text);
            StartPage shown;
            test::showAt(shown, {1160, 700});
            for (const SceneInfo& info : sceneList()) {
                auto* one = shown.findChild<QAbstractButton*>(u"start-"_s + info.name);
                EXPECT_EQ(one->accessibleDescription(), info.summary);
                for (const QString& word : info.summary.split(QRegularExpression(u"[ -]"_s))) {
                    EXPECT_LE(one->fontMetrics().horizontalAdvance(word),
                              one->width() - 2 * Theme::margin)
                        << word.toStdString();
                }
                EXPECT_LE(one->geometry().right(), one->parentWidget()->width());
                EXPECT_GE(one->height(), one->heightForWidth(one->width()));
            }
        }
    }
    Theme::instance().setTextScale(1.0);
    installLanguage(u"en"_s);
}

TEST_F(StartPageTest, IsWorkedByTheKeyboardAlone) {
    page.activateWindow();
    card(u"balance-shaft"_s)->setFocus();
    QSet<QWidget*> reached;
    QWidget* at = page.focusWidget();
    for (int i = 0; i < 60 && at != nullptr && !reached.contains(at); ++i) {
        reached << at;
        QTest::keyClick(at, Qt::Key_Tab);
        at = page.focusWidget();
    }
    for (const QAbstractButton* button : page.findChildren<QAbstractButton*>()) {
        if (button->objectName().startsWith(u"start-") && button->isVisible()) {
            EXPECT_TRUE(reached.contains(const_cast<QAbstractButton*>(button)))
                << button->text().toStdString();
        }
    }
    card(u"methods"_s)->setFocus();
    QTest::keyClick(card(u"methods"_s), Qt::Key_Return);
    QTest::keyClick(card(u"methods"_s), Qt::Key_Space);
    EXPECT_EQ(scenes, (QStringList{u"methods"_s, u"methods"_s}));
}

TEST_F(StartPageTest, AnExampleIsACaseWithoutAFile) {
    const auto examples = page.findChildren<QAbstractButton*>(u"start-example"_s);
    EXPECT_EQ(examples.size(), exampleCount());
    for (QAbstractButton* each : examples) {
        EXPECT_TRUE(each->text().endsWith(u'?')) << each->text().toStdString();
        each->click();
    }
    ASSERT_EQ(std::ssize(files), exampleCount());
    EXPECT_TRUE(paths.isEmpty());
    for (const CaseFile& file : files) {
        EXPECT_FALSE(file.title.empty());
    }
}

TEST_F(StartPageTest, ListsTheFilesOpenedLast) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"двигатель.case.json"_s);
    QWidget place;
    const std::unique_ptr<ScenePage> scene(sceneList().front().make(&place, nullptr));
    CaseDocument document(scene->model());
    EXPECT_EQ(document.saveTo(path), QString());
    const StartPage again;
    QStringList opened;
    QObject::connect(&again, &StartPage::openRequested,
                     [&](const QString& each) { opened << each; });
    auto* recent = again.findChild<QAbstractButton*>(u"start-recent"_s);
    ASSERT_NE(recent, nullptr);
    EXPECT_EQ(recent->text(), u"двигатель.case.json"_s);
    EXPECT_EQ(recent->accessibleDescription(), folder.path());
    recent->click();
    EXPECT_EQ(opened, QStringList{path});
}

// Everything that a new case may begin with can be loaded, and shows something.
TEST(NewCases, AreTakenByTheirScenes) {
    QWidget place;
    for (const SceneInfo& info : sceneList()) {
        int empty = 0;
        int presets = 0;
        const std::unique_ptr<ScenePage> page(info.make(&place, nullptr));
        for (const NewCase& each : newCases()) {
            if (each.scene != info.name) {
                continue;
            }
            empty += each.listed == each.title ? 1 : 0;
            presets += each.listed != each.title && each.question.isEmpty() ? 1 : 0;
            const CaseFile file = each.make();
            EXPECT_EQ(QString::fromStdString(file.scene), info.name);
            EXPECT_NO_THROW(
                page->model()->loadCase(file.input, {}, QString::fromStdString(file.title)))
                << each.title.toStdString();
            EXPECT_FALSE(page->resultsAsText().isEmpty()) << each.title.toStdString();
        }
        const bool hasCases = info.name != u"methods";
        EXPECT_EQ(empty, hasCases ? 1 : 0) << info.name.toStdString();
        EXPECT_EQ(presets > 0, hasCases) << info.name.toStdString();
    }
}

class StartInTheWindow : public ::testing::Test {
  protected:
    StartInTheWindow() {
        test::showAt(window, {1024, 700});
        window.activateWindow();
        window.showStart();
        QApplication::processEvents();
    }

    QAction* action(const QString& text) { return test::actionNamed(window, text); }

    MainWindow window;
};

TEST(StartOfTheProgram, MakesNoPageBeforeOneIsAskedFor) {
    MainWindow window(MainWindow::First::Nothing);
    test::showAt(window, {1024, 700});
    window.showStart();
    QApplication::processEvents();
    EXPECT_TRUE(window.isAtStart());
    EXPECT_TRUE(window.documents().all().empty());
    EXPECT_EQ(window.windowTitle(), u"Ravnoves"_s);
    // Another language makes the window again, and still no page.
    Preferences::instance().setLanguage(u"ru"_s);
    QApplication::processEvents();
    EXPECT_TRUE(window.isAtStart());
    EXPECT_TRUE(window.documents().all().empty());
    Preferences::instance().setLanguage(u"en"_s);
    QApplication::processEvents();
    // The document in front is made for whoever asks for it, behind the start page.
    EXPECT_EQ(window.currentScene(), u"balance-shaft"_s);
    ASSERT_NE(window.currentPage(), nullptr);
    EXPECT_TRUE(window.isAtStart());
    EXPECT_TRUE(window.showScene(u"balance-shaft"_s));
    EXPECT_FALSE(window.isAtStart());
    EXPECT_EQ(window.documents().all().size(), 1U);
    QApplication::processEvents();
    EXPECT_TRUE(window.currentPage()->isVisible())
        << window.documents().isVisible() << window.centralWidget()->isVisible();
}

TEST(StartOfTheProgram, APresetIsSpeltAsItsCase) {
    installLanguage(u"ru"_s);
    {
        MainWindow window(MainWindow::First::Nothing);
        window.showScene(u"balance-shaft"_s);
        const QString title = window.currentPage()->model()->title();
        EXPECT_EQ(title, u"ТМЗ-650Д"_s);
        const auto& cases = newCases();
        EXPECT_TRUE(std::any_of(cases.begin(), cases.end(),
                                [&](const NewCase& each) { return each.title == title; }));
    }
    installLanguage(u"en"_s);
}

TEST_F(StartInTheWindow, AClickLeadsToAScene) {
    EXPECT_TRUE(window.isAtStart());
    EXPECT_FALSE(action(u"Save case"_s)->isEnabled());
    EXPECT_FALSE(action(u"Close case"_s)->isEnabled());
    QTest::mouseClick(test::named<QAbstractButton>(window, "start-balance-shaft"), Qt::LeftButton);
    EXPECT_FALSE(window.isAtStart());
    EXPECT_TRUE(action(u"Save case"_s)->isEnabled());
}

TEST_F(StartInTheWindow, ComesBackByItsKeyAndGoesWithAScene) {
    QTest::keyClick(&window, Qt::Key_3, Qt::ControlModifier);
    EXPECT_FALSE(window.isAtStart());
    EXPECT_EQ(window.currentScene(), u"workshop"_s);
    QTest::keyClick(&window, Qt::Key_Home, Qt::AltModifier);
    EXPECT_TRUE(window.isAtStart());
    EXPECT_EQ(window.windowTitle(), u"Ravnoves"_s);
    QTest::keyClick(&window, Qt::Key_3, Qt::ControlModifier);
    EXPECT_FALSE(window.isAtStart()) << "though it is the scene that was in front";
    EXPECT_TRUE(window.windowTitle().contains(u"Workshop"_s));
}

/// When the page before goes, the focus goes where Qt finds a place: not always to a field.
TEST_F(StartInTheWindow, OnThePageOfTheWorkshopOneTypesAtOnce) {
    for (const Qt::Key scene : {Qt::Key_3, Qt::Key_1, Qt::Key_3}) {
        QTest::keyClick(&window, scene, Qt::ControlModifier);
        QTest::qWait(20);
        if (scene != Qt::Key_1) {
            QTRY_VERIFY(qobject_cast<EntryField*>(window.focusWidget()) != nullptr);
        }
        QTest::keyClick(&window, Qt::Key_Home, Qt::AltModifier);
        QTest::qWait(20);
    }
}

/// They would change a case that is not shown.
TEST_F(StartInTheWindow, KnowsNoVariants) {
    auto* button = test::named<QToolButton>(window, "variants_button");
    EXPECT_FALSE(button->isEnabled());
    QTest::keyClick(&window, Qt::Key_1, Qt::ControlModifier);
    EXPECT_TRUE(button->isEnabled());
    SceneModel& model = *window.currentPage()->model();
    QTest::keyClick(&window, Qt::Key_K, Qt::ControlModifier);
    ASSERT_EQ(model.variants().size(), 1);
    ASSERT_EQ(model.reference(), 0);
    model.setByKey(u"shaft_angle_deg"_s, u"77"_s);
    const Json input = model.inputJson();
    const int steps = model.history()->count();

    QTest::keyClick(&window, Qt::Key_Home, Qt::AltModifier);
    ASSERT_TRUE(window.isAtStart());
    EXPECT_FALSE(button->isEnabled());
    EXPECT_TRUE(button->text().isEmpty());
    button->menu()->popup(QPoint());
    for (const QAction* each : button->menu()->actions()) {
        EXPECT_TRUE(each->isSeparator() || !each->isEnabled()) << each->text().toStdString();
    }
    button->menu()->hide();
    QTest::keyClick(&window, Qt::Key_K, Qt::ControlModifier);
    QTest::keyClick(&window, Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(model.variants().size(), 1);
    EXPECT_EQ(model.reference(), 0);
    EXPECT_EQ(model.inputJson(), input);
    EXPECT_EQ(model.history()->count(), steps);

    QTest::keyClick(&window, Qt::Key_1, Qt::ControlModifier);
    EXPECT_TRUE(button->isEnabled());
    QTest::keyClick(&window, Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(model.reference(), -1);
}

TEST_F(StartInTheWindow, TheNewButtonOffersBeginnings) {
    ASSERT_TRUE(window.showScene(u"inertia-moments"_s));
    auto* bar = window.findChild<QToolBar*>(u"main-toolbar"_s);
    auto* button = qobject_cast<QToolButton*>(
        bar->widgetForAction(test::actionOfKeys(window, QKeySequence::New)));
    ASSERT_NE(button, nullptr);
    ASSERT_NE(button->menu(), nullptr);
    button->menu()->popup(QPoint());
    const QList<QAction*> offered = button->menu()->actions();
    ASSERT_GT(offered.size(), 3);
    offered.at(0)->trigger();
    button->menu()->hide();
    const Json input = window.currentPage()->model()->inputJson();
    EXPECT_EQ(window.currentScene(), u"inertia-moments"_s);
    EXPECT_EQ(input.at("cylinders").size(), 1U) << "the empty engine";
    EXPECT_TRUE(window.currentPage()->model()->title().isEmpty());
}

}  // namespace
}  // namespace ravnoves

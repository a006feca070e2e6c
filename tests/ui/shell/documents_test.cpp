// Several cases open as tabs, through the window's keys, mouse and menus.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QStatusBar>
#include <QTableWidget>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "files.h"
#include "methods/methods_page.h"
#include "methods/model/case_budget_model.h"
#include "shell/scene_list.h"
#include "shell/window_test.h"
#include "workshop/journal_dialog.h"
#include "workshop/model/job_desk.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class DocumentsTest : public test::WindowTest {
  protected:
    /// Of an example; "honda" is another engine with a balance shaft.
    QString example(const QString& name) {
        const QString path = QStringLiteral(RAVNOVES_EXAMPLES "/%1.case.json");
        if (name != "honda"_L1) {
            return path.arg(name);
        }
        const QString honda = folder.filePath(u"honda.case.json"_s);
        if (!QFile::exists(honda)) {
            QFile::copy(path.arg(u"tmz-650d"_s), honda);
        }
        return honda;
    }
    void open(const QString& name) { ASSERT_EQ(window->openCase(example(name)), QString()); }
    QTabBar& bar() { return *window->findChild<QTabBar*>(u"documents"_s); }
    /// Keeps job A-1 of the workshop in a journal of its own.
    JobDesk* keepJob() {
        QFile::remove(Journal::defaultPath());
        press(Qt::Key_3);
        QTest::qWait(100);  // until the page is there for its keys
        set(u"job/engine_number=A-1"_s);
        press(Qt::Key_F2, {});
        auto* desk = window->currentPage()->findChild<JobDesk*>();
        EXPECT_TRUE(test::comes([&] { return desk->jobId() != 0; }));
        return desk;
    }
};

/// Its page is the last one of the navigation.
Qt::Key methodsKey() {
    return static_cast<Qt::Key>(Qt::Key_0 + static_cast<int>(sceneList().size()));
}

TEST_F(DocumentsTest, ACaseThatIsOpenedReplacesNothing) {
    EXPECT_FALSE(bar().isVisible());
    open(u"tmz-650d"_s);
    EXPECT_FALSE(bar().isVisible()) << "took the place of the untouched first document";
    set(u"shaft_angle_deg=77"_s);
    open(u"honda"_s);
    EXPECT_TRUE(bar().isVisible());
    EXPECT_EQ(tabs(), (QStringList{u"tmz-650d *"_s, u"honda"_s}));
    EXPECT_EQ(bar().currentIndex(), 1);
    EXPECT_FALSE(window->isWindowModified());
    EXPECT_NE(model().inputJson().at("shaft_angle_deg"), 77);
    press(Qt::Key_Tab);
    EXPECT_EQ(bar().currentIndex(), 0);
    EXPECT_TRUE(window->isWindowModified());
    EXPECT_TRUE(window->windowTitle().startsWith(u"tmz-650d.case.json"_s));
    EXPECT_EQ(model().inputJson().at("shaft_angle_deg"), 77);
}

TEST_F(DocumentsTest, AFileThatIsOpenComesToTheFront) {
    const QString link = folder.filePath(u"link.case.json"_s);
    ASSERT_TRUE(QFile::link(example(u"tmz-650d"_s), link));
    open(u"tmz-650d"_s);
    set(u"shaft_angle_deg=77"_s);
    open(u"vr5-volkswagen"_s);
    ASSERT_EQ(window->openCase(link), QString());
    EXPECT_EQ(bar().count(), 2);
    EXPECT_EQ(window->currentScene(), u"balance-shaft"_s);
    EXPECT_EQ(model().inputJson().at("shaft_angle_deg"), 77);
}

TEST_F(DocumentsTest, WhatIsWrongWithAFileIsSaidInWords) {
    open(u"vr5-volkswagen"_s);
    const std::size_t open = window->documents().all().size();
    CaseFile file = CaseDocument::read(example(u"tmz-650d"_s));
    file.input["crank_radius_mm"] = -46;
    const QString bad = folder.filePath(u"bad.json"_s);
    test::writeFile(bad, QByteArray::fromStdString(write_case(file).dump()));
    EXPECT_EQ(window->openCase(bad).mid(bad.size() + 2),
              u"Crank radius r: must be greater than 0, got −46"_s);
    EXPECT_EQ(window->documents().all().size(), open);
    EXPECT_EQ(window->currentScene(), u"inertia-moments"_s);
}

TEST_F(DocumentsTest, TheNavigationFollowsAndBringsASceneSLastTab) {
    open(u"tmz-650d"_s);
    open(u"honda"_s);
    open(u"vr5-volkswagen"_s);
    const auto checked = [this](const QString& title) { return action(title)->isChecked(); };
    EXPECT_TRUE(checked(u"Inertia moments"_s));
    QTest::mouseClick(&bar(), Qt::LeftButton, {}, bar().tabRect(0).center());
    EXPECT_TRUE(checked(u"Balance shaft"_s));
    EXPECT_TRUE(window->windowTitle().contains(u"tmz-650d"_s));
    press(Qt::Key_4);
    press(Qt::Key_1);
    EXPECT_TRUE(window->windowTitle().contains(u"tmz-650d"_s)) << "the one shown last";
    // A scene without a document gets its first.
    press(Qt::Key_2);
    EXPECT_EQ(window->currentScene(), u"elastic-hinge"_s);
    EXPECT_EQ(bar().count(), 4);
    const QString hint = action(u"Elastic hinges"_s)->statusTip();
    const auto labels = window->findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
        return label->isVisible() && label->text() == hint;
    }));
}

/// Of a case that somebody sent: a line of its own in a title, or letters that run backwards, would
/// make a window or a tab look like another.
TEST_F(DocumentsTest, TitlesAreOneLineInItsDirection) {
    CaseFile file = model().caseFile();
    file.title = "a\nb\tc\x1b[31m\u202e\u2066d\u2028e[*]f";
    const QString shown = u"a b c [31md e[*]f"_s;
    for (const QString& name : {u"plain"_s, u"x\n\u202ey"_s}) {
        const QString path = folder.filePath(name + u".case.json"_s);
        test::writeFile(path, QByteArray::fromStdString(write_case(file).dump()));
        ASSERT_EQ(window->openCase(path), QString());
        const QString title = window->windowTitle();
        EXPECT_TRUE(title.contains(u"a b c [31md e[*][*]f"_s)) << qPrintable(title);
        EXPECT_EQ(model().titleShown(), shown);
        EXPECT_EQ(model().title().toStdString(), file.title) << "as the file has it";
        window->showStart();
        QStringList texts = tabs() + QStringList{title};
        for (const auto* recent : window->findChildren<QAbstractButton*>(u"start-recent"_s)) {
            texts << recent->text();
        }
        EXPECT_GT(texts.size(), tabs().size() + 1);
        for (const QString& text : texts) {
            for (const QChar letter : text) {
                EXPECT_TRUE(letter.category() != QChar::Other_Control &&
                            letter.unicode() != 0x202E && letter.unicode() != 0x2066)
                    << qPrintable(text);
            }
        }
    }
    EXPECT_TRUE(tabs().constLast().startsWith(u"x y"_s)) << qPrintable(tabs().constLast());
}

TEST_F(DocumentsTest, BrowsingThroughTheScenesNeedsNoTabs) {
    for (const Qt::Key key : {Qt::Key_2, Qt::Key_3, Qt::Key_4, methodsKey(), Qt::Key_1}) {
        press(key);
        EXPECT_FALSE(bar().isVisible());
        EXPECT_FALSE(action(u"Next case"_s)->isEnabled());
    }
    // What one has worked on stays within reach.
    set(u"shaft_angle_deg=77"_s);
    press(Qt::Key_2);
    EXPECT_TRUE(bar().isVisible());
    EXPECT_EQ(bar().count(), 2);
}

TEST_F(DocumentsTest, NewBeginsATabOfTheScene) {
    open(u"tmz-650d"_s);
    press(Qt::Key_N);
    EXPECT_EQ(bar().count(), 2);
    EXPECT_FALSE(window->windowTitle().contains(u"tmz-650d"_s));
    press(Qt::Key_N);
    ASSERT_EQ(bar().count(), 3);
    EXPECT_NE(bar().tabText(1), bar().tabText(2));
    EXPECT_EQ(window->currentScene(), u"balance-shaft"_s);
    press(methodsKey());
    const int before = bar().count();
    press(Qt::Key_N);
    EXPECT_EQ(bar().count(), before) << "the page has no cases";
}

TEST_F(DocumentsTest, NoCaseIsBegunFromABadOne) {
    CaseFile bad = CaseDocument::read(example(u"vr5-volkswagen"_s));
    bad.input = {{"cylinders", -1}};
    EXPECT_NE(window->documents().begin(bad), QString());
    EXPECT_FALSE(window->newCase(u"balance-shift"_s));
}

TEST_F(DocumentsTest, ClosesByKeyByButtonAndByTheMiddleButton) {
    open(u"tmz-650d"_s);
    open(u"honda"_s);
    open(u"vr5-volkswagen"_s);
    open(u"zotov-energy"_s);
    press(Qt::Key_W);
    EXPECT_EQ(tabs(), (QStringList{u"tmz-650d"_s, u"honda"_s, u"vr5-volkswagen"_s}));
    EXPECT_TRUE(window->windowTitle().contains(u"vr5-volkswagen"_s)) << "the one shown before";
    auto* button = qobject_cast<QAbstractButton*>(bar().tabButton(0, QTabBar::RightSide));
    ASSERT_NE(button, nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_EQ(tabs(), (QStringList{u"honda"_s, u"vr5-volkswagen"_s}));
    QTest::mouseClick(&bar(), Qt::MiddleButton, {}, bar().tabRect(1).center());
    EXPECT_EQ(window->documents().all().size(), 1U);
    EXPECT_FALSE(bar().isVisible());
    // The last leaves the start page, not another engine's numbers as if they were one's own.
    press(Qt::Key_W);
    EXPECT_TRUE(window->isAtStart());
    EXPECT_FALSE(window->documents().hasCurrent());
    EXPECT_FALSE(action(u"Close case"_s)->isEnabled());
    open(u"honda"_s);
    EXPECT_FALSE(window->isAtStart());
    EXPECT_TRUE(window->windowTitle().contains(u"honda"_s));
}

TEST_F(DocumentsTest, TheEngineOfAnotherOpenCaseIsTakenAsOneStep) {
    open(u"tmz-650d"_s);
    set(u"crank_radius_mm=41"_s);
    set(u"cylinder/rod_length_mm=164"_s);
    const double speed = model().inputJson().at("angular_speed_rad_s").get<double>();
    open(u"zotov-energy"_s);
    const Json before = model().inputJson();
    QAction* from = action(u"Take the engine from"_s);
    ASSERT_NE(from, nullptr);
    auto* menu = from->menu<QMenu*>();
    Q_EMIT menu->aboutToShow();
    ASSERT_EQ(menu->actions().size(), 1) << "not its own";
    menu->actions().constFirst()->trigger();
    const Json now = model().inputJson();
    EXPECT_EQ(now.at("crank_radius_mm"), 41.0);
    EXPECT_EQ(now.at("lambda"), 0.25);
    EXPECT_NEAR(now.at("angular_speed_rad_s").get<double>(), speed, 1e-9);
    const QString said = window->statusBar()->currentMessage();
    EXPECT_TRUE(said.contains(u"tmz-650d"_s) && said.contains(u"crank radius"_s))
        << said.toStdString();
    const int steps = model().history()->index();
    Q_EMIT menu->aboutToShow();
    menu->actions().constFirst()->trigger();
    EXPECT_EQ(model().history()->index(), steps) << "it is the same already";
    model().undo();
    EXPECT_EQ(model().inputJson(), before);
}

TEST_F(DocumentsTest, ClosingAsksForItsOwnChangesAlone) {
    open(u"tmz-650d"_s);
    set(u"shaft_angle_deg=77"_s);
    open(u"honda"_s);
    press(Qt::Key_W);
    EXPECT_TRUE(asked.isEmpty());
    EXPECT_TRUE(window->windowTitle().contains(u"tmz-650d"_s));
    answer("Cancel");
    press(Qt::Key_W);
    EXPECT_TRUE(window->windowTitle().contains(u"tmz-650d"_s));
    EXPECT_EQ(model().inputJson().at("shaft_angle_deg"), 77);
    answer("Don’t save");
    press(Qt::Key_W);
    EXPECT_FALSE(window->windowTitle().contains(u"tmz-650d"_s));
    ASSERT_EQ(asked.size(), 2);
    EXPECT_TRUE(asked[0].contains(u"tmz-650d.case.json"_s));
    open(u"honda"_s);
    set(u"shaft_angle_deg=78"_s);
    answer("Save");
    press(Qt::Key_W);
    EXPECT_EQ(CaseDocument::read(example(u"honda"_s)).input.at("shaft_angle_deg"), 78);
}

TEST_F(DocumentsTest, QuittingAsksForEachThatHasChanges) {
    open(u"tmz-650d"_s);
    set(u"shaft_angle_deg=77"_s);
    open(u"vr5-volkswagen"_s);
    open(u"honda"_s);
    set(u"shaft_angle_deg=78"_s);
    open(u"zotov-energy"_s);
    answer("Don’t save");
    answer("Cancel");
    EXPECT_FALSE(window->close());
    ASSERT_EQ(asked.size(), 2);
    EXPECT_TRUE(asked[0].contains(u"tmz-650d"_s));
    EXPECT_TRUE(asked[1].contains(u"honda"_s));
    EXPECT_TRUE(window->windowTitle().contains(u"honda"_s)) << "what was asked about";
    EXPECT_EQ(window->documents().all().size(), 4U);
}

TEST_F(DocumentsTest, OfManyFilesThatCannotBeOpenedOneMessageSaysSo) {
    QStringList paths;
    for (int i = 0; i < 300; ++i) {
        paths << folder.filePath(u"none%1.case.json"_s.arg(i));
    }
    answer("OK");
    window->openOrSayWhy(paths);
    ASSERT_EQ(asked.size(), 1);
    EXPECT_TRUE(asked[0].contains(u"none19.case.json"_s));
    EXPECT_FALSE(asked[0].contains(u"none20.case.json"_s));
    EXPECT_TRUE(asked[0].endsWith(u"Too many files; not opened: 280"_s)) << qPrintable(asked[0]);
}

TEST_F(DocumentsTest, TabsAreMovedByTheMouse) {
    open(u"tmz-650d"_s);
    open(u"honda"_s);
    open(u"vr5-volkswagen"_s);
    const QPoint from = bar().tabRect(0).center();
    test::drag(&bar(), from, bar().tabRect(2).center() + QPoint(20, 0));
    const QStringList moved{u"honda"_s, u"vr5-volkswagen"_s, u"tmz-650d"_s};
    EXPECT_TRUE(test::comes([&] { return tabs() == moved; }));
    EXPECT_TRUE(window->windowTitle().contains(u"tmz-650d"_s));
    press(Qt::Key_Tab);
    EXPECT_TRUE(window->windowTitle().contains(u"honda"_s));
}

TEST_F(DocumentsTest, EveryFileThatIsDroppedOpens) {
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(example(u"tmz-650d"_s)),
                   QUrl::fromLocalFile(example(u"vr5-volkswagen"_s))});
    QDragEnterEvent enters(QPoint(300, 300), Qt::CopyAction, &files, Qt::LeftButton, {});
    QApplication::sendEvent(window.get(), &enters);
    EXPECT_TRUE(enters.isAccepted());
    QDropEvent drops(QPointF(300, 300), Qt::CopyAction, &files, Qt::LeftButton, {});
    QApplication::sendEvent(window.get(), &drops);
    EXPECT_EQ(tabs(), (QStringList{u"tmz-650d"_s, u"vr5-volkswagen"_s}));
}

TEST_F(DocumentsTest, MethodsFollowTheCaseShownLastAndStayOnePage) {
    open(u"tmz-650d"_s);
    open(u"honda"_s);
    press(Qt::Key_Tab);
    const QString title = model().title();
    press(methodsKey());
    auto* page = qobject_cast<MethodsPage*>(window->currentPage());
    ASSERT_NE(page, nullptr);
    ASSERT_TRUE(page->budget()->open().has_value());
    EXPECT_EQ(QString::fromStdString(page->budget()->open()->file.title), title);
    press(Qt::Key_1);
    press(methodsKey());
    EXPECT_EQ(window->currentPage(), page);
}

TEST_F(DocumentsTest, AJobBegunFromAnExampleIsKnownByItsNumber) {
    const CaseFile v8 = CaseDocument::read(example(u"bob-weights-v8"_s));
    ASSERT_EQ(window->documents().begin(v8), QString());
    const QString title = QString::fromStdString(v8.title);
    EXPECT_TRUE(window->windowTitle().startsWith(title));
    set(u"job/customer=Smith"_s);
    EXPECT_TRUE(window->windowTitle().startsWith(u"Smith[*]"_s));
    set(u"job/engine_number=A-1"_s);
    press(Qt::Key_N);
    EXPECT_EQ(tabs().constFirst(), u"A-1 *"_s);
    press(Qt::Key_Tab);
    EXPECT_TRUE(window->windowTitle().startsWith(u"A-1[*] – "_s + title));
}

TEST_F(DocumentsTest, TheJournalIsOpenedFromTheStartPage) {
    keepJob();
    press(Qt::Key_1);
    window->showStart();
    QTest::qWait(100);
    int listed = 0;
    test::whenModal<JournalDialog>(window.get(), [&](JournalDialog* dialog) {
        listed = dialog->findChild<QTableWidget*>()->rowCount();
        dialog->reject();
    });
    press(Qt::Key_F3, {});
    EXPECT_TRUE(test::comes([&] { return listed == 1; }));
    EXPECT_FALSE(window->isAtStart());
    EXPECT_EQ(window->currentScene(), u"workshop"_s);
}

TEST_F(DocumentsTest, UndoSaysItsStep) {
    set(u"shaft_angle_deg=77"_s);
    press(Qt::Key_Z);
    EXPECT_EQ(window->statusBar()->currentMessage(), u"Undone: Open case"_s);
    press(Qt::Key_Y);
    EXPECT_EQ(window->statusBar()->currentMessage(), u"Redone: Open case"_s);
    EXPECT_EQ(model().inputJson().at("shaft_angle_deg"), 77);
}

TEST_F(DocumentsTest, AJobThatIsOpenInAnotherTabIsNotOpenedTwice) {
    const JobDesk* desk = keepJob();
    press(Qt::Key_N);
    QTest::qWait(100);
    EXPECT_NE(window->currentPage()->findChild<JobDesk*>(), desk);
    test::whenModal<JournalDialog>(window.get(), [](JournalDialog* dialog) {
        QTest::keyClick(test::named<QLineEdit>(*dialog, "journal_search"), Qt::Key_Return);
    });
    press(Qt::Key_F3, {});
    EXPECT_EQ(window->currentPage()->findChild<JobDesk*>(), desk);
}

}  // namespace
}  // namespace ravnoves

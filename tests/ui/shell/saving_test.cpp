// Cases and pages as files, through the real window.

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressDialog>
#include <QPushButton>
#include <QStatusBar>
#include <QTableView>
#include <QToolTip>

#include "balance-shaft/presets.h"
#include "balance-shaft/torque_table.h"
#include "case-file/case_file.h"
#include "case-file/text_file.h"
#include "files.h"
#include "processor_time.h"
#include "report/report_dialog.h"
#include "shell/case_properties.h"
#include "shell/settings_dialog.h"
#include "shell/window_test.h"
#include "shop/scale_dialog.h"
#include "text/file_path.h"
#include "widgets/number_field.h"
#include "widgets/table_editor.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class SavingTest : public test::WindowTest {
  protected:
    static Json read(const QString& path) { return parse_json(read_text_file(fsPath(path))); }
    /// Types what a field of the page in front rejects.
    void reject(const char* name, const char* text) {
        auto* field = test::named<NumberField>(*window->currentPage(), name);
        field->setFocus();
        field->selectAll();
        QTest::keyClick(field, Qt::Key_Delete);
        QTest::keyClicks(field, QString::fromUtf8(text));
        EXPECT_FALSE(field->trouble().isEmpty()) << name;
        window->currentPage()->setFocus();
    }
    balance_shaft::TorqueTable torque = balance_shaft::preset_tmz_650d().torque.table;

    /// The example with its torque in a file beside it.
    QString caseWithTable(const char* folderName) {
        EXPECT_TRUE(QDir(folder.path()).mkpath(QString::fromUtf8(folderName)));
        const QString path = file(folderName) + QStringLiteral("/engine.case.json");
        Json content = read(QStringLiteral(RAVNOVES_EXAMPLES "/tmz-650d.case.json"));
        content["title"] = "Mine";
        write_text_file(fsPath(file(folderName) + QStringLiteral("/момент.csv")),
                        balance_shaft::write_torque_table(torque));
        content["input"]["torque"] = {{"csv", "момент.csv"}};
        write_text_file(fsPath(path), content.dump());
        return path;
    }
};

TEST_F(SavingTest, TitleAndNotesAreFieldsThatAreSavedAndUndone) {
    press(Qt::Key_I);
    auto* dialog = window->findChild<CaseProperties*>();
    ASSERT_NE(dialog, nullptr);
    auto* title = test::named<QLineEdit>(*dialog, "case_title");
    EXPECT_EQ(title->text(), QStringLiteral("TMZ-650D"));
    test::typeOver(title, QStringLiteral("My engine"));
    auto* notes = test::named<QPlainTextEdit>(*dialog, "case_notes");
    QTest::keyClicks(notes, QStringLiteral("Measured on Monday"));
    QTest::keyClick(title, Qt::Key_Return);
    EXPECT_EQ(model().title(), QStringLiteral("My engine"));
    EXPECT_TRUE(window->windowTitle().contains(QStringLiteral("My engine")));
    EXPECT_TRUE(window->isWindowModified());
    ASSERT_EQ(document().saveTo(file("мой.case.json")), QString());
    EXPECT_TRUE(
        window->windowTitle().startsWith(QStringLiteral("мой.case.json[*] – My engine – ")));
    const Json written = read(file("мой.case.json"));
    EXPECT_EQ(written.at("title"), "My engine");
    EXPECT_EQ(written.at("notes"), "Measured on Monday");
    model().undo();
    EXPECT_EQ(model().title(), QStringLiteral("TMZ-650D"));
    EXPECT_EQ(model().notes(), QString());
    model().redo();
    EXPECT_EQ(model().notes(), QStringLiteral("Measured on Monday"));
}

TEST_F(SavingTest, OfAPastedMegabyteATitleTakesWhatSuitsIt) {
    press(Qt::Key_I);
    auto* dialog = window->findChild<CaseProperties*>();
    ASSERT_NE(dialog, nullptr);
    auto* title = test::named<QLineEdit>(*dialog, "case_title");
    QApplication::clipboard()->setText(QString(1'000'000, QLatin1Char('7')));
    const test::ProcessorTime time;
    QTest::keyClick(title, Qt::Key_V, Qt::ControlModifier);
    EXPECT_LT(time.seconds(), 2.0);
    EXPECT_TRUE(QToolTip::text().startsWith(QStringLiteral("Cut: at most")))
        << qPrintable(QToolTip::text());
    QToolTip::hideText();
    EXPECT_EQ(title->text().size(), 200);
    QTest::keyClick(title, Qt::Key_Return);
    EXPECT_EQ(model().title().size(), 200);
}

TEST_F(SavingTest, UndoTakesBackARejectedEntryWhereNothingElseIsToUndo) {
    auto* field = test::named<NumberField>(*window->currentPage(), "crank_radius_mm");
    QAction* undo = test::actionOfKeys(*window, QKeySequence::Undo);
    const QString shown = field->text();
    test::typeOver(field, QStringLiteral("-7"));
    QTest::keyClick(field, Qt::Key_Tab);
    ASSERT_FALSE(field->trouble().isEmpty());
    QApplication::processEvents();
    EXPECT_FALSE(model().history()->canUndo());
    ASSERT_TRUE(undo->isEnabled());
    undo->trigger();
    EXPECT_EQ(field->trouble(), QString());
    EXPECT_EQ(field->text(), shown);
    EXPECT_FALSE(undo->isEnabled());
    // All that is rejected, wherever it stands; then what was changed before it.
    ASSERT_EQ(model().editField("/crank_radius_mm", 50.0, u"r"_s), QString());
    reject("speed_rpm", "abc");
    auto* table = window->currentPage()->findChild<TableEditor*>();
    table->view()->model()->setData(table->view()->model()->index(5, 1), QStringLiteral("x"));
    undo->trigger();
    EXPECT_TRUE(table->trouble().isEmpty());
    EXPECT_EQ(test::named<NumberField>(*window->currentPage(), "speed_rpm")->trouble(), QString());
    EXPECT_EQ(model().inputJson().at("crank_radius_mm"), 50.0);
    undo->trigger();
    EXPECT_EQ(field->text(), shown);
    EXPECT_FALSE(undo->isEnabled());
}

TEST_F(SavingTest, ClosingAsksWhereNothingButARejectedEntryStands) {
    const QString path = caseWithTable("a");
    ASSERT_EQ(window->openCase(path), QString());
    reject("crank_radius_mm", "-5");
    ASSERT_FALSE(window->isWindowModified());
    answer("Stay");
    press(Qt::Key_W);
    ASSERT_EQ(asked.size(), 1);
    EXPECT_TRUE(asked[0].contains(QStringLiteral("Crank radius"))) << asked[0].toStdString();
    EXPECT_EQ(test::named<NumberField>(*window->currentPage(), "crank_radius_mm")->selectedText(),
              QStringLiteral("-5"));
    answer("Stay");
    EXPECT_FALSE(window->close());
    EXPECT_EQ(asked.size(), 2);
    answer("Continue without them");
    press(Qt::Key_W);
    EXPECT_EQ(asked.size(), 3);
    EXPECT_NE(window->windowTitle().indexOf(QStringLiteral("Ravnoves")), -1);
}

TEST_F(SavingTest, WhoStaysIsAtTheRedCellOfATable) {
    window->resize(1024, 700);
    QTableView* view = window->currentPage()->findChild<TableEditor*>()->view();
    window->currentPage()->showTabs({u"torque"_s});
    QApplication::processEvents();
    const auto seen = [view](const QModelIndex& at) {
        return view->viewport()->rect().contains(view->visualRect(at));
    };
    view->setFocus();
    const int last = view->rowAt(view->viewport()->height() - view->rowHeight(0));
    const QModelIndex low = view->model()->index(last, 1);
    view->setCurrentIndex(low);
    view->model()->setData(low, u"q5"_s);  // its message takes of the height
    QApplication::processEvents();
    ASSERT_FALSE(seen(view->model()->index(0, 1)));
    EXPECT_TRUE(seen(low));
    QTest::keyClick(view, Qt::Key_Home, Qt::ControlModifier);
    EXPECT_FALSE(seen(low));
    answer("Stay");
    press(Qt::Key_W);
    ASSERT_EQ(asked.size(), 1);
    EXPECT_EQ(view->currentIndex(), low);
    EXPECT_TRUE(seen(low));
}

TEST_F(SavingTest, ReturnDoesNotCancelAReport) {
    const QString path = folder.filePath(u"report.html"_s);
    fileChoosers().save = [&](auto...) { return path; };
    bool isCancelled = true;
    test::whenModal<ReportDialog>(window.get(), [](ReportDialog* dialog) { dialog->accept(); });
    test::whenModal<QProgressDialog>(window.get(), [&](QProgressDialog* dialog) {
        QTest::keyClick(dialog->findChild<QPushButton*>(), Qt::Key_Return);
        isCancelled = dialog->wasCanceled();
        dialog->cancel();
    });
    press(Qt::Key_R);
    EXPECT_FALSE(isCancelled);
    EXPECT_FALSE(QFile::exists(path));
    EXPECT_TRUE(window->statusBar()->currentMessage().contains(u"not written"_s));
}

TEST_F(SavingTest, NotesTypedAreNotLostByEscape) {
    const auto dialog = [this] {
        press(Qt::Key_I);
        return window->findChildren<CaseProperties*>().constLast();
    };
    CaseProperties* open = dialog();
    QTest::keyClick(open, Qt::Key_Escape);  // nothing was typed: it is no step
    EXPECT_FALSE(open->isVisible());
    EXPECT_FALSE(model().history()->canUndo());
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    open = dialog();
    auto* notes = test::named<QPlainTextEdit>(*open, "case_notes");
    QTest::keyClicks(notes, QStringLiteral("one"));
    QTest::keyClick(notes, Qt::Key_Return);
    QTest::keyClicks(notes, QStringLiteral("two"));
    QTest::keyClick(open, Qt::Key_Escape);
    EXPECT_FALSE(open->isVisible());
    EXPECT_EQ(model().notes(), QStringLiteral("one\ntwo"));
    model().undo();
    EXPECT_EQ(model().notes(), QString());
}

TEST_F(SavingTest, RejectedEntriesAreSaidBeforeTheCaseIsWritten) {
    const QString path = caseWithTable("a");
    ASSERT_EQ(window->openCase(path), QString());
    const std::string before = read_text_file(fsPath(path));
    reject("backlash_mm", "-5");  // on a tab that is not in front
    reject("crank_radius_mm", "abc");
    reject("speed_rpm", "");
    QAbstractItemModel* cells = window->currentPage()->findChild<TableEditor*>()->view()->model();
    cells->setData(cells->index(5, 1), QStringLiteral("xyz"));
    answer("Stay");
    press(Qt::Key_S);
    ASSERT_EQ(asked.size(), 1);
    EXPECT_TRUE(asked[0].contains(QStringLiteral("“abc” is not a number")))
        << asked[0].toStdString();
    EXPECT_TRUE(asked[0].contains(QStringLiteral("Enter a value"))) << asked[0].toStdString();
    EXPECT_TRUE(asked[0].contains(QStringLiteral("xyz"))) << asked[0].toStdString();
    EXPECT_EQ(read_text_file(fsPath(path)), before);
    answer("Stay");
    press(Qt::Key_R);
    ASSERT_EQ(asked.size(), 2);
    EXPECT_EQ(asked[1], asked[0]);
    // Pages that are made again would discard them; a table in the clipboard says nothing of them.
    QApplication::clipboard()->setText(u"before"_s);
    for (const char* name : {"Settings", "Scale", "Copy results as text", "Copy results as CSV"}) {
        answer("Stay");
        action(QString::fromUtf8(name))->trigger();
    }
    ASSERT_EQ(asked.size(), 6);
    EXPECT_EQ(window->findChild<SettingsDialog*>(), nullptr);
    EXPECT_EQ(window->findChild<ScaleDialog*>(), nullptr);
    EXPECT_EQ(QApplication::clipboard()->text(), u"before"_s);
    const QString report = folder.filePath(u"report.html"_s);
    ASSERT_EQ(window->writeReport(report), QString());
    const std::string written = read_text_file(fsPath(report));
    EXPECT_NE(written.find("“abc” is not a number"), std::string::npos);
    EXPECT_EQ(written.find("OK: "), std::string::npos);
    answer("Continue without them");
    press(Qt::Key_S);
    ASSERT_EQ(asked.size(), 7);
    EXPECT_NE(read_text_file(fsPath(path)), before);
    EXPECT_EQ(read(path).at("input").at("crank_radius_mm"),
              parse_json(before).at("input").at("crank_radius_mm"));
    // Those of another case are not asked for.
    ASSERT_TRUE(window->newCase(QStringLiteral("balance-shaft")));
    typed = QStringList{file("new.case.json")};
    press(Qt::Key_S);
    EXPECT_EQ(asked.size(), 7);
    EXPECT_TRUE(QFile::exists(file("new.case.json")));
    EXPECT_TRUE(window->statusBar()->currentMessage().contains(QStringLiteral("new.case.json")));
    // Settings would discard them: the question names the case, which comes to the front.
    answer("Stay");
    action(u"Settings"_s)->trigger();
    ASSERT_EQ(asked.size(), 8);
    EXPECT_TRUE(asked[7].startsWith(u"engine.case.json\n"_s)) << asked[7].toStdString();
    EXPECT_EQ(document().path(), path);
    const auto* first = test::named<NumberField>(*window->currentPage(), "backlash_mm");
    EXPECT_TRUE(first->isVisible());
    EXPECT_EQ(window->focusWidget(), first);
}

TEST_F(SavingTest, WhatCannotBeSavedInItsPlaceIsSavedElsewhere) {
    const QString path = caseWithTable("a");
    ASSERT_EQ(window->openCase(path), QString());
    ASSERT_TRUE(QFile(path).setPermissions(QFile::ReadOwner));
    set(QStringLiteral("shaft_angle_deg=70"));
    typed = QStringList{file("mine")};
    answer("Save as…");
    press(Qt::Key_S);
    ASSERT_EQ(asked.size(), 1);
    EXPECT_TRUE(asked[0].startsWith(path)) << asked[0].toStdString();
    EXPECT_EQ(document().path(), file("mine.case.json"));
    EXPECT_FALSE(window->isWindowModified());
}

TEST_F(SavingTest, AnotherStateOfTheCaseEndsWhatWasRejected) {
    const QString path = caseWithTable("a");
    ASSERT_EQ(window->openCase(path), QString());
    const auto radius = [this] {
        return test::named<NumberField>(*window->currentPage(), "crank_radius_mm");
    };
    const QString text = radius()->text();
    const auto isBack = [&] {
        EXPECT_EQ(radius()->text(), text);
        EXPECT_EQ(radius()->trouble(), QString());
    };
    set(QStringLiteral("shaft_angle_deg=70"));
    reject("crank_radius_mm", "abc");
    // Another value alone does not.
    set(QStringLiteral("shaft_angle_deg=80"));
    EXPECT_EQ(radius()->text(), QStringLiteral("abc"));
    // What is rejected is the newest: undo takes back that alone.
    const int steps = model().history()->index();
    press(Qt::Key_Z);
    isBack();
    EXPECT_EQ(model().history()->index(), steps);
    press(Qt::Key_Z);
    EXPECT_EQ(model().history()->index(), steps - 1);
    reject("crank_radius_mm", "");
    press(Qt::Key_Y);
    isBack();
    model().keepVariant();
    reject("crank_radius_mm", "abc");
    EXPECT_EQ(model().takeVariant(0), QString());
    isBack();
    reject("crank_radius_mm", "abc");
    EXPECT_EQ(document().reload(), QString());
    isBack();
}

TEST_F(SavingTest, AFileThatTheSavedCaseReadsIsNotWrittenOver) {
    const QString table = file("a/момент.csv");
    const QString path = caseWithTable("a");
    EXPECT_EQ(sourceTrouble(table), QString());
    ASSERT_EQ(window->openCase(path), QString());
    EXPECT_NE(sourceTrouble(table), QString());
    // The case has numbers of its own now; its file still reads the table.
    Json input = model().inputJson();
    input["torque"] =
        read(QStringLiteral(RAVNOVES_EXAMPLES "/tmz-650d.case.json"))["input"]["torque"];
    model().loadInput(input, {});
    EXPECT_FALSE(model().inputJson()["torque"].contains("csv"));
    EXPECT_NE(sourceTrouble(table), QString());
}

TEST_F(SavingTest, ACaseWithATableOfItsOwnSurvivesAnotherFolder) {
    ASSERT_EQ(window->openCase(caseWithTable("папка")), QString());
    const Json result = model().resultJson();
    const QString copy = file("other.case.json");
    ASSERT_EQ(document().saveTo(copy), QString());
    EXPECT_EQ(read(copy).at("input").at("torque").at("csv"), "папка/момент.csv");
    // Saved again in a third place, then opened there.
    ASSERT_TRUE(QDir(folder.path()).mkpath(QStringLiteral("x/y")));
    const QString deep = file("x/y/deep.case.json");
    ASSERT_EQ(document().saveTo(deep), QString());
    EXPECT_EQ(read(deep).at("input").at("torque").at("csv"), "../../папка/момент.csv");
    MainWindow other;
    ASSERT_EQ(other.openCase(deep), QString());
    EXPECT_EQ(other.currentPage()->model()->resultJson(), result);
}

TEST_F(SavingTest, AMissingTableIsLookedForWithTheUser) {
    const QString path = caseWithTable("a");
    ASSERT_TRUE(QDir(folder.path()).mkpath(QStringLiteral("b")));
    ASSERT_TRUE(QFile::rename(file("a/момент.csv"), file("b/there.csv")));
    const QString trouble = window->openCase(path);
    EXPECT_TRUE(trouble.contains(QStringLiteral("момент.csv"))) << trouble.toStdString();
    write_text_file(fsPath(file("b/wrong.csv")), "nothing\n");
    typed = QStringList{path, file("b/wrong.csv"), file("b/there.csv")};
    // What the case names is looked for, whatever was chosen.
    const auto asksForIt = [&](int at) {
        return asked.value(at).contains(QStringLiteral("момент.csv"));
    };
    answer("Locate file…");
    answer("Locate file…");
    press(Qt::Key_O);
    ASSERT_EQ(asked.size(), 5);
    for (int at = 1; at < 5; ++at) {
        EXPECT_TRUE(asksForIt(at)) << qPrintable(asked.at(at));
    }
    EXPECT_EQ(folders.constLast(), QFileInfo(path).absolutePath()) << "where the case is";
    EXPECT_EQ(model().title(), QStringLiteral("Mine"));
    EXPECT_TRUE(window->isWindowModified());
    ASSERT_EQ(document().saveTo(path), QString());
    EXPECT_FALSE(window->isWindowModified());
    MainWindow other;
    EXPECT_EQ(other.openCase(path), QString());
}

TEST_F(SavingTest, ATableThatOthersChangeIsSaidAndReadAgain) {
    ASSERT_EQ(window->openCase(caseWithTable("a")), QString());
    auto* notice = window->findChild<QWidget*>(QStringLiteral("disk_notice"));
    const auto isSaid = [&] { return notice->isVisible(); };
    const Json before = model().resultJson();
    const QString table = file("a/момент.csv");
    torque.torque[1] = 100.0;
    write_text_file(fsPath(table), balance_shaft::write_torque_table(torque));
    lookAgain();
    ASSERT_TRUE(isSaid());
    EXPECT_TRUE(notice->findChild<QLabel*>()->text().contains(QStringLiteral("момент.csv")));
    EXPECT_EQ(model().resultJson(), before);
    QTest::mouseClick(test::named<QPushButton>(*notice, "disk_reload"), Qt::LeftButton);
    EXPECT_FALSE(isSaid());
    EXPECT_NE(model().resultJson(), before);
    press(Qt::Key_Z);
    EXPECT_EQ(model().resultJson(), before);
    // What cannot be read is said, and all stays.
    write_text_file(fsPath(table), "nothing");
    lookAgain();
    ASSERT_TRUE(isSaid());
    answer("OK");
    QTest::mouseClick(test::named<QPushButton>(*notice, "disk_reload"), Qt::LeftButton);
    EXPECT_EQ(model().resultJson(), before);
    ASSERT_TRUE(QFile::remove(table));
    lookAgain();
    ASSERT_EQ(notice->findChild<QPushButton*>(u"disk_reload"_s), nullptr);
    QTest::mouseClick(test::named<QPushButton>(*notice, "disk_keep"), Qt::LeftButton);
    EXPECT_FALSE(isSaid());
}

TEST_F(SavingTest, GivingUpTheSearchLeavesAllAsItWas) {
    const QString path = caseWithTable("a");
    ASSERT_TRUE(QFile::remove(file("a/момент.csv")));
    typed = QStringList{path};
    answer("Cancel");
    press(Qt::Key_O);
    EXPECT_EQ(asked.size(), 2);
    EXPECT_EQ(model().title(), QStringLiteral("TMZ-650D"));
}

TEST_F(SavingTest, ThePageIsWrittenAsADrawing) {
    typed = QStringList{file("страница.pdf")};
    press(Qt::Key_E);
    EXPECT_TRUE(test::contentOf(file("страница.pdf")).startsWith("%PDF-"));
    typed = QStringList{file("page.svg")};
    press(Qt::Key_E);
    EXPECT_TRUE(read_text_file(fsPath(file("page.svg"))).starts_with("<?xml"));
    typed = QStringList{file("page.jpg")};
    answer("OK");
    press(Qt::Key_E);
    EXPECT_FALSE(QFile::exists(file("page.jpg")));
}

}  // namespace
}  // namespace ravnoves

// Jobs between the page and its journal.

#include <QCheckBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTableWidget>

#include "job_page_test.h"
#include "pictures/file_dialogs.h"
#include "workshop/journal_dialog.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

using units::gram;

TEST_F(PlugsPageTest, EscapeReturnsToWhatIsSaved) {
    auto* number = find<QLineEdit>("engine_number");
    number->setFocus();
    QTest::keyClicks(number, u"77"_s);
    save();
    QTest::keyClicks(number, u"8"_s);
    EXPECT_EQ(model->input().job.engine_number, "778");
    for (int i = 0; i < 2; ++i) {
        QTest::keyClick(number, Qt::Key_Escape);
        EXPECT_EQ(number->text(), u"77"_s);
        EXPECT_EQ(model->input().job.engine_number, "77");
        EXPECT_FALSE(model->hasChanges());
    }
    auto* plug = find<QLineEdit>("rod_big_end");
    show(PartsTab);
    plug->setFocus();
    QTest::keyClicks(plug, u"5"_s);
    save();
    QTest::keyClick(plug, Qt::Key_Backspace);
    EXPECT_EQ(model->input().plugs->typed_changes.rod_big_end, 0.0)
        << "what stood before the saving";
    QTest::keyClick(plug, Qt::Key_Escape);
    EXPECT_NEAR(model->input().plugs->typed_changes.rod_big_end, 5.0 * gram, 1e-12);
}

TEST_F(PlugsPageTest, JournalListsWhatTheMachineSaidAndFindsTheCrankshaft) {
    fill({{"engine_number", "53-11"},
          {"crankshaft_number", "KV-77"},
          {"rod_big_end", "1"},
          {"unbalance_1", "3.14159"},
          {"unbalance_2", "6"}});
    typeGear();
    limitTo(5.0);
    save();
    QStringList cells;
    whenModal<JournalDialog>([&](JournalDialog* dialog) {
        QTest::keyClicks(dialog->findChild<QLineEdit*>(u"journal_search"_s), u"kv-77"_s);
        auto* table = dialog->findChild<QTableWidget*>(u"journal_table"_s);
        for (int i = 0; table->rowCount() == 1 && i < table->columnCount(); ++i) {
            cells << table->item(0, i)->text();
        }
        dialog->reject();
    });
    press(Qt::Key_F3);
    EXPECT_TRUE(cells.contains(u"KV-77"_s));
    EXPECT_TRUE(cells.contains(u"3.1 / 6.0: FAIL"_s)) << qPrintable(cells.join(u'|'));
}

TEST_F(PlugsPageTest, AnEngineThatIsRememberedStaysThatOfItsJob) {
    type("engine_number", u"53-11"_s);
    type("rod_big_end", u"1"_s);
    save();
    model->nameEngine(u"Ours"_s);
    EXPECT_EQ(model->desk()->otherEngine(), QString());
    save();
    const auto jobs = this->jobs();
    ASSERT_EQ(jobs.size(), 1);
    EXPECT_EQ(jobs.at(0).engine, u"Ours"_s);
    // Its values make it another.
    model->editPlugs(u"oil"_s, [](auto& input) { input.engine.oil_mass = 0.123; });
    model->editPlugs(u"name"_s, [](auto& input) { input.engine.name = "Theirs"; });
    EXPECT_EQ(model->desk()->otherEngine(), u"53-11"_s);
}

TEST_F(PlugsPageTest, JobsArePutAsideUnfinishedAndTheTechnicianIsRemembered) {
    type("engine_number", u"53-11"_s);
    type("technician", u"O. Bauer"_s);
    press(Qt::Key_F2, Qt::ShiftModifier);
    ASSERT_GT(model->desk()->jobId(), 0);
    EXPECT_FALSE(model->desk()->journal()->job(model->desk()->jobId())->isFinished);
    press(Qt::Key_F4);
    EXPECT_EQ(model->input().job.technician, "O. Bauer");
    PlugsModel tomorrow(model->desk()->journal()->path());
    EXPECT_EQ(tomorrow.input().job.technician, "O. Bauer");
    type("engine_number", u"done"_s);
    typeGear();
    type("rod_big_end", u"0"_s);
    save();
    QStringList found;
    whenModal<JournalDialog>([&](JournalDialog* dialog) {
        auto* table = dialog->findChild<QTableWidget*>(u"journal_table"_s);
        EXPECT_EQ(table->rowCount(), 2);
        auto* box = dialog->findChild<QCheckBox*>(u"journal_unfinished"_s);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Space);
        for (int i = 0; table->rowCount() == 1 && i < table->columnCount(); ++i) {
            found << table->item(0, i)->text();
        }
        table->setFocus();
        QTest::keyClick(table, Qt::Key_Return);
        if (dialog->isVisible()) {
            QTest::mouseClick(dialog->findChild<QPushButton*>(u"journal_open"_s), Qt::LeftButton);
        }
    });
    press(Qt::Key_F3);
    EXPECT_TRUE(found.contains(u"53-11"_s) && found.contains(u"unfinished"_s))
        << qPrintable(found.join(u'|'));
    // Gone on with and finished: it is the same job.
    EXPECT_EQ(model->input().job.engine_number, "53-11");
    typeGear();
    type("rod_big_end", u"1"_s);
    save();
    EXPECT_EQ(jobs().size(), 2);
    EXPECT_TRUE(model->desk()->journal()->job(model->desk()->jobId())->isFinished);
    QSettings().remove(u"workshop/technician"_s);
}

TEST_F(PlugsPageTest, JournalIsBackedUpAndRestoredByTheMenu) {
    const QString backup = QDir(folder.path()).filePath(u"backup.sqlite"_s);
    const auto before = fileChoosers();
    fileChoosers().save = [&](auto...) { return backup; };
    fileChoosers().open = [&](auto...) { return backup; };
    const auto command = [&](const QString& name) {
        const auto said = answer(u"OK"_s);
        act(name);
        return *said;
    };
    type("engine_number", u"first"_s);
    save();
    EXPECT_TRUE(command(u"back_up"_s).contains(backup));
    ASSERT_TRUE(model->desk()->journal()->remove(model->desk()->jobId()));
    press(Qt::Key_F4);
    type("engine_number", u"second"_s);
    save();
    EXPECT_EQ(command(u"restore"_s), u"Jobs restored: 1; already in the journal: 0."_s);
    EXPECT_EQ(jobs().size(), 2);
    EXPECT_EQ(command(u"restore"_s), u"Jobs restored: 0; already in the journal: 1."_s);
    test::writeFile(backup, "a letter");
    EXPECT_TRUE(command(u"restore"_s).contains(u"not a backup"_s));
    EXPECT_EQ(jobs().size(), 2);
    fileChoosers() = before;
}

TEST_F(PlugsPageTest, AJobThatAnotherProgramKeepsFromTheJournalIsSaid) {
    type("engine_number", u"53-11"_s);
    type("rod_big_end", u"1"_s);
    {
        QSqlDatabase other = QSqlDatabase::addDatabase(u"QSQLITE"_s, u"other"_s);
        other.setDatabaseName(model->desk()->journal()->path());
        ASSERT_TRUE(other.open());
        QSqlQuery query(other);
        ASSERT_TRUE(query.exec(u"BEGIN IMMEDIATE"_s));
        const auto said = answer(u"OK"_s);
        save();
        EXPECT_TRUE(said->contains(u"another program is writing"_s)) << qPrintable(*said);
        EXPECT_EQ(model->desk()->jobId(), 0);
        EXPECT_FALSE(model->desk()->isJournaled());
        ASSERT_TRUE(query.exec(u"ROLLBACK"_s));
    }
    QSqlDatabase::removeDatabase(u"other"_s);
    save();
    EXPECT_GT(model->desk()->jobId(), 0);
}

TEST_F(PlugsPageTest, UnsavedJobIsAskedAbout) {
    type("engine_number", u"7"_s);
    const auto asked = answer(u"Cancel"_s);
    press(Qt::Key_F4);
    EXPECT_EQ(*asked, u"Save the job “7” in the journal?"_s);
    EXPECT_EQ(model->input().job.engine_number, "7");
    answer(u"Save"_s);
    press(Qt::Key_F4);
    EXPECT_TRUE(model->input().job.engine_number.empty());
    EXPECT_EQ(jobs().size(), 1);
    // So does the window that is closed.
    type("engine_number", u"8"_s);
    answer(u"Cancel"_s);
    EXPECT_EQ(page.askToSave(), false);
    answer(u"Don’t save"_s);
    EXPECT_EQ(page.askToSave(), true);
    EXPECT_EQ(jobs().size(), 1);
    answer(u"Save"_s);
    EXPECT_EQ(page.askToSave(), true);
    EXPECT_EQ(jobs().size(), 2);
}

TEST_F(PlugsPageTest, EnterLeavesOutNoRejectedEntryOfAnUnsavedJob) {
    const auto enter = [](QMessageBox* box) {
        QTest::mouseClick(box->defaultButton(), Qt::LeftButton);
    };
    type("engine_number", u"7"_s);
    type("rod_big_end", u"0,5 k"_s);
    whenModal<QMessageBox>(enter);
    EXPECT_EQ(page.askToSave(), false);
    EXPECT_TRUE(jobs().isEmpty());
    type("rod_big_end", u"0,5"_s);
    whenModal<QMessageBox>(enter);
    EXPECT_EQ(page.askToSave(), true);
    EXPECT_EQ(jobs().size(), 1);
}

TEST_F(PlugsPageTest, LongJournalSaysThatTheListIsCutAndExportsAll) {
    JournalJob job;
    job.scene = u"workshop"_s;
    job.date = QDate(2024, 5, 31);
    QSqlDatabase database = QSqlDatabase::database(QSqlDatabase::connectionNames().constFirst());
    database.transaction();  // one sync for all
    for (int i = 0; i < 1005; ++i) {
        job.id = 0;
        job.engineNumber = u"many %1"_s.arg(i);
        ASSERT_EQ(model->desk()->journal()->save(job), Journal::Saved::Yes);
    }
    database.commit();
    JournalDialog dialog(model->desk()->journal());
    EXPECT_EQ(dialog.findChild<QTableWidget*>(u"journal_table"_s)->rowCount(), 1000);
    bool said = false;
    for (const QLabel* each : dialog.findChildren<QLabel*>()) {
        said = said || each->text().contains(u"1000"_s);
    }
    EXPECT_TRUE(said);
    const QString file = QDir(folder.path()).filePath(u"list.csv"_s);
    EXPECT_EQ(dialog.exportTo(file), QString());
    EXPECT_EQ(test::contentOf(file).count('\n'), 1006);  // and the headings
}

TEST_F(PlugsPageTest, TheListIsWorkedFromTheSearch) {
    for (const char* number : {"A-1", "B-2", "C-3"}) {
        type("engine_number", QString::fromLatin1(number));
        save();
        press(Qt::Key_F4);
    }
    qint64 second = 0;
    whenModal<JournalDialog>([&](JournalDialog* dialog) {
        auto* search = dialog->findChild<QLineEdit*>(u"journal_search"_s);
        EXPECT_EQ(dialog->findChild<QTableWidget*>(u"journal_table"_s)->rowCount(), 3);
        QTest::keyClick(search, Qt::Key_Down);
        QTest::keyClick(search, Qt::Key_Return);
        EXPECT_FALSE(dialog->isVisible());
        second = dialog->chosenId();
    });
    press(Qt::Key_F3);
    EXPECT_EQ(model->desk()->jobId(), second);
    EXPECT_EQ(model->input().job.engine_number, "B-2");
}

TEST_F(PlugsPageTest, JournalDialogExportsWhatItLists) {
    for (const QString& number : {u"A-1"_s, u"B-2"_s}) {
        model->newJob();
        type("engine_number", number);
        save();
    }
    JournalDialog dialog(model->desk()->journal());
    dialog.findChild<QLineEdit*>(u"journal_search"_s)->setText(u"b-"_s);
    const QString file = QDir(folder.path()).filePath(u"list.csv"_s);
    EXPECT_EQ(dialog.exportTo(file), QString());
    const QByteArray text = test::contentOf(file);
    EXPECT_TRUE(text.contains("B-2"));
    EXPECT_FALSE(text.contains("A-1"));
    EXPECT_FALSE(dialog.exportTo(QDir(folder.path()).filePath(u"no/list.csv"_s)).isEmpty());
    // Remove asks first, and Enter is no yes.
    auto* remove = dialog.findChild<QPushButton*>(u"journal_remove"_s);
    whenModal<QMessageBox>([](QMessageBox* box) {
        EXPECT_TRUE(box->text().contains(u"B-2"_s)) << qPrintable(box->text());
        EXPECT_TRUE(box->text().contains(QDate::currentDate().toString(Qt::ISODate)));
        QTest::keyClick(box, Qt::Key_Return);
    });
    QTest::mouseClick(remove, Qt::LeftButton);
    EXPECT_EQ(jobs().size(), 2);
    answer(u"Yes"_s);
    QTest::mouseClick(remove, Qt::LeftButton);
    EXPECT_EQ(jobs().size(), 1);
    dialog.findChild<QLineEdit*>(u"journal_search"_s)->clear();
    // Enter opens the one that is found.
    QTest::keyClick(dialog.findChild<QLineEdit*>(u"journal_search"_s), Qt::Key_Return);
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    EXPECT_GT(dialog.chosenId(), 0);
    EXPECT_EQ(readDay(u"2024-05-31"_s), QDate(2024, 5, 31));
    EXPECT_EQ(readDay(u" 1.2.24 "_s), QDate(2024, 2, 1));
    EXPECT_EQ(readDay(u"31.05.2024"_s), QDate(2024, 5, 31));
    EXPECT_FALSE(readDay(u"32.05.2024"_s).isValid());
    for (const char* language : {"en", "ru"}) {  // what is shown is read
        const QString shown = Words(QString::fromLatin1(language)).day(u"2024-05-31"_s);
        EXPECT_EQ(readDay(shown), QDate(2024, 5, 31)) << qPrintable(shown);
    }
}

}  // namespace
}  // namespace ravnoves

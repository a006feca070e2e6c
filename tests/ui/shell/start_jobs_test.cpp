// The journal's newest jobs on the start page.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "files.h"
#include "scene_tests.h"
#include "shell/window_test.h"
#include "shop/model/journal.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class StartJobsTest : public test::WindowTest {
  protected:
    StartJobsTest() : WindowTest(MainWindow::First::Nothing) { forget(); }
    ~StartJobsTest() override {
        window.reset();
        forget();
    }
    static QDir journalFolder() { return QFileInfo(Journal::defaultPath()).dir(); }
    static void forget() { journalFolder().removeRecursively(); }

    /// As the page Workshop keeps them.
    void keep(const QString& number, const QDate& day, bool isFinished, const QString& verdict) {
        CaseFile file = test::makePage("workshop")->model()->caseFile();
        file.input["job"]["engine_number"] = number.toStdString();
        JournalJob job;
        job.scene = u"workshop"_s;
        job.engineNumber = number;
        job.customer = u"A & B"_s;
        job.engine = u"V-8, 90°"_s;
        job.date = day;
        job.isFinished = isFinished;
        job.verdict = verdict;
        job.form = QByteArray::fromStdString(write_case(file).dump());
        Journal journal;
        ASSERT_TRUE(journal.open()) << journal.lastError().toStdString();
        ASSERT_EQ(journal.save(job), Journal::Saved::Yes);
    }
    void keepSeven() {
        for (int day = 1; day <= 7; ++day) {
            keep(u"N"_s + QString::number(day), QDate(2026, 11, day), day != 6,
                 day == 7 ? u"passes"_s : u"fails"_s);
        }
    }
    void showStart() {
        window->showStart();
        QTest::qWait(50);
    }
    QList<QAbstractButton*> jobs() const {
        return window->findChildren<QAbstractButton*>(u"start-job"_s);
    }
    /// The journal is read beside the window.
    QAbstractButton* job(qsizetype row) const {
        EXPECT_TRUE(test::comes([&] { return jobs().size() > row; })) << row;
        return jobs().at(row);
    }
    QAbstractButton* journalButton() const {
        return test::named<QAbstractButton>(*window, "start-journal");
    }
    QString numberOnSheet() const {
        return test::named<QLineEdit>(*window->currentPage(), "engine_number")->text();
    }
};

TEST_F(StartJobsTest, WithoutAJournalThereIsNothing) {
    showStart();
    EXPECT_TRUE(jobs().isEmpty());
    EXPECT_FALSE(journalButton()->isVisible());
    EXPECT_FALSE(QFileInfo::exists(Journal::defaultPath())) << "to look makes none";
}

TEST_F(StartJobsTest, WhatCannotBeOpenedIsPassedOverAndStaysAsItIs) {
    ASSERT_TRUE(journalFolder().mkpath(u"."_s));
    test::writeFile(Journal::defaultPath(), QByteArray(5000, 'x'));
    showStart();
    EXPECT_TRUE(jobs().isEmpty());
    EXPECT_FALSE(journalButton()->isVisible());
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_EQ(journalFolder().entryList(QDir::Files), QStringList{u"journal.sqlite"_s});
    EXPECT_EQ(test::contentOf(Journal::defaultPath()), QByteArray(5000, 'x'));
}

TEST_F(StartJobsTest, TheNewestFiveAreListedWithWhatTheyAre) {
    keepSeven();
    showStart();
    ASSERT_TRUE(test::comes([&] { return jobs().size() == 5; }));
    EXPECT_TRUE(journalButton()->isVisible());
    const QString newest = jobs().constFirst()->toolTip();
    for (const QString& part : {u"N7"_s, u"A & B"_s, u"V-8, 90°"_s, u"PASS"_s, u"2026"_s}) {
        EXPECT_TRUE(newest.contains(part)) << newest.toStdString();
    }
    EXPECT_FALSE(newest.contains(u"unfinished"_s));
    const QString open = job(1)->toolTip();
    EXPECT_TRUE(open.contains(u"N6"_s) && open.contains(u"FAIL"_s) &&
                open.contains(u"unfinished"_s))
        << open.toStdString();
    EXPECT_TRUE(jobs().constLast()->toolTip().contains(u"N3"_s));
    // Jobs that come later are there when the page is shown again.
    window->showScene(u"balance-shaft"_s);
    keep(u"N8"_s, QDate(2026, 11, 8), true, {});
    showStart();
    ASSERT_TRUE(test::comes([&] { return jobs().size() == 5; }));
    EXPECT_TRUE(test::comes([&] { return jobs().constFirst()->toolTip().contains(u"N8"_s); }));
}

TEST_F(StartJobsTest, AClickBringsTheJobOntoTheSheet) {
    keepSeven();
    showStart();
    job(2)->click();
    EXPECT_FALSE(window->isAtStart());
    EXPECT_EQ(window->currentScene(), u"workshop"_s);
    EXPECT_EQ(numberOnSheet(), u"N5"_s);
    EXPECT_FALSE(document().needsSaving());

    // The one on the sheet is shown with what was changed in it.
    test::type(test::named<QLineEdit>(*window->currentPage(), "customer"), u"Ivanov"_s);
    showStart();
    job(2)->click();
    EXPECT_EQ(test::named<QLineEdit>(*window->currentPage(), "customer")->text(), u"Ivanov"_s);
    // Before another takes its place it is asked for.
    showStart();
    answer("Don’t save");
    job(0)->click();
    EXPECT_TRUE(asked.value(0).contains(u"N5"_s));
    EXPECT_EQ(numberOnSheet(), u"N7"_s);
}

}  // namespace
}  // namespace ravnoves

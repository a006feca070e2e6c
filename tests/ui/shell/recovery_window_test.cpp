// Nothing is lost: by a crash, by another program, by quitting. Through the window.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>

#include "case-file/json.h"
#include "files.h"
#include "model/recovery.h"
#include "shell/window_test.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class NothingIsLost : public test::WindowTest {
  protected:
    NothingIsLost() {
        QDir(Recovery::defaultFolder()).removeRecursively();
        for (const char* name : {"tmz-650d", "vr5-volkswagen"}) {
            QFile::copy(u":/examples/%1.case.json"_s.arg(QLatin1String(name)), file(name));
            QFile(file(name)).setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        }
        window->beginSession();
    }

    QString file(const char* name) const {
        return folder.filePath(QLatin1String(name) + u".case.json"_s);
    }
    void start() {
        WindowTest::start();
        window->beginSession();
    }
    /// As kill -9 does: what was kept stays as it is.
    void crash() {
        QTest::qWait(900);
        QApplication::processEvents();  // what was due while the machine was busy
        window.reset();
    }
    QMessageBox* offered() {
        window->offerRecovered();
        QApplication::processEvents();
        return window->findChild<QMessageBox*>(u"recovery"_s);
    }
    /// Presses a button of what is offered, by its text.
    void choose(const QString& text) {
        auto* box = window->findChild<QMessageBox*>(u"recovery"_s);
        ASSERT_NE(box, nullptr);
        for (QAbstractButton* button : box->buttons()) {
            if (button->text().remove(u'&') == text) {
                QTest::mouseClick(button, Qt::LeftButton);
            }
        }
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QApplication::processEvents();
    }
    static void click(const QWidget& parent, const char* name) {
        QTest::mouseClick(test::named<QPushButton>(parent, name), Qt::LeftButton);
        QApplication::processEvents();
    }
    /// What is offered when the window begins again after a crash.
    QString afterACrash() {
        crash();
        start();
        const QMessageBox* box = offered();
        EXPECT_NE(box, nullptr);
        return box != nullptr ? box->text() : QString();
    }
    void openAndChange() {
        ASSERT_EQ(window->openCase(file("tmz-650d")), QString());
        set(u"shaft_angle_deg=77"_s);
    }
    QWidget* notice() { return window->findChild<QWidget*>(u"disk_notice"_s); }
    void writeByOthers(const char* name, const QByteArray& from, const QByteArray& to) {
        QFile f(file(name));
        ASSERT_TRUE(f.open(QIODevice::ReadWrite));
        const QByteArray text = f.readAll();
        ASSERT_TRUE(text.contains(from)) << text.toStdString();
        f.seek(0);
        f.resize(0);
        f.write(QByteArray(text).replace(from, to));
    }
};

TEST_F(NothingIsLost, ACrashLeavesEveryUnsavedCase) {
    openAndChange();
    ASSERT_EQ(window->openCase(file("vr5-volkswagen")), QString());
    QTest::keyClick(window.get(), Qt::Key_2, Qt::ControlModifier);
    set(u"lambda=0.31"_s);
    const QStringList before = tabs();
    crash();
    start();
    EXPECT_EQ(tabs().size(), 1);
    window->showStart();
    const QMessageBox* box = offered();
    ASSERT_NE(box, nullptr);
    EXPECT_EQ(box->text().count(u'•'), 2) << "what was not changed is no loss";
    EXPECT_TRUE(box->text().contains(file("tmz-650d")));
    EXPECT_TRUE(box->text().contains(u"no file yet"_s));
    choose(u"Restore"_s);
    EXPECT_FALSE(window->isAtStart()) << "what is restored stands before it";
    EXPECT_EQ(tabs(), (QStringList{before[0], before[2]}));
    EXPECT_TRUE(window->showScene(u"elastic-hinge"_s));
    EXPECT_EQ(model().inputJson().at("lambda"), 0.31);
    EXPECT_TRUE(window->isWindowModified());
    EXPECT_TRUE(window->showScene(u"balance-shaft"_s));
    EXPECT_EQ(model().inputJson().at("shaft_angle_deg"), 77);
    EXPECT_TRUE(window->windowTitle().contains(u"tmz-650d.case.json"_s));
    EXPECT_TRUE(window->isWindowModified());
    // Crashed again at once, nothing is lost either.
    window.reset();
    start();
    EXPECT_NE(offered(), nullptr);
}

TEST_F(NothingIsLost, ACopyWhoseTableIsMissingStays) {
    const QString table = folder.filePath(u"torque.csv"_s);
    Json json = Json::parse(test::contentOf(file("tmz-650d")).toStdString());
    test::writeFile(table, "0;1\n360;3\n720;1\n");
    json["input"]["torque"] = {{"csv", "torque.csv"}};
    test::writeFile(file("tmz-650d"), QByteArray::fromStdString(json.dump()));
    openAndChange();
    crash();
    ASSERT_TRUE(QFile::remove(table));
    start();
    ASSERT_NE(offered(), nullptr);
    answer("Cancel");
    choose(u"Restore"_s);
    EXPECT_TRUE(asked.value(0).contains(u"torque.csv"_s));
    EXPECT_EQ(QDir(Recovery::defaultFolder()).entryList({u"*.json"_s}).size(), 1)
        << "the copy stays";
}

TEST_F(NothingIsLost, WhatIsThrownAwayIsGoneAndLaterIsLater) {
    openAndChange();
    afterACrash();
    choose(u"Later"_s);
    window->close();
    window.reset();
    start();
    ASSERT_NE(offered(), nullptr) << "it was to be later";
    test::whenModal<QMessageBox>(window.get(), [&](QMessageBox* box) {
        EXPECT_TRUE(box->text().endsWith(u": 1."_s)) << box->text().toStdString();
        QTest::keyClick(box, Qt::Key_Return);
    });
    choose(u"Discard"_s);
    ASSERT_NE(window->findChild<QMessageBox*>(u"recovery"_s), nullptr) << "Enter is no yes";
    answer("Yes");
    choose(u"Discard"_s);
    window.reset();
    start();
    EXPECT_EQ(offered(), nullptr);
}

TEST_F(NothingIsLost, ACleanEndLeavesNothing) {
    openAndChange();
    QTest::qWait(900);
    answer("Don’t save");
    EXPECT_TRUE(window->close());
    window.reset();
    start();
    EXPECT_EQ(offered(), nullptr);
}

TEST_F(NothingIsLost, TheJobOfTheWorkshopComesBackOnce) {
    QTest::keyClick(window.get(), Qt::Key_3, Qt::ControlModifier);
    QTest::qWait(100);
    set(u"job/engine_number=A-77"_s);
    set(u"job/customer=Smith"_s);
    const QString said = afterACrash();
    static const QRegularExpression timeAlone(
        u"A-77, Smith \\(\\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d\\)"_s);
    EXPECT_TRUE(said.contains(timeAlone)) << said.toStdString();
    choose(u"Restore"_s);
    EXPECT_EQ(window->currentScene(), u"workshop"_s);
    EXPECT_EQ(model().inputJson().at("job").at("engine_number"), "A-77");
    EXPECT_TRUE(window->isWindowModified());
    QTest::qWait(100);
    const auto* banner = test::named<QLabel>(*window->currentPage(), "banner");
    EXPECT_FALSE(banner->isVisible()) << banner->text().toStdString();
}

TEST_F(NothingIsLost, ADamagedCopyIsSaid) {
    openAndChange();
    crash();
    const QDir kept(Recovery::defaultFolder());
    for (const QString& name : kept.entryList({u"*.json"_s})) {
        QFile::resize(kept.filePath(name), 100);
    }
    start();
    const QMessageBox* box = offered();
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->text().contains(u"damaged"_s));
    choose(u"Close"_s);
}

// ------------------------------------------------------------------------------- other programs

TEST_F(NothingIsLost, AFileThatOthersChangeIsSaidAndReloaded) {
    ASSERT_EQ(window->openCase(file("tmz-650d")), QString());
    const Json before = model().inputJson();
    EXPECT_FALSE(notice()->isVisible());
    writeByOthers("tmz-650d", "100.15", "100.25");
    lookAgain();
    EXPECT_TRUE(notice()->isVisible());
    EXPECT_EQ(model().inputJson(), before);
    click(*notice(), "disk_reload");
    EXPECT_FALSE(notice()->isVisible());
    EXPECT_EQ(model().inputJson().at("centre_distance_mm"), 100.25);
    QWidget* focus = QApplication::focusWidget();
    EXPECT_TRUE(window->currentPage() == focus || window->currentPage()->isAncestorOf(focus));
    EXPECT_FALSE(window->isWindowModified());
    QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(model().inputJson(), before);
    EXPECT_TRUE(window->isWindowModified());
}

TEST_F(NothingIsLost, TheNoticeIsOfTheTabInFront) {
    ASSERT_EQ(window->openCase(file("tmz-650d")), QString());
    ASSERT_EQ(window->openCase(file("vr5-volkswagen")), QString());
    writeByOthers("tmz-650d", "100.15", "100.25");
    lookAgain();
    EXPECT_FALSE(notice()->isVisible());
    QTest::keyClick(window.get(), Qt::Key_1, Qt::ControlModifier);
    EXPECT_TRUE(notice()->isVisible());
    click(*notice(), "disk_keep");
    EXPECT_FALSE(notice()->isVisible());
    EXPECT_TRUE(window->isWindowModified());
}

TEST_F(NothingIsLost, SavingOverWhatOthersWroteAsks) {
    openAndChange();
    writeByOthers("tmz-650d", "100.15", "100.25");
    const auto written = [this] { return CaseDocument::read(file("tmz-650d")).input; };
    answer("Cancel");
    QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
    EXPECT_TRUE(asked.value(0).contains(file("tmz-650d")));
    EXPECT_EQ(written().at("centre_distance_mm"), 100.25);
    answer("Overwrite");
    test::pressIn(*window, Qt::Key_S);
    EXPECT_EQ(written().at("centre_distance_mm"), 100.15);
    EXPECT_EQ(written().at("shaft_angle_deg"), 77);
}

}  // namespace
}  // namespace ravnoves

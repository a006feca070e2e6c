#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QMessageBox>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include "events.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/v8_plugs_page.h"
#include "widgets/number_field.h"

namespace ravnoves {

/// The page over a journal of its own, used as a person does. Not in an anonymous namespace: the
/// tests of all files here are of this one class.
class V8PageTest : public ::testing::Test {
  protected:
    V8PageTest() : page(QDir(folder.path()).filePath(QStringLiteral("journal.sqlite")), nullptr) {
        test::showAt(page, {1187, 712});
        page.activateWindow();
        model = page.viewModel();
        page.openJournal();
    }

    template <typename Widget>
    Widget* find(const char* name) {
        return test::named<Widget>(page, name);
    }
    NumberField* field(const char* name) { return find<NumberField>(name); }
    QString label(const char* name) {
        settle();
        return find<QLabel>(name)->text();
    }
    /// A placing that is looked for is found.
    void settle() {
        EXPECT_TRUE(QTest::qWaitFor([this] { return !model->isSearching(); }));
    }

    /// Types as a person does: goes to the field, types over what is there, presses Enter.
    void type(QWidget* target, const QString& text) {
        for (int sheet = 0; sheet < page.sheets()->count(); ++sheet) {
            if (page.fieldsOf(sheet).contains(target)) {
                page.sheets()->setCurrentIndex(sheet);
            }
        }
        target->setFocus();
        QTest::keyClick(target, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(target, text);
        QTest::keyClick(target, Qt::Key_Return);
    }
    void type(const char* name, const QString& text) { type(find<QWidget>(name), text); }

    /// A key that is an action's, wherever the focus is; what it saves is saved then.
    void press(Qt::Key key) {
        page.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
        QTest::keyClick(&page, key);
        ASSERT_TRUE(QTest::qWaitFor([this] { return !model->desk()->isWaiting(); }, 20'000));
    }

    /// Answers the next message box with a button.
    static void answer(QMessageBox::StandardButton button) {
        whenModal<QMessageBox>(
            [button](QMessageBox* box) { QTest::mouseClick(box->button(button), Qt::LeftButton); });
    }

    template <typename Dialog, typename Act>
    static void whenModal(Act act) {
        test::whenModal<Dialog>(qApp, act);
    }

    QTemporaryDir folder;
    V8PlugsPage page;
    V8PlugsModel* model = nullptr;
};

}  // namespace ravnoves

#pragma once

#include <gtest/gtest.h>

#include <QDir>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include "events.h"

namespace ravnoves::test {

/// A page of the workshop over a journal of its own, used as a person does.
template <typename Page>
class WorkshopPageTest : public ::testing::Test {
  protected:
    WorkshopPageTest() {
        showAt(page, {1187, 712});
        page.activateWindow();
        page.openJournal();
    }

    template <typename Widget>
    Widget* find(const char* name) {
        return named<Widget>(page, name);
    }

    /// Goes to the sheet's tab and the field, types over what is there, presses Enter.
    void type(QWidget* field, const QString& text) {
        for (int sheet = 0; sheet < page.sheets()->count(); ++sheet) {
            if (page.sheets()->widget(sheet)->isAncestorOf(field)) {
                page.sheets()->setCurrentIndex(sheet);
            }
        }
        field->setFocus(Qt::TabFocusReason);
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(field, Qt::Key_Delete);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void type(const char* name, const QString& text) { type(find<QWidget>(name), text); }

    /// A key that is an action's, wherever the focus is; what it saves is saved then.
    void press(Qt::Key key) {
        page.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
        pressNow(key);
    }
    /// The same, before a question has taken the focus.
    void pressNow(Qt::Key key) { QTest::keyClick(&page, key); }

    QTemporaryDir folder;
    Page page{QDir(folder.path()).filePath(QStringLiteral("journal.sqlite")), nullptr};
    decltype(page.viewModel()) model = page.viewModel();
};

}  // namespace ravnoves::test

#pragma once

#include <gtest/gtest.h>

#include <QTabBar>
#include <QTemporaryDir>
#include <memory>

#include "events.h"
#include "page/scene_page.h"
#include "pictures/file_dialogs.h"
#include "shell/documents.h"
#include "shell/main_window.h"
#include "shell/screenshot.h"

namespace ravnoves::test {

/// The window of the program, and what a user does with it.
class WindowTest : public ::testing::Test {
  protected:
    explicit WindowTest(MainWindow::First first = MainWindow::First::Scene) {
        fileChoosers().save = [this](QWidget*, const QString&, const QString&, const QString&,
                                     QString*) {
            ++filesAsked;
            return typed.isEmpty() ? QString() : typed.takeFirst();
        };
        fileChoosers().open = [this](QWidget*, const QString& title, const QString& in,
                                     const QString&) {
            asked << title;
            folders << in;
            return typed.isEmpty() ? QString() : typed.takeFirst();
        };
        start(first);
    }
    ~WindowTest() override {
        window.reset();
        fileChoosers() = choosers_;
    }

    /// Another window in place of the one there is, as if it had been killed.
    void start(MainWindow::First first = MainWindow::First::Scene) {
        window.reset();
        window = std::make_unique<MainWindow>(first);
        showAt(*window, {1280, 800});
        window->activateWindow();
    }
    QString file(const char* name) const { return folder.filePath(QString::fromUtf8(name)); }
    SceneModel& model() { return *window->currentPage()->model(); }
    CaseDocument& document() { return *window->documents().current().document; }
    QStringList tabs() {
        QStringList texts;
        auto* bar = window->findChild<QTabBar*>(QStringLiteral("documents"));
        for (int i = 0; i < bar->count(); ++i) {
            texts << bar->tabText(i);
        }
        return texts;
    }
    QAction* action(const QString& begins) { return actionNamed(*window, begins); }
    void set(const QString& pair) { ASSERT_EQ(applySetting(*window, pair), QString()); }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::ControlModifier) {
        pressIn(*window, key, modifiers);
        QApplication::processEvents();
    }
    /// Clicks a button of the next message box, by its words.
    void answer(const char* button) {
        answerWith(window.get(), QString::fromUtf8(button),
                   [this](const QString& text) { asked << text; });
    }
    /// The window comes to the front, and looks at its files.
    void lookAgain() {
        QEvent activated(QEvent::WindowActivate);
        QApplication::sendEvent(&window->documents(), &activated);
    }

  private:
    FileChoosers choosers_ = fileChoosers();

  protected:
    QTemporaryDir folder;
    QStringList typed;  ///< what the file dialogs answer, in order
    int filesAsked = 0;
    QStringList folders;  ///< in which they began
    QStringList asked;    ///< by dialogs and messages
    std::unique_ptr<MainWindow> window;
};

}  // namespace ravnoves::test

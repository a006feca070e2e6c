// Every dialog that a menu opens, with normal and large text, in both languages: it fits on the
// screen, and nothing in it is cut or overlapping.

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QMenu>
#include <QMenuBar>
#include <QTimer>

#include "events.h"
#include "looks/checker.h"
#include "page/scene_page.h"
#include "pictures/file_dialogs.h"
#include "scene_tests.h"
#include "shell/main_window.h"
#include "text/language.h"
#include "theme/theme.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using test::Checker;

struct Screen {
    const char* name;
    QSize size;
    double text;
};

class Dialogs : public ::testing::TestWithParam<std::tuple<std::string, Screen, const char*>> {
  protected:
    Dialogs() {
        fileChoosers().save = [](auto&&...) { return QString(); };
        fileChoosers().open = [](auto&&...) { return QString(); };
    }
    ~Dialogs() override {
        fileChoosers() = choosers_;
        installLanguage(u"en"_s);
        Theme::instance().setTextScale(1.0);
    }

    /// Looks at what is open beside the window, and closes it.
    void lookAtDialogs(const QSize& screen) {
        for (QWidget* each : QApplication::topLevelWidgets()) {
            auto* dialog = qobject_cast<QDialog*>(each);
            if (dialog == nullptr || !dialog->isVisible()) {
                continue;
            }
            ++seen_;
            const QSize minimum = dialog->minimumSizeHint().expandedTo(dialog->minimumSize());
            const std::string name =
                (QString(dialog->windowTitle()) + u" ("_s +
                 QString::fromLatin1(dialog->metaObject()->className()).section(u"::"_s, -1) + u')')
                    .toStdString();
            EXPECT_LE(minimum.width(), screen.width()) << name;
            EXPECT_LE(minimum.height(), screen.height()) << name;
            dialog->resize(dialog->size().boundedTo(screen));
            QApplication::processEvents();
            QApplication::processEvents();
            for (const QString& fault : Checker(dialog).faults()) {
                ADD_FAILURE() << name << ": " << fault.toStdString();
            }
            dialog->reject();
        }
    }

    int seen_ = 0;

  private:
    FileChoosers choosers_ = fileChoosers();
};

TEST_P(Dialogs, FitOnTheScreenAndCutNothing) {
    const auto& [scene, screen, language] = GetParam();
    installLanguage(QString::fromLatin1(language));
    Theme::instance().setTextScale(screen.text);
    MainWindow window;
    window.showScene(QString::fromStdString(scene));
    test::showAt(window, screen.size);
    window.currentPage()->model()->keepVariant();  // inputs are compared with it
    QApplication::processEvents();
    QList<QAction*> actions = window.findChildren<QAction*>();
    actions.removeIf([](const QAction* action) {
        return !action->text().contains(u'…') || !action->isEnabled();
    });
    actions << window.menuBar()->actions().constLast()->menu()->actions();
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &window, [&] { lookAtDialogs(screen.size); });
    constexpr int rest = 30;  // ms
    look.start(rest);
    for (QAction* action : actions) {
        action->trigger();
        QTest::qWait(2 * rest);
    }
    EXPECT_GE(seen_, 10);
}

const Screen screens[] = {{"at1024x700", {1024, 700}, 1.0}, {"LargeText", {1920, 1080}, 2.0}};

INSTANTIATE_TEST_SUITE_P(Pages, Dialogs,
                         ::testing::Combine(::testing::Values("workshop"),
                                            ::testing::ValuesIn(screens),
                                            ::testing::Values("en", "ru")),
                         [](const auto& each) {
                             return test::testName(std::get<0>(each.param) + "_" +
                                                   std::get<1>(each.param).name + "_" +
                                                   std::get<2>(each.param));
                         });

}  // namespace
}  // namespace ravnoves

// Every page, with each of its tabs in front, and every dialog that a menu opens, at the sizes of
// small and large windows, with normal and large text, in both languages: nothing is cut, hidden
// without a tip, overlapping or out of reach.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <functional>
#include <optional>

#include "events.h"
#include "looks/checker.h"
#include "page/scene_page.h"
#include "pictures/file_dialogs.h"
#include "scene_tests.h"
#include "shell/main_window.h"
#include "shell/scene_list.h"
#include "text/language.h"
#include "theme/theme.h"
#include "widgets/page_columns.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using test::Checker;
using test::placeOf;

/// A window as people have it.
struct Look {
    const char* name;
    QSize size;
    double text;
};

const Look small{"at1024x700", {1024, 700}, 1.0};
const Look unfolded{"at1920x1080", {1920, 1080}, 1.0};
const Look large{"LargeText", {1920, 1080}, 2.0};
const Look folded{"LargeTextOnALaptop", {1360, 850}, 2.0};
const Look looks[] = {
    small,  {"at1280x800", {1280, 800}, 1.0},  unfolded,
    large,  {"ScaleFactor2", {960, 540}, 1.0},  // of a screen of 1920×1080
    folded,
};

class Looks : public ::testing::TestWithParam<std::tuple<std::string, Look, const char*>> {
  protected:
    ~Looks() override {
        window_.reset();
        installLanguage(u"en"_s);
        Theme::instance().setTextScale(1.0);
    }

    /// A window with the page, in its look and language.
    MainWindow& open() {
        const auto& [scene, look, language] = GetParam();
        installLanguage(QString::fromLatin1(language));
        Theme::instance().setTextScale(look.text);
        window_.emplace();
        window_->showScene(QString::fromStdString(scene));
        test::showAt(*window_, look.size);
        return *window_;
    }

    static void onEveryTab(QWidget* page, const std::function<void(const QString&)>& look) {
        look(u"first"_s);
        for (QTabWidget* tabs : page->findChildren<QTabWidget*>()) {
            showTabOf(tabs);
            for (int i = 0; i < tabs->count(); ++i) {
                tabs->setCurrentIndex(i);
                for (int turn = 0; turn < 3; ++turn) {
                    QApplication::processEvents();
                }
                look(QString(tabs->tabText(i)).remove(u'&'));
            }
            tabs->setCurrentIndex(0);
        }
    }

  private:
    std::optional<MainWindow> window_;
};

TEST_P(Looks, NothingIsCutOrOutOfReach) {
    MainWindow& window = open();
    EXPECT_EQ(window.size(), std::get<Look>(GetParam()).size);
    // What is open is in sight of the navigation.
    for (const QToolButton* button :
         window.findChild<QScrollArea*>(u"navigation"_s)->findChildren<QToolButton*>()) {
        EXPECT_TRUE(!button->isChecked() ||
                    button->visibleRegion().boundingRect().size() == button->size());
    }
    ScenePage* page = window.currentPage();
    QStringList said;
    onEveryTab(page, [&](const QString& tab) {
        QStringList faults = Checker(page).faults();
        for (int turn = 0; turn < 20 && !faults.isEmpty(); ++turn) {
            constexpr int rest = 200;  // ms: what waits until the hand rests is laid out then
            QTest::qWait(rest);
            faults = Checker(page).faults();
        }
        for (const QString& fault : faults) {
            if (!said.contains(fault)) {
                said << fault;
                ADD_FAILURE() << tab.toStdString() << " › " << fault.toStdString();
            }
        }
    });
}

QChar letterOf(const QString& text) {
    const qsizetype at = QString(text).replace(u"&&"_s, u"  "_s).indexOf(u'&');
    return at >= 0 && at + 1 < text.size() ? text.at(at + 1).toLower() : QChar();
}

/// Letters depend on what is folded, not on the size.
class Letters : public Looks {};

TEST_P(Letters, NoneOfThePageIsAMenus) {
    MainWindow& window = open();
    QString menus;
    for (const QAction* menu : window.menuBar()->actions()) {
        menus += letterOf(menu->text());
    }
    EXPECT_GE(menus.size(), 4);
    QWidget* page = window.currentPage();
    onEveryTab(page, [&](const QString&) {
        for (const QWidget* each : page->findChildren<QWidget*>()) {
            QStringList texts;
            if (const auto* label = qobject_cast<const QLabel*>(each)) {
                texts << (label->buddy() != nullptr ? label->text() : QString());
            } else if (const auto* button = qobject_cast<const QAbstractButton*>(each)) {
                texts << button->text();
            } else if (const auto* bar = qobject_cast<const QTabBar*>(each)) {
                for (int i = 0; i < bar->count(); ++i) {
                    texts << bar->tabText(i);
                }
            }
            for (const QString& text : texts) {
                const QChar letter = letterOf(text);
                EXPECT_FALSE(each->isVisible() && !letter.isNull() && menus.contains(letter))
                    << text.toStdString();
            }
        }
    });
}

class Dialogs : public Looks {
  protected:
    Dialogs() {
        fileChoosers().save = [](auto&&...) { return QString(); };
        fileChoosers().open = [](auto&&...) { return QString(); };
    }
    ~Dialogs() override { fileChoosers() = choosers_; }

    /// Looks at what is open beside the window, and closes it.
    void lookAtDialogs(const QSize& screen) {
        for (QWidget* each : QApplication::topLevelWidgets()) {
            auto* dialog = qobject_cast<QDialog*>(each);
            if (dialog == nullptr || !dialog->isVisible()) {
                continue;
            }
            ++seen_;
            const QSize minimum = dialog->minimumSizeHint().expandedTo(dialog->minimumSize());
            const std::string name = (dialog->windowTitle() + u' ' + placeOf(dialog)).toStdString();
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
    MainWindow& window = open();
    const QSize screen = window.size();
    window.currentPage()->model()->keepVariant();  // inputs are compared with it
    QApplication::processEvents();
    QList<QAction*> actions = window.findChildren<QAction*>();
    actions.removeIf([](const QAction* action) {
        return !action->text().contains(u'…') || !action->isEnabled();
    });
    actions << window.menuBar()->actions().constLast()->menu()->actions();
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &window, [&] { lookAtDialogs(screen); });
    constexpr int rest = 30;  // ms
    look.start(rest);
    for (QAction* action : actions) {
        action->trigger();
        QTest::qWait(2 * rest);
    }
    EXPECT_GE(seen_, 10);
}

std::string nameOf(const ::testing::TestParamInfo<Looks::ParamType>& each) {
    return test::testName(std::get<0>(each.param) + "_" + std::get<1>(each.param).name + "_" +
                          std::get<2>(each.param));
}

INSTANTIATE_TEST_SUITE_P(Pages, Looks,
                         ::testing::Combine(::testing::ValuesIn(test::sceneNames()),
                                            ::testing::ValuesIn(looks),
                                            ::testing::Values("en", "ru")),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Pages, Letters,
                         ::testing::Combine(::testing::ValuesIn(test::sceneNames()),
                                            ::testing::Values(unfolded, folded),
                                            ::testing::Values("en", "ru")),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Pages, Dialogs,
                         ::testing::Combine(::testing::Values("workshop"),
                                            ::testing::Values(small, large),
                                            ::testing::Values("en", "ru")),
                         nameOf);

}  // namespace
}  // namespace ravnoves

// Every page, with each of its tabs in front, in both themes and both languages, looks as it did.

#include "golden/golden.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "case-file/case_file.h"
#include "events.h"
#include "methods/methods_page.h"
#include "methods/report.h"
#include "model/case_document.h"
#include "scene_tests.h"
#include "shell/documents.h"
#include "shell/main_window.h"
#include "shop/model/journal.h"
#include "text/language.h"
#include "theme/theme.h"
#include "widgets/page_columns.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using test::Golden;

/// Neither the machine's fonts nor what it is told of drawing them: the bundled font alone.
const bool hasBundledFont = qputenv("FONTCONFIG_FILE", RAVNOVES_FONTS);

constexpr QSize windowSize(1280, 800);
constexpr int rest = 250;  // ms: what waits until the hand rests is there then
const char* const start = "start";
const char* const withoutPlugs = "workshop-shaft";  ///< the workshop's other form

/// The case of the examples that fills a page best; the others begin full.
const std::map<std::string, const char*> filledBy{
    {"workshop", "workshop-v8-4.25.case.json"},
    {withoutPlugs, "bob-weights-v8.case.json"},
};

class PageGolden : public ::testing::TestWithParam<std::tuple<std::string, const char*>> {
  protected:
    PageGolden() { Journal::setKept(false); }  // neither today's date nor anybody's jobs
    ~PageGolden() override {
        Theme::instance().setMode(Theme::Mode::Light);
        installLanguage(u"en"_s);
        Journal::setKept(true);
    }

    void open(const std::string& scene) {
        if (scene == start) {
            window->showStart();
        } else if (const auto example = filledBy.find(scene); example != filledBy.end()) {
            const QString path =
                QDir(QString::fromUtf8(RAVNOVES_EXAMPLES)).filePath(QLatin1String(example->second));
            ASSERT_EQ(window->documents().begin(CaseDocument::read(path)), QString());
        } else {
            ASSERT_TRUE(window->showScene(QString::fromStdString(scene)));
        }
        test::showAt(*window, windowSize);
        ASSERT_EQ(window->size(), windowSize);
        settle();
        holdTimesStill();
    }
    void settle() {
        ScenePage* page = window->isAtStart() ? nullptr : window->currentPage();
        const auto busy = [page] { return page != nullptr && page->isBusy(); };
        for (int turn = 0; turn < 3; ++turn) {
            QApplication::processEvents();
        }
        ASSERT_TRUE(test::comes([&] { return !busy(); }));
        if (QWidget* focus = QApplication::focusWidget()) {
            focus->clearFocus();  // no cursor that blinks
        }
        QApplication::processEvents();
    }
    /// No machine measures twice the same: their numbers stand in for the times.
    void holdTimesStill() {
        auto* page = qobject_cast<MethodsPage*>(window->currentPage());
        if (page == nullptr || window->isAtStart()) {
            return;
        }
        const auto measured = [page] {
            return page->viewModel()->shown() != nullptr && !page->viewModel()->isStale();
        };
        auto* tabs = page->findChild<QTabWidget*>({}, Qt::FindDirectChildrenOnly);
        tabs->setCurrentIndex(1);  // where it measures
        ASSERT_TRUE(test::comes(measured));
        settle();
        auto still = std::make_shared<MethodMeasurement>(*page->viewModel()->shown());
        for (methods::MethodRow& point : still->report.rows) {
            const double time = 20.0 * static_cast<double>(point.method + 1) *
                                std::exp2(2.0 * static_cast<double>(point.setting));
            point.timing = {time, 0.9 * time, 1.2 * time, 9};
        }
        page->viewModel()->show(still);
        tabs->setCurrentIndex(0);
        settle();
    }
    QImage picture() const { return window->grab().toImage(); }

    /// Calls `look` with every state of the page's tabs, each once, and the name of the tab.
    void onEveryTab(const std::function<void(const QString&)>& look) {
        std::set<std::vector<std::pair<const QTabWidget*, int>>> seen;
        const QWidget* page = window->isAtStart() ? nullptr : window->currentPage();
        const QList<QTabWidget*> all =
            page != nullptr ? page->findChildren<QTabWidget*>() : QList<QTabWidget*>();
        const auto lookOnce = [&](const QString& name) {
            settle();
            std::vector<std::pair<const QTabWidget*, int>> state;
            for (const QTabWidget* tabs : all) {
                if (tabs->isVisible()) {
                    state.emplace_back(tabs, tabs->currentIndex());
                }
            }
            if (seen.insert(state).second) {
                look(name);
            }
        };
        lookOnce(u"first"_s);
        for (QTabWidget* tabs : all) {
            std::vector<std::pair<QTabWidget*, int>> before;
            for (QTabWidget* each : all) {
                before.emplace_back(each, each->currentIndex());
            }
            showTabOf(tabs);
            for (int i = 0; i < tabs->count(); ++i) {
                tabs->setCurrentIndex(i);  // shows its group
                if (tabs->isTabVisible(i) && tabs->isTabEnabled(i)) {
                    const QString name = tabs->widget(i)->objectName();
                    lookOnce(name.isEmpty() ? u"tab-%1-%2"_s.arg(all.indexOf(tabs)).arg(i) : name);
                }
            }
            for (const auto& [each, index] : before) {
                each->setCurrentIndex(index);
            }
        }
    }

    std::unique_ptr<MainWindow> window;
};

TEST_P(PageGolden, LooksAsItDid) {
    const auto& [scene, language] = GetParam();
    const bool renews = qEnvironmentVariableIsSet("RAVNOVES_UPDATE_GOLDEN");
    Golden golden(QDir(QString::fromUtf8(RAVNOVES_GOLDEN)),
                  QDir(QString::fromUtf8(RAVNOVES_GOLDEN_FOUND)));
    installLanguage(QString::fromLatin1(language));
    window = std::make_unique<MainWindow>();
    ASSERT_NO_FATAL_FAILURE(open(scene));
    const QString prefix = QString::fromStdString(scene) + u'_';
    QStringList names;
    for (const auto mode : {Theme::Mode::Light, Theme::Mode::Dark}) {
        Theme::instance().setMode(mode);
        const QString suffix = u"_%1_%2"_s.arg(mode == Theme::Mode::Light ? u"light"_s : u"dark"_s,
                                               QString::fromLatin1(language));
        onEveryTab([&](const QString& tab) {
            const QString name = prefix + tab + suffix;
            ASSERT_FALSE(names.contains(name)) << name.toStdString();
            names << name;
            const bool isFirst = names.size() == 1 || !names.at(names.size() - 2).endsWith(suffix);
            if (isFirst) {
                golden.goBy({});
            }
            const auto goByFirst = qScopeGuard([&] {
                if (isFirst) {
                    golden.goBy(name);  // the form, the menus
                }
            });
            if (renews) {
                QTest::qWait(rest);
                ASSERT_TRUE(golden.store(name, picture())) << name.toStdString();
                return;
            }
            QString trouble = golden.check(name, picture());
            for (int turn = 0; turn < 4 && !trouble.isEmpty(); ++turn) {
                QTest::qWait(rest);
                trouble = golden.check(name, picture());
            }
            EXPECT_EQ(trouble, QString()) << trouble.toStdString();
        });
    }
    for (const QString& file :
         golden.stored().entryList({prefix + u"*_"_s + QLatin1String(language) + u".png"_s})) {
        if (!names.contains(file.chopped(4))) {
            if (renews) {
                QFile::remove(golden.stored().filePath(file));
            } else {
                ADD_FAILURE() << file.toStdString() << " is of no page";
            }
        }
    }
}

std::vector<std::string> pages() {
    std::vector<std::string> names = test::sceneNames();
    names.emplace_back(start);
    names.emplace_back(withoutPlugs);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Pages, PageGolden,
                         ::testing::Combine(::testing::ValuesIn(pages()),
                                            ::testing::Values("en", "ru")),
                         [](const auto& each) {
                             return test::testName(std::get<0>(each.param)) + "_" +
                                    std::get<1>(each.param);
                         });

}  // namespace
}  // namespace ravnoves

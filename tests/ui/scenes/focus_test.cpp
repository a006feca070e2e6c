// The Tab key goes round every page, and one sees where it is.

#include <gtest/gtest.h>

#include <QSet>
#include <tuple>

#include "difference.h"
#include "events.h"
#include "page/scene_page.h"
#include "scene_tests.h"
#include "shell/main_window.h"
#include "theme/theme.h"

namespace ravnoves {
namespace {

class FocusOnPage : public ::testing::TestWithParam<std::tuple<std::string, Theme::Mode>> {
  protected:
    FocusOnPage() {
        Theme::instance().setMode(std::get<1>(GetParam()));
        test::showAt(window, {1024, 700});  // where some of them are scrolled to
        window.activateWindow();
        window.showScene(QString::fromStdString(std::get<0>(GetParam())));
        QApplication::processEvents();
        // A button that goes while it has the focus is another test's.
        EXPECT_TRUE(test::comes([&] { return !window.currentPage()->isBusy(); }));
    }

    ~FocusOnPage() override { Theme::instance().setMode(Theme::Mode::Light); }

    /// A widget and what is close around it.
    static QImage around(QWidget* widget) {
        constexpr int rim = 4;
        const QRect place(widget->mapTo(widget->window(), QPoint()), widget->size());
        return widget->window()->grab(place.adjusted(-rim, -rim, rim, rim)).toImage();
    }
    static std::string describe(const QWidget* widget) {
        QString text = QString::fromLatin1(widget->metaObject()->className()) + QLatin1Char(' ') +
                       widget->objectName() + QLatin1Char(' ') + widget->accessibleName();
        return (text + QLatin1String(" in ") +
                QString::fromLatin1(widget->parentWidget()->metaObject()->className()))
            .toStdString();
    }

    MainWindow window;
};

TEST_P(FocusOnPage, IsSeenAtEveryStopAndComesRound) {
    constexpr int maximum = 400;
    QSet<QWidget*> stops;
    std::string names;
    for (int turn = 0; turn < maximum; ++turn) {
        QTest::keyClick(
            QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : &window,
            Qt::Key_Tab);
        QWidget* stop = QApplication::focusWidget();
        ASSERT_NE(stop, nullptr);
        if (stops.contains(stop)) {
            break;
        }
        stops.insert(stop);
        names += describe(stop) + '\n';
        EXPECT_TRUE(stop->isVisible()) << describe(stop);
        QApplication::processEvents();
        const QImage with = around(stop);
        stop->clearFocus();
        const QImage without = around(stop);
        stop->setFocus(Qt::TabFocusReason);
        constexpr int frame = 60;
        EXPECT_GE(test::differenceOf(with, without).seen, frame)
            << "the focus is hardly seen on " << describe(stop);
    }
    EXPECT_GT(stops.size(), 5) << names;
    EXPECT_LT(stops.size(), maximum);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, FocusOnPage,
    ::testing::Combine(::testing::ValuesIn(test::sceneNames()),
                       ::testing::Values(Theme::Mode::Light, Theme::Mode::Dark)),
    [](const auto& each) {
        return test::testName(std::get<0>(each.param) +
                              (std::get<1>(each.param) == Theme::Mode::Dark ? "_dark" : "_light"));
    });

}  // namespace
}  // namespace ravnoves

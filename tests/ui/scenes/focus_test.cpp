// The Tab key goes round every page, and one sees where it is.

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QSet>
#include <QTabWidget>
#include <algorithm>

#include "events.h"
#include "scene_tests.h"
#include "shell/main_window.h"
#include "shell/scene_list.h"
#include "shell/scene_page.h"

namespace ravnoves {
namespace {

class FocusOnPage : public ::testing::TestWithParam<std::string> {
  protected:
    FocusOnPage() {
        test::showAt(window, {1280, 800});
        window.activateWindow();
        window.showScene(QString::fromStdString(GetParam()));
        QApplication::processEvents();
        // A button that goes while it has the focus is another test's.
        EXPECT_TRUE(QTest::qWaitFor([&] { return !window.currentPage()->isBusy(); }, 60'000));
    }

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
    constexpr int most = 400;
    QSet<QWidget*> stops;
    std::string names;
    for (int turn = 0; turn < most; ++turn) {
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
        EXPECT_NE(with, without) << "the focus is not seen on " << describe(stop);
    }
    EXPECT_GT(stops.size(), 10) << names;
    EXPECT_LT(stops.size(), most);
}

INSTANTIATE_TEST_SUITE_P(Scenes, FocusOnPage, ::testing::ValuesIn(test::sceneNames()),
                         test::sceneOf<::testing::TestParamInfo<std::string>>);

}  // namespace
}  // namespace ravnoves

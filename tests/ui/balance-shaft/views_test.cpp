#include <gtest/gtest.h>

#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>
#include <cmath>

#include "balance-shaft/balance_shaft_page.h"
#include "balance-shaft/balance_shaft_view_model.h"
#include "balance-shaft/forces_view.h"
#include "balance-shaft/orders_view.h"
#include "balance-shaft/torque_source_editor.h"
#include "events.h"
#include "widgets/value_slider.h"

namespace ravnoves {
namespace {

class BalanceShaftViewsTest : public ::testing::Test {
  protected:
    BalanceShaftViewsTest() {
        test::showAt(page, {1187, 712});
        page.activateWindow();
        model = page.viewModel();
    }
    template <typename View>
    View* open() {
        auto* view = page.findChild<View*>();
        page.views()->setCurrentWidget(view);
        QApplication::processEvents();
        return view;
    }

    BalanceShaftPage page;
    BalanceShaftViewModel* model = nullptr;
};

TEST_F(BalanceShaftViewsTest, OrdersFollowTheShaft) {
    auto* view = open<OrdersView>();
    const double before = *view->plot()->valueAt(1, 1.0);
    const double half = *view->plot()->valueAt(1, 0.5);
    model->setShaftAngleDeg(200.0);
    EXPECT_NE(*view->plot()->valueAt(1, 1.0), before);
    EXPECT_EQ(*view->plot()->valueAt(1, 0.5), half);
}

TEST_F(BalanceShaftViewsTest, ShareSliderTurnsTheEllipseIntoALine) {
    auto* view = open<ForcesView>();
    QTest::keyClick(view->shareSlider()->slider(), Qt::Key_Home);
    EXPECT_EQ(model->input().crank_share, 0.0);
    QTest::keyClick(view->shareSlider()->slider(), Qt::Key_End);
    EXPECT_EQ(model->input().crank_share, 1.0);
    EXPECT_FALSE(view->grab().isNull());
    model->history()->undo();
    EXPECT_NEAR(view->shareSlider()->value(), model->input().crank_share, 1e-9);
}

TEST_F(BalanceShaftViewsTest, AToothOutShowsInTheMoment) {
    auto* view = open<ForcesView>();
    view->shiftedTeeth()->setFocus();
    QTest::keyClick(view->shiftedTeeth(), Qt::Key_Up);
    EXPECT_EQ(model->input().gears.shifted_teeth, 1);
    const double right = *view->gearPlot()->valueAt(2, 100.0);
    const double wrong = *view->gearPlot()->valueAt(3, 100.0);
    const double amplitude = model->result().moment_amplitude;
    const double alpha = model->input().shaft_angle;
    EXPECT_NEAR(wrong - right,
                amplitude * (std::sin(alpha + 109.0 * degree) - std::sin(alpha + 100.0 * degree)),
                1e-6 * amplitude);
}

TEST_F(BalanceShaftViewsTest, RemediesMakeTheTorqueFit) {
    ASSERT_EQ(model->result().inertia_check.consistent, false);
    auto* tabs = page.findChild<QTabWidget*>();
    tabs->setCurrentWidget(page.torqueSource());
    QTest::mouseClick(page.findChild<QPushButton*>(QStringLiteral("use_matching_speed")),
                      Qt::LeftButton);
    EXPECT_EQ(model->result().inertia_check.consistent, true);
    EXPECT_NEAR(model->input().angular_speed / rpm, 2600.0, 30.0);
    model->history()->undo();
    ASSERT_EQ(model->result().inertia_check.consistent, false);
    QTest::mouseClick(page.findChild<QPushButton*>(QStringLiteral("rebuild_torque")),
                      Qt::LeftButton);
    EXPECT_EQ(model->result().inertia_check.consistent, true);
    EXPECT_NEAR(model->input().angular_speed, 376.8, 1e-9);
}

}  // namespace
}  // namespace ravnoves

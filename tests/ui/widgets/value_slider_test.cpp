#include <gtest/gtest.h>

#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QVBoxLayout>
#include <numbers>

#include "case-file/decimal.h"
#include "events.h"
#include "widgets/number_field.h"
#include "widgets/value_slider.h"

namespace ravnoves {
namespace {

class ValueSliderTest : public ::testing::Test {
  protected:
    ValueSliderTest() {
        auto* column = new QVBoxLayout(&window);
        column->addWidget(&slider);
        column->addWidget(&other);
        slider.setValue(45.0);
        test::showAt(window, {500, 120});
        window.activateWindow();
    }
    ~ValueSliderTest() override {
        slider.setParent(nullptr);
        other.setParent(nullptr);
    }

    ValueSlider slider{QStringLiteral("&Angle"), {0.0, 360.0, 0.1, 10.0, 1}, QStringLiteral("°")};
    QSignalSpy edited{&slider, &ValueSlider::valueEdited};
    QLineEdit other;
    QWidget window;
};

TEST_F(ValueSliderTest, GoesWhenTheSliderMoves) {
    test::type(slider.box(), QStringLiteral("-3"));
    QTest::keyClick(slider.box(), Qt::Key_Tab);
    EXPECT_FALSE(slider.trouble().isEmpty());
    slider.slider()->setFocus();
    QTest::keyClick(slider.slider(), Qt::Key_Right);
    EXPECT_EQ(slider.trouble(), QString());
}

TEST_F(ValueSliderTest, ComesAndGoesWhileNoButtonIsDown) {
    const auto room = [&] { return slider.sizeHint().height(); };
    const int before = room();
    QTest::mousePress(&other, Qt::LeftButton);
    test::type(slider.box(), QStringLiteral("400"));
    EXPECT_FALSE(slider.trouble().isEmpty());
    EXPECT_EQ(room(), before);
    QTest::mouseRelease(&other, Qt::LeftButton);
    QTest::qWait(50);
    const int below = room();
    EXPECT_GT(below, before);
    QTest::mousePress(slider.slider(), Qt::LeftButton);
    slider.setValue(50.0);
    QApplication::processEvents();
    EXPECT_EQ(slider.trouble(), QString());
    EXPECT_GE(room(), below);
    QTest::mouseRelease(slider.slider(), Qt::LeftButton);
    QTest::qWait(50);
    EXPECT_EQ(room(), before);
}

TEST_F(ValueSliderTest, KeysMoveByStepAndPage) {
    QTest::keyClick(slider.slider(), Qt::Key_Right);
    EXPECT_DOUBLE_EQ(slider.value(), 45.1);
    QTest::keyClick(slider.slider(), Qt::Key_PageUp);
    EXPECT_DOUBLE_EQ(slider.value(), 55.1);
    QTest::keyClick(slider.slider(), Qt::Key_Home);
    EXPECT_DOUBLE_EQ(slider.value(), 0.0);
    QTest::keyClick(slider.slider(), Qt::Key_End);
    EXPECT_DOUBLE_EQ(slider.value(), 360.0);
    EXPECT_EQ(edited.size(), 4);
}

TEST_F(ValueSliderTest, WheelAndGrooveMoveIt) {
    other.setFocus();
    slider.slider()->setFocus(Qt::TabFocusReason);
    test::turnWheel(slider.slider(), slider.slider()->rect().center(), 1);
    EXPECT_GT(slider.value(), 45.0);
    const double before = slider.value();
    QTest::mouseClick(slider.slider(), Qt::LeftButton, {},
                      QPoint(slider.slider()->width() - 10, slider.slider()->height() / 2));
    EXPECT_GT(slider.value(), before);
}

TEST_F(ValueSliderTest, WhatIsTypedKeepsItsDecimals) {
    test::type(slider.box(), QStringLiteral("10.6257"));
    EXPECT_EQ(slider.value(), 10.6257);
    EXPECT_EQ(slider.box()->text(), QStringLiteral("10.6257"));
    QTest::keyClick(slider.slider(), Qt::Key_Right);
    EXPECT_EQ(slider.value(), 10.7);
    EXPECT_EQ(slider.box()->text(), QStringLiteral("10.7"));
    slider.setValue(rounded_to_digits(43.25 * std::numbers::pi / 30.0, 12) * 30.0 /
                    std::numbers::pi);
    EXPECT_EQ(slider.box()->text(), QStringLiteral("43.25"));
    slider.setValue(100.0 / 3.0);  // computed
    EXPECT_EQ(slider.box()->text(), QStringLiteral("33.3"));
    slider.box()->setFocus();
    slider.box()->selectAll();
    QTest::keyClick(slider.box(), Qt::Key_Return);
    EXPECT_EQ(slider.value(), 100.0 / 3.0);
}

TEST_F(ValueSliderTest, SettingTheValueSaysNothing) {
    slider.setValue(100.0);
    EXPECT_TRUE(edited.isEmpty());
    EXPECT_NEAR(slider.slider()->value(), 1000, 1);
}

}  // namespace
}  // namespace ravnoves

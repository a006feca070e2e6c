#include "widgets/number_field.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QSlider>
#include <QVBoxLayout>

#include "events.h"
#include "text/number_text.h"
#include "widgets/decimal_spin_box.h"
#include "widgets/value_slider.h"

namespace ravnoves {
namespace {

class NumberFieldTest : public ::testing::Test {
  protected:
    NumberFieldTest() {
        field.setRange(Range::greater_than(0, 100), QStringLiteral("mm"));
        field.setValue(46.0);
        test::showAt(field, {120, 30});
        field.setFocus();
        field.selectAll();
    }

    NumberField field;
};

TEST_F(NumberFieldTest, TakesCommaAndPoint) {
    QSignalSpy edited(&field, &NumberField::valueEdited);
    QTest::keyClicks(&field, QStringLiteral("12,5"));
    EXPECT_EQ(field.value(), 12.5);
    field.selectAll();
    QTest::keyClicks(&field, QStringLiteral("13.5"));
    EXPECT_EQ(field.value(), 13.5);
    EXPECT_FALSE(edited.isEmpty());
}

TEST_F(NumberFieldTest, RefusesInWordsAndKeepsTheLastValue) {
    QSignalSpy edited(&field, &NumberField::valueEdited);
    QTest::keyClicks(&field, QStringLiteral("-3"));
    EXPECT_EQ(field.value(), 46.0);
    EXPECT_EQ(field.trouble(),
              QStringLiteral("The value must be greater than 0 and at most 100\u00A0mm."));
    EXPECT_EQ(field.text(), QStringLiteral("-3"));  // nothing is lost
    EXPECT_TRUE(edited.isEmpty());
    // What is typed follows at once, so a valid beginning ("10" of "101") has been a value.
    for (const char* bad : {"nan", "inf", "1e999", "abc", "1 2", "0", "101"}) {
        field.selectAll();
        QTest::keyClicks(&field, QString::fromLatin1(bad));
        EXPECT_FALSE(field.trouble().isEmpty()) << bad;
    }
}

TEST_F(NumberFieldTest, EscapeBringsTheLastValueBack) {
    QTest::keyClicks(&field, QStringLiteral("x"));
    QTest::keyClick(&field, Qt::Key_Escape);
    EXPECT_EQ(field.text(), QStringLiteral("46"));
    EXPECT_TRUE(field.trouble().isEmpty());
}

TEST_F(NumberFieldTest, EmptyIsAllowedOnlyWhereOptional) {
    QTest::keyClick(&field, Qt::Key_Delete);
    EXPECT_FALSE(field.trouble().isEmpty());
    field.setOptional(true);
    QTest::keyClicks(&field, QStringLiteral("5"));
    QTest::keyClick(&field, Qt::Key_Backspace);
    EXPECT_TRUE(field.trouble().isEmpty());
    EXPECT_EQ(field.value(), std::nullopt);
}

TEST(NumberText, WritesWhatAPersonWants) {
    const QLocale english(QLocale::English);
    const QLocale russian(QLocale::Russian);
    EXPECT_EQ(formNumber(46.0, english), QStringLiteral("46"));
    EXPECT_EQ(formNumber(0.658, russian), QStringLiteral("0,658"));
    EXPECT_EQ(formNumber(3600.0, russian), QStringLiteral("3600"));
    EXPECT_EQ(fixedNumber(-0.001, 2, english), QStringLiteral("0.00"));
    EXPECT_EQ(fixedNumber(-1.5, 1, english), QStringLiteral("\u22121.5"));
    EXPECT_EQ(fixedNumber(std::nan(""), 1, english), QStringLiteral("–"));
}

class ValueSliderTest : public ::testing::Test {
  protected:
    ValueSliderTest()
        : slider(QStringLiteral("&Angle"), 0, 360, 0.1, 10, 1, QStringLiteral("°")),
          edited(&slider, &ValueSlider::valueEdited) {
        slider.setValue(45.0);
        test::showAt(slider, {500, 40});
    }

    ValueSlider slider;
    QSignalSpy edited;
};

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
    test::turnWheel(slider.slider(), slider.slider()->rect().center(), 1);
    EXPECT_GT(slider.value(), 45.0);
    const double before = slider.value();
    QTest::mouseClick(slider.slider(), Qt::LeftButton, {},
                      QPoint(slider.slider()->width() - 10, slider.slider()->height() / 2));
    EXPECT_GT(slider.value(), before);
}

TEST_F(ValueSliderTest, DoubleClickGoesToTheBoxToType) {
    slider.activateWindow();
    QTest::mouseDClick(slider.slider(), Qt::LeftButton, {}, slider.slider()->rect().center());
    EXPECT_TRUE(slider.box()->hasFocus());
    QTest::keyClicks(slider.box(), QStringLiteral("50,6"));
    EXPECT_DOUBLE_EQ(slider.value(), 45.0);  // not while typing
    QTest::keyClick(slider.box(), Qt::Key_Return);
    EXPECT_DOUBLE_EQ(slider.value(), 50.6);
}

TEST_F(ValueSliderTest, SettingTheValueSaysNothing) {
    slider.setValue(100.0);
    EXPECT_TRUE(edited.isEmpty());
    EXPECT_NEAR(slider.slider()->value(), 1000, 1);
}

TEST(LogarithmicSlider, GoesByDecades) {
    ValueSlider slider(QStringLiteral("&c"), 1.0, 1e6, 0.1, 1.0, 1, QStringLiteral("kN/m"));
    slider.setLogarithmic(50, 3);
    slider.setValue(20000.0);
    QSignalSpy edited(&slider, &ValueSlider::valueEdited);
    QTest::keyClick(slider.slider(), Qt::Key_PageDown);  // one decade
    ASSERT_EQ(edited.size(), 1);
    EXPECT_NEAR(slider.value(), 2000.0, 40.0);  // to the nearest step
    QTest::keyClick(slider.slider(), Qt::Key_Home);
    EXPECT_DOUBLE_EQ(slider.value(), 1.0);
    QTest::keyClick(slider.slider(), Qt::Key_End);
    EXPECT_DOUBLE_EQ(slider.value(), 1e6);
    // Every step is the same part of the value, and comes out with three digits.
    QTest::keyClick(slider.slider(), Qt::Key_Left);
    EXPECT_DOUBLE_EQ(slider.value(), 955000.0);
    // The box takes any value.
    slider.box()->setValue(1234.5);
    EXPECT_DOUBLE_EQ(slider.value(), 1234.5);
}

}  // namespace
}  // namespace ravnoves

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QToolTip>
#include <QVBoxLayout>

#include "events.h"
#include "widgets/elided_tips.h"
#include "widgets/value_slider.h"

namespace ravnoves {
namespace {

class ValueSliderRefusal : public ::testing::Test {
  protected:
    ValueSliderRefusal() {
        auto* column = new QVBoxLayout(&window);
        column->addWidget(&slider);
        column->addWidget(&other);
        slider.setValue(45.0);
        test::showAt(window, {500, 120});
        window.activateWindow();
    }
    ~ValueSliderRefusal() override {
        slider.setParent(nullptr);
        other.setParent(nullptr);
    }
    void type(const QString& text) {
        slider.box()->setFocus();
        slider.box()->selectAll();
        QTest::keyClicks(slider.box(), text);
    }

    ValueSlider slider{QStringLiteral("&Angle"), 0.0, 360.0, 0.1, 10.0, 2, QStringLiteral("°")};
    QLineEdit other;
    QWidget window;
};

TEST_F(ValueSliderRefusal, SaysWhyUnderTheRowUntilAnotherValueIsGiven) {
    type(QStringLiteral("400"));
    QTest::keyClick(slider.box(), Qt::Key_Return);
    EXPECT_EQ(slider.value(), 45.0);
    EXPECT_TRUE(slider.trouble().contains(QStringLiteral("400"))) << slider.trouble().toStdString();
    EXPECT_TRUE(slider.trouble().contains(QStringLiteral("360"))) << slider.trouble().toStdString();
    bool isSeen = false;
    for (const QLabel* label : slider.findChildren<QLabel*>()) {
        isSeen = isSeen || (label->isVisible() && label->text() == slider.trouble());
    }
    EXPECT_TRUE(isSeen);

    type(QStringLiteral("50.65"));
    QTest::keyClick(slider.box(), Qt::Key_Return);
    EXPECT_EQ(slider.value(), 50.65);
    EXPECT_EQ(slider.trouble(), QString());
}

TEST_F(ValueSliderRefusal, WhatTheBoxShowsShortIsWholeInItsTip) {
    showElidedTips();
    const auto tip = [&] {
        const QPoint at(10, 10);
        QHelpEvent help(QEvent::ToolTip, at, slider.box()->mapToGlobal(at));
        QApplication::sendEvent(slider.box()->findChild<QLineEdit*>(), &help);
        return QToolTip::text();
    };
    type(QStringLiteral("45.123456789"));
    QTest::keyClick(slider.box(), Qt::Key_Return);
    EXPECT_EQ(slider.value(), 45.123456789);
    EXPECT_LT(slider.box()->text().size(), 10);
    EXPECT_EQ(tip().section(QLatin1Char('\n'), 0, 0), QStringLiteral("45.123456789"));
    slider.box()->setFocus();
    QTest::keyClick(slider.box(), Qt::Key_Tab);
    EXPECT_EQ(slider.value(), 45.123456789) << "to show it is to change nothing";
    type(QStringLiteral("45.5"));
    QTest::keyClick(slider.box(), Qt::Key_Return);
    EXPECT_EQ(slider.wholeText(), QString());
    QToolTip::hideText();
}

TEST_F(ValueSliderRefusal, StaysWhenTheFieldIsLeftAndGoesWhenTheSliderMoves) {
    type(QStringLiteral("-3"));
    QTest::keyClick(slider.box(), Qt::Key_Tab);
    EXPECT_FALSE(slider.trouble().isEmpty());
    slider.slider()->setFocus();
    QTest::keyClick(slider.slider(), Qt::Key_Right);
    EXPECT_EQ(slider.trouble(), QString());
}

TEST_F(ValueSliderRefusal, ComesAndGoesWhileNoButtonIsDown) {
    type(QStringLiteral("400"));
    const auto room = [&] { return slider.sizeHint().height(); };
    const int before = room();
    QTest::mousePress(&other, Qt::LeftButton);
    QApplication::processEvents();
    EXPECT_FALSE(slider.trouble().isEmpty());
    EXPECT_EQ(room(), before);
    QTest::mouseRelease(&other, Qt::LeftButton);
    QApplication::processEvents();
    const int below = room();
    EXPECT_GT(below, before);
    QTest::mousePress(slider.slider(), Qt::LeftButton);
    slider.setValue(50.0);
    QApplication::processEvents();
    EXPECT_EQ(slider.trouble(), QString());
    EXPECT_GE(room(), below);
    QTest::mouseRelease(slider.slider(), Qt::LeftButton);
    QApplication::processEvents();
    EXPECT_EQ(room(), before);
}

TEST_F(ValueSliderRefusal, QuotesTheWholeTextAndTakesNoPartOfIt) {
    for (const char* text : {"abc50,65", "50,65abc", "5o", "1 000", "50.65 kg", "1,2.3"}) {
        const QString typed = QString::fromUtf8(text);
        type(typed);
        EXPECT_TRUE(slider.box()->cleanText().startsWith(typed)) << text;
        QTest::keyClick(slider.box(), Qt::Key_Return);
        EXPECT_EQ(slider.value(), 45.0) << text;
        EXPECT_TRUE(slider.trouble().contains(u'“' + typed + u'”'))
            << slider.trouble().toStdString();
    }
    type(QStringLiteral("50,65°"));
    QTest::keyClick(slider.box(), Qt::Key_Return);
    EXPECT_EQ(slider.value(), 50.65);
    EXPECT_EQ(slider.trouble(), QString());
}

TEST_F(ValueSliderRefusal, EscapeTakesBackTheTextAndWhatIsSaidOfIt) {
    const QString before = slider.box()->text();
    type(QStringLiteral("400"));
    QTest::keyClick(slider.box(), Qt::Key_Return);
    EXPECT_FALSE(slider.trouble().isEmpty());
    QTest::keyClick(slider.box(), Qt::Key_Escape);
    EXPECT_EQ(slider.trouble(), QString());
    type(QStringLiteral("12x"));
    QTest::keyClick(slider.box(), Qt::Key_Escape);
    EXPECT_EQ(slider.box()->text(), before);
    QTest::keyClick(slider.box(), Qt::Key_Return);
    EXPECT_EQ(slider.value(), 45.0);
    EXPECT_EQ(slider.trouble(), QString());
}

TEST(ValueSliderUnits, ConvertsAsNumberFieldsDo) {
    ValueSlider slider{QStringLiteral("&Offset"), -50.0, 50.0, 0.1, 1.0, 2, QStringLiteral("mm")};
    test::showAt(slider, {500, 60});
    const auto type = [&](const char* text) {
        slider.box()->selectAll();
        for (const QChar c : QString::fromUtf8(text)) {  // keyClicks() has no Russian
            QTest::sendKeyEvent(QTest::Click, slider.box(), Qt::Key_unknown, QString(c), {});
        }
        QTest::keyClick(slider.box(), Qt::Key_Return);
        return slider.value();
    };
    EXPECT_EQ(type("0.5 in"), 12.7);
    EXPECT_EQ(type("1,2 cm"), 12.0);
    EXPECT_EQ(type("7,5 мм"), 7.5);
    EXPECT_EQ(type("8 mm"), 8.0);
    EXPECT_EQ(slider.trouble(), QString());
    EXPECT_EQ(type("5 in"), 8.0);
    EXPECT_TRUE(slider.trouble().contains(QStringLiteral("“5 in”")));
    EXPECT_EQ(type("5 kg"), 8.0);
    EXPECT_TRUE(slider.trouble().contains(QStringLiteral("“kg”")));
}

TEST_F(ValueSliderRefusal, KeepsASliderThatCanBeUsedWhereTheRowIsNarrow) {
    for (const int width : {150, 200, 260, 400}) {
        test::showAt(window, {width, 140});
        EXPECT_GE(slider.slider()->width(), 110) << width;
        EXPECT_FALSE(slider.slider()->geometry().intersects(slider.box()->geometry())) << width;
    }
}

}  // namespace
}  // namespace ravnoves

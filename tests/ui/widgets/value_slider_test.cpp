#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QVBoxLayout>

#include "events.h"
#include "widgets/value_slider.h"

namespace ravnoves {
namespace {

class ValueSliderRejection : public ::testing::Test {
  protected:
    ValueSliderRejection() {
        auto* column = new QVBoxLayout(&window);
        column->addWidget(&slider);
        column->addWidget(&other);
        slider.setValue(45.0);
        test::showAt(window, {500, 120});
        window.activateWindow();
    }
    ~ValueSliderRejection() override {
        slider.setParent(nullptr);
        other.setParent(nullptr);
    }

    ValueSlider slider{QStringLiteral("&Angle"), 0.0, 360.0, 0.1, 10.0, 2, QStringLiteral("°")};
    QLineEdit other;
    QWidget window;
};

TEST_F(ValueSliderRejection, SaysWhyUnderTheRowUntilAnotherValueIsGiven) {
    test::type(slider.box(), QStringLiteral("400"));
    EXPECT_EQ(slider.value(), 45.0);
    EXPECT_TRUE(slider.trouble().contains(QStringLiteral("360"))) << slider.trouble().toStdString();
    bool isSeen = false;
    for (const QLabel* label : slider.findChildren<QLabel*>()) {
        isSeen = isSeen || (label->isVisible() && label->text() == slider.trouble());
    }
    EXPECT_TRUE(isSeen);
    test::type(slider.box(), QStringLiteral("50.65"));
    EXPECT_EQ(slider.value(), 50.65);
    EXPECT_EQ(slider.trouble(), QString());
}

TEST_F(ValueSliderRejection, GoesWhenTheSliderMoves) {
    test::type(slider.box(), QStringLiteral("-3"));
    QTest::keyClick(slider.box(), Qt::Key_Tab);
    EXPECT_FALSE(slider.trouble().isEmpty());
    slider.slider()->setFocus();
    QTest::keyClick(slider.slider(), Qt::Key_Right);
    EXPECT_EQ(slider.trouble(), QString());
}

TEST_F(ValueSliderRejection, ComesAndGoesWhileNoButtonIsDown) {
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

TEST_F(ValueSliderRejection, EscapeTakesBackTheTextAndWhatIsSaidOfIt) {
    const QString before = slider.box()->text();
    test::type(slider.box(), QStringLiteral("400"));
    QTest::keyClick(slider.box(), Qt::Key_Escape);
    EXPECT_EQ(slider.trouble(), QString());
    EXPECT_EQ(slider.box()->text(), before);
    slider.box()->selectAll();
    QTest::keyClicks(slider.box(), QStringLiteral("12"));
    EXPECT_EQ(slider.value(), 12.0) << "what is typed shows at once";
    QTest::keyClick(slider.box(), Qt::Key_Escape);
    EXPECT_EQ(slider.value(), 45.0);
}

TEST_F(ValueSliderRejection, KeepsASliderThatCanBeUsedWhereTheRowIsNarrow) {
    for (const int width : {150, 200, 260, 400}) {
        test::showAt(window, {width, 140});
        EXPECT_GE(slider.slider()->width(), 110) << width;
        EXPECT_FALSE(slider.slider()->geometry().intersects(slider.box()->geometry())) << width;
    }
}

}  // namespace
}  // namespace ravnoves

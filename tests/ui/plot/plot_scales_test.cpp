#include <gtest/gtest.h>

#include <QLocale>
#include <cmath>

#include "events.h"
#include "plot/model/ticks.h"
#include "plot/plot_view.h"

namespace ravnoves {
namespace {

TEST(LogarithmicTicks, AreDecadesThatFit) {
    const auto all = logarithmicTicks(1e-4, 1e2, 10);
    ASSERT_EQ(all.size(), 7U);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_NEAR(all[i], std::pow(10.0, static_cast<double>(i) - 4.0), 1e-12 * all[i]);
    }
    // Eighteen decades where there is room for seven labels.
    const auto few = logarithmicTicks(1e-17, 10.0, 7);
    EXPECT_LE(few.size(), 8U);
    EXPECT_GE(few.size(), 5U);
    for (const double tick : few) {
        EXPECT_NEAR(std::remainder(std::log10(tick), 1.0), 0.0, 1e-9);
    }
    // With few decades also 2 and 5; within one decade round steps.
    const auto close = logarithmicTicks(1.0, 100.0, 12);
    EXPECT_EQ(close, (std::vector<double>{1, 2, 5, 10, 20, 50, 100}));
    for (const double tick : logarithmicTicks(23.0, 47.0, 6)) {
        EXPECT_NEAR(std::remainder(tick, 5.0), 0.0, 1e-9);
    }
}

TEST(PowerText, ReadsAsScienceWritesIt) {
    const QLocale english(QLocale::English);
    EXPECT_EQ(powerText(1e-9, english), QStringLiteral("10⁻⁹"));
    EXPECT_EQ(powerText(2e-17, english), QStringLiteral("2·10⁻¹⁷"));
    EXPECT_EQ(powerText(1.2345e12, english), QStringLiteral("1.23·10¹²"));
    EXPECT_EQ(powerText(1.0, english), QStringLiteral("1"));
    EXPECT_EQ(powerText(10.0, english), QStringLiteral("10"));
    EXPECT_EQ(powerText(0.25, english), QStringLiteral("0.25"));
    EXPECT_EQ(powerText(1234.0, english), QStringLiteral("1234"));
    EXPECT_EQ(powerText(-3e-5, english), QStringLiteral("−3·10⁻⁵"));
    EXPECT_EQ(powerText(0.0, english), QStringLiteral("0"));
    EXPECT_EQ(powerText(std::nan(""), english), QStringLiteral("–"));
    EXPECT_EQ(powerText(1.5e-9, QLocale(QLocale::Russian)), QStringLiteral("1,5·10⁻⁹"));
}

class ScaledPlot : public ::testing::Test {
  protected:
    void show() {
        plot.showFigure(figure);
        test::showAt(plot, {500, 400});
    }
    Figure figure{
        .title = QStringLiteral("Errors"),
        .x = {.title = QStringLiteral("time"), .min = 1.0, .max = 1e6, .logarithmic = true},
        .left = {.title = QStringLiteral("error"), .logarithmic = true},
        .leftRange = std::pair(1e-16, 1.0)};
    PlotView plot;
};

TEST_F(ScaledPlot, ReadsAlongTheLineThatIsDrawn) {
    figure.add("a", {.name = {}, .width = 4.0}, {1.0, 1e6}, {1.0, 1e-12});
    show();
    // A straight line on both logarithmic axes.
    EXPECT_NEAR(std::log10(*plot.valueAt(0, 1e3)), -6.0, 1e-9);
    EXPECT_LT(plot.grab().toImage().pixelColor(plot.toPixel(1e3, 1e-6).toPoint()).lightness(), 170);
}

TEST_F(ScaledPlot, ArrowsStepFromPointToPoint) {
    figure
        .add("a", {.name = {}, .shape = plot::Shape::LineAndPoints}, {10, 1e3, 1e5},
             {1e-2, 1e-6, 1e-12})
        .text = [](std::size_t point) { return QString::number(point); };
    show();
    plot.setFocus();
    const QImage before = plot.grab().toImage();
    QTest::keyClick(&plot, Qt::Key_Right);
    const QImage first = plot.grab().toImage();
    EXPECT_NE(first, before);
    QTest::keyClick(&plot, Qt::Key_Right);
    EXPECT_NE(plot.grab().toImage(), first);
    QTest::keyClick(&plot, Qt::Key_Left);
    EXPECT_EQ(plot.grab().toImage(), first);
    // The mouse reads the nearest point, and none far from all of them.
    test::movePointer(&plot, plot.toPixel(10, 1e-2) + QPointF(4, 3));
    EXPECT_EQ(plot.grab().toImage(), first);
    test::movePointer(&plot, plot.toPixel(10, 1e-12));
    EXPECT_EQ(plot.grab().toImage(), before);
}

TEST_F(ScaledPlot, FadesWhileNewerDataAreOnTheWay) {
    figure.add("a", {.name = {}, .width = 4.0}, {1.0, 1e6}, {1e-8, 1e-8});
    show();
    const QPoint at = plot.toPixel(1e3, 1e-8).toPoint();
    const int clear = plot.grab().toImage().pixelColor(at).saturation();
    plot.setFaded(true, QStringLiteral("measuring"));
    EXPECT_LT(plot.grab().toImage().pixelColor(at + QPoint(100, 0)).saturation(), clear);
    EXPECT_TRUE(plot.isFaded());
    plot.setFaded(false);
    EXPECT_EQ(plot.grab().toImage().pixelColor(at).saturation(), clear);
}

}  // namespace
}  // namespace ravnoves

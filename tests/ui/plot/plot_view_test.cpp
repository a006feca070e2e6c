#include "plot/plot_view.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <cmath>
#include <numbers>
#include <numeric>

#include "events.h"
#include "plot/legend_item.h"
#include "plot/model/ticks.h"
#include "plot/picture_file.h"

namespace ravnoves {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<double> ramp(int count, double last) {
    std::vector<double> x(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = last * static_cast<double>(i) / (count - 1);
    }
    return x;
}

std::vector<double> sine(const std::vector<double>& x, double amplitude) {
    std::vector<double> y;
    for (const double v : x) {
        y.push_back(amplitude * std::sin(v * pi / 180.0));
    }
    return y;
}

TEST(Ticks, AreWhatAPersonWouldChoose) {
    EXPECT_DOUBLE_EQ(niceStep(1208.0, 6), 250.0);
    EXPECT_DOUBLE_EQ(niceAngleStep(720.0, 10), 90.0);
    EXPECT_DOUBLE_EQ(niceAngleStep(360.0, 8), 45.0);
    EXPECT_EQ(tickDecimals(250.0), 0);
    EXPECT_EQ(tickDecimals(0.25), 2);
    const auto [low, high] = niceInterval(-893.0, 315.0, 6);
    EXPECT_LE(low, -893.0);
    EXPECT_GE(high, 315.0);
    const auto [flatLow, flatHigh] = niceInterval(5.0, 5.0, 6);
    EXPECT_LT(flatLow, flatHigh);
}

TEST(Ticks, NeverLeaveAScaleWithOneNumber) {
    EXPECT_DOUBLE_EQ(readableStep(-1208.0, 1208.0, 6, false), niceStep(2416.0, 6));
    EXPECT_DOUBLE_EQ(niceStep(2900.0, 2), 2000.0);  // only 0 from -1450 to 1450
    EXPECT_DOUBLE_EQ(readableStep(-1450.0, 1450.0, 2, false), 1000.0);
    EXPECT_DOUBLE_EQ(readableStep(170.0, 350.0, 2, true), 90.0);
    for (double low = -50.0; low < 50.0; low += 0.37) {
        for (const double span : {0.013, 0.9, 1.0, 7.3, 19.9, 640.0}) {
            for (const bool degrees : {false, true}) {
                const double step = readableStep(low, low + span, 2, degrees);
                const double ticks =
                    std::floor((low + span) / step + 1e-9) - std::ceil(low / step - 1e-9) + 1.0;
                EXPECT_GE(ticks, 2.0) << low << " to " << low + span;
                EXPECT_LE(ticks, 8.0) << low << " to " << low + span;
            }
        }
    }
}

class PlotViewTest : public ::testing::Test {
  protected:
    PlotViewTest() : plot(QStringLiteral("Test")) {
        plot.setXAxis({QStringLiteral("φ, °"), 0.0, 720.0, true});
        curve = plot.addCurve({.name = QStringLiteral("sine")});
        const auto x = ramp(721, 720.0);
        plot.setCurve(curve, x, sine(x, 100.0));
        test::showAt(plot, {600, 400});
    }

    QPoint at(double x, double y) const { return plot.toPixel(x, y).toPoint(); }

    PlotView plot;
    int curve = 0;
};

TEST_F(PlotViewTest, DrawsTheCurveWhereItBelongs) {
    const QImage image = plot.grab().toImage();
    const auto differs = [&](const QPointF& p) {
        // Some pixel near p is neither background nor grid.
        for (int dy = -2; dy <= 2; ++dy) {
            const QColor c = image.pixelColor(p.toPoint() + QPoint(0, dy));
            if (c.lightness() < 180) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(differs(plot.toPixel(90, 100)));
    EXPECT_TRUE(differs(plot.toPixel(270, -100)));
    EXPECT_FALSE(differs(plot.toPixel(100, -50)));
}

TEST_F(PlotViewTest, WheelZoomsAboutThePointerAndDoubleClickResets) {
    const auto [low, high] = plot.xInterval();
    test::turnWheel(&plot, at(180, 0), 3);
    const auto [zoomLow, zoomHigh] = plot.xInterval();
    EXPECT_LT(zoomHigh - zoomLow, 0.7 * (high - low));
    EXPECT_NEAR(plot.xAt(at(180, 0).x()), 180.0, 2.0);
    QTest::mouseDClick(&plot, Qt::LeftButton, {}, plot.plotArea().center().toPoint());
    QApplication::processEvents();
    plot.grab();
    EXPECT_EQ(plot.xInterval(), std::pair(low, high));
}

TEST_F(PlotViewTest, DragPans) {
    test::turnWheel(&plot, at(360, 0), 4);
    const double before = plot.xInterval().first;
    const QPoint from = plot.plotArea().center().toPoint();
    QTest::mousePress(&plot, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, from - QPoint(50, 0),
                     plot.mapToGlobal(from - QPoint(50, 0)), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(&plot, &move);
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, from - QPoint(50, 0));
    EXPECT_GT(plot.xInterval().first, before + 10.0);
}

TEST_F(PlotViewTest, ZoomStaysFiniteHoweverFarItGoes) {
    for (int i = 0; i < 400; ++i) {
        test::turnWheel(&plot, at(100, 0), 5);
    }
    EXPECT_LT(plot.xInterval().first, plot.xInterval().second);
    for (int i = 0; i < 800; ++i) {
        test::turnWheel(&plot, plot.plotArea().center().toPoint(), -5);
    }
    EXPECT_TRUE(std::isfinite(plot.xInterval().second));
    EXPECT_LT(plot.xInterval().first, plot.xInterval().second);
}

TEST_F(PlotViewTest, MouseReadsTheCurve) {
    QSignalSpy moved(&plot, &PlotView::cursorMoved);
    QTest::mouseMove(&plot, at(90, 0));
    QMouseEvent move(QEvent::MouseMove, at(90, 0), plot.mapToGlobal(at(90, 0)), Qt::NoButton,
                     Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&plot, &move);
    ASSERT_FALSE(moved.isEmpty());
    EXPECT_NEAR(moved.last().first().toDouble(), 90.0, 1.0);
    EXPECT_NEAR(*plot.valueAt(curve, 90.0), 100.0, 1e-9);
    EXPECT_NEAR(*plot.valueAt(curve, 30.5), 100.0 * std::sin(30.5 * pi / 180), 0.01);
    EXPECT_FALSE(plot.valueAt(curve, 721.0).has_value());
}

TEST_F(PlotViewTest, PicksOnlyWherePickable) {
    QSignalSpy picked(&plot, &PlotView::picked);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, at(200, 0));
    EXPECT_TRUE(picked.isEmpty());
    plot.setPickable(true);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, at(200, 0));
    ASSERT_EQ(picked.size(), 1);
    EXPECT_NEAR(picked.last().first().toDouble(), 200.0, 1.5);
}

TEST_F(PlotViewTest, LegendSwitchesCurves) {
    auto* button = plot.findChild<LegendItem*>();
    ASSERT_NE(button, nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_FALSE(plot.isCurveShown(curve));
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(plot.isCurveShown(curve));
}

TEST_F(PlotViewTest, ACurveWithoutANameHasNoLegendEntry) {
    EXPECT_FALSE(plot.curveName(curve).isEmpty());
    plot.setCurveStyle(curve, {.name = QString()});
    auto* button = plot.findChild<LegendItem*>();
    ASSERT_NE(button, nullptr);
    EXPECT_TRUE(button->isHidden());
    plot.setCurveStyle(curve, {.name = QStringLiteral("back")});
    EXPECT_FALSE(button->isHidden());
}

TEST_F(PlotViewTest, AWiderPlotNeverNeedsMoreRowsForItsLegend) {
    for (const char* name : {"of the reciprocating parts alone", "left", "with counterweights",
                             "two-term", "with counterweights and both shafts"}) {
        plot.addCurve({.name = QString::fromLatin1(name)});
    }
    double above = 1e9;
    for (int width = 220; width < 1400; width += 3) {
        plot.resize(width, 400);
        plot.grab();
        const double top = plot.plotArea().top();
        EXPECT_LE(top, above) << width;
        above = top;
    }
}

TEST_F(PlotViewTest, TellsWhichCurveIsSwitched) {
    QSignalSpy toggled(&plot, &PlotView::curveToggled);
    plot.setCurveShown(0, false);
    plot.setCurveShown(0, false);
    ASSERT_EQ(toggled.size(), 1);
    EXPECT_EQ(toggled[0][0].toInt(), 0);
    EXPECT_FALSE(toggled[0][1].toBool());
}

TEST_F(PlotViewTest, AFamilyShowsTheVariantsThatAreThere) {
    const auto family = plot.addFamily(3, {.name = {}, .colour = 2});
    const int first = family.first;
    EXPECT_EQ(plot.curveCount(), 4);
    const std::vector<double> x{0.0, 720.0};
    plot.setFamily(family, x, {{QStringLiteral("a"), {1, 1}}, {QStringLiteral("b"), {2, 2}}});
    EXPECT_TRUE(plot.isCurveShown(first) && plot.isCurveShown(first + 1));
    EXPECT_FALSE(plot.isCurveShown(first + 2));
    EXPECT_EQ(plot.curveName(first + 1), QStringLiteral("b"));
    EXPECT_EQ(plot.valueAt(first + 1, 360.0), 2.0);
    // What the legend hides stays hidden, until the variant goes and comes back.
    plot.setCurveShown(first, false);
    plot.setFamily(family, x, {{QStringLiteral("c"), {3, 3}}, {QStringLiteral("b"), {}}});
    EXPECT_FALSE(plot.isCurveShown(first));
    EXPECT_FALSE(plot.isCurveShown(first + 1));
    EXPECT_EQ(plot.curveName(first + 1), QString());
    plot.setFamily(family, x, {});
    plot.setFamily(family, x, {{QStringLiteral("c"), {3, 3}}});
    EXPECT_TRUE(plot.isCurveShown(first));
}

TEST_F(PlotViewTest, AllPlotsOfAPageAreReset) {
    QWidget page;
    plot.setParent(&page);
    plot.grab();
    const auto whole = plot.xInterval();
    QTest::keyClick(&plot, Qt::Key_Plus);
    EXPECT_TRUE(plot.isZoomed());
    resetAllZoom(&page);
    plot.grab();
    EXPECT_EQ(plot.xInterval(), whole);
    plot.setParent(nullptr);
}

TEST_F(PlotViewTest, KeysZoomMoveAndReset) {
    const auto whole = plot.xInterval();
    QTest::keyClick(&plot, Qt::Key_Plus);
    EXPECT_LT(plot.xInterval().second - plot.xInterval().first, whole.second - whole.first);
    QTest::keyClick(&plot, Qt::Key_0);
    plot.grab();
    EXPECT_EQ(plot.xInterval(), whole);
    QSignalSpy moved(&plot, &PlotView::cursorMoved);
    QTest::keyClick(&plot, Qt::Key_Right);
    EXPECT_EQ(moved.size(), 1);
}

TEST_F(PlotViewTest, ExportsPictureAndData) {
    const QTemporaryDir folder;
    const QString svg = folder.filePath(QStringLiteral("plot.svg"));
    const QString png = folder.filePath(QStringLiteral("plot.png"));
    EXPECT_EQ(plot.exportPicture(svg), QString());
    EXPECT_EQ(plot.exportPicture(png), QString());
    QFile file(svg);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("<text"));
    EXPECT_EQ(QImage(png).width(), printedWidth(plot.size()));
    EXPECT_NE(plot.exportPicture(QStringLiteral("/dev/null/x.png")), QString());
    const QString csv = plot.dataAsCsv();
    EXPECT_TRUE(csv.startsWith(QStringLiteral("\"φ, °\",\"sine\"\n0,0\n")));
    EXPECT_EQ(csv.count(QLatin1Char('\n')), 721 + 1);
}

TEST_F(PlotViewTest, EqualScaleKeepsCirclesRound) {
    PlotView round(QStringLiteral("Circle"));
    round.setXAxis({{}, -1.0, 1.0});
    round.setEqualScale(true);
    const int circle = round.addCurve({.name = QStringLiteral("circle")});
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i <= 360; ++i) {
        x.push_back(std::cos(i * pi / 180));
        y.push_back(std::sin(i * pi / 180));
    }
    round.setCurve(circle, x, y);
    test::showAt(round, {700, 300});
    const QPointF a = round.toPixel(0, 0);
    EXPECT_NEAR(round.toPixel(1, 0).x() - a.x(), a.y() - round.toPixel(0, 1).y(), 0.5);
}

}  // namespace
}  // namespace ravnoves

#include "plot/plot_view.h"

#include <gtest/gtest.h>

#include <QScrollArea>
#include <QSignalSpy>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "events.h"
#include "painted.h"
#include "plot/legend_item.h"
#include "plot/model/figure.h"
#include "plot/model/ticks.h"
#include "widgets/mnemonics.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

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
    EXPECT_DOUBLE_EQ(readableStep(0.5, 12.5, 5, false), 5.0);  // not 2.5: orders are whole
    EXPECT_DOUBLE_EQ(niceStep(720.0, 10, true), 90.0);
    EXPECT_DOUBLE_EQ(niceStep(360.0, 8, true), 45.0);
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
    PlotViewTest() {
        figure.title = u"Test"_s;
        figure.x = {u"φ, °"_s, 0.0, 720.0, true};
        const auto x = ramp(721, 720.0);
        figure.add("sine", {.name = u"sine"_s}, x, sine(x, 100.0));
        plot.showFigure(figure);
        test::showAt(plot, {600, 400});
    }

    QPoint at(double x, double y) const { return plot.toPixel(x, y).toPoint(); }

    Figure figure;
    PlotView plot;
};

TEST_F(PlotViewTest, WheelZoomsAboutThePointerAndDoubleClickResets) {
    const auto [low, high] = plot.data().x.interval();
    test::turnWheel(&plot, at(180, 0), 3);
    const auto [zoomLow, zoomHigh] = plot.data().x.interval();
    EXPECT_LT(zoomHigh - zoomLow, 0.7 * (high - low));
    EXPECT_NEAR(plot.xAt(at(180, 0).x()), 180.0, 2.0);
    QTest::mouseDClick(&plot, Qt::LeftButton, {}, plot.plotArea().center().toPoint());
    QApplication::processEvents();
    plot.grab();
    EXPECT_EQ(plot.data().x.interval(), std::pair(low, high));
}

TEST(PlotViewWheel, APageThatIsScrolledGoesOnOverAPlot) {
    QScrollArea area;
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    auto* plot = new PlotView;
    plot->showFigure({.x = {u"φ, °"_s, 0.0, 360.0}});
    plot->setMinimumSize(300, 900);
    column->addWidget(plot);
    area.setWidget(page);
    area.setWidgetResizable(true);
    test::showAt(area, {400, 300});
    const auto [low, high] = plot->data().x.interval();
    // What a test sends is not passed on by itself.
    const QPointF at(150, 100);
    plot->setCursorX(180.0);
    QWheelEvent down(at, plot->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(plot, &down);
    EXPECT_FALSE(down.isAccepted()) << "left to the page";
    EXPECT_FALSE(plot->data().cursorX) << "the plot has gone from under the pointer";
    EXPECT_EQ(plot->data().x.interval(), std::pair(low, high));
    QTest::mouseClick(plot, Qt::LeftButton, {}, {150, 150});
    test::turnWheel(plot, {150, 150}, 1);
    EXPECT_LT(plot->data().x.interval().second - plot->data().x.interval().first, high - low);
}

TEST_F(PlotViewTest, DragPans) {
    test::turnWheel(&plot, at(360, 0), 4);
    const double before = plot.data().x.interval().first;
    const QPoint from = plot.plotArea().center().toPoint();
    test::drag(&plot, from, from - QPoint(50, 0), 1);
    EXPECT_GT(plot.data().x.interval().first, before + 10.0);
}

TEST_F(PlotViewTest, PicksOnlyWherePickable) {
    QSignalSpy picked(&plot, &PlotView::picked);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, at(200, 0));
    EXPECT_TRUE(picked.isEmpty());
    plot.setPickable(true);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, at(200, 0));
    ASSERT_EQ(picked.size(), 1);
    EXPECT_NEAR(picked.last().first().toDouble(), 200.0, 1.5);
    // A double click shows all of a zoomed plot, and what its first click chose is taken back.
    const auto whole = plot.data().x.interval();
    plot.setPresentX(100.0);
    test::turnWheel(&plot, at(180, 0), 3);
    QTest::mouseClick(&plot, Qt::LeftButton, {}, at(200, 0));
    QTest::mouseDClick(&plot, Qt::LeftButton, {}, at(200, 0));
    plot.grab();
    EXPECT_EQ(plot.data().x.interval(), whole);
    EXPECT_EQ(picked.last().first().toDouble(), 100.0);
}

TEST_F(PlotViewTest, LegendSwitchesCurves) {
    auto* button = plot.findChild<LegendItem*>();
    ASSERT_NE(button, nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_FALSE(plot.data().curve(0).shown);
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(plot.data().curve(0).shown);
}

TEST_F(PlotViewTest, AWiderPlotNeverNeedsMoreRowsForItsLegendAndCutsNoName) {
    for (const QString& name :
         {u"of the reciprocating parts alone"_s, u"left"_s, u"with counterweights"_s, u"two-term"_s,
          u"with counterweights and both shafts, which is longer than a row"_s}) {
        figure.add(name.toStdString(), {.name = name}, {0, 720}, {0, 1});
    }
    plot.showFigure(figure);
    double above = 1e9;
    for (int width = 220; width < 1400; width += 3) {
        plot.resize(width, 400);
        plot.grab();
        const double top = plot.plotArea().top();
        EXPECT_LE(top, above) << width;
        above = top;
        for (const LegendItem* item : plot.findChildren<LegendItem*>()) {
            EXPECT_GE(item->height(), item->heightForWidth(item->width()))
                << width << ' ' << item->name().toStdString();
            EXPECT_LE(item->geometry().right(), width);
            EXPECT_LT(item->geometry().bottom(), top + 1.0);
        }
    }
}

TEST(PlotView, AVariantsNameInTheLegendIsNoKey) {
    Figure figure;
    figure.add("a", {.name = u"a"_s}, {0.0, 1.0}, {0.0, 1.0});
    PlotView plot;
    plot.showFigure(figure);
    plot.showReference(&figure, u"R&D"_s);
    separateMnemonics(&plot);
    const auto* item = plot.findChildren<LegendItem*>().last();
    EXPECT_EQ(item->name(), u"R&D"_s);
    EXPECT_TRUE(item->shortcut().isEmpty());
}

TEST_F(PlotViewTest, TheLegendNamesOnlyCurvesThatAreThere) {
    const auto named = [&] {
        plot.showFigure(figure);
        QStringList names;
        for (const LegendItem* item : plot.findChildren<LegendItem*>()) {
            if (!item->isHidden()) {
                names << item->name();
            }
        }
        return names;
    };
    figure.add("left", {.name = u"left"_s}, {}, {});
    EXPECT_EQ(named(), QStringList({u"sine"_s}));
    figure.curves[1].x = figure.curves[1].y = {0, 720};
    EXPECT_EQ(named(), QStringList({u"sine"_s, u"left"_s}));
    figure.curves[0].style.name.clear();
    EXPECT_EQ(named(), QStringList({u"left"_s}));
    // With no data at all it is the frame of what is to come.
    figure.curves[0].style.name = u"back"_s;
    figure.curves[0].x = figure.curves[1].x = {};
    EXPECT_EQ(named(), QStringList({u"back"_s, u"left"_s}));
    figure.curves.pop_back();
    EXPECT_EQ(named(), QStringList({u"back"_s})) << "nothing of a figure that is gone";
}

QStringList textsOf(PlotView& plot) {
    QStringList texts;
    for (const test::PaintedText& each : test::painted(plot).texts) {
        texts << each.text;
    }
    return texts;
}

TEST_F(PlotViewTest, NumbersHaveATrueMinus) {
    plot.setCursorX(270.0);
    const QString all = textsOf(plot).join(QLatin1Char('|'));
    EXPECT_TRUE(all.contains(QStringLiteral("\u2212100"))) << all.toStdString();
    EXPECT_FALSE(all.contains(QLatin1Char('-'))) << all.toStdString();
    EXPECT_TRUE(plot.dataAsCsv().contains(QStringLiteral(",-"))) << "data keep what programs read";
}

TEST_F(PlotViewTest, ALimitOutOfSightIsReportedAtTheEdge) {
    figure.lines = {
        {.at = 900.0, .orientation = Qt::Vertical, .text = u"at most"_s, .keptAtEdge = true},
        {.at = -500.0, .text = u"at least"_s, .keptAtEdge = true},
        {.at = 2000.0, .text = u"not told"_s}};
    plot.showFigure(figure);
    const QString texts = u'|' + textsOf(plot).join(u'|');
    EXPECT_TRUE(texts.contains(u"|at most 900"_s));
    EXPECT_TRUE(texts.contains(u"|at least \u2212500"_s));
    EXPECT_FALSE(texts.contains(u"|not told"_s));
}

TEST_F(PlotViewTest, WhatIsReadGoesWhileTheChartIsDragged) {
    const QPoint from = plot.plotArea().center().toPoint();
    test::movePointer(&plot, from);
    EXPECT_TRUE(plot.data().cursorX.has_value());
    QTest::mousePress(&plot, Qt::LeftButton, {}, from);
    test::movePointer(&plot, from + QPoint(60, 0), Qt::LeftButton);
    EXPECT_FALSE(plot.data().cursorX.has_value());
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, from + QPoint(60, 0));
    EXPECT_TRUE(plot.data().cursorX.has_value());
}

TEST_F(PlotViewTest, WhatStandsOverOneAnotherBeginsAtOnePixel) {
    QWidget page;
    page.resize(500, 500);
    std::vector<std::unique_ptr<PlotView>> plots;
    figure.left.title = u"N·m"_s;
    const auto show = [&](PlotView& each, double amplitude) {
        figure.curves[0].y = sine(figure.curves[0].x, amplitude);
        each.showFigure(figure);
    };
    for (const double amplitude : {1.0, 123456.0}) {
        plots.push_back(std::make_unique<PlotView>(&page));
        plots.back()->setGeometry(0, 250 * static_cast<int>(plots.size() - 1), 500, 250);
        show(*plots.back(), amplitude);
    }
    test::showAt(page, {500, 500});
    EXPECT_NE(plots[0]->plotArea().left(), plots[1]->plotArea().left());
    PlotView::stack({plots[0].get(), plots[1].get()});
    QApplication::processEvents();
    EXPECT_EQ(plots[0]->plotArea().left(), plots[1]->plotArea().left());
    EXPECT_EQ(plots[0]->plotArea().right(), plots[1]->plotArea().right());
    // One that grows takes the other with it, and one that goes leaves nothing behind.
    show(*plots[0], 123456789.0);
    QApplication::processEvents();
    QApplication::processEvents();
    EXPECT_EQ(plots[0]->plotArea().left(), plots[1]->plotArea().left());
    plots.pop_back();
    show(*plots[0], 1.0);
    plots[0]->grab();
}

TEST_F(PlotViewTest, ACurveThatIsAPointIsSeen) {
    figure.curves[0].x = {360, 360, 360};
    figure.curves[0].y = {0, 0, 0};
    plot.showFigure(figure);
    plot.grab();
    const QPoint middle = at(360, 0);
    EXPECT_LT(plot.grab().toImage().pixelColor(middle).lightness(), 180);
}

TEST_F(PlotViewTest, KeysZoomMoveAndReset) {
    const auto whole = plot.data().x.interval();
    QTest::keyClick(&plot, Qt::Key_Plus);
    EXPECT_LT(plot.data().x.interval().second - plot.data().x.interval().first,
              whole.second - whole.first);
    QTest::keyClick(&plot, Qt::Key_0);
    plot.grab();
    EXPECT_EQ(plot.data().x.interval(), whole);
    QSignalSpy moved(&plot, &PlotView::cursorMoved);
    QTest::keyClick(&plot, Qt::Key_Right);
    EXPECT_EQ(moved.size(), 1);
}

/// The plot before and after the pointer has come to a place where something is read.
std::pair<QImage, QImage> readAt(PlotView& plot, const QPointF& at) {
    QTest::mouseMove(&plot, QPoint(2, 2));
    const QImage before = plot.grab().toImage();
    QImage after;
    EXPECT_TRUE(test::pointUntil(
        &plot, [&] { return at; },
        [&] {
            after = plot.grab().toImage();
            return after != before;
        }));
    return {before, after};
}

/// A read-out with the values of a reference may be wider than its chart, or the whole plot.
TEST(PlotView, WhatTheCursorReadsIsWithinThePlot) {
    Figure means{.title = u"Means"_s, .x = {u"α, °"_s, 0.0, 360.0}};
    means.add("mean", {.name = u"Mₛ mean (paper)"_s}, {0.0, 360.0}, {-1234.5, 1450.0});
    for (const int width : {190, 230, 320, 480}) {
        PlotView plot;
        plot.showFigure(means);
        plot.showReference(&means, u"A"_s);
        test::showAt(plot, {width, 220});
        const QRectF area = plot.plotArea();
        for (const double part : {0.05, 0.5, 0.95}) {
            const auto [before, after] =
                readAt(plot, {area.left() + part * area.width(), area.center().y()});
            // Nothing of it at the edges: its frame is whole.
            for (int y = static_cast<int>(area.top()); y < after.height(); ++y) {
                for (const int x : {0, after.width() - 1}) {
                    EXPECT_EQ(before.pixel(x, y), after.pixel(x, y)) << width << ' ' << part;
                }
            }
        }
    }
}

TEST(PlotView, OfACurveThatFoldsBackNoXIsRead) {
    PlotView plot;
    Figure figure{.title = u"Guide"_s, .x = {u"x, mm"_s, -1.0, 1.0}};
    figure.add("rho", {.name = u"ρ"_s}, {}, {0.0, 1.0, 0.0, -1.0});
    const auto shown = [&](std::vector<double> x) {
        figure.curves[0].x = std::move(x);
        plot.showFigure(figure);
        test::showAt(plot, {400, 300});
        const QPoint middle = plot.plotArea().center().toPoint();
        const auto [before, after] = readAt(plot, middle);
        // Beside the cursor's line, where the box stands.
        return after.copy(middle.x() + 14, 0, 60, 300) != before.copy(middle.x() + 14, 0, 60, 300);
    };
    EXPECT_TRUE(shown({-1.0, -0.5, 0.5, 1.0}));
    EXPECT_FALSE(shown({-1.0, 0.0, 1.0, 0.0}));
}

TEST(PlotView, APlotOverAnotherReadsItsX) {
    QWidget page;
    page.resize(400, 400);
    PlotView upper(&page);
    PlotView lower(&page);
    upper.showFigure({.title = u"Order 1"_s});
    lower.showFigure({.title = u"Order 2"_s, .x = {u"φ, °"_s, 0.0, 720.0}});
    upper.setGeometry(0, 0, 400, 200);
    lower.setGeometry(0, 200, 400, 200);
    upper.stack({&upper, &lower});
    test::showAt(page, {400, 400});
    EXPECT_EQ(upper.data().xName, u"φ, °"_s);
}

}  // namespace
}  // namespace ravnoves

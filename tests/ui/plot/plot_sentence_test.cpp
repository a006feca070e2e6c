// A plot in words, and its units: what a screen reader says.

#include <gtest/gtest.h>

#include <QAccessible>
#include <cmath>

#include "plot/plot_view.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

PlotView* torquePlot(QWidget* parent) {
    auto* plot = new PlotView(u"Moments"_s, parent);
    plot->setXAxis({u"φ, °"_s, 0.0, 720.0, true});
    plot->setYAxis(PlotView::Side::Left, {u"M, N·m"_s});
    plot->addCurve({.name = u"Mᵤₚ"_s});
    plot->resize(600, 300);
    return plot;
}

std::vector<double> angles() {
    std::vector<double> x;
    for (int i = 0; i <= 720; ++i) {
        x.push_back(i);
    }
    return x;
}

TEST(PlotSentence, NamesExtremesAndWhereTheyAre) {
    QWidget window;
    PlotView* plot = torquePlot(&window);
    std::vector<double> y;
    for (const double x : angles()) {
        y.push_back(500.0 * std::sin(x * 3.14159265358979 / 360.0));
    }
    plot->setCurve(0, angles(), y);
    plot->grab();
    EXPECT_EQ(plot->sentence().toStdString(),
              "Over φ from 0.0 to 720.0°. Mᵤₚ: from −500 at 540.0° to 500\u00A0N·m at 180.0°.");
    // A curve that is switched off is not there for anybody.
    plot->setCurveShown(0, false);
    EXPECT_EQ(plot->sentence(), u"Over φ from 0.0 to 720.0°. No data."_s);
}

TEST(PlotSentence, SaysHowACurveGoes) {
    QWidget window;
    PlotView* plot = torquePlot(&window);
    plot->setCurve(0, {0.0, 360.0, 720.0}, {1.0, 20.0, 300.0});
    plot->grab();
    EXPECT_TRUE(
        plot->sentence().contains(u"Mᵤₚ: rises from 1.0 at 0.0° to 300.0\u00A0N·m at 720.0°"_s))
        << plot->sentence().toStdString();
    plot->setCurve(0, {0.0, 360.0, 720.0}, {300.0, 20.0, 20.0});
    EXPECT_TRUE(plot->sentence().contains(u"falls from"_s));
    plot->setCurve(0, {0.0, 360.0, 720.0}, {20.0, 20.0, 20.0});
    EXPECT_TRUE(plot->sentence().contains(u"constant"_s)) << plot->sentence().toStdString();
    plot->setPresentX(90.0);
    plot->setMarks({{90.0, 20.0, u"least\n20"_s}});
    EXPECT_TRUE(plot->sentence().endsWith(u"Marked: least, 20. Now at 90.0°."_s))
        << plot->sentence().toStdString();
}

TEST(PlotSentence, IsWhatAScreenReaderGetsWhenItAsks) {
    QWidget window;
    PlotView* plot = torquePlot(&window);
    plot->setCurve(0, {0.0, 360.0, 720.0}, {300.0, 20.0, 25.0});
    QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(plot);
    ASSERT_NE(spoken, nullptr);
    EXPECT_EQ(spoken->role(), QAccessible::Chart);
    EXPECT_EQ(spoken->text(QAccessible::Name), u"Moments"_s);
    EXPECT_EQ(spoken->text(QAccessible::Description), plot->sentence());
    // It is made then, not at every change: nothing is kept on the widget.
    EXPECT_TRUE(plot->accessibleDescription().isEmpty());
}

}  // namespace
}  // namespace ravnoves

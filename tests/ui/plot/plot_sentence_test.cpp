// A plot in words, and its units: what a screen reader says.

#include <gtest/gtest.h>

#include <QAccessible>
#include <cmath>

#include "plot/plot_view.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class PlotSentence : public ::testing::Test {
  protected:
    /// Of a curve through these, evenly from 0 to 720°.
    QString sentence(std::vector<double> y) {
        std::vector<double> x;
        for (std::size_t i = 0; i < y.size(); ++i) {
            x.push_back(720.0 * static_cast<double>(i) / static_cast<double>(y.size() - 1));
        }
        figure.curves.clear();
        figure.add("m", {.name = u"Mᵤₚ"_s}, std::move(x), std::move(y));
        plot.showFigure(figure);
        plot.resize(600, 300);
        plot.grab();
        return plot.sentence();
    }

    Figure figure{.title = u"Moments"_s, .x = {u"φ, °"_s, 0.0, 720.0, true}, .left = {u"M, N·m"_s}};
    QWidget window;
    PlotView plot{&window};
};

TEST_F(PlotSentence, NamesExtremesAndWhereTheyAre) {
    std::vector<double> y;
    for (int i = 0; i <= 720; ++i) {
        y.push_back(500.0 * std::sin(i * 3.14159265358979 / 360.0));
    }
    EXPECT_EQ(sentence(y).toStdString(),
              "Over φ from 0.0 to 720.0°. Mᵤₚ: from −500 at 540.0° to 500\u00A0N·m at 180.0°.");
    // A curve that is switched off is not there for anybody.
    plot.setCurveShown(0, false);
    EXPECT_EQ(plot.sentence(), u"Over φ from 0.0 to 720.0°. No data."_s);
}

TEST_F(PlotSentence, NamesWhatIsMarked) {
    EXPECT_TRUE(sentence({20.0, 20.0, 20.0}).contains(u"Mᵤₚ: constant, 20."_s))
        << plot.sentence().toStdString();
    figure.presentX = 90.0;
    figure.marks = {{90.0, 20.0, u"least\n20"_s}};
    EXPECT_TRUE(sentence({20.0, 20.0, 20.0}).endsWith(u"Marked: least, 20. Now at 90.0°."_s))
        << plot.sentence().toStdString();
}

TEST_F(PlotSentence, IsWhatAScreenReaderGetsWhenItAsks) {
    sentence({300.0, 20.0, 25.0});
    QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(&plot);
    ASSERT_NE(spoken, nullptr);
    EXPECT_EQ(spoken->role(), QAccessible::Chart);
    EXPECT_EQ(spoken->text(QAccessible::Name), u"Moments"_s);
    EXPECT_EQ(spoken->text(QAccessible::Description), plot.sentence());
    // It is made then, not at every change: nothing is kept on the widget.
    EXPECT_TRUE(plot.accessibleDescription().isEmpty());
}

}  // namespace
}  // namespace ravnoves

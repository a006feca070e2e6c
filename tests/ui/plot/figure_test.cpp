#include "plot/model/figure.h"

#include <gtest/gtest.h>

#include <QTest>

#include "plot/plot_view.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

Figure::Curve curve(const std::string& id, std::vector<double> y) {
    Figure::Curve made;
    made.id = id;
    made.style.name = QString::fromStdString(id);
    for (std::size_t i = 0; i < y.size(); ++i) {
        made.x.push_back(static_cast<double>(i));
    }
    made.y = std::move(y);
    return made;
}

Figure figure(std::vector<Figure::Curve> curves) {
    Figure made;
    made.title = u"t"_s;
    made.x = {.title = u"x, °"_s, .min = 0.0, .max = 2.0};
    made.left = {.title = u"y, N"_s};
    made.curves = std::move(curves);
    return made;
}

TEST(ShownFigure, CurvesKeepTheirPlaceByWordWhateverComesBetween) {
    PlotView plot;
    plot.showFigure(figure({curve("a", {1, 2, 3}), curve("c", {3, 2, 1})}));
    ASSERT_EQ(std::ssize(plot.data().curves), 2);
    plot.setCurveShown(1, false);
    plot.showFigure(figure({curve("a", {1, 2, 3}), curve("b", {0, 0, 1}), curve("c", {5, 5, 5})}));
    ASSERT_EQ(std::ssize(plot.data().curves), 3);
    EXPECT_EQ(plot.data().curve(1).id, "c");
    EXPECT_EQ(*plot.valueAt(1, 1.0), 5.0);
    EXPECT_FALSE(plot.data().curve(1).shown) << "what the user switched off stays off";
    EXPECT_EQ(plot.data().curve(2).id, "b");
    plot.showFigure(figure({curve("c", {1, 1, 1})}));
    EXPECT_TRUE(plot.data().curve(0).x.empty());
    EXPECT_TRUE(plot.data().curve(2).x.empty());
    EXPECT_EQ(*plot.valueAt(1, 1.0), 1.0);
}

TEST(ShownFigure, GhostsAreOfTheSameWordAndUnit) {
    PlotView plot;
    plot.showFigure(figure({curve("a", {1, 2, 3}), curve("b", {4, 4, 4})}));
    const Figure reference = figure({curve("b", {9, 9, 9}), curve("z", {0, 0, 0})});
    plot.showReference(&reference, u"R"_s);
    EXPECT_EQ(plot.data().ghostOf(plot.data().curve(0)), nullptr);
    const PlotCurve* ghost = plot.data().ghostOf(plot.data().curve(1));
    ASSERT_NE(ghost, nullptr);
    EXPECT_EQ(ghost->y, std::vector<double>({9, 9, 9}));
    Figure other = reference;
    other.left.title = u"y, kN"_s;
    plot.showReference(&other, u"R"_s);
    EXPECT_EQ(plot.data().ghostOf(plot.data().curve(1)), nullptr) << "another quantity";
    plot.showReference(nullptr, {});
    EXPECT_FALSE(plot.data().hasGhosts());
}

TEST(ShownFigure, WhatIsZoomedToStaysWhileTheAxisIsTheSame) {
    PlotView plot;
    plot.resize(400, 300);
    Figure shown = figure({curve("a", {1, 2, 3})});
    plot.showFigure(shown);
    plot.grab();
    QTest::keyClick(&plot, Qt::Key_Plus);
    ASSERT_TRUE(plot.isZoomed());
    const auto before = plot.data().x.interval();
    shown.x.max = 3.0;
    plot.showFigure(shown);
    EXPECT_TRUE(plot.isZoomed());
    EXPECT_EQ(plot.data().x.interval(), before);
    plot.resetZoom();
    shown.x = {.title = u"n"_s, .min = 10.0, .max = 20.0};
    plot.showFigure(shown);
    EXPECT_EQ(plot.data().x.interval(), std::pair(10.0, 20.0));
}

TEST(ShownFigure, AMarkGoesWithItsCurve) {
    PlotView plot;
    plot.resize(400, 300);
    Figure shown = figure({curve("a", {1, 1, 1}), curve("b", {0, 1, 2})});
    plot.showFigure(shown);
    const QImage without = plot.grab().toImage();
    plot::Mark mark;
    mark.x = 1.0;
    mark.y = 1.0;
    mark.text = u"top"_s;
    mark.curve = "b";
    shown.marks = std::vector{mark};
    plot.showFigure(shown);
    EXPECT_NE(plot.grab().toImage(), without);
    plot.setCurveShown(1, false);
    const QImage hidden = plot.grab().toImage();
    shown.marks->clear();
    plot.showFigure(shown);
    EXPECT_EQ(plot.grab().toImage(), hidden);
}

}  // namespace
}  // namespace ravnoves

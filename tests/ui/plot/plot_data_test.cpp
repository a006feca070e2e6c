// The part of the plots that knows no window.

#include "plot/model/plot_data.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <memory>

#include "pictures/model/stroke.h"
#include "plot/model/label_places.h"
#include "text/csv_format.h"

namespace ravnoves {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
using Values = std::vector<double>;
using Starts = std::vector<std::size_t>;

TEST(PlotScale, HasFewTicksWhateverTheData) {
    constexpr double subnormal = 5e-324;
    constexpr double huge = std::numeric_limits<double>::max();
    for (const auto& [minimum, maximum] :
         std::initializer_list<std::pair<double, double>>{{0.0, 0.0},
                                                          {-1e-17, 1e-17},
                                                          {0.0, 1e-17},
                                                          {1e3 - 1e-17, 1e3 + 1e-17},
                                                          {1e3, 1e3 + 1e-12},
                                                          {-1e3 - 1e-9, -1e3},
                                                          {0.0, 1e-300},
                                                          {0.0, subnormal},
                                                          {subnormal, subnormal},
                                                          {-1e308, 1e308},
                                                          {0.0, huge},
                                                          {-huge, huge},
                                                          {1e308, huge},
                                                          {1e-9, 1e9},
                                                          {2.0, 2.0 + 1e-7}}) {
        for (const bool degrees : {false, true}) {
            PlotScale scale;
            scale.spec.degrees = degrees;
            scale.fit(minimum, maximum);
            scale.chooseStep(600.0, 40.0);
            const std::string what = std::to_string(minimum) + " " + std::to_string(maximum);
            ASSERT_LT(scale.low, scale.high) << what;
            ASSERT_GT(scale.step, 0.0) << what;
            EXPECT_LE((scale.high - scale.low) / scale.step, 50.0) << what;
            // A step that is lost in the values never ends.
            EXPECT_NE(scale.low + 1e-3 * scale.step, scale.low) << what;
            EXPECT_NE(scale.high - 1e-3 * scale.step, scale.high) << what;
            EXPECT_LE(scale.tickText(scale.high, QLocale::c()).size(), 24) << what;
        }
        if (maximum > 0.0) {
            PlotScale scale;
            scale.spec.logarithmic = true;
            scale.fit(std::max(minimum, subnormal), maximum);
            EXPECT_LE(scale.ticks(600.0, 40.0).size(), 50U) << minimum << " " << maximum;
        }
    }
}

TEST(PlotScale, LabelsBesideOneAnotherHaveRoom) {
    PlotScale scale;
    scale.low = -5e5;
    scale.high = 5e5;
    const auto width = [](const QString& label) { return 8.0 * static_cast<double>(label.size()); };
    for (const double pixels : {150.0, 300.0, 900.0}) {
        scale.chooseStep(pixels, 30.0, width, QLocale::c());
        EXPECT_GE(pixels * scale.step / 1e6, width(QStringLiteral("-500000"))) << pixels;
        EXPECT_GE(scale.ticks(pixels, 30.0).size(), 2U) << pixels;
    }
    EXPECT_EQ(scale.tickText(-5e5, QLocale::c()), QStringLiteral("\u2212500000"));
}

TEST(LabelPlaces, ChoosesWhereMinimumIsDrawn) {
    LabelPlaces places(QRectF(10, 10, 200, 100));
    places.addLine({{10, 60}, {210, 60}});
    places.addLine({{-1e9, 20}, {1e9, 20}});  // far beyond it
    const QSizeF size(40, 12);
    const QRectF over({50, 54}, size);
    const QRectF below({50, 70}, size);
    EXPECT_GT(places.covered(over), 0);
    EXPECT_EQ(places.covered(below), 0);
    EXPECT_EQ(places.place(std::array{over, below}), below);
    // The next one keeps off the first even where a curve passes.
    EXPECT_EQ(places.place(std::array{below, over}), over);
    // All of it within the area.
    EXPECT_EQ(places.place(std::array{QRectF({190, 90}, size)}), QRectF({170, 90}, size));
    places.addShape(QRectF(0, 0, 400, 400));
    EXPECT_GT(places.covered(QRectF({100, 85}, size)), 0);
    places.addShape(QRectF(500, 500, 4, 4));  // elsewhere
}

TEST(PlotScale, RestsInADragWhileTheDataFit) {
    PlotScale scale;
    scale.fit(-100.0, 100.0);
    EXPECT_LE(scale.low, -100.0);
    EXPECT_GE(scale.high, 100.0);
    const std::pair before(scale.low, scale.high);
    scale.fit(-80.0, 80.0, true);
    EXPECT_EQ(std::pair(scale.low, scale.high), before);
    scale.fit(infinity, -infinity);  // no data
    EXPECT_EQ(std::pair(scale.low, scale.high), before);
    scale.fit(-20.0, 20.0, true);
    EXPECT_LT(scale.high, 50.0);
    // Else what was shown before does not matter.
    PlotScale other;
    other.fit(-80.0, 80.0);
    scale.fit(-100.0, 100.0);
    scale.fit(-80.0, 80.0);
    EXPECT_EQ(std::pair(scale.low, scale.high), std::pair(other.low, other.high));
}

TEST(PlotScale, KeepsToWhatIsFixed) {
    PlotScale scale;
    EXPECT_FALSE(scale.fix(1.0, 1.0));
    EXPECT_FALSE(scale.fix(0.0, infinity));
    EXPECT_TRUE(scale.fix(0.0, 10.0));
    EXPECT_FALSE(scale.fix(0.0, 10.0));
    scale.fit(-1e3, 1e3);
    EXPECT_DOUBLE_EQ(scale.low, -0.3);
    EXPECT_DOUBLE_EQ(scale.high, 10.3);
}

TEST(PlotData, AFixedAxisHoldsTheReference) {
    PlotData plot;
    PlotData reference;
    for (PlotData* each : {&plot, &reference}) {
        each->x.spec = {QStringLiteral("x"), 0.0, 1.0};
        each->curves.push_back({});
    }
    plot.left.fix(-1.0, 1.0);
    plot.curve(0).set({}, {}, plot.x, plot.left);
    reference.curve(0).set({0.0, 1.0}, {-5.0, 800.0}, reference.x, reference.left);
    plot.reference = std::make_shared<PlotData>(reference);
    plot.fitScales();
    EXPECT_LT(plot.left.low, -5.0);
    EXPECT_GT(plot.left.high, 800.0);
    plot.referenceShown = false;
    plot.fitScales();
    EXPECT_LT(plot.left.high, 2.0);
}

TEST(PlotScale, EndsWhereItsDataEnd) {
    PlotScale scale;
    for (const auto& [low, high] :
         {std::pair(-893.0, 562.0), {0.0, 1574.0}, {0.0, 5436.0}, {-0.92, 0.92}, {487.0, 651.0}}) {
        scale.fit(low, high);
        const double span = high - low;
        EXPECT_LE(scale.low, low);
        EXPECT_GE(scale.high, high);
        EXPECT_LE(scale.high - scale.low, 1.2 * span) << low << "…" << high;
        EXPECT_TRUE(low != 0.0 || scale.low == 0.0) << "nothing below 0";
    }
}

TEST(PlotScale, ZoomsAboutAPlaceAndMoves) {
    PlotScale scale;
    scale.zoom(0.5, 0.25);
    EXPECT_DOUBLE_EQ(scale.low, 0.125);
    EXPECT_DOUBLE_EQ(scale.high, 0.625);
    scale.shift(-0.25);
    EXPECT_DOUBLE_EQ(scale.low, 0.0);
    EXPECT_DOUBLE_EQ(scale.high, 0.5);
    for (int i = 0; i < 500; ++i) {
        scale.zoom(0.4, 0.7);
    }
    EXPECT_LT(scale.low, scale.high);
    for (int i = 0; i < 500; ++i) {
        scale.zoom(2.5, 0.5);
    }
    EXPECT_TRUE(scale.isHome()) << "further out there is nothing";
}

TEST(PlotScale, ReadsOutFinerThanItsInterval) {
    const QLocale english(QLocale::English);
    PlotScale scale;
    scale.high = 100.0;
    EXPECT_EQ(scale.readout(12.34567, english), QStringLiteral("12.3"));
    scale.chooseStep(400.0, 100.0);
    EXPECT_EQ(scale.tickText(50.0, english), QStringLiteral("50"));
    scale.spec.logarithmic = true;
    EXPECT_EQ(scale.readout(1e-9, english), QStringLiteral("10⁻⁹"));
}

class PlotDataTest : public ::testing::Test {
  protected:
    PlotDataTest() {
        data.x.high = 10.0;
        data.left.high = 10.0;
        data.area = QRectF(50.0, 20.0, 200.0, 100.0);
        data.curves.resize(1);
    }
    PlotCurve& curve() { return data.curves[0]; }
    bool set(Values x, Values y) {
        return curve().set(std::move(x), std::move(y), data.x, data.left);
    }
    std::optional<double> at(double x) const { return data.valueAt(data.curves[0], x); }

    PlotData data;
};

TEST_F(PlotDataTest, LeavesOutWhatHasNoPlace) {
    EXPECT_TRUE(set({0, 1, 2, 3}, {1, nan, infinity, 4}));
    EXPECT_EQ(curve().x, (Values{0, 3}));
    EXPECT_TRUE(curve().starts.empty());
    EXPECT_NEAR(*at(1.5), 2.5, 1e-12);
    EXPECT_FALSE(at(3.5).has_value());
    EXPECT_FALSE(set({0, 3, 4}, {1, 4}));  // the same, and an x too many
    EXPECT_TRUE(set({}, {}));
    EXPECT_FALSE(at(1.5).has_value());
}

TEST_F(PlotDataTest, GapsAreReadAsNothingButTheirEndsAre) {
    curve().style.gaps = true;
    set({0, 1, 2, 3, 4, 5}, {7, 7, nan, nan, 8, 8});
    EXPECT_EQ(curve().starts, (Starts{2}));
    EXPECT_EQ(at(0.5), 7.0);
    EXPECT_EQ(at(1.0), 7.0);
    EXPECT_FALSE(at(2.5).has_value());
    EXPECT_EQ(at(4.0), 8.0);
    data.thinCurves();
    ASSERT_EQ(curve().stretches.size(), 2U);
    EXPECT_EQ(curve().stretches[1].front(), data.toPixel(4.0, 8.0));
}

TEST_F(PlotDataTest, ACurveWithoutPointsIsNothingToDraw) {
    set({0, 1}, {2, 3});
    data.thinCurves();
    EXPECT_EQ(curve().stretches.size(), 1U);
    set({}, {});
    data.thinCurves();
    EXPECT_TRUE(curve().stretches.empty());
}

TEST_F(PlotDataTest, ScalesFollowTheShownCurves) {
    set({0, 1}, {-40, 60});
    data.fitScales();
    EXPECT_LE(data.left.low, -40.0);
    EXPECT_GE(data.left.high, 60.0);
    EXPECT_EQ(data.x.high, 1.0);  // as its axis says
    curve().shown = false;
    const double high = data.left.high;
    data.fitScales();
    EXPECT_EQ(data.left.high, high);
    curve().shown = true;
    curve().style.shape = plot::Shape::Bars;
    set({0, 1}, {50, 60});
    data.left.high = 1.0;
    data.fitScales();
    EXPECT_EQ(data.left.low, 0.0);  // bars stand on 0
    // Those without points bring no 0.
    data.curves.resize(2);
    set({}, {});
    data.curves[1].set({0, 1}, {500, 510}, data.x, data.left);
    data.fitScales();
    EXPECT_GT(data.left.low, 400.0);
    data.curves.pop_back();
    set({0, 1}, {50, 60});
    data.fitScales();
    data.zoomed = true;
    set({0, 1}, {500, 600});
    data.fitScales();
    EXPECT_LT(data.left.high, 100.0);
}

TEST_F(PlotDataTest, EqualScaleWidensTheAxisWithRoom) {
    data.equalise();
    EXPECT_DOUBLE_EQ(data.left.high - data.left.low, 10.0);
    EXPECT_DOUBLE_EQ(data.x.high - data.x.low, 20.0);
    EXPECT_DOUBLE_EQ(data.x.low, -5.0);
    data.equalScale = true;
    data.zoom(0.5, 1.0, data.area.center());
    EXPECT_DOUBLE_EQ(data.left.high - data.left.low, 5.0);
    EXPECT_TRUE(data.zoomed);
    data.zoom(3.0, 1.0, data.area.topLeft());
    EXPECT_DOUBLE_EQ(data.x.low, -5.0);
    EXPECT_DOUBLE_EQ(data.left.high - data.left.low, 10.0);
    EXPECT_FALSE(data.zoomed) << "all is seen again";
}

TEST_F(PlotDataTest, EqualScaleEndsWithWhatThereIsToSee) {
    struct Case {
        QSizeF data;
        QSizeF image;  ///< empty: none
        QSizeF room;
        QSizeF area;
    };
    for (const Case& each : {
             Case{{10, 10}, {}, {200, 300}, {200, 200}},
             Case{{20, 10}, {}, {600, 200}, {400, 200}},
             Case{{1, 100}, {}, {600, 200}, {100, 200}},  // room for ticks
             Case{{1, 100}, {}, {80, 200}, {80, 200}},
             Case{{10, 10}, {30, 10}, {500, 200}, {500, 200}},  // the image continues
             Case{{10, 10}, {20, 10}, {500, 200}, {400, 200}},
         }) {
        data.x.high = each.data.width();
        data.left.high = each.data.height();
        data.image = each.image.isEmpty() ? QImage() : QImage(1, 1, QImage::Format_RGB32);
        data.imageValues = QRectF({}, each.image);
        data.area = QRectF({50.0, 20.0}, each.room);
        data.endWithData();
        EXPECT_EQ(data.area, QRectF({50.0, 20.0}, each.area));
    }
}

TEST_F(PlotDataTest, AResizeThereAndBackShowsTheSameSection) {
    data.equalise();
    data.equalScale = true;
    data.zoom(0.5, 1.0, data.area.center());
    data.pan({10.0, 5.0});
    data.equalise();
    const auto shown = [&] {
        return std::array{data.x.low, data.x.high, data.left.low, data.left.high};
    };
    const auto before = shown();
    const QRectF area = data.area;
    for (const double wider : {-0.6, 0.9}) {
        data.area.setWidth(area.width() * (1.0 + wider));
        data.equalise();
        EXPECT_NE(shown(), before);
        data.area = area;
        data.equalise();
        EXPECT_EQ(shown(), before) << wider;
    }
}

TEST_F(PlotDataTest, KnowsDashesOverAWiderCurve) {
    data.curves.resize(2);
    PlotCurve& wide = data.curves[0];
    PlotCurve& dashed = data.curves[1];
    for (PlotCurve* each : {&wide, &dashed}) {
        each->set({0, 1}, {2, 3}, data.x, data.left);
    }
    wide.style.width = 2.8;
    dashed.style.width = 1.4;
    data.thinCurves();
    EXPECT_FALSE(data.liesOnAnother(dashed));
    dashed.style.role = Role::Engine;
    EXPECT_TRUE(data.liesOnAnother(dashed));
    EXPECT_FALSE(data.liesOnAnother(wide));
    wide.shown = false;
    EXPECT_FALSE(data.liesOnAnother(dashed));
}

TEST_F(PlotDataTest, ReadsTheNearestPointAndStepsInARound) {
    EXPECT_FALSE(data.readsPoints());
    set({1, 5, 9}, {1, 5, 9});
    EXPECT_FALSE(data.nextPoint(1).has_value());
    curve().text = [](std::size_t) { return QStringLiteral("a"); };
    EXPECT_TRUE(data.readsPoints());
    EXPECT_EQ(data.nearestPoint(data.toPixel(5, 5) + QPointF(3, 4)), PlotData::Point(0, 1));
    EXPECT_FALSE(data.nearestPoint(data.toPixel(1, 9)).has_value());
    for (const std::size_t expected : {0U, 1U, 2U, 0U}) {
        data.pointRead = data.nextPoint(1);
        EXPECT_EQ(data.pointRead, PlotData::Point(0, expected));
    }
    EXPECT_EQ(data.nextPoint(-1), PlotData::Point(0, 2));
}

TEST_F(PlotDataTest, ReadsTheBarThatIsUnderTheCursor) {
    data.curves.resize(2);
    for (const double shift : {-0.1, 0.1}) {
        PlotCurve& bars = data.curves[shift < 0.0 ? 0 : 1];
        bars.style.shape = plot::Shape::Bars;
        bars.style.barWidth = 0.18;
        bars.style.barShift = shift;
        bars.set({0.5, 1.0, 1.5}, {144.7 + shift, 158.8 + shift, 112.0}, data.x, data.left);
    }
    for (const double at : {0.82, 0.87, 1.0, 1.18}) {
        EXPECT_EQ(data.barsAt(at), 1.0) << at;
        EXPECT_EQ(data.valueAt(data.curves[0], at), 158.8 - 0.1) << at;
    }
    EXPECT_EQ(data.barsAt(0.41), 0.5);
    EXPECT_FALSE(data.barsAt(2.0).has_value());
    EXPECT_FALSE(data.valueAt(data.curves[0], 0.1).has_value());
    data.cursorX = 0.87;
    EXPECT_EQ(data.readX(), 1.0);
    // Beside a line it reads where it stands.
    data.curves[1].style.shape = plot::Shape::Line;
    EXPECT_EQ(data.readX(), 0.87);
}

TEST_F(PlotDataTest, ReadsThePathOfAVectorWithItsAngle) {
    set({1, 5, 9, 5, 1}, {5, 9, 5, 1, 5});
    EXPECT_FALSE(data.readsPoints());
    curve().style.turn = 360.0;
    EXPECT_TRUE(data.readsPoints());
    EXPECT_EQ(data.nearestPoint(data.toPixel(5, 9) + QPointF(3, 4)), PlotData::Point(0, 1));
    EXPECT_EQ(curve().angleOf(1), 90.0);
    EXPECT_EQ(curve().angleOf(4), 360.0);
}

TEST_F(PlotDataTest, CsvHoldsTheReferenceThatIsDrawn) {
    set({1, 2}, {3, 4});
    curve().style.name = QStringLiteral("M");
    PlotData before = data;
    before.curve(0).set({1, 1.5}, {7, 8}, before.x, before.left);
    data.reference = std::make_shared<PlotData>(before);
    data.referenceName = QStringLiteral("A");
    const QStringList rows = data.csv(CsvFormat(QLocale::c())).split(QLatin1Char('\n'));
    ASSERT_GE(rows.size(), 4);
    EXPECT_TRUE(rows[0].endsWith(QStringLiteral(",\"M\",\"A: M\""))) << rows[0].toStdString();
    EXPECT_EQ(rows[1], QStringLiteral("1,3,7"));
    EXPECT_EQ(rows[2], QStringLiteral("1.5,,8"));
    EXPECT_EQ(rows[3], QStringLiteral("2,4,"));
    data.referenceShown = false;
    EXPECT_FALSE(data.csv(CsvFormat(QLocale::c())).contains(QStringLiteral("A:")));
}

TEST(ThinPolyline, DropsOnlyWhatMovesNoPixel) {
    std::vector<QPointF> points;
    for (int i = 0; i <= 720; ++i) {
        points.emplace_back(i, 120.0 * std::sin(i * 3.14159265358979 / 180.0));
    }
    const QPolygonF thinned = thinPolyline(points, 0.25);
    EXPECT_LT(thinned.size(), 200);
    EXPECT_GT(thinned.size(), 20);
    // Every dropped point lies within a quarter pixel of the line that remains.
    qsizetype segment = 0;
    for (const QPointF& p : points) {
        while (thinned[segment + 1].x() < p.x()) {
            ++segment;
        }
        const QPointF a = thinned[segment];
        const QPointF d = thinned[segment + 1] - a;
        const double distance =
            std::abs(d.x() * (p.y() - a.y()) - d.y() * (p.x() - a.x())) / std::hypot(d.x(), d.y());
        EXPECT_LE(distance, 0.25 + 1e-12);
    }
}

TEST(ThinPolyline, HandlesFewAndEqualPoints) {
    EXPECT_TRUE(thinPolyline({}).empty());
    EXPECT_EQ(thinPolyline({{1, 1}}).size(), 1);
    EXPECT_EQ(thinPolyline({{1, 1}, {1, 1}, {1, 1}}).size(), 2);
    // A closed curve keeps its far side.
    EXPECT_EQ(thinPolyline({{0, 0}, {10, 0}, {10, 10}, {0, 0}}).size(), 4);
    // A line to and fro keeps both of its ends.
    const QRectF ends =
        thinPolyline({{0, 0}, {-5, 0}, {-10, 0}, {0, 0}, {10, 0}, {0, 0}}).boundingRect();
    EXPECT_EQ(ends.left(), -10);
    EXPECT_EQ(ends.right(), 10);
}

}  // namespace
}  // namespace ravnoves

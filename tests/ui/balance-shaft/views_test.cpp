#include <gtest/gtest.h>

#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "balance-shaft/balance_shaft_page.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/speed_study_model.h"
#include "balance-shaft/solver.h"
#include "balance-shaft/torque_source_editor.h"
#include "case-file/decimal.h"
#include "comes.h"
#include "model/background_job.h"
#include "page_fixture.h"
#include "text/message_text.h"
#include "theme/theme.h"

namespace ravnoves {
namespace {

using By = BalanceShaftModel::Criterion;

class BalanceShaftViewsTest : public test::PageTest<BalanceShaftPage> {
  protected:
    void waitForStudy() {
        QTRY_VERIFY_WITH_TIMEOUT(!model->speedStudy()->job()->isRunning(), 20000);
    }
    QString answer() const { return model->speedStudy()->answer(); }
};

TEST_F(BalanceShaftViewsTest, OfThreeSizesOfTheShaftOneIsFound) {
    bring("relieved");
    const auto shaft = [this] { return model->result().relieved_shaft; };
    // At first a half disc, that of the map.
    EXPECT_TRUE(field("depth_mm")->text().isEmpty());
    EXPECT_FALSE(field("depth_mm")->placeholderText().isEmpty());
    EXPECT_FALSE(model->input().relieved_shaft);
    // A bar that is surely thick enough.
    type("diameter_mm", QStringLiteral("80"));
    ASSERT_TRUE(shaft().feasible) << shaft().reason.english();
    // What was found becomes what is given.
    type("length_mm", QStringLiteral("400"));
    // One of two that are given cannot be blank; of three any can, and is found.
    const double depth = shaft().depth;
    blank("length_mm");
    EXPECT_FALSE(field("length_mm")->trouble().isEmpty());
    EXPECT_TRUE(model->input().relieved_shaft->length);
    type("length_mm", QStringLiteral("400"));
    type("depth_mm", QString::number(depth / units::mm, 'g', 17));
    blank("length_mm");
    EXPECT_FALSE(model->input().relieved_shaft->length);
    EXPECT_NEAR(*model->input().relieved_shaft->depth, depth, 1e-12);
    EXPECT_NEAR(shaft().length, 0.4, 1e-6);
    EXPECT_EQ(field("length_mm")->placeholderText(), QStringLiteral("auto\u00a0400"));
    // One that was rejected blank is read once the third is given, as a step of its own.
    blank("diameter_mm");
    EXPECT_FALSE(field("diameter_mm")->trouble().isEmpty());
    type("length_mm", QStringLiteral("395"));
    EXPECT_TRUE(test::comes([&] { return !model->input().relieved_shaft->diameter; }));
    EXPECT_EQ(field("diameter_mm")->trouble(), QString());
    EXPECT_NE(shaft().diameter, 0.08);
    EXPECT_EQ(field("diameter_mm")->placeholderText(),
              QStringLiteral("auto\u00a0") +
                  QString::number(rounded_to_digits(shaft().diameter / units::mm, 6)));
    model->undo();
    EXPECT_NEAR(*model->input().relieved_shaft->diameter, 0.08, 1e-12);
    EXPECT_NEAR(*model->input().relieved_shaft->length, 0.395, 1e-12);
}

TEST_F(BalanceShaftViewsTest, TheFlywheelAnswersForInertiaAndForFluctuation) {
    const PlotView* plot = bringPlot("energy");
    EXPECT_FALSE(model->input().flywheel);
    type("inertia_kg_m2", QStringLiteral("0.4"));
    EXPECT_DOUBLE_EQ(*model->input().flywheel->inertia, 0.4);
    const double found = *model->result().flywheel.fluctuation;
    EXPECT_GT(found, 0.0);
    type("fluctuation", QStringLiteral("0.01"));
    EXPECT_FALSE(model->input().flywheel->inertia);
    EXPECT_TRUE(field("inertia_kg_m2")->text().isEmpty());
    EXPECT_NEAR(*model->result().flywheel.inertia, 0.4 * found / 0.01, 1e-9);
    // The extremes of the curve are those of the result.
    const auto& wheel = model->result().flywheel;
    EXPECT_NEAR(*plot->valueAt(0, std::round(wheel.max_angle / degree)), wheel.max_energy,
                0.01 * wheel.excess_work);
    blank("fluctuation");
    EXPECT_FALSE(model->input().flywheel);
    EXPECT_EQ(std::get<Results>(model->part("flywheel")).rows.size(), 6);
}

TEST_F(BalanceShaftViewsTest, ATwoStrokeHasPlotsOfOneTurn) {
    model->setTorqueKind(balance_shaft::TorqueSource::Kind::cycle);
    choose("strokes", 0);
    EXPECT_EQ(model->input().strokes, 2);
    EXPECT_EQ(partPlot(page, "moments")->data().x.interval().second, 360.0);
    EXPECT_EQ(bringPlot("energy")->data().x.interval().second, 360.0);
    model->crank()->turnTo(400.0);
    EXPECT_EQ(model->crank()->degrees(), 40.0);
    EXPECT_FALSE(bringPlot("orders")->valueAt(1, 0.4)) << "half orders are of four strokes";
    // The table brings its own cycle back.
    EXPECT_EQ(model->setTorqueKind(balance_shaft::TorqueSource::Kind::table), QString());
    EXPECT_EQ(model->input().strokes, 4);
    EXPECT_EQ(bringPlot("moments")->data().x.interval().second, 720.0);
}

TEST_F(BalanceShaftViewsTest, AToothOutShowsInTheMoment) {
    const PlotView* plot = bringPlot("gear-moment");
    type("shifted_teeth", QStringLiteral("1"));
    EXPECT_EQ(model->input().gears.shifted_teeth, 1);
    const auto at100 = [&](const char* curve) {
        return *plot->valueAt(static_cast<int>(*plot->data().find(curve)), 100.0);
    };
    const double right = at100("right");
    const double wrong = at100("wrong");
    const double amplitude = model->result().moment_amplitude;
    const double alpha = model->input().shaft_angle;
    EXPECT_NEAR(wrong - right,
                amplitude * (std::sin(alpha + 109.0 * degree) - std::sin(alpha + 100.0 * degree)),
                1e-6 * amplitude);
}

TEST_F(BalanceShaftViewsTest, TheBandOfSpeedsIsAForm) {
    bring("speed");
    EXPECT_FALSE(model->input().speed_band);
    type("to_rpm", QStringLiteral("500"));  // below the other end
    EXPECT_FALSE(model->input().speed_band);
    EXPECT_FALSE(field("to_rpm")->trouble().isEmpty());
    type("to_rpm", QStringLiteral("5000"));
    ASSERT_TRUE(model->input().speed_band);
    EXPECT_NEAR(model->input().speed_band->to / units::rpm, 5000.0, 1e-9);
    EXPECT_NEAR(model->input().speed_band->from, 0.3 * model->input().angular_speed, 1e-9);
    EXPECT_EQ(field("to_rpm")->trouble(), QString());
    model->history()->undo();
    EXPECT_FALSE(model->input().speed_band);
    EXPECT_NEAR(*field("from_rpm")->value(), 0.3 * model->input().angular_speed / units::rpm, 1e-3);
}

TEST_F(BalanceShaftViewsTest, SpeedStudyIsSolvedInTheBackground) {
    // The printed table cannot be computed to its masses: the page says so instead of a curve.
    PartPlot* angles = bringPlot("best-angles");
    PartPlot* map = partPlot(page, "speed-map");
    waitForStudy();
    EXPECT_TRUE(answer().contains(QStringLiteral("cannot be computed"))) << answer().toStdString();
    // A computed cycle follows the speed.
    model->setTorqueKind(balance_shaft::TorqueSource::Kind::cycle);
    waitForStudy();
    EXPECT_TRUE(answer().contains(QStringLiteral("Best compromise"))) << answer().toStdString();
    const double speed = model->input().angular_speed / units::rpm;
    const auto best = angles->valueAt(1, speed);
    ASSERT_TRUE(best.has_value());
    // Between the band's speeds the curve is a straight line; the optimum is flat.
    EXPECT_NEAR(*best, *model->best(By::rms).shaft_angle / degree, 0.5);
    // What cannot be built is shaded along α, which runs upwards in one plot.
    const auto& stretch = model->result().buildable.stretches.at(0);
    for (const PlotView* plot : {angles, map}) {
        ASSERT_EQ(plot->data().bands.size(), 2U);
        EXPECT_NEAR(plot->data().bands[0].to, stretch.from / degree, 1e-9);
    }
    EXPECT_EQ(angles->data().bands[0].orientation, Qt::Vertical);
    EXPECT_TRUE(answer().contains(QStringLiteral("does not fit"))) << answer().toStdString();
    // A click into the map sets the angle.
    QTRY_VERIFY_WITH_TIMEOUT(map->plotArea().contains(map->toPixel(200.0, speed)), 5000);
    QTest::mouseClick(map, Qt::LeftButton, {}, map->toPixel(200.0, speed).toPoint());
    EXPECT_NEAR(model->shaftAngleDeg(), 200.0, 3.0);
    // Where no α is feasible, none is offered.
    press("go_best_compromise");
    const double offered = model->shaftAngleDeg();
    EXPECT_NEAR(offered, model->speedStudy()->bestCompromiseDeg(), 1e-9);
    type("clearance_mm", QStringLiteral("50"));
    waitForStudy();
    EXPECT_TRUE(answer().contains(QStringLiteral("No position is feasible")));
    press("go_best_compromise");
    EXPECT_EQ(model->shaftAngleDeg(), offered);
    EXPECT_EQ(find<QPushButton>("go_best_compromise")->toolTip(),
              messageText(model->speedStudy()->buildable().reason));
}

TEST_F(BalanceShaftViewsTest, AnEmptySpeedMapHasItsRemedyBesideIt) {
    bring("speed");
    const PlotView* map = partPlot(page, "speed-map");
    const QString empty = map->title();
    waitForStudy();
    auto* rebuild = find<QPushButton>("rebuild_torque_here");
    ASSERT_TRUE(rebuild->isVisible());
    EXPECT_FALSE(answer().contains(QStringLiteral("below")));
    QTest::mouseClick(rebuild, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!model->speedStudy()->job()->isRunning() && !rebuild->isVisible(),
                             20000);
    EXPECT_TRUE(answer().contains(QStringLiteral("Best compromise"))) << answer().toStdString();
    EXPECT_NE(map->title(), empty);
    // The rebuilt numbers are shown shorter than they are.
    const QAbstractItemModel* table = page.findChild<TorqueTableEditor*>()->view()->model();
    for (int row = 0; row < table->rowCount(); ++row) {
        // A sign, a point, 6 digits, and zeros or an exponent.
        EXPECT_LE(table->index(row, 1).data(Qt::DisplayRole).toString().size(), 12);
    }
    EXPECT_GT(table->index(1, 1).data(Qt::EditRole).toString().size(), 10);
    // An empty map says nothing about its values.
    model->history()->undo();
    QTRY_VERIFY_WITH_TIMEOUT(!model->speedStudy()->job()->isRunning() && rebuild->isVisible(),
                             20000);
    EXPECT_EQ(map->title(), empty);
}

TEST_F(BalanceShaftViewsTest, TheSpeedMapSaysWhereTheShaftHelps) {
    model->setTorqueKind(balance_shaft::TorqueSource::Kind::cycle);
    PartPlot* plot = bringPlot("speed-map");
    waitForStudy();
    // Along the line of no change the shaft changes nothing: the solver's own answer at its points.
    const ChangeContours& map = model->speedStudy()->map();
    const auto none = std::find_if(map.contours.begin(), map.contours.end(),
                                   [](const auto& contour) { return contour.level == 0.0; });
    ASSERT_NE(none, map.contours.end());
    ASSERT_FALSE(none->lines.empty());
    const QPolygonF& border = none->lines.front();
    const QPointF place = border[border.size() / 2];
    balance_shaft::Input input = model->input();
    input.angular_speed = place.y() * units::rpm;
    input.shaft_angle = place.x() * degree;
    const balance_shaft::Result there = balance_shaft::solve(input);
    EXPECT_NEAR(there.M_ups.range / there.M_up.range, 1.0, 0.01);
    // The pointer reads α, speed and value.
    QString words;
    ASSERT_TRUE(test::pointUntil(
        plot, [&] { return plot->toPixel(90.0, model->input().angular_speed / units::rpm); },
        [&] {
            words = QToolTip::text();
            return words.startsWith(QStringLiteral("α "));
        }))
        << words.toStdString();
    EXPECT_TRUE(words.contains(QStringLiteral("min⁻¹")));
    EXPECT_TRUE(words.contains(QStringLiteral("better")) ||
                words.contains(QStringLiteral("worse")));
    EXPECT_GT(plot->dataAsCsv().count(QLatin1Char('\n')), 360);
}

TEST_F(BalanceShaftViewsTest, SizeFollowsTheShaft) {
    PartPlot* sizes = bringPlot("sizes");
    PartPlot* range = partPlot(page, "range-over-size");
    EXPECT_EQ(sizes->data().bands.size(), 2U);
    EXPECT_EQ(range->data().curve(1).style.name, QStringLiteral("feasible"));
    model->setShaftAngleDeg(90.0);
    EXPECT_NEAR(*sizes->valueAt(0, 90.0), 1e3 * model->result().envelope.width(), 1e-6);
    QTest::mouseClick(
        sizes, Qt::LeftButton, {},
        QPoint(sizes->toPixel(180.0, 0.0).toPoint().x(), sizes->plotArea().center().toPoint().y()));
    EXPECT_NEAR(model->shaftAngleDeg(), 180.0, 1.0);
    // A click into the other one goes to the α whose point lies there.
    const PlotCurve& all = range->data().curves[*range->data().find("all")];
    const QPointF place = range->toPixel(all.x[100], all.y[100]);
    QTest::mouseClick(range, Qt::LeftButton, {}, place.toPoint());
    const PlotCurve& present = range->data().curves[*range->data().find("present")];
    EXPECT_LT(QLineF(range->toPixel(present.x[0], present.y[0]), place).length(), 3.0);
    EXPECT_NE(model->shaftAngleDeg(), 180.0);
}

TEST_F(BalanceShaftViewsTest, RemediesMakeTheTorqueFit) {
    ASSERT_EQ(model->result().inertia_check.consistent, false);
    bring(page.findChild<TorqueSourceEditor*>());
    press("use_matching_speed");
    EXPECT_EQ(model->result().inertia_check.consistent, true);
    EXPECT_NEAR(model->input().angular_speed / units::rpm, 2600.0, 30.0);
    model->history()->undo();
    ASSERT_EQ(model->result().inertia_check.consistent, false);
    press("rebuild_torque");
    EXPECT_EQ(model->result().inertia_check.consistent, true);
    EXPECT_NEAR(model->input().angular_speed, 376.8, 1e-9);
}

}  // namespace
}  // namespace ravnoves

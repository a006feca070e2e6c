#include "balance-shaft/model/balance_shaft_model.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <algorithm>
#include <cmath>

#include "balance-shaft/model/speed_study_model.h"
#include "case-file/json.h"
#include "events.h"
#include "model/background_job.h"
#include "model/input_differences.h"
#include "part_tests.h"

namespace ravnoves {
namespace {

using By = BalanceShaftModel::Criterion;

using test::curveOf;
using test::figureOf;

TEST(BalanceShaftModel, AShaftBeyondTheCircleMovesAsFarAsItsSliderGoes) {
    BalanceShaftModel model;
    for (const auto& [given, moved] : {std::pair(380.0, 375.0), std::pair(-20.0, -10.0)}) {
        Json input = model.inputJson();
        input["shaft_angle_deg"] = given;
        model.loadInput(input, {});
        model.setShaftAngleDeg(moved);
        EXPECT_DOUBLE_EQ(model.shaftAngleDeg(), moved);
        model.setShaftAngleDeg(given);
        EXPECT_DOUBLE_EQ(model.shaftAngleDeg(), moved) << "no farther than it was";
    }
    model.setShaftAngleDeg(100.0);
    model.setShaftAngleDeg(-5.0);
    EXPECT_EQ(model.shaftAngleDeg(), 0.0);
}

// Its slider has the label, the field itself has none.
TEST(BalanceShaftModel, AnAngleThatDiffersHasItsUnit) {
    BalanceShaftModel model;
    const Json before = model.inputJson();
    model.setShaftAngleDeg(240.0);
    const auto differences = inputDifferences(model, before);
    ASSERT_EQ(differences.size(), 1u);
    EXPECT_EQ(differences[0].unit, QStringLiteral("°"));
    const auto numbers = inputNumbers(model);
    const auto angle = std::find_if(numbers.begin(), numbers.end(), [](const InputNumber& each) {
        return each.pointer == "/shaft_angle_deg";
    });
    ASSERT_NE(angle, numbers.end());
    EXPECT_EQ(angle->unit, QStringLiteral("°"));
}

TEST(BalanceShaftModel, MovingTheShaftFollowsEverywhere) {
    BalanceShaftModel model;
    QSignalSpy moved(&model, &SceneModel::shownChanged);
    QSignalSpy changed(&model, &SceneModel::changed);
    model.setShaftAngleDeg(240.0);
    EXPECT_EQ(moved.size(), 1);
    EXPECT_EQ(changed.size(), 0);
    EXPECT_NEAR(model.result().M_ups.range, 1821.0, 1.0);
    // The best α that can be built leads; the paper's 50.65° and 11.76° cannot be.
    model.goToBest(By::range);
    EXPECT_EQ(model.shaftAngleDeg(), *model.result().best_range_buildable.shaft_angle / degree);
    EXPECT_TRUE(model.result().is_buildable);
    EXPECT_TRUE(model.bestText(By::range).contains(
        QStringLiteral("50.65° would give 43.1\u00A0N·m less but does not fit")))
        << model.bestText(By::range).toStdString();
    model.goToBest(By::rms);
    EXPECT_EQ(model.shaftAngleDeg(), *model.result().best_rms_buildable.shaft_angle / degree);
    EXPECT_TRUE(model.bestText(By::rms).contains(QStringLiteral("11.76° would give")));
    // No word of what rounds to nothing.
    model.setByKey(QStringLiteral("envelope/clearance_mm"), QStringLiteral("0"));
    const QString less = QStringLiteral(" 0.0\u00A0N·m less");
    EXPECT_FALSE(model.bestText(By::range).contains(less));
    EXPECT_FALSE(model.bestText(By::rms).contains(less));
    // Where nothing can be built, the best of all is shown and said to be that.
    model.setByKey(QStringLiteral("envelope/clearance_mm"), QStringLiteral("50"));
    model.goToBest(By::range);
    EXPECT_NEAR(model.shaftAngleDeg(), 50.65, 0.05);
    EXPECT_NEAR(model.result().M_ups.range, 1066.75, 0.1);
    EXPECT_TRUE(
        model.bestText(By::range).endsWith(QStringLiteral("but at this l no α is feasible")));
    for (const char* part : {"best-range", "best-rms"}) {
        const auto lines = std::get<Notes>(model.part(part)).lines;
        ASSERT_EQ(lines.size(), 1U) << "the report says no line twice";
        EXPECT_TRUE(lines[0].second.endsWith(QStringLiteral("no α is feasible"))) << part;
    }
    EXPECT_TRUE(model.notesText().contains(QStringLiteral("No feasible position")));
    model.goToBest(By::rms);
    EXPECT_NEAR(model.shaftAngleDeg(), 11.76, 0.05);
}

TEST(BalanceShaftModel, AChangeSaysWhetherItIsBetter) {
    BalanceShaftModel model;
    model.setShaftAngleDeg(50.65);
    const auto& result = model.result();
    ASSERT_LT(*result.range_change, 0.0);
    ASSERT_GT(*result.rms_change, 0.0);
    const auto rows = model.criteria().rows;
    EXPECT_TRUE(rows[0].last().text.endsWith(QStringLiteral("better")))
        << rows[0].last().text.toStdString();
    EXPECT_TRUE(rows[1].last().text.endsWith(QStringLiteral("worse")));
    // A minimum that rises is one nearer to zero.
    ASSERT_LT(result.M_up.min, result.M_ups.min);
    EXPECT_TRUE(rows[4].last().text.endsWith(QStringLiteral("better")));
    EXPECT_FALSE(rows[2].last().text.contains(QStringLiteral("better")));
}

TEST(SpeedStudyModel, ACancelledOneOffersNoneOfTheInputBefore) {
    BalanceShaftModel model;
    model.setTorqueKind(balance_shaft::TorqueSource::Kind::cycle);
    SpeedStudyModel& study = *model.speedStudy();
    study.setBand(&balance_shaft::SpeedBand::from, 2000.0 * units::rpm);
    model.edit(QStringLiteral("coarse"), [](auto& input) { input.speed_band->speeds = 5; });
    study.need();
    ASSERT_TRUE(test::comes([&] { return !study.job()->isRunning(); }));
    ASSERT_TRUE(study.isSolved());
    model.edit(QStringLiteral("longer"), [](auto& input) { input.crank_radius *= 1.1; });
    study.need();
    study.cancel();
    EXPECT_FALSE(study.isSolved());
    EXPECT_TRUE(study.answer().startsWith(QStringLiteral("Cancelled")))
        << qPrintable(study.answer());
    model.undo();
    study.need();
    ASSERT_TRUE(test::comes([&] { return !study.job()->isRunning(); }));
    EXPECT_TRUE(study.isSolved());
}

TEST(SpeedStudyModel, AnswersForTheInputThatIsThere) {
    BalanceShaftModel model;
    model.setTorqueKind(balance_shaft::TorqueSource::Kind::cycle);
    SpeedStudyModel& study = *model.speedStudy();
    study.setBand(&balance_shaft::SpeedBand::from, 2000.0 * units::rpm);
    study.setBand(&balance_shaft::SpeedBand::to, 4000.0 * units::rpm);
    model.edit(QStringLiteral("coarse"), [](auto& input) { input.speed_band->speeds = 5; });
    EXPECT_FALSE(study.isSolved());
    EXPECT_EQ(study.answer(), QString());
    const auto solve = [&] {
        study.need();
        return test::comes([&] { return !study.job()->isRunning(); });
    };
    ASSERT_TRUE(solve());
    ASSERT_TRUE(study.isSolved());
    const auto points = study.points();
    ASSERT_EQ(points.size(), 5U);
    EXPECT_NEAR(points.front().angular_speed, 2000.0 * units::rpm, 1e-9);
    EXPECT_NEAR(points.back().angular_speed, 4000.0 * units::rpm, 1e-9);
    // The map is the criterion against the engine without a shaft: solved alone at one place.
    const ChangeContours map = study.map();  // a copy: it goes with the criterion
    ASSERT_EQ(map.changes.size(), 5U * map.columns);
    auto input = model.input();
    input.angular_speed = points[2].angular_speed;
    const balance_shaft::Solver alone(input);
    const double change = alone.range(100.0 * degree) / alone.result().M_up.range - 1.0;
    EXPECT_NEAR(map.changes[2 * map.columns + 100], change, 1e-9);
    EXPECT_NEAR(study.changeAt(100.0, points[2].angular_speed / units::rpm), change, 1e-9);
    for (std::size_t row = 0; row < 5; ++row) {  // 360° is 0°
        EXPECT_EQ(map.changes[row * map.columns], map.changes[(row + 1) * map.columns - 1]);
    }
    study.goToBestCompromise();
    EXPECT_NEAR(model.shaftAngleDeg(), study.bestCompromiseDeg(), 1e-9);
    const QString answer = study.answer();
    model.setCriterion(By::rms);
    EXPECT_NE(study.answer(), answer);
    EXPECT_NE(study.map().changes, map.changes);
    model.setCriterion(By::range);

    // The shaft's angle solves nothing again; neither does an input that comes back meanwhile.
    model.setShaftAngleDeg(10.0);
    study.need();
    EXPECT_FALSE(study.job()->isRunning());
    study.setBand(&balance_shaft::SpeedBand::to, 5000.0 * units::rpm);
    study.need();
    EXPECT_TRUE(study.job()->isRunning());
    model.history()->undo();
    ASSERT_TRUE(solve());
    EXPECT_NEAR(study.points().back().angular_speed, 4000.0 * units::rpm, 1e-9);
    EXPECT_EQ(study.answer(), answer);

    // A table that does not fit its masses: a reason, and nothing to show.
    model.setTorqueKind(balance_shaft::TorqueSource::Kind::table);
    ASSERT_TRUE(solve());
    EXPECT_FALSE(study.isSolved());
    EXPECT_TRUE(study.answer().contains(QStringLiteral("cannot be computed")));
}

TEST(BalanceShaftParts, LociAreThoseOfTheRows) {
    BalanceShaftModel model;
    model.editField("/crank_share", 0.3, QStringLiteral("share"));
    const Figure figure = figureOf(model, "force-locus");
    double across = 0.0;
    double along = 0.0;
    for (const Figure::Curve& locus : figure.curves) {
        for (std::size_t i = 0; i < locus.x.size(); ++i) {
            if (locus.id == "first") {
                across = std::max(across, std::abs(locus.x[i]));
                along = std::max(along, std::abs(locus.y[i]));
            }
            EXPECT_LE(std::abs(locus.x[i]), figure.x.max);
            EXPECT_GE(locus.y[i], figure.leftRange->first);
            EXPECT_LE(locus.y[i], figure.leftRange->second);
        }
    }
    const double force = model.result().inertia_force_1_max / 1000.0;
    EXPECT_NEAR(across, 0.3 * force, 1e-3 * force);
    EXPECT_NEAR(along, 0.7 * force, 1e-3 * force);
    for (const char* table : {"forces", "gears"}) {
        EXPECT_EQ(std::get<Results>(model.part(table)).rows.size(), 6) << table;
    }
}

TEST(BalanceShaftParts, AreInTheUnitsOfTheirAxes) {
    BalanceShaftModel model;
    EXPECT_TRUE(figureOf(model, "torque").curves.empty());
    EXPECT_TRUE(figureOf(model, "indicator").curves.empty());
    EXPECT_TRUE(model.replacedInputs().empty());
    model.setTorqueKind(balance_shaft::TorqueSource::Kind::cycle);
    EXPECT_EQ(model.replacedInputs(), std::vector<std::string>{"/interpolation"});
    const auto& curves = model.result().curves;
    const Figure torque = figureOf(model, "torque");
    const std::vector<double>& total = curveOf(torque, "total").y;
    for (std::size_t i = 0; i < curves.M_gas.size(); i += 7) {
        EXPECT_NEAR(total[i], curves.M_gas[i] + curves.M_inertia[i], 1e-9);
    }
    const Figure indicator = figureOf(model, "indicator");
    EXPECT_EQ(indicator.curves[0].id, "loop");
    EXPECT_NEAR(indicator.curves[0].y[100], curves.pressure[100] / 1e5, 1e-12);
    EXPECT_EQ(figureOf(model, "pressure").curves[0].y, indicator.curves[0].y);
    // As a trace is drawn, without the clearance volume.
    EXPECT_NEAR(indicator.x.max / 1.03 * 1e-6, model.result().indicated->displacement, 1e-9);
}

}  // namespace
}  // namespace ravnoves

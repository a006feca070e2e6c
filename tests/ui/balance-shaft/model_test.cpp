#include "balance-shaft/model/balance_shaft_model.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "balance-shaft/model/relieved_shaft_model.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "example_check.h"
#include "scenes/scenes.h"

namespace ravnoves {
namespace {

TEST(BalanceShaftModel, ShowsWhatTheCommandLinePrints) {
    BalanceShaftModel model;
    model.setShaftAngleDeg(45.0);
    const CaseFile file{"balance-shaft", "", model.inputJson()};
    EXPECT_EQ(model.resultJson(), solve_case(file, {}).at("result"));
}

TEST(BalanceShaftModel, MovingTheShaftFollowsEverywhere) {
    BalanceShaftModel model;
    QSignalSpy moved(&model, &BalanceShaftModel::shaftMoved);
    QSignalSpy changed(&model, &SceneModel::changed);
    model.setShaftAngleDeg(240.0);
    EXPECT_EQ(moved.size(), 1);
    EXPECT_EQ(changed.size(), 0);
    EXPECT_NEAR(model.result().M_ups.range, 1821.0, 1.0);
    // The best α that can be built leads; the paper's 50.65° and 11.76° cannot be.
    model.goToBestRange();
    EXPECT_EQ(model.shaftAngleDeg(), *model.result().best_range_buildable.shaft_angle / degree);
    EXPECT_TRUE(model.result().is_buildable);
    EXPECT_TRUE(model.bestRangeText().contains(QStringLiteral("43.1 N·m less at 50.65° cannot be built")))
        << model.bestRangeText().toStdString();
    model.goToBestRms();
    EXPECT_EQ(model.shaftAngleDeg(), *model.result().best_rms_buildable.shaft_angle / degree);
    EXPECT_TRUE(model.bestRmsText().contains(QStringLiteral("at 11.76°")));
    // Where nothing can be built, the best of all is shown and said to be that.
    model.setByKey(QStringLiteral("envelope/clearance_mm"), QStringLiteral("50"));
    model.goToBestRange();
    EXPECT_NEAR(model.shaftAngleDeg(), 50.65, 0.05);
    EXPECT_NEAR(model.result().M_ups.range, 1066.75, 0.1);
    EXPECT_TRUE(model.bestRangeText().endsWith(QStringLiteral("but nothing can be built")));
    EXPECT_TRUE(model.notesText().contains(QStringLiteral("Nothing can be built")));
    model.goToBestRms();
    EXPECT_NEAR(model.shaftAngleDeg(), 11.76, 0.05);
}

TEST(BalanceShaftModel, ADragIsOneStepOfTheHistory) {
    BalanceShaftModel model;
    const double before = model.shaftAngleDeg();
    for (int i = 0; i < 50; ++i) {
        model.setShaftAngleDeg(100.0 + i);
    }
    model.finishDrag();
    model.setShaftAngleDeg(10.0);
    EXPECT_EQ(model.history()->count(), 2);
    model.history()->undo();
    EXPECT_NEAR(model.shaftAngleDeg(), 149.0, 1e-9);
    model.history()->undo();
    EXPECT_NEAR(model.shaftAngleDeg(), before, 1e-9);
    model.history()->redo();
    EXPECT_NEAR(model.shaftAngleDeg(), 149.0, 1e-9);
}

TEST(BalanceShaftModel, RefusesInWordsAndKeepsTheOldInput) {
    BalanceShaftModel model;
    const Json before = model.inputJson();
    QSignalSpy refused(&model, &BalanceShaftModel::refused);
    const QString why =
        model.edit(QStringLiteral("radius"), [](auto& input) { input.crank_radius = -1.0; });
    EXPECT_TRUE(why.contains(QStringLiteral("Crank radius"))) << why.toStdString();
    EXPECT_EQ(refused.size(), 1);
    EXPECT_EQ(model.inputJson(), before);
    EXPECT_EQ(model.history()->count(), 0);
    EXPECT_THROW(model.loadInput(Json{{"speed_rpm", 1}}, {}), InputError);
    EXPECT_EQ(model.inputJson(), before);
}

TEST(BalanceShaftModel, SetsValuesByTheirKeys) {
    BalanceShaftModel model;
    model.setByKey(QStringLiteral("centre_distance_mm"), QStringLiteral("120"));
    EXPECT_NEAR(model.input().centre_distance, 0.12, 1e-12);
    model.setByKey(QStringLiteral("reciprocating_masses_kg/pin"), QStringLiteral("0.3"));
    EXPECT_NEAR(model.mass("pin"), 0.3, 1e-12);
    model.setByKey(QStringLiteral("crank_angle_deg"), QStringLiteral("370"));
    EXPECT_NEAR(model.crankAngleDeg(), 370.0, 1e-12);
    EXPECT_THROW(model.setByKey(QStringLiteral("crank_radus_mm"), QStringLiteral("1")), InputError);
    EXPECT_THROW(model.setByKey(QStringLiteral("means"), QStringLiteral("x")), InputError);
}

TEST(BalanceShaftModel, TablesHoldNoEmptyCells) {
    BalanceShaftModel model;
    for (const auto& rows : {model.criteriaRows(), model.quantityRows()}) {
        for (const QStringList& row : rows) {
            for (const QString& cell : row) {
                EXPECT_FALSE(cell.isEmpty());
                EXPECT_FALSE(cell.contains(QStringLiteral("nan"))) << cell.toStdString();
            }
        }
    }
}

TEST(RelievedShaftModel, FindsOneSizeOfThree) {
    using Sized = RelievedShaftModel::Sized;
    using Sizes = balance_shaft::RelievedShaftSizes;
    BalanceShaftModel model;
    const RelievedShaftModel relief(&model);
    EXPECT_EQ(relief.sized(), Sized::Depth);
    EXPECT_FALSE(relief.isGiven(&Sizes::depth));
    EXPECT_TRUE(relief.isGiven(&Sizes::length));
    EXPECT_EQ(relief.rows().size(), 10);
    EXPECT_LE(RelievedShaftModel::hints().size(), relief.rows().size());
    // A bar that is surely thick enough.
    model.editField("/relieved_shaft/diameter_mm", 80.0, QStringLiteral("D"));
    ASSERT_TRUE(relief.shaft().feasible) << relief.verdict().toStdString();
    EXPECT_NEAR(relief.shaft().unbalance, relief.shaft().required, 1e-9 * relief.shaft().required);
    EXPECT_EQ(relief.sizeMm(&Sizes::diameter), 80.0);
    EXPECT_NE(relief.exportDxf(QStringLiteral("/dev/null/shaft.dxf")), QString());
}

TEST(RelievedShaftModel, WhatWasFoundBecomesWhatIsGiven) {
    using Sized = RelievedShaftModel::Sized;
    using Sizes = balance_shaft::RelievedShaftSizes;
    BalanceShaftModel model;
    RelievedShaftModel relief(&model);
    model.editField("/relieved_shaft/diameter_mm", 80.0, QStringLiteral("D"));
    const double depth = *relief.sizeMm(&Sizes::depth);
    const int steps = model.history()->count();
    relief.choose(Sized::Length);
    EXPECT_EQ(relief.sized(), Sized::Length);
    EXPECT_NEAR(*relief.sizeMm(&Sizes::depth), depth, 1e-9);
    EXPECT_NEAR(*relief.sizeMm(&Sizes::length), 400.0, 1e-3);
    relief.choose(Sized::None);
    EXPECT_EQ(relief.sized(), Sized::None);
    EXPECT_TRUE(relief.isGiven(&Sizes::length));
    EXPECT_EQ(model.history()->count(), steps + 2);
}

}  // namespace
}  // namespace ravnoves

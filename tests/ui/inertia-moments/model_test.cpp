#include "inertia-moments/model/inertia_moments_model.h"

#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QSettings>
#include <QSignalSpy>
#include <cmath>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "inertia-moments/model/cylinder_table_model.h"
#include "model/input_differences.h"
#include "part_tests.h"
#include "scenes/scenes.h"
#include "text/message_text.h"
#include "text/preferences.h"

namespace ravnoves {
namespace {

using inertia_moments::Direction;
using inertia_moments::Input;

double largest(const inertia_moments::RotatingPair& pair) {
    return pair.max();
}

TEST(InertiaMomentsModel, ComparedInputsAreSaidInWords) {
    InertiaMomentsModel model;
    model.chooseLayout(QStringLiteral("i4"));
    const Json before = model.inputJson();
    model.chooseLayout(QStringLiteral("i6"));
    bool hasLayout = false;
    for (const InputDifference& each : inputDifferences(model, before)) {
        if (each.pointer == "/layout/name") {
            hasLayout = true;
            EXPECT_EQ(each.name, QStringLiteral("Layout"));
            EXPECT_EQ(each.present, QStringLiteral("In-line 6"));
            EXPECT_EQ(each.reference, QStringLiteral("In-line 4"));
        }
        // Numbers of cylinders are names: a difference of them says nothing.
        if (each.pointer.find("firing_order") != std::string::npos) {
            EXPECT_FALSE(each.present.from(each.reference)) << each.pointer;
        }
    }
    EXPECT_TRUE(hasLayout);
}

TEST(InertiaMomentsModel, TheLayoutThatThereIsChangesNothingWhenItIsChosen) {
    for (const QString& name : InertiaMomentsModel::layoutNames()) {
        InertiaMomentsModel model;
        model.chooseLayout(name);
        model.addShaft();
        const Json before = model.inputJson();
        model.chooseLayout(name);
        EXPECT_EQ(model.inputJson(), before) << name.toStdString();
    }
}

TEST(InertiaMomentsModel, PlotsSayThatTheyIncludeRotatingMasses) {
    const InertiaMomentsModel model;
    for (const char* part : {"order-1", "hodograph-forces", "forces-by-order", "moments-by-order",
                             "moments-over-angle"}) {
        EXPECT_TRUE(std::get<Figure>(model.part(part)).title.contains(QStringLiteral("rotating")))
            << part;
    }
    EXPECT_TRUE(model.orderResults().columns[1].heading.contains(QStringLiteral("recipr.")));
}

TEST(InertiaMomentsModel, InchesInTheTableHaveRoomAndAreEditedWhole) {
    InertiaMomentsModel model;
    const CylinderTableModel table(&model);
    Preferences::instance().setUnits(Preferences::Length, Preferences::Units::Imperial);
    const QModelIndex offset = table.index(1, CylinderTableModel::Offset);
    const QString shown = offset.data().toString();
    const QString edited = offset.data(Qt::EditRole).toString();
    QSettings().clear();
    Preferences::instance().load();
    EXPECT_EQ(shown, QStringLiteral("−0.4925"));
    EXPECT_TRUE(edited.startsWith(QStringLiteral("-0.492519"))) << edited.toStdString();
}

TEST(InertiaMomentsModel, EveryLayoutOfTheListCanBeChosenAndUndone) {
    InertiaMomentsModel model;
    const Json first = model.inputJson();
    int steps = 0;
    for (const QString& name : InertiaMomentsModel::layoutNames()) {
        const int before = model.history()->index();
        model.chooseLayout(name);
        steps += model.history()->index() - before;
        EXPECT_EQ(model.layoutName(), name) << name.toStdString();
        EXPECT_FALSE(model.layoutTitle(name).isEmpty());
        EXPECT_GE(model.orderResults().rows.size(), 60);
    }
    for (int i = 0; i < steps; ++i) {
        model.history()->undo();
    }
    EXPECT_EQ(model.inputJson(), first);
}

TEST(InertiaMomentsModel, ATableIsTheSameEngine) {
    InertiaMomentsModel model;
    const auto before = model.result().engine.cylinders;
    const double moment = largest(model.result().exact.order(1).moment);
    model.makeTable();
    EXPECT_EQ(model.layoutName(), QStringLiteral("table"));
    EXPECT_NEAR(largest(model.result().exact.order(1).moment), moment, 1e-9 * moment);
    EXPECT_FALSE(model.canChangeBankAngle());
    // Even firing can be asked for again.
    model.edit(QStringLiteral("banks"), [](Input& input) {
        for (auto& cylinder : input.cylinders) {
            cylinder.bank_angle *= 2.0;
        }
    });
    EXPECT_EQ(model.setEvenFiring(), QString());
    EXPECT_NE(model.result().engine.cylinders[1].crankpin_angle, before[1].crankpin_angle);
    ASSERT_EQ(model.result().firing.size(), 5U);
    EXPECT_NEAR(model.result().firing[2].interval / degree, 144.0, 1e-9);
}

TEST(InertiaMomentsModel, TheSliderOfTheOffsetEndsBeforeLocking) {
    InertiaMomentsModel model;
    QSignalSpy rejected(&model, &InertiaMomentsModel::rejected);
    EXPECT_NE(model.edit(QStringLiteral("λ"), [](Input& input) { input.lambda = 0.9; }), QString());
    const auto [minimum, maximum] = model.offsetLimitsMm();
    model.editField("/layout/offset_mm", maximum, {});
    model.editField("/layout/offset_mm", minimum, {});
    ASSERT_EQ(rejected.size(), 2);
    EXPECT_EQ(rejected.last().at(0).toString(), QString());  // nothing is wrong any more
    EXPECT_NEAR(model.offsetMm(), minimum, 1e-9);
}

TEST(InertiaMomentsModel, ShaftsAreAddedInPairsAndRemoved) {
    InertiaMomentsModel model;
    model.addShaft();
    model.addShaft();
    ASSERT_EQ(model.input().shafts.size(), 6U);
    EXPECT_EQ(model.input().shafts[4].order, 3);
    EXPECT_EQ(model.input().shafts[4].direction, Direction::forward);
    EXPECT_EQ(model.input().shafts[5].order, 3);
    EXPECT_EQ(model.input().shafts[5].direction, Direction::backward);
    EXPECT_LT(largest(model.result().remaining.order(3).moment), 1e-9);
    EXPECT_EQ(model.shaftTitle(model.input().shafts[3]), QStringLiteral("M\u00A0−2ω"));
    model.removeShaft(5);
    EXPECT_EQ(model.input().shafts.size(), 5U);
    model.removeShaft(99);
    EXPECT_EQ(model.input().shafts.size(), 5U);
    model.history()->undo();
    EXPECT_EQ(model.input().shafts.size(), 6U);
}

TEST(InertiaMomentsModel, FiringOrdersAreReadAsPeopleWriteThem) {
    InertiaMomentsModel model;
    EXPECT_EQ(model.setFiringOrder(inertia_moments::whole_numbers("1, 3, 5, 4, 2")), QString());
    EXPECT_EQ(model.firingOrderText(), QStringLiteral("1-3-5-4-2"));
    for (const QString& bad :
         {QStringLiteral("1-2-3"), QStringLiteral("1-2-3-4-4"),
          QStringLiteral("1-2-3-4-9999999999"), QString(), QStringLiteral("abc")}) {
        const std::vector<int> order = inertia_moments::whole_numbers(bad.toStdString());
        EXPECT_FALSE(model.orderTrouble(order).isEmpty()) << bad.toStdString();
        EXPECT_FALSE(model.setFiringOrder(order).isEmpty()) << bad.toStdString();
    }
    EXPECT_EQ(model.firingOrderText(), QStringLiteral("1-3-5-4-2"));
    model.makeTable();
    EXPECT_EQ(model.setFiringOrder({}), QString());
    EXPECT_TRUE(model.firingOrderText().isEmpty());
    EXPECT_FALSE(model.setEvenFiring().isEmpty());
}

TEST(InertiaMomentsModel, SettingsByKeyAsOnTheCommandLine) {
    InertiaMomentsModel model;
    model.setByKey(QStringLiteral("layout/bank_angle_deg"), QStringLiteral("20"));
    EXPECT_NEAR(model.bankAngleDeg(), 20.0, 1e-12);
    model.setByKey(QStringLiteral("crank_angle_deg"), QStringLiteral("400,5"));
    EXPECT_NEAR(model.crank()->degrees(), 400.5, 1e-12);
    model.setByKey(QStringLiteral("layout_name"), QStringLiteral("i4"));
    EXPECT_EQ(model.layoutName(), QStringLiteral("i4"));
    EXPECT_THROW(model.setByKey(QStringLiteral("layout_name"), QStringLiteral("i7")), InputError);
    EXPECT_THROW(model.setByKey(QStringLiteral("lambda"), QStringLiteral("2")), InputError);
    EXPECT_THROW(model.setByKey(QStringLiteral("nonsense"), QStringLiteral("2")), InputError);
    EXPECT_EQ(model.layoutName(), QStringLiteral("i4"));
}

TEST(InertiaMomentsModel, RodsAreHungWithTheUsualKnuckleRadius) {
    InertiaMomentsModel model;
    const double mass = model.input().reciprocating_mass;
    model.chooseLayout(QStringLiteral("radial-5"));
    EXPECT_EQ(model.input().reciprocating_mass, mass);
    EXPECT_FALSE(model.canChangeBankAngle());
    EXPECT_EQ(model.setArticulatedRods(false), QString());
    EXPECT_FALSE(model.hasArticulatedRods());
    EXPECT_EQ(model.layoutName(), QStringLiteral("table"));
    EXPECT_EQ(model.setArticulatedRods(true), QString());
    EXPECT_NEAR(model.input().cylinders[4].articulated->knuckle_radius,
                0.75 * model.input().crank_radius, 1e-4);
    // As they were: by undo.
    model.history()->undo();
    model.history()->undo();
    EXPECT_EQ(model.layoutName(), QStringLiteral("radial-5"));
}

using test::curveOf;
using test::figureOf;

double reachOf(const std::vector<double>& values) {
    double reach = 0.0;
    for (const double value : values) {
        reach = std::max(reach, std::abs(value));
    }
    return reach;
}

TEST(EnginePlots, ShowTheForcesOfAnEngineInOnePlane) {
    InertiaMomentsModel model;
    EXPECT_FALSE(model.showsForces());
    model.chooseLayout(QStringLiteral("radial-7"));
    EXPECT_TRUE(model.showsForces());
    model.chooseLayout(QStringLiteral("i6"));
    model.edit(QStringLiteral("bare"), [](Input& input) { input.end_webs.reset(); });
    EXPECT_FALSE(model.showsForces());  // nor forces
}

TEST(EnginePlots, ShowNoRounding) {
    InertiaMomentsModel model;
    model.chooseLayout(QStringLiteral("i6"));
    ASSERT_EQ(model.layoutName(), QStringLiteral("i6"));
    model.edit(QStringLiteral("bare"), [](Input& input) {
        input.shafts.clear();
        input.end_webs.reset();
    });
    const Figure moments = figureOf(model, "order-1");
    ASSERT_TRUE(moments.leftRange);
    EXPECT_EQ(moments.leftRange->second, 1.0);
    EXPECT_EQ(reachOf(curveOf(moments, "vertical").y), 0.0);
    EXPECT_EQ(reachOf(curveOf(moments, "horizontal").y), 0.0);
    const Figure forces = figureOf(model, "hodograph-forces");
    EXPECT_GT(forces.leftRange->second, 100.0 * reachOf(curveOf(forces, "first").y));
    EXPECT_LT(reachOf(curveOf(forces, "left").y), forces.leftRange->second);
    EXPECT_EQ(reachOf(curveOf(forces, "all").x), 0.0);
    EXPECT_EQ(reachOf(curveOf(figureOf(model, "forces-over-angle"), "horizontal").y), 0.0);
    EXPECT_EQ(curveOf(figureOf(model, "forces-by-order"), "exact").y.at(1), 0.0);
}

TEST(InertiaMomentsModel, EveryTableHasNumbersAndRoundingIsZero) {
    InertiaMomentsModel model;
    for (const QString& layout : InertiaMomentsModel::layoutNames()) {
        model.chooseLayout(layout);
        for (const bool enabled : {true, false}) {
            model.edit(QStringLiteral("webs"), [&](Input& input) {
                if (input.end_webs) {
                    input.end_webs->enabled = enabled;
                    input.end_webs->first_order_share = enabled ? 0.5 : 0.0;
                }
            });
            // Of the tables this one alone is not about z₀.
            EXPECT_EQ(model.weightResults().rows[1].value(0).text,
                      QStringLiteral("Moment about zₘ, N·m"));
            for (const Results& table : {model.orderResults(), model.rotatingResults(),
                                         model.shaftResults(), model.remainingResults()}) {
                EXPECT_EQ(table.columns[0].heading, QStringLiteral("N; N·m about z₀"));
            }
            for (const auto& rows : {model.orderResults().rows, model.rotatingResults().rows,
                                     model.shaftResults().rows, model.weightResults().rows,
                                     model.remainingResults().rows}) {
                for (const ResultRow& row : rows) {
                    // The high orders of a small engine are some 1e-6 N·m, and no rounding.
                    static const QRegularExpression rounding(
                        QStringLiteral("E-(0[89]|[1-9])|nan|inf"));
                    EXPECT_FALSE(row.texts().join(QLatin1Char(';')).contains(rounding))
                        << layout.toStdString() << ": "
                        << row.texts().join(QLatin1Char(';')).toStdString();
                }
            }
        }
    }
}

}  // namespace
}  // namespace ravnoves

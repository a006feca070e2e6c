// What was really drilled: the rows of the sheet Correction change the plan.

#include <QComboBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <functional>
#include <numbers>

#include "bob-weights/drilled.h"
#include "core/workshop/doubted_jobs.h"
#include "core/workshop/support.h"
#include "job_page_test.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using bob_weights::HoleState;

class DrilledTest : public PlugsPageTest {
  protected:
    /// A job whose plan of the first run was drilled.
    DrilledTest() {
        model->loadInput(workshop::test::card(), {});
        typeRun(1, {u"300"_s, u"40"_s, u"95"_s, u"70"_s});
        show(CorrectionTab);
    }
    const bob_weights::DrilledHole& hole(std::size_t at) const {
        return model->input().correction->earlier_runs.at(0).drilled->at(at);
    }
    /// What is in the front plane after the first run's drilling.
    const bob_weights::Metal& drilled() const { return model->solution().runs.at(0).drilled[0]; }
    void choose(const char* name, auto word) {
        keys(name, {Qt::Key_Home});
        ASSERT_TRUE(find<QComboBox>(name)->isVisible());
        for (int step = 0; step < static_cast<int>(word); ++step) {
            keys(name, {Qt::Key_Down});
        }
    }
    QStringList shown(const Results& results) const {
        QStringList rows;
        for (const ResultRow& row : results.rows) {
            // Of what is drilled the first cell is the run.
            rows << row.texts().mid(row.texts().size() - 4).join(u" | "_s);
        }
        return rows;
    }
    bool isAsPlannedOffered() {
        const QComboBox* state = find<QComboBox>("drilled_state_1");
        return (state->model()->flags(state->model()->index(0, 0)) & Qt::ItemIsEnabled) != 0;
    }
    /// As the verdict's doubt tells whether the holes explain what the machine read.
    QString plan() const {
        QStringList rows;
        for (const bob_weights::Metal& metal : model->solution().runs.at(0).drilled) {
            for (const bob_weights::Hole& each : metal.holes) {
                rows << u"%1 %2 %3"_s.arg(each.diameter).arg(each.depth).arg(each.angle);
            }
        }
        for (const workshop::Doubt& doubt : model->doubts()) {
            rows << Words().message(doubt.text);
        }
        return rows.join(u'\n');
    }
};

TEST_F(PlugsPageTest, WhatIsPrintedOrPutAsideIsDrilledWhateverThePlanIsThen) {
    const QTemporaryDir folder;
    const auto print = [&] {
        ASSERT_EQ(page.writeCard(folder.filePath(u"card.pdf"_s)), QString());
    };
    const auto putAside = [&] {
        bool ok = false;
        model->desk()->saveJob(&ok, false);
        ASSERT_TRUE(ok);
    };
    for (const std::function<void()>& keep : {std::function<void()>(print), {putAside}}) {
        model->loadInput(workshop::test::card(), {});
        const auto card = *bob_weights::planned_holes(model->solution());
        ASSERT_FALSE(card.empty());
        keep();
        EXPECT_EQ(model->stopText(), QString()) << "it is the present plan";
        type("diameters_mm", u"8"_s);  // the drill broke at the last hole
        EXPECT_TRUE(has(model->stopText(), u"The plan has changed"_s));
        EXPECT_TRUE(model->withheld().holes);
        EXPECT_TRUE(has(model->stopText(), u"Front plane ⌀ "_s)) << "which holes";
        keep();  // of a plan that is not shown nothing is kept
        model->undo();
        EXPECT_EQ(model->stopText(), QString());
        model->undo();  // what is on paper is not undone
        type("diameters_mm", u"8"_s);
        EXPECT_TRUE(has(model->stopText(), u"The plan has changed"_s));
        typeRun(1, {u"300"_s, u"40"_s, u"95"_s, u"70"_s});
        const auto& recorded = *model->input().correction->earlier_runs.at(0).drilled;
        ASSERT_EQ(recorded.size(), card.size());
        for (std::size_t i = 0; i < card.size(); ++i) {
            EXPECT_NEAR(recorded[i].diameter, card[i].diameter, 1e-9);
        }
        EXPECT_FALSE(has(model->stopText(), u"The plan has changed"_s));
    }
    model->loadInput(workshop::test::card(), {});
    print();
    type("diameters_mm", u"8"_s);
    page.findChild<QPushButton*>(u"verdict_act"_s)->click();
    EXPECT_FALSE(model->withheld().holes);
    EXPECT_FALSE(model->input().correction->planned.drilled);
}

TEST_F(DrilledTest, EveryStateOfAHoleCountsAndIsTakenBack) {
    ASSERT_GE(model->input().correction->earlier_runs.at(0).drilled->size(), 2U);
    const QString before = plan();
    const std::size_t holes = drilled().holes.size();
    const double angle = hole(0).angle;
    choose("drilled_state_1", HoleState::not_drilled);
    EXPECT_EQ(hole(0).state, HoleState::not_drilled);
    EXPECT_EQ(drilled().holes.size(), holes - 1);
    EXPECT_NE(plan(), before);
    choose("drilled_state_1", HoleState::wrong_side);
    EXPECT_EQ(hole(0).angle, angle) << "the plan stays as it was written";
    const auto isOpposite = [&](const bob_weights::Hole& each) {
        return std::cos(each.angle - angle - std::numbers::pi) > 1.0 - 1e-12;
    };
    EXPECT_TRUE(std::ranges::any_of(drilled().holes, isOpposite));
    EXPECT_NEAR(*field("drilled_angle_1")->value(), std::fmod(angle / degree + 180.0, 360.0), 1e-9);
    choose("drilled_state_1", HoleState::as_planned);
    EXPECT_EQ(plan(), before);
}

TEST_F(DrilledTest, AMeasuredAngleAndDepthCount) {
    const QString before = plan();
    type("drilled_angle_1", u"55"_s);
    EXPECT_EQ(hole(0).state, HoleState::measured);
    EXPECT_NEAR(hole(0).angle, 55.0 * degree, 1e-12);
    EXPECT_EQ(find<QComboBox>("drilled_state_1")->currentIndex(),
              static_cast<int>(HoleState::measured));
    EXPECT_NE(plan(), before);
    // Its plan is typed over: undo brings it back, no word does.
    EXPECT_FALSE(isAsPlannedOffered());
    const QString why = u"Undo restores them."_s;
    EXPECT_TRUE(has(find<QComboBox>("drilled_state_1")->toolTip(), why));
    // A rejected depth stands where any rejected entry does.
    const double planned = hole(0).depth;
    type("drilled_depth_1", u"5x"_s);
    EXPECT_TRUE(has(label("rejected"), model->planeName(static_cast<std::size_t>(hole(0).plane))));
    EXPECT_EQ(hole(0).depth, planned);
    EXPECT_TRUE(has(model->keepForSaving(), u"Depth"_s)) << "it is not saved with that";
    // A copy for a crash has the depth before it, and says so.
    model->takePlace(model->placeJson());
    EXPECT_TRUE(has(label("banner"), u"check them again: "_s));
    EXPECT_TRUE(has(label("banner"), u"Depth"_s));
    click("banner_close");
    type("drilled_depth_1", {});
    EXPECT_FALSE(label("rejected").isEmpty()) << "none is not that before";
    type("drilled_depth_1", u"4.5"_s);
    EXPECT_TRUE(label("rejected").isEmpty());
    EXPECT_NEAR(hole(0).depth, 4.5 * units::mm, 1e-12);
    EXPECT_TRUE(std::ranges::any_of(drilled().holes, [](const bob_weights::Hole& each) {
        return std::abs(each.depth - 4.5 * units::mm) < 1e-12 &&
               std::abs(each.angle - 55.0 * degree) < 1e-12;
    }));
    // What it took off is that of the depth measured, not of the plan.
    const double mass = drilled().holes.at(0).mass;
    type("drilled_depth_1", u"9"_s);
    EXPECT_GT(drilled().holes.at(0).mass, 1.5 * mass);
    while (model->history()->canUndo() && plan() != before) {
        model->history()->undo();
    }
    EXPECT_EQ(plan(), before);
    EXPECT_TRUE(isAsPlannedOffered());
    EXPECT_FALSE(has(find<QComboBox>("drilled_state_1")->toolTip(), why));
}

TEST_F(DrilledTest, ASlugOfUnknownMassIsNotAsPlannedOnceItsDepthIsTyped) {
    Json input = workshop::test::card();
    input["correction"]["earlier_runs"] = parse_json(
        R"([{"drilled": [{"plane": "front", "diameter_mm": 20, "depth_mm": 12, "angle_deg": 220,
                          "removed_g": -30}]}])");
    model->loadInput(input, {});
    EXPECT_TRUE(isAsPlannedOffered());
    choose("drilled_state_1", HoleState::wrong_side);
    type("drilled_depth_1", u"9"_s);
    EXPECT_EQ(hole(0).depth, 9 * units::mm);
    EXPECT_FALSE(isAsPlannedOffered());
}

TEST_F(DrilledTest, ADepthTypedOnTheWrongSideIsNotAsPlannedAfterwards) {
    choose("drilled_state_1", HoleState::wrong_side);
    EXPECT_TRUE(isAsPlannedOffered());
    const double mass = drilled().holes.at(0).mass;
    type("drilled_depth_1", u"1"_s);
    EXPECT_EQ(hole(0).state, HoleState::wrong_side);
    EXPECT_LT(drilled().holes.at(0).mass, 0.9 * mass) << "what is typed counts";
    for (const HoleState other : {HoleState::not_drilled, HoleState::wrong_side}) {
        choose("drilled_state_1", other);
        EXPECT_FALSE(isAsPlannedOffered());
    }
}

TEST_F(DrilledTest, ADeepeningIsListedWithTheDepthBeforeAndItsOwnMass) {
    const auto list = [&](const char* runs) {
        Json input = workshop::test::card();
        input["correction"]["earlier_runs"] = parse_json(runs);
        model->loadInput(input, {});
        return model->drilledResults().rows;
    };
    const auto twice = list(
        R"([{"drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 9, "angle_deg": 40}]},
            {"readings": [{"unbalance_g_mm": 900, "angle_deg": 40}, {"unbalance_g_mm": 0}],
             "drilled": [{"plane": "front", "diameter_mm": 16, "from_depth_mm": 9, "depth_mm": 12,
                          "angle_deg": 40}]}])");
    ASSERT_EQ(twice.size(), 2);
    EXPECT_EQ(twice[0].at(2).text, u"9.0"_s);
    EXPECT_EQ(twice[1].at(2).text, u"9.0 → 12.0"_s);
    EXPECT_TRUE(has(cardText(), u"9.0 → 12.0"_s));
    const auto once = list(
        R"([{"drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 12, "angle_deg": 40}]}])");
    EXPECT_NEAR(twice[0].last().text.toDouble() + twice[1].last().text.toDouble(),
                once[0].last().text.toDouble(), 0.011);
}

TEST_F(DrilledTest, AHoleInTheOtherPlaneCountsThereAndIsTakenBackInOneStep) {
    const workshop::Input before = model->input();
    const auto holesIn = [&](std::size_t plane) {
        return model->solution().runs.at(0).drilled[plane].holes.size();
    };
    const std::array there{holesIn(0), holesIn(1)};
    ASSERT_EQ(hole(0).plane, bob_weights::PlaneName::front);
    EXPECT_EQ(find<QComboBox>("drilled_plane_1")->currentText(), u"Front"_s);
    choose("drilled_plane_1", bob_weights::PlaneName::rear);
    EXPECT_EQ(hole(0).plane, bob_weights::PlaneName::rear);
    EXPECT_EQ(hole(0).state, HoleState::measured);
    EXPECT_EQ(holesIn(0), there[0] - 1);
    EXPECT_EQ(holesIn(1), there[1] + 1);
    const QString size = u"⌀ %1 mm"_s.arg(hole(0).diameter / units::mm);
    EXPECT_TRUE(has(cardText(), u"Rear plane: "_s + size));
    model->history()->undo();
    EXPECT_EQ(model->input(), before);
    // By the machine's own names.
    model->edit({}, [](workshop::Input& job) { job.machine.planes = {"left", "right"}; });
    EXPECT_EQ(find<QComboBox>("drilled_plane_1")->currentText(), u"Left"_s);
}

TEST_F(DrilledTest, AHoleThatWasThereBeforeIsAddedAndKeptClearOf) {
    model->loadInput(workshop::test::card(), {});
    const auto holes = [&] { return (*model->solution().correction)[0].holes; };
    ASSERT_FALSE(holes().empty());
    const double angle = holes().front().angle;
    show(CorrectionTab);
    auto* add = find<QPushButton>("add_hole");
    EXPECT_FALSE(add->isEnabled());
    fill({{"what_if_diameter", "16"}, {"what_if_depth", "5"}});
    EXPECT_FALSE(add->isEnabled());
    type("what_if_angle", QString::number(angle / degree, 'f', 1));
    add->click();
    EXPECT_FALSE(add->isEnabled()) << "it is not added twice";
    EXPECT_EQ(field("what_if_depth")->value(), std::nullopt);
    // The list says the plane of the next one.
    keys("what_if_plane", {Qt::Key_Down});
    fill({{"what_if_diameter", "16"}, {"what_if_depth", "5"}, {"what_if_angle", "10"}});
    add->click();
    EXPECT_EQ(find<QComboBox>("what_if_plane")->currentIndex(), 1);
    EXPECT_EQ(model->input().correction->earlier_runs.front().drilled->back().plane,
              bob_weights::PlaneName::rear);
    model->history()->undo();
    ASSERT_EQ(model->input().correction->earlier_runs.size(), 1U);
    EXPECT_EQ(model->newestRun(), 0U) << "no run of the machine";
    EXPECT_EQ(model->drilledResults().rows.at(0).at(0).text, u"Older holes"_s);
    const Json kept = model->inputJson();
    EXPECT_TRUE(find<QComboBox>("drilled_state_1")->isVisible());
    for (const bob_weights::Hole& each : holes()) {
        EXPECT_TRUE(each.deepens || std::abs(each.angle - angle) > 5.0 * degree);
    }
    EXPECT_EQ(model->reading(0, 0).unbalance, 2500 * units::gram_mm);
    model->history()->undo();
    EXPECT_TRUE(model->input().correction->earlier_runs.empty());
    model->loadInput(kept, {});
    EXPECT_EQ(model->inputJson(), kept);
    EXPECT_EQ(model->newestRun(), 0U);
    // Readings that are valid again leave them as they are.
    type("oil", u"40"_s);
    ASSERT_FALSE(model->otherRunText().isEmpty());
    model->confirmReadings();
    EXPECT_TRUE(model->otherRunText().isEmpty());
    EXPECT_TRUE(model->input().correction->earlier_runs.front().readings.empty());
}

TEST_F(DrilledTest, HolesAreOfTheirRunAlsoWhereItsReadingsAreErased) {
    const auto holes = [&] { return model->drilledResults().rows.at(0).at(0).text; };
    ASSERT_EQ(holes(), u"After “Before”"_s);
    for (const char* reading : {"unbalance_1", "angle_1", "unbalance_2", "angle_2"}) {
        type(reading, {});
    }
    for (int time = 0; time < 2; ++time) {
        EXPECT_EQ(holes(), u"After “Before”"_s);
        EXPECT_EQ(model->newestRun(), 1U);
        EXPECT_TRUE(begins(label("verdict"), u"STOP. Before, Front plane: enter the unbalance."_s));
        model->loadInput(model->inputJson(), {});
    }
    model->editReading({}, 0, 0, false, 2500 * units::gram_mm);
    EXPECT_EQ(holes(), u"After “Before”"_s);
}

TEST_F(DrilledTest, HolesThatNoRunHasReadLeaveNoPlan) {
    const QStringList holes = shown(model->drilledResults());
    const auto expectStop = [&] {
        EXPECT_TRUE(begins(
            label("verdict"),
            u"STOP. Holes are recorded after “Before”: enter the readings of Run 1, or mark"_s));
        EXPECT_TRUE(model->holeResults().rows.isEmpty());
        EXPECT_EQ(shown(model->drilledResults()), holes);
        EXPECT_TRUE(has(cardText(), u"Already drilled"_s));
        EXPECT_TRUE(field("run_1_unbalance_1")->isEnabled());
    };
    const QStringList run{u"300"_s, u"40"_s, u"95"_s, u"70"_s};
    typeRun(1, {{}, {}, {}, {}});
    EXPECT_EQ(model->newestRun(), 0U);
    expectStop();
    model->loadInput(model->inputJson(), {});
    expectStop();
    type("diameters_mm", u"12"_s);
    expectStop();
    click("verdict_act");
    EXPECT_EQ(QApplication::focusWidget(), find<QWidget>("drilled_state_1"));
    typeRun(1, run);
    EXPECT_EQ(shown(model->drilledResults()), holes);
    // Where none was drilled, what is planned then is.
    typeRun(1, {{}, {}, {}, {}});
    const std::size_t count = model->input().correction->record.drilled->size();
    for (std::size_t row = 1; row <= count; ++row) {
        EXPECT_TRUE(model->withheld().holes);
        choose(("drilled_state_" + std::to_string(row)).c_str(), HoleState::not_drilled);
    }
    EXPECT_FALSE(model->withheld().holes);
    const auto planned = bob_weights::planned_holes(model->solution());
    ASSERT_TRUE(planned && !planned->empty());
    EXPECT_EQ(planned->front().diameter, 12 * units::mm);
    typeRun(1, run);
    EXPECT_EQ(model->input().correction->earlier_runs.at(0).drilled, planned);
}

TEST_F(DrilledTest, HolesOfALaterRunAreKeptWhereReadingsAreErased) {
    const auto asMeasured = [&](std::size_t run) {
        model->editCorrection({}, [&](bob_weights::Correction& correction) {
            for (bob_weights::DrilledHole& each : *correction.earlier_runs[run].drilled) {
                each.state = HoleState::measured;
            }
        });
    };
    limitTo(150);
    asMeasured(0);
    ASSERT_FALSE(model->holeResults().rows.isEmpty()) << qPrintable(label("verdict"));
    typeRun(2, {u"60"_s, u"10"_s, u"20"_s, u"300"_s});
    asMeasured(1);
    const QStringList holes = shown(model->drilledResults());
    for (const int run : {2, 1}) {
        typeRun(run, {{}, {}, {}, {}});
        EXPECT_EQ(model->newestRun(), 1U);
        EXPECT_EQ(shown(model->drilledResults()), holes);
        EXPECT_TRUE(begins(label("verdict"), u"STOP. Holes are recorded after Run 1: enter"_s));
    }
}

TEST_F(DrilledTest, AHoleThatIsThoughtOfSaysWhatItWouldLeaveAndChangesNothing) {
    const workshop::Input before = model->input();
    type("what_if_diameter", u"16"_s);
    type("what_if_depth", u"0.5"_s);
    EXPECT_EQ(label("what_if"), QString());
    type("what_if_angle", u"300"_s);
    const QString said = label("what_if");
    EXPECT_TRUE(begins(said, u"Front plane: residual "_s));
    // Of what is no number nothing is said, and the plan is none the worse.
    type("what_if_angle", u"abc"_s);
    EXPECT_EQ(label("what_if") + label("rejected"), QString());
    type("what_if_angle", u"300"_s);
    EXPECT_EQ(label("what_if"), said);
    type("what_if_depth", u"5"_s);
    EXPECT_NE(label("what_if"), said);
    EXPECT_EQ(model->input(), before);
    fill({{"from_1", "10"}, {"to_1", "120"}});
    EXPECT_EQ(label("what_if"), u"The hole is outside the drilling sector."_s);
    type("what_if_angle", u"60"_s);
    EXPECT_FALSE(has(label("what_if"), u"sector"_s));
    // Of a plane that needs no hole half a sector is no doubt, nor is it the whole rim.
    type("run_1_unbalance_1", u"1"_s);
    type("to_1", {});
    const QString both = u"Enter both ends of the drilling sector."_s;
    EXPECT_EQ(label("what_if"), both);
    EXPECT_EQ(field("to_1")->placeholderText(), QString());
    EXPECT_FALSE(has(cardText(), u"whole rim"_s));
    // Also where that is what stops the plan.
    type("run_1_unbalance_1", u"600"_s);
    EXPECT_TRUE(model->withheld().holes);
    EXPECT_EQ(label("what_if"), both);
    type("from_1", {});
    EXPECT_EQ(field("to_1")->placeholderText(), u"whole rim"_s);
    // By a job that is stopped nothing is thought of either.
    type("run_1_unbalance_1", u"4900"_s);
    EXPECT_EQ(label("what_if"), QString());
}

TEST_F(DrilledTest, AHoleThatIsThoughtOfMayDeepenOne) {
    const bob_weights::DrilledHole& there = hole(0);
    const auto shown = [](double value, const auto& unit) { return QString::number(value / unit); };
    type("what_if_diameter", shown(there.diameter, units::mm));
    type("what_if_depth", shown(there.depth, units::mm));
    type("what_if_angle", shown(there.angle, degree));
    EXPECT_EQ(label("what_if"), u"Another hole is too near."_s);
    type("what_if_depth", shown(there.depth + 1 * units::mm, units::mm));
    EXPECT_TRUE(begins(label("what_if"), u"Front plane: residual "_s));
    // Tab leads to the buttons that add it.
    auto* angle = find<QWidget>("what_if_angle");
    angle->setFocus(Qt::TabFocusReason);
    for (const char* button : {"add_hole", "add_late_hole"}) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        EXPECT_EQ(QApplication::focusWidget(), find<QWidget>(button)) << button;
    }
    const double depth = there.depth;
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    const bob_weights::DrilledHole& added =
        model->input().correction->earlier_runs.at(0).drilled->back();
    EXPECT_NEAR(added.depth, depth + 1 * units::mm, 1e-9);
    EXPECT_EQ(added.from_depth, depth);
}

TEST_F(DrilledTest, TheVerdictLeadsToTheHolesOfTheRunThatItNames) {
    model->loadInput(
        workshop::test::changed(workshop::test::twice_drilled(),
                                {{"/correction/earlier_runs/0/drilled/1/depth_mm", 0}}),
        {});
    ASSERT_TRUE(begins(label("verdict"), u"STOP. Run 1, Rear plane"_s));
    click("verdict_act");
    EXPECT_EQ(QApplication::focusWidget(), find<QWidget>("drilled_state_2"));
}

TEST_F(DrilledTest, TheVerdictLeadsToWhatWasDrilledOtherwise) {
    // The machine reads what the holes do not explain.
    type("run_1_unbalance_1", u"4900"_s);
    ASSERT_TRUE(model->withheld().holes);
    show(JobTab);
    click("verdict_act");
    EXPECT_EQ(sheets->currentIndex(), CorrectionTab);
    EXPECT_EQ(QApplication::focusWidget(), find<QWidget>("drilled_state_1"));
    // They were drilled on the wrong side: that explains it, and there is a plan again.
    for (int row = 1; model->withheld().holes && row <= 5; ++row) {
        const std::string name = "drilled_state_" + std::to_string(row);
        if (row <=
                static_cast<int>(model->input().correction->earlier_runs.at(0).drilled->size()) &&
            hole(static_cast<std::size_t>(row - 1)).plane == bob_weights::PlaneName::front) {
            choose(name.c_str(), HoleState::wrong_side);
        }
    }
    EXPECT_FALSE(model->withheld().holes);
    EXPECT_FALSE(model->holeResults().rows.isEmpty());
}

}  // namespace
}  // namespace ravnoves

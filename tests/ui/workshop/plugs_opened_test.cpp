// Tolerances of cases that became jobs, and plugs that come and go.

#include <QCheckBox>
#include <QSettings>

#include "core/workshop/support.h"
#include "fixtures.h"
#include "job_page_test.h"
#include "scenes/scenes.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

/// Their numbers as jobs: fixtures_test.cpp of the models.
TEST(OpenedCase, HasTolerancesOfWhatTheJobHas) {
    for (const std::string scene : {"v8-plugs", "bob-weights"}) {
        const CaseFile job =
            parse_shown_case(read_text_file(test::fixture_folder() / (scene + ".case.json")));
        EXPECT_EQ(job.scene, "workshop");
        const Json result = solve_case(job, {}).at("result");
        for (const auto& [list, in] : {std::pair("vary", job.input), {"watch", result}}) {
            EXPECT_FALSE(job.study.at(list).empty());
            for (const auto& item : job.study.at(list).items()) {
                EXPECT_TRUE(in.contains(Json::json_pointer(item.key()))) << item.key();
            }
        }
    }
}

TEST_F(PlugsPageTest, PlugsThatComeAndGoKeepPartsAndFactor) {
    QSettings().setValue(u"workshop/tolerance_g_mm"_s, 7.0);
    const auto guard = qScopeGuard([] { QSettings().remove(u"workshop/tolerance_g_mm"_s); });
    model->loadInput(workshop::test::card(), {});
    type("overbalance_percent", u"2"_s);
    const workshop::Input without = model->input();
    const auto toggle = [&] { keys("has_plugs", {Qt::Key_Space}); };
    EXPECT_FALSE(sheets->isTabVisible(PlugsTab));
    EXPECT_TRUE(field("piston")->isVisibleTo(sheets->widget(PartsTab)));
    QWidget* last = fieldsOf(WeighInTab).constLast();
    show(WeighInTab);
    last->setFocus();
    QTest::keyClick(last, Qt::Key_Return);
    EXPECT_EQ(sheets->currentIndex(), MachineTab) << "no sheet that is not there";
    toggle();
    ASSERT_TRUE(model->hasPlugs());
    EXPECT_TRUE(sheets->isTabVisible(PlugsTab));
    EXPECT_FALSE(field("piston")->isVisibleTo(sheets->widget(PartsTab)));
    EXPECT_TRUE(field("reciprocating_mass_g")->isVisibleTo(sheets->widget(PartsTab)));
    EXPECT_FALSE(model->resultJson().at("error").get<std::string>().find("factor") !=
                 std::string::npos);
    EXPECT_DOUBLE_EQ(model->input().plugs->tolerance, 7.0 * units::gram_mm) << "Shop limit";
    EXPECT_EQ(model->input().correction, without.correction);
    EXPECT_EQ(model->input().tolerance, without.tolerance);
    type("rod_big_end", u"0.5"_s);
    toggle();
    EXPECT_EQ(model->input(), without);
    EXPECT_FALSE(sheets->isTabVisible(PlugsTab));
    toggle();
    EXPECT_NEAR(model->input().plugs->typed_changes.rod_big_end, 0.5 * units::gram, 1e-15);
    model->history()->undo();
    EXPECT_EQ(model->input(), without);
    // Another engine than a V-8 at 90° has none.
    toggle();
    type("bank_angle_deg", u"60"_s);
    EXPECT_TRUE(model->input().engine.bank_angle == without.engine.bank_angle)
        << "refused while there are plugs";
    EXPECT_TRUE(field("bank_angle_deg")->trouble().contains(u"Untick"_s));
    QTest::keyClick(field("bank_angle_deg"), Qt::Key_Escape);
    toggle();
    type("bank_angle_deg", u"60"_s);
    EXPECT_FALSE(find<QCheckBox>("has_plugs")->isEnabled());
    // Those of one job are not in the next.
    type("bank_angle_deg", u"90"_s);
    model->newJob();
    toggle();
    EXPECT_FALSE(model->plugsInput()->changes_known());
}

}  // namespace
}  // namespace ravnoves

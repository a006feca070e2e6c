// The engines to choose from, and one with a name of its own.

#include <QComboBox>
#include <QLineEdit>

#include "job_page_test.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

TEST_F(PlugsPageTest, EngineBringsItsPlugAndItsOwnSheets) {
    type("customer", u"Smith"_s);
    fill({{"height_mm", "9.5"},
          {"bore_diameter_mm", "12"},
          {"bore_depth_mm", "5"},
          {"cutter_diameter_mm", "14"},
          {"nominal_piston", "600"},
          {"spread_piston", "2"},
          {"mass_piston_1", "601"}});
    // Kept with the job, and found by the engine's name.
    const PlugSheet plug = model->input().plugs->plug.value();
    type("engine_name", u"Kept"_s);
    EXPECT_EQ(find<QComboBox>("engine")->placeholderText(), u"Kept"_s);
    save();
    ASSERT_EQ(model->desk()->journal()->search({.text = u"kept"_s}).size(), 1);
    const qint64 kept = model->desk()->jobId();
    keys("engine", {Qt::Key_Home, Qt::Key_Down});
    EXPECT_EQ(model->input().plugs->preset, "6 l");
    EXPECT_EQ(field("height_mm")->value(), 11.0) << "another engine's plug stays";
    EXPECT_FALSE(field("bore_diameter_mm")->value());
    EXPECT_EQ(field("cutter_diameter_mm")->value(), 14.0) << "the cutter is the shop's";
    EXPECT_FALSE(field("nominal_piston")->value());
    EXPECT_EQ(field("mass_piston_1")->value(), 601.0) << "what the scale said stays";
    EXPECT_EQ(find<QLineEdit>("engine_name")->text(), QString());
    EXPECT_EQ(model->desk()->openJob(kept, true), QString());
    EXPECT_EQ(model->input().plugs->engine.name, "Kept");
    EXPECT_EQ(model->input().plugs->plug, plug);
    EXPECT_EQ(field("nominal_piston")->value(), 600.0);
    EXPECT_EQ(field("spread_piston")->value(), 2.0);
    EXPECT_FALSE(field("mass_piston_1")->value());
    fill({{"customer", "Jones"}, {"mass_piston_1", "602"}});
    // The next job keeps what is the engine's.
    fill({{"grade_mm_s", "16"},
          {"rotor_mass_kg", "30"},
          {"service_speed_rpm", "3200"},
          {"unbalance_1", "100"}});
    press(Qt::Key_F2);
    press(Qt::Key_F4);
    EXPECT_EQ(model->input().plugs->plug, plug);
    EXPECT_EQ(field("nominal_piston")->value(), 600.0);
    EXPECT_FALSE(field("mass_piston_1")->value());
    EXPECT_EQ(field("grade_mm_s")->value(), 16.0);
    EXPECT_FALSE(field("unbalance_1")->value());
}

}  // namespace
}  // namespace ravnoves

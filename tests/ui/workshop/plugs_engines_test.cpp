// The engines to choose from and those of the shop's own.

#include <QInputDialog>
#include <QPushButton>

#include "job_page_test.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

TEST_F(PlugsPageTest, OwnEnginesByKeyboard) {
    show(PlugsTab);
    auto* keep = find<QPushButton>("save_engine");
    auto* rename = find<QPushButton>("rename_engine");
    auto* remove = find<QPushButton>("remove_engine");
    EXPECT_FALSE(rename->isEnabled());
    EXPECT_FALSE(remove->isEnabled());
    const auto giveName = [&](QPushButton* button, const QString& name) {
        whenModal<QInputDialog>([name](QInputDialog* dialog) {
            dialog->setTextValue(name);
            QTest::keyClick(dialog, Qt::Key_Return);
        });
        button->setFocus();
        QTest::keyClick(button, Qt::Key_Space);
    };
    type("steel_plug_mass_g", u"25"_s);
    giveName(keep, u"ZMZ-53"_s);
    EXPECT_EQ(model->engineNames().constLast(), u"ZMZ-53"_s);
    EXPECT_TRUE(rename->isEnabled());
    giveName(rename, u"ZMZ-66"_s);
    EXPECT_EQ(model->engineNames().constLast(), u"ZMZ-66"_s);
    EXPECT_EQ(model->input().plugs->engine.name, "ZMZ-66");
    // The same name again, in other capitals: asked first.
    type("steel_plug_mass_g", u"26"_s);
    EXPECT_TRUE(model->ownEngineChanged());
    EXPECT_FALSE(model->engineNote().isEmpty());
    const auto keepAnd = [&](const QString& button) {
        whenModal<QInputDialog>([button](QInputDialog* dialog) {
            answer(button);
            dialog->setTextValue(u"zmz-66"_s);
            QTest::keyClick(dialog, Qt::Key_Return);
        });
        QTest::mouseClick(keep, Qt::LeftButton);
    };
    keepAnd(u"No"_s);
    EXPECT_TRUE(model->ownEngineChanged());
    keepAnd(u"Yes"_s);
    EXPECT_FALSE(model->ownEngineChanged());
    EXPECT_EQ(model->engineNames().size(), 8);
    answer(u"Yes"_s);
    QTest::mouseClick(remove, Qt::LeftButton);
    EXPECT_EQ(model->engineNames().size(), 7);
    EXPECT_FALSE(remove->isEnabled());
}

TEST_F(PlugsPageTest, EngineBringsItsPlugAndItsOwnSheets) {
    type("customer", u"Smith"_s);
    fill({{"height_mm", "9.5"},
          {"bore_diameter_mm", "12"},
          {"bore_depth_mm", "5"},
          {"cutter_diameter_mm", "14"},
          {"nominal_piston", "600"},
          {"spread_piston", "2"},
          {"mass_piston_1", "601"}});
    // Kept with the engine.
    const PlugSheet plug = model->input().plugs->plug.value();
    whenModal<QInputDialog>([](QInputDialog* dialog) {
        dialog->setTextValue(u"Kept"_s);
        dialog->accept();
    });
    click("save_engine");
    keys("engine", {Qt::Key_Home, Qt::Key_Down});
    EXPECT_EQ(model->input().plugs->preset, "6 l");
    EXPECT_EQ(field("height_mm")->value(), 11.0) << "another engine's plug stays";
    EXPECT_FALSE(field("bore_diameter_mm")->value());
    EXPECT_EQ(field("cutter_diameter_mm")->value(), 14.0) << "the cutter is the shop's";
    EXPECT_FALSE(field("nominal_piston")->value());
    EXPECT_EQ(field("mass_piston_1")->value(), 601.0) << "what the scale said stays";
    keys("engine", {Qt::Key_End});
    EXPECT_EQ(model->input().plugs->engine.name, "Kept");
    EXPECT_EQ(model->input().plugs->plug, plug);
    EXPECT_EQ(field("nominal_piston")->value(), 600.0);
    EXPECT_EQ(field("spread_piston")->value(), 2.0);
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

#include "case-file/key_units.h"

#include <gtest/gtest.h>

namespace ravnoves {
namespace {

TEST(KeyUnits, AKeyEndsInItsUnit) {
    EXPECT_EQ(unit_of_key("angular_speed_rad_s").unit, units::rad_per_s);
    EXPECT_EQ(unit_of_key("angular_speed_rad_s").length, 6U);
    EXPECT_EQ(unit_of_key("inertia_kg_m2").unit, units::kg_m2);
    EXPECT_EQ(unit_of_key("lambda").length, 0U);
    EXPECT_EQ(unit_of_key("M_s").unit, units::none) << "a moment's symbol";
}

TEST(KeyUnits, AnElementOfAListHasTheListsUnit) {
    EXPECT_EQ(unit_at("/torque/M_up_Nm/17"), units::N_m);
    EXPECT_EQ(unit_at("/cylinders/0/offset_mm"), units::mm);
    EXPECT_EQ(unit_at("/x0"), units::none);
    EXPECT_EQ(unit_at("/3"), units::none);
    EXPECT_EQ(unit_at(""), units::none);
}

}  // namespace
}  // namespace ravnoves

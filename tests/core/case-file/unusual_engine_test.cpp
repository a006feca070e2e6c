#include "case-file/unusual_engine.h"

#include <gtest/gtest.h>

namespace ravnoves {
namespace {

constexpr double rpm = 3000 * units::rpm;

/// Model diesel of 0.8 cm³, racing engine, motorcycle, locomotive, marine crosshead engine, and the
/// low-pressure cylinder of a process compressor.
TEST(UnusualEngine, NoRealOneIsDoubted) {
    const EngineSizes engines[] = {{30000 * units::rpm, 0.0049, 0.022, {0.002, 0.003}},
                                   {18000 * units::rpm, 0.02, 0.102, {0.22, 0.3}},
                                   {rpm, 0.046, 0.14, {0.45, 0.05, 0.52}},
                                   {rpm / 10, 0.33, 3.9, {330.0, 250.0}},
                                   {rpm / 40, 1.86, 3.72, {15000.0, 9000.0}},
                                   {rpm / 5, 0.14, 0.7, {1000.0, 150.0}},
                                   {rpm, 0.046, 0.0, {}}};
    for (const EngineSizes& engine : engines) {
        EXPECT_TRUE(unusual_engine_notes(engine).empty()) << engine.crank_radius;
    }
}

TEST(UnusualEngine, ASlipOfTheUnitIsDoubtedOnce) {
    const auto grams = unusual_engine_notes({rpm, 0.046, 0.14, {500.0, 120.0}});
    ASSERT_EQ(grams.size(), 1U);
    EXPECT_NE(grams[0].english().find("Mass 500 kg and crank radius 46 mm"), std::string::npos)
        << grams[0].english();
    const auto centimetres = unusual_engine_notes({rpm, 0.0038, 0.128, {0.5}});
    ASSERT_EQ(centimetres.size(), 1U);
    EXPECT_NE(centimetres[0].english().find("Crank radius 3.8 mm and rod 128 mm"),
              std::string::npos)
        << centimetres[0].english();
}

}  // namespace
}  // namespace ravnoves

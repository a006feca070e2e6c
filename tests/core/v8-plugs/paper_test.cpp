// What the paper prints of its engines, and what follows from it.

#include <gtest/gtest.h>

#include <cmath>

#include "support.h"
#include "v8-plugs/compensation.h"
#include "v8-plugs/presets.h"

namespace ravnoves::v8_plugs {
namespace {

using test::gram;
using test::millimetre;

/// The report on the printed numbers computes with the coefficients as they are printed.
TEST(PaperText, UnroundedCoefficientsMoveTable3ByLessThanThreeMilligrams) {
    for (const char* name : {"4.25 l", "6 l"}) {
        const Engine& exact = *find_preset(name);
        const Coefficients k = coefficients(exact);
        Engine rounded = exact;
        rounded.plug_radius = std::round(k.k_y * 1e3) / 2e3;
        rounded.new_plug_radius = std::round(*k.k_y_new * 1e3) / 2e3;
        rounded.crank_radius = 1.0;
        for (const OptionId id : all_options) {
            EXPECT_NEAR(evaluate_option(id, exact, 0.0, 0.0)->maximum / gram,
                        evaluate_option(id, rounded, 0.0, 0.0)->maximum / gram, 0.003);
        }
    }
}

TEST(Presets, SizesOfTable1) {
    const PlugSheet small = printed_plug("4.25 l");
    EXPECT_EQ(thread_name(small.thread.value()), "M22x1.5");
    EXPECT_NEAR(small.height.value(), 14 * millimetre, 1e-12);
    for (const char* name : {"6 l", "7 l"}) {
        const PlugSheet large = printed_plug(name);
        EXPECT_EQ(thread_name(large.thread.value()), "M30x1.5");
        EXPECT_NEAR(large.height.value(), 11 * millimetre, 1e-12);
        EXPECT_FALSE(large.bore_diameter);
    }
    EXPECT_EQ(printed_plug("8.32 l"), PlugSheet{});
    EXPECT_EQ(printed_plug(""), PlugSheet{});
}

TEST(Presets, GiveNothingThatThePaperDoesNotPrint) {
    ASSERT_EQ(engine_presets().size(), 7U);
    for (const Engine& engine : engine_presets()) {
        EXPECT_FALSE(engine.reciprocating_mass) << engine.name;
        EXPECT_FALSE(engine.rotating_mass) << engine.name;
        EXPECT_FALSE(engine.oil_mass) << engine.name;
        EXPECT_FALSE(engine.oil_coefficient) << engine.name;
        EXPECT_TRUE(engine.crank_radius) << engine.name;
        EXPECT_FALSE(has_nominal_masses(engine)) << engine.name;
    }
    for (const char* name : {"8.32 l", "8.74 l", "10.85 l", "14.86 l"}) {
        const Engine& engine = *find_preset(name);
        EXPECT_EQ(missing_fields(engine, true).size(), engine_fields().size() - 1) << name;
        EXPECT_FALSE(has_plug_data(engine)) << name;
    }
    EXPECT_EQ(find_preset("4.25"), find_preset("4.25 l"));
    EXPECT_EQ(find_preset("5 l"), nullptr);
}

}  // namespace
}  // namespace ravnoves::v8_plugs

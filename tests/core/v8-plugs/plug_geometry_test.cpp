#include "v8-plugs/plug_geometry.h"

#include <gtest/gtest.h>

#include "case-file/input_error.h"
#include "numerics/constants.h"
#include "support.h"

namespace ravnoves::v8_plugs {
namespace {

using test::gram;
using test::millimetre;
using test::Workshop;

/// The cup of the 6 and 7 l engines: M30×1.5, 11 high, bored 25 wide and 8 deep (Table 1).
const PlugGeometry cup{
    {30 * millimetre, 1.5 * millimetre}, 11 * millimetre, 25 * millimetre, 8 * millimetre};

TEST(ThreadTest, ReadsWhatPeopleWrite) {
    for (const char* text :
         {"M22x1.5", "m22x1.5", "M22×1,5", "М22х1,5", " M 22 x 1.5 ", "M22*1.5"}) {
        const Thread thread = parse_thread(text, "/thread");
        EXPECT_DOUBLE_EQ(thread.diameter, 22 * millimetre) << text;
        EXPECT_DOUBLE_EQ(thread.pitch, 1.5 * millimetre) << text;
        EXPECT_EQ(thread_name(thread), "M22x1.5");
    }
    for (const char* text : {"", "M", "22x1.5", "M22", "M22x", "Mx1.5", "M-22x1.5", "M22x0",
                             "M22x10", "M1e300x1.5", "M22x1.5x2", "G1/2", "Mnanx1"}) {
        EXPECT_THROW(parse_thread(text, "/thread"), InputError) << text;
    }
}

TEST(ThreadTest, DiametersOfIso724) {
    // M30×1.5 in ISO 724: d₂ = 29.026; the root of the external thread d₃ = 28.160.
    EXPECT_NEAR(cup.thread.pitch_diameter() / millimetre, 29.026, 0.5e-3);
    EXPECT_NEAR(cup.thread.root_diameter() / millimetre, 28.160, 0.5e-3);
}

TEST(PlugGeometryTest, SteelCupM30WeighsAbout25Grams) {
    EXPECT_NEAR(cup.volume() * steel_density / gram, 25.0, 2.0);
    // The 4.03 g that the paper prints do not fit, and neither would 4.03 g of aluminium.
    EXPECT_FALSE(mass_fits(4.03 * gram, cup.volume() * steel_density));
    EXPECT_TRUE(mass_fits(25.0 * gram, cup.volume() * steel_density));
}

TEST(PlugGeometryTest, SolidPlugBoredNineTenths) {
    // By hand: 1.83 g of steel from a bore 20 mm wide is 1.83/(7.85e-3 · 100π) mm deep.
    const PlugGeometry plug{
        {30 * millimetre, 1.5 * millimetre}, 14 * millimetre, 20 * millimetre, 8 * millimetre};
    const BoreLimits limits{20 * millimetre, 1 * millimetre, 2 * millimetre};
    const Boring boring = plan_boring({plug, limits, steel_density}, 1.83 * gram);
    EXPECT_NEAR(boring.deeper / millimetre, 1.83 / (7.85e-3 * 100 * pi), 1e-9);
    EXPECT_EQ(boring.limit, Boring::Limit::none);
    EXPECT_EQ(describe(boring, limits).english(),
              "Bore 0.74 mm deeper with a cutter of 20 mm, to 8.74 mm from the face.");
}

TEST(PlugGeometryTest, BoringRemovesExactlyWhatWasAsked) {
    Workshop workshop(4);
    int bored = 0;
    for (int round = 0; round < 5000; ++round) {
        const double diameter = workshop.between(12, 60);
        PlugGeometry plug{{diameter * millimetre, 1.5 * millimetre},
                          workshop.between(5, 30) * millimetre,
                          workshop.between(0, 0.9) * diameter * millimetre,
                          0.0};
        plug.bore_depth = plug.height * workshop.between(0, 0.9);
        if (geometry_fault(plug)) {
            continue;
        }
        const double density = round % 2 == 0 ? steel_density : aluminium_density;
        const double mass = plug.volume() * density;
        const BoreLimits limits{workshop.between(0.2, 0.95) * diameter * millimetre,
                                workshop.between(0, 2) * millimetre,
                                workshop.between(0, 3) * millimetre};
        const double reduction = workshop.between(0, 0.5) * mass;
        const Boring boring = plan_boring({plug, limits, density}, reduction);
        EXPECT_NEAR(bored_mass(plug, limits.cutter_diameter, boring.depth, density), reduction,
                    1e-12 * mass);
        EXPECT_GE(boring.deeper, 0.0);
        if (boring.limit == Boring::Limit::none) {
            ++bored;
            EXPECT_LE(reduction, boring.max_reduction * (1 + 1e-6) + 1e-9);
            EXPECT_GE((plug.thread.root_diameter() - limits.cutter_diameter) / 2.0,
                      limits.minimum_wall - 2e-9);
            EXPECT_GE(boring.wall, 0.0);
            EXPECT_GT(boring.bottom, 0.0);
            EXPECT_TRUE(boring.deeper == 0.0 || boring.bottom >= limits.minimum_bottom - 2e-9);
            // The bored plug as a body of its own, when the cutter is as wide as the bore, has its
            // centre of mass where the plan says.
            PlugGeometry same = plug;
            same.bore_diameter = limits.cutter_diameter;
            const Boring deeper =
                plan_boring({same, limits, density}, 0.3 * same.volume() * density);
            if (same.volume() > 0 && !geometry_fault(same) && deeper.limit == Boring::Limit::none) {
                PlugGeometry after = same;
                after.bore_depth = deeper.depth;
                EXPECT_NEAR(same.centre_of_mass() - after.centre_of_mass(), deeper.shift,
                            1e-9 * plug.height);
            }
        } else {
            EXPECT_GT(reduction, boring.max_reduction * (1 - 1e-6) - 1e-9);
            EXPECT_NE(describe(boring, limits).english().find("cutter"), std::string::npos);
        }
    }
    EXPECT_GT(bored, 500);
}

TEST(PlugGeometryTest, ImpossiblePlugsAreSaidInWords) {
    PlugGeometry plug = cup;
    plug.bore_depth = plug.height;
    EXPECT_TRUE(geometry_fault(plug));
    plug = cup;
    plug.bore_diameter = 28.5 * millimetre;
    EXPECT_TRUE(geometry_fault(plug));
    EXPECT_FALSE(geometry_fault(cup));
}

}  // namespace
}  // namespace ravnoves::v8_plugs

// The shift of a machined plug's centre of mass that the method neglects.

#include "v8-plugs/shift.h"

#include <gtest/gtest.h>

#include "support.h"
#include "v8-plugs/presets.h"
#include "v8-plugs/results.h"
#include "v8-plugs/solver.h"

namespace ravnoves::v8_plugs {
namespace {

using test::gram;
using test::gram_millimetre;
using test::millimetre;
using test::Workshop;

constexpr double tolerance = 5 * gram_millimetre;

Option option_of(const Engine& plugs, double excess, OptionId id = OptionId::steel_machined) {
    return evaluate_option(id, plugs, excess, tolerance).value();
}

/// First moment of one plug about the crank axis, kg·m, from the mass and centre of the whole body.
double plug_moment(const PlugGeometry& plug, const PlugGeometry& unmachined, double radius,
                   double density) {
    const double inwards = unmachined.centre_of_mass() - plug.centre_of_mass();
    return plug.volume() * density * (radius - inwards);
}

// The bored plug weighed as a body of its own: what the bore takes from the crankpin, and what the
// corrected bore takes.
TEST(Shift, OfABoredPlugIsThatOfTheBody) {
    Workshop workshop(11);
    int corrected = 0;
    for (int round = 0; round < 500; ++round) {
        const double bore = workshop.between(8, 14) * millimetre;
        PlugGeometry plug{{22 * millimetre, 1.5 * millimetre},
                          workshop.between(10, 30) * millimetre,
                          bore,
                          workshop.between(1, 5) * millimetre};
        Engine plugs = workshop.engine();
        plugs.crank_radius = 40 * millimetre;
        plugs.plug_radius = 47.2 * millimetre;
        plugs.steel_plug_mass = plug.volume() * steel_density;
        plugs.max_steel_reduction = 0.5 * *plugs.steel_plug_mass;
        const double excess = 2.36 * workshop.between(0.01, 0.3) * *plugs.steel_plug_mass;
        const Option option = option_of(plugs, excess);
        const BoreSetup setup{plug, {bore, 0.0, 0.0}, steel_density};
        if (plan_boring(setup, option.reduction).limit != Boring::Limit::none) {
            continue;  // pierced
        }
        const auto effect = shift_effect(option, tolerance, setup);
        ASSERT_TRUE(effect);
        const auto taken = [&](double reduction) {
            PlugGeometry after = plug;
            after.bore_depth = plan_boring(setup, reduction).depth;
            return 2.0 * (plug_moment(plug, plug, *plugs.plug_radius, steel_density) -
                          plug_moment(after, plug, *plugs.plug_radius, steel_density));
        };
        const double wanted = excess * *plugs.crank_radius;
        EXPECT_NEAR(taken(option.reduction) - wanted, effect->maximum, 1e-9 * wanted);
        EXPECT_NEAR(effect->residual_unbalance, -effect->maximum, 1e-9 * wanted);
        EXPECT_NEAR(taken(effect->min_reduction), wanted, 1e-9 * wanted);
        EXPECT_EQ(effect->matters, std::abs(effect->maximum) > tolerance);
        if (effect->depth) {
            ++corrected;
            EXPECT_NEAR(bored_mass(plug, bore, *effect->depth, steel_density),
                        effect->min_reduction, 1e-12);
        }
        EXPECT_EQ(describe(*effect, tolerance).empty(), !effect->matters);
    }
    EXPECT_GT(corrected, 100);
}

TEST(Shift, OfTheRangeOfThePaperIsCorrectedAtBothEnds) {
    const Engine& plugs = *find_preset("6 l");
    const Option option = option_of(plugs, 3.0 * gram);
    const ShiftEffect effect = shift_effect(option, tolerance, std::nullopt).value();
    EXPECT_FALSE(effect.planned);
    EXPECT_TRUE(option.feasible);
    EXPECT_TRUE(effect.matters);  // 2 · 2.87 g · 1.2 mm = 6.9 g·mm
    const double counted = *plugs.steel_plug_mass - option.reduction;
    EXPECT_NEAR(effect.maximum, 2 * counted * 1.2 * millimetre, 1e-15);
    EXPECT_NEAR(effect.residual_unbalance, -effect.maximum, 1e-15);
    // Plugs so corrected, with their centre where it really is, weigh on the pin what was counted.
    const auto weight = [&](double reduction, double shift) {
        return (*plugs.steel_plug_mass - reduction) * (*plugs.plug_radius - shift);
    };
    EXPECT_NEAR(weight(effect.min_reduction, 1.2 * millimetre), counted * *plugs.plug_radius,
                1e-15);
    EXPECT_NEAR(weight(effect.max_reduction, 0.8 * millimetre), counted * *plugs.plug_radius,
                1e-15);
    EXPECT_EQ(describe(effect, tolerance).english(),
              "The method neglects the shift of the plug's centre of mass, 0.8 to 1.2 mm in the "
              "paper: the residual is up to 6.9 g·mm, permissible 5.0 g·mm. Enter the plug's sizes "
              "and the cutter, or take off 1.11 g each: the residual is then up to 1.2 g·mm.");
    EXPECT_EQ(describe_action(option, effect.reduction).english(),
              "Take 1.11 g off each of the 8 steel plugs.");
    // Halfway what either end leaves is the same, and less than anywhere else.
    for (const double shift : {0.8 * millimetre, 1.2 * millimetre}) {
        EXPECT_NEAR(2.0 * std::abs(weight(effect.reduction, shift) - counted * *plugs.plug_radius),
                    effect.uncertainty, 1e-15);
    }
    // Of the smaller engine it stays within the tolerance.
    const Engine& small = *find_preset("4.25 l");
    EXPECT_FALSE(shift_effect(option_of(small, 3.0 * gram), tolerance, std::nullopt)->matters);
}

// What is hung counts the plugs as they are machined: the mass that is taken off by headline and
// card, at the radius where its centre then is.
TEST(Shift, BobWeightCountsThePlugsAsMachined) {
    Workshop workshop(12);
    int corrected = 0;
    for (int round = 0; round < 400; ++round) {
        Input input;
        input.engine = workshop.engine();
        input.typed_changes.piston = workshop.between(1, 15) * gram;
        input.changes_given = true;
        input.tolerance = workshop.between(1, 20) * gram_millimetre;
        if (round % 2 == 0) {
            input.plug = PlugSheet{};
            input.plug->thread = Thread{22 * millimetre, 1.5 * millimetre};
            input.plug->height = workshop.between(12, 30) * millimetre;
            input.plug->bore_diameter = 12 * millimetre;
            input.plug->bore_depth = 2 * millimetre;
            input.plug->cutter_diameter = 12 * millimetre;
            input.engine.steel_plug_mass = input.plug->geometry()->volume() * steel_density;
            input.engine.max_steel_reduction = 0.5 * *input.engine.steel_plug_mass;
        }
        const Result result = solve(input);
        for (const auto& option : result.options) {
            if (!option) {
                continue;
            }
            const auto& line = option->bob_weight->lines.at(2);
            ASSERT_EQ(line.name.word, "plugs");
            EXPECT_NEAR(line.mass, option->plug_mass_unmachined - option->take_off(), 1e-15);
            EXPECT_GE(line.mass, 0.0) << "nothing is taken off that the plug has not";
            // The limits of the plug apart, that weighs on the pin what the method counts.
            const double counted = 2.0 * (option->plug_mass_unmachined - option->reduction) *
                                   option->plug_radius / *input.engine.crank_radius;
            if (!option->by_method_alone() || option->shift->reduction > 0.0) {
                corrected += option->by_method_alone() ? 1 : 0;
                EXPECT_NEAR(line.product(), counted, 1e-9 * counted);
            }
        }
    }
    EXPECT_GT(corrected, 50);
}

TEST(Shift, PlugsThatAreNotMachinedHaveNone) {
    const Engine& plugs = *find_preset("6 l");
    const Option as_it_is = option_of(plugs, 6.869 * gram, OptionId::steel_to_aluminium);
    EXPECT_FALSE(as_it_is.machined());
    EXPECT_FALSE(shift_effect(as_it_is, tolerance, std::nullopt));
}

}  // namespace
}  // namespace ravnoves::v8_plugs

#include "v8-plugs/compensation.h"

#include <gtest/gtest.h>

#include <cmath>

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

constexpr int rounds = 2000;

struct Job {
    Input input;
    Result result;

    Job(const Engine& plugs, Crankshaft crankshaft, double excess, double tolerance) {
        input.engine = plugs;
        input.crankshaft = crankshaft;
        input.typed_changes.piston = excess;
        input.tolerance = tolerance;
        result = solve(input);
    }
    Advice::Kind kind() const { return result.advice->kind; }
    std::string words() const { return plug_work(input, result).english(); }
};

TEST(Compensation, BobWeightAfterFullCompensationIsNominal) {
    Workshop workshop(1);
    int compensated = 0;
    for (int round = 0; round < rounds; ++round) {
        const Engine plugs = workshop.engine();
        const MassChanges changes = workshop.changes(30);
        const double excess = unbalanced_mass(changes, *plugs.rod_coefficient);
        for (const OptionId id : all_options) {
            const Option option = evaluate_option(id, plugs, excess, 0.0).value();
            const double nominal =
                bob_weight(plugs, {},
                           needs_new_crankshaft(id) ? Crankshaft::new_plugs : Crankshaft::standard)
                    ->sum();
            const double after =
                bob_weight(plugs, changes, option.plug_mass_unmachined - option.reduction,
                           option.plug_radius)
                    .sum();
            // Whatever the limits leave, and only that, is what the bob weight is off by.
            EXPECT_NEAR(after - nominal, option.residual_mass, 1e-12 * nominal);
            if (option.residual_mass == 0.0) {
                ++compensated;
                EXPECT_NEAR(after, nominal, 1e-12 * nominal);
            }
        }
        // Today's plugs unchanged: the whole excess is there.
        const double before = bob_weight(plugs, changes, Crankshaft::standard)->sum();
        const double nominal = bob_weight(plugs, {}, Crankshaft::standard)->sum();
        EXPECT_NEAR(before - nominal, excess, 1e-12 * nominal);
    }
    EXPECT_GT(compensated, rounds / 2);  // the property has been seen, not skipped
}

TEST(Compensation, ResidualIsExactlyWhatTheLimitsLeave) {
    Workshop workshop(2);
    int short_of = 0;
    int over = 0;
    for (int round = 0; round < rounds; ++round) {
        const Engine plugs = workshop.engine();
        const double tolerance = workshop.between(0, 50) * gram_millimetre;
        const double excess = workshop.between(-50, 300) * gram;
        for (const OptionId id : all_options) {
            const Option option = evaluate_option(id, plugs, excess, tolerance).value();
            const double scale = std::abs(excess) + std::abs(option.maximum);
            EXPECT_DOUBLE_EQ(option.maximum, option.constant + option.slope * option.max_reduction);
            EXPECT_NEAR(option.constant + option.slope * option.required_reduction, excess,
                        1e-14 * scale);
            EXPECT_GE(option.reduction, 0.0);
            EXPECT_LE(option.reduction, option.max_reduction);
            if (excess > option.maximum) {
                ++short_of;
                EXPECT_EQ(option.reduction, option.max_reduction);
                EXPECT_DOUBLE_EQ(option.residual_unbalance,
                                 (excess - option.maximum) * *plugs.crank_radius);
                EXPECT_GT(option.residual_unbalance, 0.0);
            } else if (excess < option.constant) {
                ++over;
                EXPECT_EQ(option.reduction, 0.0);
                EXPECT_DOUBLE_EQ(option.residual_unbalance,
                                 (excess - option.constant) * *plugs.crank_radius);
                EXPECT_LT(option.residual_unbalance, 0.0);
            } else {
                EXPECT_EQ(option.residual_unbalance, 0.0);
                EXPECT_EQ(option.residual_mass, 0.0);
            }
            EXPECT_EQ(option.feasible, std::abs(option.residual_unbalance) <= tolerance);
            EXPECT_EQ(describe_failure(option, tolerance).empty(), option.feasible);
        }
    }
    EXPECT_GT(short_of, 100);
    EXPECT_GT(over, 100);
}

TEST(Compensation, AdviceIsTheCheapestThatWorksOnTheCrankshaftFitted) {
    Workshop workshop(3);
    std::array<int, 6> seen{};
    for (int round = 0; round < rounds; ++round) {
        const Engine plugs = workshop.engine();
        const double tolerance = 5 * gram_millimetre;
        const double excess = workshop.between(-20, 200) * (round % 5 == 0 ? 0.01 : 1.0) * gram;
        const Crankshaft crankshaft = round % 2 == 0 ? Crankshaft::standard : Crankshaft::new_plugs;
        const Job job(plugs, crankshaft, excess, tolerance);
        const Advice& advice = *job.result.advice;
        ++seen[static_cast<std::size_t>(advice.kind)];
        const bool needed = std::abs(excess * *plugs.crank_radius) > tolerance;
        EXPECT_EQ(advice.kind == Advice::Kind::none_needed, !needed);
        std::optional<OptionId> first;
        for (const OptionId id : all_options) {
            if (needs_new_crankshaft(id) == (crankshaft == Crankshaft::new_plugs) && !first &&
                evaluate_option(id, plugs, excess, tolerance)->feasible) {
                first = id;
            }
        }
        if (needed && first) {
            ASSERT_EQ(advice.kind, Advice::Kind::option);
            EXPECT_EQ(*advice.option, *first);
        } else if (needed) {
            EXPECT_NE(advice.kind, Advice::Kind::option);
            if (advice.with_other_crankshaft) {
                EXPECT_NE(needs_new_crankshaft(*advice.with_other_crankshaft),
                          crankshaft == Crankshaft::new_plugs);
                EXPECT_TRUE(evaluate_option(*advice.with_other_crankshaft, plugs, excess, tolerance)
                                ->feasible);
            }
        }
        const std::string words = job.words();
        EXPECT_TRUE(words.ends_with(".")) << words;
        EXPECT_EQ(words.find("nan"), std::string::npos) << words;
    }
    for (const auto kind :
         {Advice::Kind::none_needed, Advice::Kind::option, Advice::Kind::too_light,
          Advice::Kind::none_sufficient, Advice::Kind::none_light_enough}) {
        EXPECT_GT(seen[static_cast<std::size_t>(kind)], 0) << static_cast<int>(kind);
    }
}

TEST(Compensation, WordsOfATechnician) {
    const Engine& plugs = *find_preset("4.25 l");
    const auto words = [&](double excess_g, Crankshaft crankshaft = Crankshaft::standard) {
        return Job(plugs, crankshaft, excess_g * gram, 5 * gram_millimetre).words();
    };
    EXPECT_EQ(words(4.3225), "Take 1.83 g off each of the 8 steel plugs.");
    EXPECT_EQ(words(5.0), "Replace all 8 plugs by aluminium plugs, lightened by 0.28 g each.");
    EXPECT_EQ(words(0.1),
              "Leave the plugs unchanged: the excess of 0.10 g per crankpin is 4.0 g·mm, within "
              "the 5.0 g·mm allowed.");
    EXPECT_EQ(words(4.7),
              "Take 1.95 g off each of the 8 steel plugs. This leaves an excess of 0.10 g on each "
              "crankpin: 3.8 g·mm, within the 5.0 g·mm allowed.");
    EXPECT_EQ(words(7.0),
              "No plug of this crankshaft can be made light enough. The nearest option is "
              "“Aluminium plugs”, which leaves an excess of 1.05 g on each crankpin: 42.1 g·mm "
              "against the 5.0 g·mm allowed. Also take 1.05 g off each piston. A crankshaft for "
              "the new plugs would be suitable: “New crankshaft, aluminium plugs”.");
    EXPECT_EQ(words(-1.0),
              "The parts are 1.00 g per crankpin lighter than nominal (40.0 g·mm). Plugs can only "
              "be lightened: use heavier parts or heavier plugs.");
    EXPECT_EQ(words(1.0, Crankshaft::new_plugs), "Take 0.34 g off each of the 8 new steel plugs.")
        << "0.41 g without the shift of the heavy plug";
    EXPECT_EQ(words(1.92, Crankshaft::new_plugs), "Fit the 8 present steel plugs unchanged.");
}

// The counterweights expect the new plugs: what is taken off them at their own radius is what they
// compensate, up to the limit of today's plugs.
TEST(Compensation, NewPlugsAreMachinedAtTheirOwnRadius) {
    const Engine& plugs = *find_preset("4.25 l");
    const auto option = [&](double excess_g) {
        return evaluate_option(OptionId::new_steel_machined, plugs, excess_g * gram, 0.0).value();
    };
    EXPECT_EQ(option(1.0).constant, 0.0);
    EXPECT_NEAR(option(1.0).reduction / gram, 1.0 * 40.0 / (2.0 * 49.3), 1e-12);
    EXPECT_EQ(option(1.0).residual_mass, 0.0);
    EXPECT_NEAR(option(1.0).maximum / gram, 2.0 * 49.3 / 40.0 * 1.951, 1e-12);
    EXPECT_FALSE(option(4.9).feasible);
    // On this crankshaft every excess up to the largest has an option now.
    for (double excess = 0.0; excess < 7.8; excess += 0.05) {
        EXPECT_EQ(Job(plugs, Crankshaft::new_plugs, excess * gram, gram * millimetre).kind() ==
                      Advice::Kind::option,
                  excess * 40.0 > 1.0)
            << excess;
    }
    // A new plug that is lighter than today's bears less.
    Engine light = plugs;
    light.new_steel_plug_mass = 0.5 * *plugs.steel_plug_mass;
    EXPECT_DOUBLE_EQ(evaluate_option(OptionId::new_steel_machined, light, gram, 0.0)->max_reduction,
                     0.5 * *plugs.max_steel_reduction);
}

TEST(Compensation, EngineWithoutAluminiumOrNewPlugsHasFewerOptions) {
    Engine plugs = *find_preset("6 l");
    set_plugs(plugs, EngineGroup::new_plug, false);
    EXPECT_FALSE(evaluate_option(OptionId::new_steel_to_steel, plugs, gram, 0.0));
    EXPECT_FALSE(evaluate_option(OptionId::new_steel_to_aluminium, plugs, gram, 0.0));
    EXPECT_FALSE(evaluate_option(OptionId::new_steel_machined, plugs, gram, 0.0));
    EXPECT_TRUE(evaluate_option(OptionId::steel_to_aluminium, plugs, gram, 0.0));
    EXPECT_EQ(Job(plugs, Crankshaft::new_plugs, gram, 0.0).kind(), Advice::Kind::no_new_plug_data);
    set_plugs(plugs, EngineGroup::aluminium_plug, false);
    EXPECT_FALSE(evaluate_option(OptionId::steel_to_aluminium, plugs, gram, 0.0));
    EXPECT_TRUE(evaluate_option(OptionId::steel_machined, plugs, gram, 0.0));
}

}  // namespace
}  // namespace ravnoves::v8_plugs

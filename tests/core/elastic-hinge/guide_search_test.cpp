#include "elastic-hinge/guide_search.h"

#include "elastic-hinge/presets.h"

namespace ravnoves::elastic_hinge {
namespace {

class ElasticHingeSearch : public testing::TestWithParam<Branch> {};

TEST_P(ElasticHingeSearch, FindsASpringThatGivesWhatWasWanted) {
    for (const double relief : {0.2e-3, 1e-3, 5e-3}) {
        for (const GuideSign sign : {GuideSign::energy, GuideSign::as_printed}) {
            Input input = preset_zotov();
            input.guide_sign = sign;
            input.roller_radius = 0.008;
            const GuideWish wish{relief, 0.24, {}};
            input.guide_search = wish;
            const GuideProposal found = search_guide(solve(input).design, input, GetParam());
            ASSERT_TRUE(found.found) << found.reason.english();
            input.spring = found.spring;
            const Guide guide = solve(input).crank_guide;
            ASSERT_TRUE(guide.feasible) << guide.reason.english();
            EXPECT_EQ(guide.branch, GetParam());
            EXPECT_NEAR(guide.relief, relief, 1e-9 * relief);
            EXPECT_FALSE(guide.summary().undercut);
            EXPECT_LE(guide.summary().max_radius + input.roller_radius, 0.12 * (1 + 1e-9));
            EXPECT_NEAR(2 * (guide.summary().max_radius + input.roller_radius),
                        found.outer_diameter, 1e-6);
            EXPECT_NEAR(guide.largest_spring_force, found.largest_spring_force,
                        1e-9 * found.largest_spring_force);
            // Its guide is what was wished, and not what asks for more.
            const auto meets = [&](const GuideWish& other) {
                input.guide_search = other;
                return meets_wish(guide, input);
            };
            EXPECT_TRUE(meets(wish));
            const double margin = guide.preload - guide.minimum_preload;
            for (const GuideWish& more :
                 {GuideWish{1.1 * relief, 0.24, {}},
                  GuideWish{relief, found.outer_diameter - 1e-4, {}},
                  GuideWish{relief, 0.24, found.smallest_spring_length + 1e-4},
                  GuideWish{relief, 0.24, {}, margin + 1e-4}}) {
                EXPECT_FALSE(meets(more));
            }
            // The preload has the margin that was asked for, and no more where that decides.
            EXPECT_GE(margin, wish.preload_margin * (1.0 - 1e-6));
            if (guide.minimum_preload > 0.0 && relief < 5e-3) {
                EXPECT_LE(margin, 1.1 * wish.preload_margin);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(BothBranches, ElasticHingeSearch,
                         testing::Values(Branch::compressed, Branch::stretched));

/// Of the paper's crank hinge.
GuideProposal proposal(const GuideWish& wish, Branch branch = Branch::compressed,
                       double roller = 0.0, double free_length = 0.2) {
    Input input = preset_zotov();
    input.guide_search = wish;
    input.roller_radius = roller;
    input.spring->free_length = free_length;
    return search_guide(std::make_shared<const Design>(input), input, branch);
}

TEST(ElasticHingeSearchLimits, TheImpossibleIsRejectedWithASize) {
    const GuideProposal tight = proposal({1e-3, 0.05, {}});
    EXPECT_FALSE(tight.found);
    // The reason names the diameter that would do, to the digits of a drawing.
    const auto needed = std::get<Number>(tight.reason.arguments().at(2));
    const double diameter = needed.value * needed.unit;
    EXPECT_TRUE(proposal({1e-3, diameter * (1 + 1e-3), {}}).found);
    EXPECT_FALSE(proposal({1e-3, diameter * (1 - 1e-2), {}}).found);
    const GuideProposal bulky = proposal({1e-3, 0.5, 0.1985});
    EXPECT_NE(bulky.reason.english().find("it must be at least"), std::string::npos);
    EXPECT_NE(tight.reason.english().find("at least"), std::string::npos) << tight.reason.english();
    const GuideProposal stretched = proposal({1e-3, 0.2, {}, 0.0}, Branch::stretched, 0.01);
    EXPECT_FALSE(stretched.found);
    EXPECT_NE(stretched.reason.english().find("222.2 mm"), std::string::npos)
        << stretched.reason.english();
}

TEST(ElasticHingeSearchLimits, ABigRollerGetsASmootherGuideOrNone) {
    for (const Branch branch : {Branch::compressed, Branch::stretched}) {
        const auto search = [&](double roller) {
            return proposal(GuideWish{16e-3, 0.4, 0.02}, branch, roller, 0.06);
        };
        const GuideProposal small = search(1e-4);
        ASSERT_TRUE(small.found) << small.reason.english();
        bool smoother = false;
        bool rejected = false;
        for (double roller = 0.001; roller < 0.15; roller *= 1.02) {
            const GuideProposal proposal = search(roller);
            if (!proposal.found) {
                rejected = true;
                continue;
            }
            EXPECT_FALSE(rejected) << "a bigger roller cannot be easier";
            Input input = preset_zotov();
            input.spring = proposal.spring;
            input.roller_radius = roller * (1 - 1e-6);
            EXPECT_FALSE(solve(input).crank_guide.summary().undercut) << roller;
            smoother |= proposal.largest_spring_energy > 1.01 * small.largest_spring_energy;
        }
        EXPECT_TRUE(rejected);
        // Preload smooths a stretched spring's guide; a compressed one's is pulled into the middle.
        EXPECT_EQ(smoother, branch == Branch::stretched);
    }
}

TEST(ElasticHingeSearchLimits, AHingeWithoutWorkHasNoGuideToShape) {
    Input input = preset_zotov();
    input.masses_as_weights = false;
    input.gravity = 0.0;
    input.angular_speed = 0.0;
    EXPECT_FALSE(search_guide(solve(input).design, input, Branch::compressed).found);
}

}  // namespace
}  // namespace ravnoves::elastic_hinge

/// The scenes at the limits of their inputs, through the door that users have: a case in, a finite
/// answer or a worded rejection out.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "case-file/json.h"
#include "elastic-hinge/motion.h"
#include "error_of.h"
#include "example_check.h"
#include "inertia-moments/engine.h"
#include "methods/kernel.h"
#include "scenes/scenes.h"
#include "support.h"

namespace ravnoves::methods {
namespace {

/// The "result" of a case.
Json solved(const Json& document) {
    return solve_case(parse_case(document.dump()), CaseContext{RAVNOVES_EXAMPLES}).at("result");
}

std::string rejection(const Json& document) {
    return test::error_of([&] { solved(document); });
}

TEST(SceneLimits, HingeOfARodAsLongAsTheCrank) {
    for (const char* name : {"zotov-energy", "zotov-as-printed", "zotov-counterweight"}) {
        Json document = write_case(test::example(name));
        double last = 0.0;
        for (const double lambda : {0.3, 0.9, 0.99, 0.999, 0.9999, 0.999999}) {
            document["input"]["lambda"] = lambda;
            const Json result = solved(document);
            if (lambda > 0.99995) {
                continue;  // finite; the peak is narrower than the samples lie apart
            }
            // The nearer to locking, the more the crank's moment swings.
            const auto& moment = result.at("curves").at("crank_moment_Nm");
            const double largest =
                std::max_element(moment.begin(), moment.end())->template get<double>();
            EXPECT_GT(largest, last) << name << " " << lambda;
            last = largest;
        }
    }
}

TEST(SceneLimits, LayoutUpToLocking) {
    Json document = write_case(test::example("vr5-volkswagen"));
    const double radius = document["input"]["crank_radius_mm"];
    for (const double lambda : {0.9, 0.99, 0.999, 0.9999}) {
        document["input"]["lambda"] = lambda;
        const double limit = radius * (1.0 / lambda - 1.0);
        for (const double share : {0.0, 0.5, 1.0 - 1e-2, 1.0 - 1e-4}) {
            document["input"]["layout"]["offset_mm"] = share * limit;
            EXPECT_EQ(rejection(document), "no error") << lambda << " " << share;
        }
        for (const double share : {1.0 + 1e-9, 2.0, 1e6}) {
            document["input"]["layout"]["offset_mm"] = share * limit;
            const std::string text = rejection(document);
            EXPECT_TRUE(says(text, "/input/") && (says(text, "lock") || says(text, "not possible")))
                << lambda << " " << share << ": " << text;
        }
    }
}

/// Energy ½ c (2 × preload)²: the smallest preload falls with the root of the stiffness, and a
/// spring too soft for the preload it has is rejected with a reason.
TEST(SceneLimits, SpringStiffnessOverEightDecades) {
    Json document = write_case(test::example("zotov-energy"));
    Json& spring = document["input"]["spring"];
    const double preload = spring["free_length_mm"].get<double>() / 2.0 -
                           spring["guide_radius_at_zero_mm"].get<double>();
    const double printed = spring["stiffness_N_m"];
    const double unit =
        solved(document).at("guide").at("minimum_preload_mm").get<double>() * std::sqrt(printed);
    int feasible = 0;
    int rejected = 0;
    for (double stiffness = 1e3; stiffness < 2e11; stiffness *= 10.0) {
        spring["stiffness_N_m"] = stiffness;
        const Json guide = solved(document).at("guide");
        const double minimum = guide.at("minimum_preload_mm");
        EXPECT_NEAR(minimum * std::sqrt(stiffness) / unit, 1.0, 1e-9) << stiffness;
        const bool possible = guide.at("feasible").get<bool>();
        EXPECT_EQ(possible, minimum <= preload) << stiffness;
        EXPECT_EQ(guide.at("reason").get<std::string>().empty(), possible) << stiffness;
        (possible ? feasible : rejected) += 1;
    }
    EXPECT_GE(feasible, 5);
    EXPECT_GE(rejected, 1);
}

// ------------------------------------------------------- what a scene declares is what it runs

TEST(DeclaredMethods, BelongToScenesOfTheProgram) {
    for (const Kernel& kernel : kernels()) {
        const auto scenes = scene_solvers();
        EXPECT_TRUE(std::any_of(scenes.begin(), scenes.end(), [&](const SceneSolver& scene) {
            return scene.name == kernel.choice.scene;
        })) << kernel.id;
    }
}

TEST(DeclaredMethods, TheScenesRunAtTheDeclaredAccuracy) {
    const auto setting = [](const char* kernel) {
        return std::stod(std::string(find_kernel(kernel)->choice.setting));
    };
    EXPECT_EQ(elastic_hinge::motion_tolerance, setting("hinge-motion"));
    EXPECT_EQ(inertia_moments::order_accuracy, setting("inertia-orders"));
}

}  // namespace
}  // namespace ravnoves::methods

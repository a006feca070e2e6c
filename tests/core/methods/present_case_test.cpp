#include "methods/present_case.h"

#include <gtest/gtest.h>

#include <cmath>

#include "balance-shaft/presets.h"
#include "balance-shaft/scene.h"
#include "balance-shaft/solver.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/scene.h"
#include "inertia-moments/presets.h"
#include "inertia-moments/scene.h"
#include "numerics/constants.h"

namespace ravnoves::methods {
namespace {

std::optional<double> present(const char* kernel_id, const char* sweep, const Json& input) {
    const Kernel& kernel = *find_kernel(kernel_id);
    return present_value(kernel, kernel.find_sweep(sweep), input);
}

double preset(const char* kernel_id, const char* sweep) {
    const Kernel& kernel = *find_kernel(kernel_id);
    return kernel.sweeps[kernel.find_sweep(sweep)].present;
}

/// The sweeps begin at the papers' mechanisms, which are the presets of the scenes.
TEST(PresentCase, ThePapersCasesLieWhereTheSweepsSay) {
    const Json engine = balance_shaft::write_input(balance_shaft::preset_tmz_650d());
    for (const char* kernel : {"cycle-mean", "moment-range"}) {
        EXPECT_NEAR(*present(kernel, "shaft-angle", engine), preset(kernel, "shaft-angle"), 1e-12);
    }
    EXPECT_NEAR(*present("best-angle", "amplitude", engine), preset("best-angle", "amplitude"),
                1e-9);
    const Json hinge = elastic_hinge::write_input(elastic_hinge::preset_zotov());
    for (const char* sweep : {"stiffness", "speed", "lambda"}) {
        const double stated = preset("guide", sweep);
        EXPECT_NEAR(*present("guide", sweep, hinge), stated, 1e-9 * std::abs(stated)) << sweep;
    }
    EXPECT_EQ(*present("hinge-motion", "lambda", hinge), preset("hinge-motion", "lambda"));
    const Json vr5 = inertia_moments::write_input(inertia_moments::preset_vw_vr5());
    for (const char* kernel : {"slider-crank", "inertia-orders"}) {
        EXPECT_EQ(*present(kernel, "lambda", vr5), preset(kernel, "lambda"));
        EXPECT_NEAR(*present(kernel, "offset", vr5), preset(kernel, "offset"), 1e-3);
    }
}

/// What a case states comes back, whatever it states.
TEST(PresentCase, FollowsTheInput) {
    elastic_hinge::Input hinge = elastic_hinge::preset_zotov();
    hinge.lambda = 0.71;
    hinge.angular_speed = 42.0;
    hinge.motion = elastic_hinge::MotionWish{};
    hinge.motion->turns = 17.0;
    hinge.motion->start_speed = 21.0;
    const Json input = elastic_hinge::write_input(hinge);
    EXPECT_EQ(*present("guide", "lambda", input), 0.71);
    EXPECT_EQ(*present("guide", "speed", input), 42.0);
    EXPECT_EQ(*present("hinge-motion", "turns", input), 17.0);
    EXPECT_NEAR(*present("hinge-motion", "start-speed", input), 0.5, 1e-15);

    balance_shaft::Input engine = balance_shaft::preset_tmz_650d();
    engine.shaft_angle = -30.0 * degree;
    engine.centre_distance *= 2.0;
    const Json shaft = balance_shaft::write_input(engine);
    EXPECT_NEAR(*present("moment-range", "shaft-angle", shaft), 330.0, 1e-9);
    EXPECT_NEAR(*present("moment-range", "amplitude", shaft),
                2.0 * preset("moment-range", "amplitude"), 1e-9);
}

TEST(PresentCase, MadeUpProblemsHaveNoPlaceForACase) {
    const Json engine = balance_shaft::write_input(balance_shaft::preset_tmz_650d());
    EXPECT_FALSE(present("best-angle", "second-minimum", engine));
    const Json hinge = elastic_hinge::write_input(elastic_hinge::preset_zotov());
    EXPECT_FALSE(present("hinge-motion", "start-speed", hinge));  // at the design speed
    EXPECT_FALSE(present("guide", "preload", hinge));
}

TEST(PresentCase, BadInputIsRefusedByName) {
    Json hinge = elastic_hinge::write_input(elastic_hinge::preset_zotov());
    hinge["lambda"] = -1;
    try {
        static_cast<void>(present("guide", "lambda", hinge));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.where(), "/input/lambda");
    }
}

/// Every value of a sweep has its place on the sweep's scale, and the places keep their order.
TEST(Sweep, PlacesAndValuesAreInverse) {
    for (const Kernel& kernel : kernels()) {
        for (const SweepInfo& sweep : kernel.sweeps) {
            EXPECT_EQ(sweep.place(sweep.from), 0.0) << kernel.id << ' ' << sweep.id;
            EXPECT_NEAR(sweep.place(sweep.to), 1.0, 1e-12) << kernel.id << ' ' << sweep.id;
            double before = -1.0;
            for (int i = 0; i <= 50; ++i) {
                const double place = i / 50.0;
                const double value = sweep.at(place);
                // Next to a limit a value holds its distance to seven digits.
                EXPECT_NEAR(sweep.place(value), place, 1e-8) << kernel.id << ' ' << sweep.id;
                EXPECT_TRUE(i == 0 || value > before) << kernel.id << ' ' << sweep.id << place;
                before = value;
            }
        }
    }
}

}  // namespace
}  // namespace ravnoves::methods

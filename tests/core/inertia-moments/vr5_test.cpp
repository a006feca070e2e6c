// The paper's engine: N. D. Chainov, P. R. Vallejo Maldonado, 2020. Every number that it prints is
// among those of tests/core/methods/validation_test.cpp.
#include <gtest/gtest.h>

#include "case-file/result_json.h"
#include "engines.h"
#include "inertia-moments/results.h"

namespace ravnoves::inertia_moments {
namespace {

using test::vr5;

// By the contract about the mean of the crankpins, 15.8 mm and more from the z₀ of all others.
TEST(VolkswagenVr5, NamesThePointOfTheRotatingMoment) {
    for (const ResultEntry& entry :
         list_results([](ResultVisitor& visitor) { visit_results(visitor, vr5()); })) {
        if (entry.pointer.starts_with("/rotating/moment_") && entry.unit != units::degree) {
            EXPECT_TRUE(entry.name.english().ends_with(" about mean z")) << entry.pointer;
        }
    }
}

TEST(VolkswagenVr5, TwoTermIsNotEnoughInTheVerticalPlane) {
    const Result result = solve(vr5());
    bool force_1 = false;
    bool force_3 = false;
    for (const Difference& d : result.differences) {
        if (d.component == 1) {  // force, vertical
            force_1 = force_1 || (d.order == 1 && d.warning);
            force_3 = force_3 || (d.order == 3 && d.warning && d.two_term == 0.0);
        }
        if (d.component == 0 && d.order == 1) {  // force, horizontal
            EXPECT_FALSE(d.warning);
            EXPECT_LT(*d.relative, 0.001);
        }
    }
    EXPECT_TRUE(force_1);
    EXPECT_TRUE(force_3);
}

}  // namespace
}  // namespace ravnoves::inertia_moments

// Cases of versions before this one give the numbers that they gave then, examples of the contract
// those that something else than this code found.

#include "fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "case-file/json.h"
#include "case-file/text_file.h"
#include "examples.h"
#include "scenes/scenes.h"

namespace ravnoves {
namespace {

using test::Difference;

/// Of results, "CASE/VARIANT/POINTER" (the variant of the case's own input is empty). Whoever takes
/// a value out of a result adds it here and says why.
const std::vector<Difference> differences_of_results{
    {"inertia-moments/*/difference/*", "orders are right to 1e-11 of m R ω²", 1e-5, 1e-6},
    {"inertia-moments/Two-stroke twin/*/angle_deg", "directions of what rounding leaves of 0"},
    {"inertia-moments/*/exact/*", "orders are right to 1e-11 of m R ω², by another transform", 1e-5,
     1e-6},
    {"inertia-moments/*/remaining/*", "orders are right to 1e-11 of m R ω², by another transform",
     1e-5, 1e-6},
    {"radial/*/exact/*", "orders are right to 1e-11 of m R ω², by another transform", 1e-5, 1e-6},
    {"radial/*/remaining/*", "orders are right to 1e-11 of m R ω², by another transform", 1e-5,
     1e-6},
    {"*/two_term/*/roll_moment_Nm/inertia/*", "what rounding leaves of 0", 1e-9, 1e-12},
    {"inertia-moments/*curves/force_x_N/*", "what rounding leaves of 0", 1e-9, 1e-10},
    {"elastic-hinge/*/guide_search/*", "the search keeps a margin of the preload"},
    {"elastic-hinge/*/steps", "from sample to sample, not stretches with many samples each"},
    {"elastic-hinge/*/energy_drift", "rounding is all that it is", 1e-5, 1e-14},
    {"*/relieved_shaft/*sag_mm", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/*stress_MPa", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/bearing_*", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/weight_N", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/whirling_speed_rpm", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/deflection_mm", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/journal_slope_rad", "bending of the relieved shaft is not computed"},
    {"*/relieved_shaft/feasible", "it depends on the unbalance and the swing circle alone"},
    {"*/relieved_shaft/reason", "the same"},
    {"balance-shaft/*/notes/*", "the verdict says where no angle helps"},
    {"two-stroke/*/notes/*", "the same"},
    {"balance-shaft/*/best_position_buildable/front/*", "other sizes and places of the same front"},
    {"balance-shaft/*/best_position_buildable/*", "places as good to the gap, up to 0.1 µm apart",
     1e-5, 1e-7},
    {"balance-shaft/*/least_bad/range_relative/worst_speed_rpm",
     "two speeds are equally bad there"},
    {"*/speed_band/least_bad_place*", "over a band there is the least bad angle alone"},
    {"two-stroke/*/clearances/*", "the bar of the relieved shaft is what must be clear"},
    {"two-stroke/*/envelope*/*", "the same"},
    {"two-stroke/*buildable/*", "the same"},
    {"bob-weights/Split pins/bobweight*", "a bob weight hangs on each of two split crankpins"},
    {"bob-weights/Split pins/lines/*", "of one crankpin, as the bob weight"},
    {"v8-plugs/*/corrected_reduction_g/*", "in the order of shift_mm"},
    {"v8-plugs//weigh_in/assignment/*_from_cylinder/*", "another placing of the same spread"},
    {"v8-plugs//weigh_in/assignment/crankpins/*", "of that placing"},
    {"v8-plugs//weigh_in/assignment/shaking/*", "of that placing"},
    {"v8-plugs/*/options/*/plug_mass_g", "as machined, also where the shift counts"},
    {"v8-plugs/*/options/*/bobweight*", "with the plugs as machined, also where the shift counts"},
    {"v8-plugs/Weighed/*", "shells that are weighed count in manufacture too"},
};

class FixtureCase : public testing::TestWithParam<std::string> {};

TEST_P(FixtureCase, GivesTheNumbersThatItGave) {
    const CaseContext context{test::fixture_folder()};
    CaseFile file = parse_case(read_text_file(context.directory / (GetParam() + ".case.json")));
    const Json document = test::fixture(GetParam() + ".case.json");
    const std::vector<CaseVariant> variants = file.variants;
    ASSERT_EQ(variants.size(), document.value("variants", Json::array()).size());
    EXPECT_EQ(file.reference, document.value("reference", ""));
    const Json results = test::fixture(GetParam() + ".result.json");
    ASSERT_EQ(results.size(), variants.size() + 1);
    file.variants.clear();
    file.reference.clear();
    const auto check = [&](const std::string& name) {
        Json now;
        ASSERT_NO_THROW(now = solve_case(file, context).at("result")) << name;
        const auto found = test::differences(GetParam() + "/" + name, results.at(name), now,
                                             differences_of_results);
        EXPECT_TRUE(found.empty()) << test::first_of(found);
    };
    check("");
    for (const CaseVariant& variant : variants) {
        file.input = variant.input;
        check(variant.name);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, FixtureCase, testing::ValuesIn(test::fixtures_with(".result.json")),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

/// Of examples, as above.
const std::vector<Difference> differences_of_examples{
    {"*", "as near as the contract asks for", 1e-6},
    {"*/exact/*", "what rounding leaves of 0", 1e-6, 1e-9},
    {"vr5-volkswagen/two_term/order_4/*/angle_deg", "null: the direction of no length"},
};

/// The curves of a result at the crank angles of the expected samples, as a fixture has them.
Json curves_of(const Json& samples, const Json& curves) {
    const auto angles = curves.at("crank_angle_deg").get<std::vector<double>>();
    Json found;
    for (const auto& curve : samples.items()) {
        for (std::size_t k = 0; k < curve.value().size(); ++k) {
            const double angle = samples.at("crank_angle_deg").at(k);
            const auto at = std::find_if(angles.begin(), angles.end(), [&](double each) {
                return std::abs(each - angle) < 1e-9;
            });
            found[curve.key()][std::to_string(at - angles.begin())] = curve.value().at(k);
        }
    }
    return found;
}

TEST(Examples, HaveTheNumbersOfTheContract) {
    std::set<std::string> scenes{"workshop"};  // as v8-plugs and bob-weights
    for (const auto& each : std::filesystem::directory_iterator(RAVNOVES_EXPECTED)) {
        const std::string name = each.path().stem().stem().string();
        const Json document = parse_json(read_text_file(each.path()));
        const CaseFile file = test::example(name);
        EXPECT_EQ(document.at("scene"), file.scene) << name;
        scenes.insert(file.scene);
        const Json result = solve_case(file, CaseContext{RAVNOVES_EXAMPLES}).at("result");
        Json expected = document.at("expected");
        if (expected.contains("samples")) {
            expected["curves"] = curves_of(expected["samples"], result.at("curves"));
            expected.erase("samples");
        }
        const auto found = test::differences(name, expected, result, differences_of_examples);
        EXPECT_TRUE(found.empty()) << test::first_of(found);
    }
    EXPECT_EQ(scenes.size(), scene_solvers().size());
}

}  // namespace
}  // namespace ravnoves

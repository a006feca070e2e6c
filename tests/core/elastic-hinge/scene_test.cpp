#include "case-file/case_file.h"
#include "case-file/json.h"
#include "case-file/result_json.h"
#include "elastic-hinge/input.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/results.h"

#include "examples.h"
#include "support.h"

namespace ravnoves::elastic_hinge {
namespace {

TEST(ElasticHingeCase, FirstCasesCanBeMade) {
    for (const char* name : {"zotov-softer-spring", "../templates/elastic-hinge"}) {
        const Input input = read_input(ravnoves::test::example(name).input);
        EXPECT_EQ(verdict(input, solve(input)).severity, Severity::good) << name;
    }
}

TEST(ElasticHingeCase, PresetIsTheExample) {
    EXPECT_EQ(read_input(ravnoves::test::example("zotov-energy").input), preset_zotov());
}

/// Every key that a case may hold.
Json full_case(bool weights) {
    Json json = parse_json(R"({
        "gravity_m_s2": 9.82, "crank_radius_mm": 50.0, "lambda": 0.3, "angular_speed_rad_s": 100.0,
        "kinematics": "series", "guide_sign": "as-printed",
        "spring": {"stiffness_N_m": 2e7, "free_length_mm": 200.0, "guide_radius_at_zero_mm": 90.3},
        "rod_hinge_spring": {"stiffness_N_m": 123456.7, "free_length_mm": 190.0,
                             "guide_radius_at_zero_mm": 100.3},
        "rod_counterweight": {"distance_mm": 77.7, "inertia": "newton-euler"},
        "roller_radius_mm": 6.35, "profile_error_um": 3.3, "profile_error_waves": 5,
        "guide_search": {"relief_mm": 1.1, "outer_diameter_mm": 310.0,
                         "smallest_spring_length_mm": 70.7},
        "motion": {"turns": 7.5, "start_speed_rad_s": 90.0, "start_angle_deg": 33.3,
                   "crank_torque_Nm": 0.25, "with_profile_error": true}})");
    const Json masses{{"crank", 5.1}, {"rod", 6.5}, {"slider", 6.3}};
    json[weights ? "weights_N" : "masses_kg"] = masses;
    json["rod_counterweight"][weights ? "weight_N" : "mass_kg"] = 1.23;
    return json;
}

TEST(ElasticHingeCase, APreloadOfExactlyTheMinimumIsFeasible) {
    for (const char* name : {"zotov-energy", "zotov-as-printed", "zotov-counterweight"}) {
        Json json = ravnoves::test::example(name).input;
        const auto guide = [&] { return result_json({}, read_input(json)).at("guide"); };
        const double minimum = guide().at("minimum_preload_mm").get<double>();
        for (const double side : {-1.0, 1.0}) {
            json["spring"]["guide_radius_at_zero_mm"] = 100.0 + side * minimum;
            EXPECT_TRUE(guide().at("feasible").get<bool>()) << name << side;
            json["spring"]["guide_radius_at_zero_mm"] = 100.0 + side * minimum * (1 - 1e-6);
            EXPECT_FALSE(guide().at("feasible").get<bool>()) << name << side;
        }
    }
}

TEST(ElasticHingeCase, TheSpringOfTheSearchMeetsTheWish) {
    Json json = ravnoves::test::example("zotov-energy").input;
    json["guide_search"] = {{"relief_mm", 1}, {"outer_diameter_mm", 250}};
    const Json result = result_json({}, read_input(json));
    EXPECT_EQ(result.at("guide_search").at("feasible"), true);
    json["spring"] = result.at("guide_search").at("spring");
    EXPECT_NEAR(result_json({}, read_input(json)).at("guide").at("relief_mm").get<double>(), 1.0,
                1e-6);
}

TEST(ElasticHingeCase, ErrorsNameTheField) {
    struct Row {
        const char* pointer;
        Json value;         // null: there is none
        const char* error;  // its beginning
        bool weights = true;
        Json merged = {};  // into the case besides
    };
    const Json weightless{{"crank", 0}, {"rod", 0}, {"slider", 0}};
    std::vector<Row> rows{
        {"/crank_radius_mm", -50, "/input/crank_radius_mm: "},
        {"/weights_N/rod", "x", "/input/weights_N/rod: must be a number, got \"x\""},
        {"/weights_N/bar", 1, "/input/weights_N/bar: "},
        {"/masses_kg", {{"crank", 5.1}, {"rod", 6.5}, {"slider", 6.3}}, "/input/masses_kg: "},
        {"/lambda", 1.5, "/input/lambda: must be from 1e-06 to 1, got 1.5"},
        {"/lambda", 1, "/input/lambda: must be less than 1", true, {{"kinematics", "exact"}}},
        {"/spring/free_length_mm", {}, "/input/spring/free_length_mm: is required and missing"},
        {"/rod_counterweight/weight_N", "auto",
         "/input/rod_counterweight/weight_N: must be a number or \"solve\", got \"auto\""},
        {"/gravity_m_s2", 0, "/input/gravity_m_s2: "},
        {"/weights_N", weightless, "/input/weights_N: must together be more than 0"},
        // A key that belongs to weights is named itself where masses are given.
        {"/rod_counterweight",
         {{"distance_mm", 77.7}, {"weight_N", 3.0}},
         "/input/rod_counterweight/weight_N: ",
         false}};
    for (const double huge : {1e300, -1e300, 5e-324}) {
        rows.push_back({"/crank_radius_mm", huge, "/input/crank_radius_mm"});
        rows.push_back({"/lambda", huge, "/input/lambda"});
        rows.push_back({"/gravity_m_s2", huge, "/input/gravity_m_s2"});
        rows.push_back({"/spring/stiffness_N_m", huge, "/input/spring/stiffness_N_m"});
    }
    for (const auto& [pointer, value, error, weights, merged] : rows) {
        Json json = full_case(weights);
        json.update(merged.is_null() ? Json::object() : merged);
        const Json::json_pointer at(pointer);
        json[at] = value;
        if (value.is_null()) {
            json[at.parent_pointer()].erase(at.back());
        }
        const std::string said = test::error_of([&] { read_input(json); });
        EXPECT_TRUE(said.starts_with(error)) << said;
    }
}

/// What the help says of an empty field is what the program takes for it.
TEST(ElasticHingeCase, AnEmptyFieldStandsForWhatTheHelpSays) {
    Json json = ravnoves::test::example("zotov-counterweight").input;
    json["guide_search"] = {{"relief_mm", 1.0}, {"outer_diameter_mm", 250.0}};
    json["motion"] = {{"turns", 1.0}};
    const auto solved = [](const Json& input) { return result_json({}, read_input(input)); };
    const Json empty = solved(json);
    const double r = json.at("crank_radius_mm");
    const double length = r / json.at("lambda").get<double>();
    const Json& weights = json.at("weights_N");
    const double by_10 =
        (weights.at("slider").get<double>() + weights.at("rod").get<double>() / 2) * length /
        json.at("rod_counterweight").at("distance_mm").get<double>();
    const std::pair<const char*, Json> defaults[] = {
        {"/motion/start_speed_rad_s", json.at("angular_speed_rad_s")},
        {"/guide_search/smallest_spring_length_mm",
         0.4 * json.at("spring").at("free_length_mm").get<double>()},
        {"/rod_counterweight/weight_N", "solve"},
        {"/rod_counterweight/inertia", "newton-euler"}};
    for (const auto& [pointer, value] : defaults) {
        Json without = json;
        Json::json_pointer at(pointer);
        without.at(at.parent_pointer()).erase(at.back());
        Json with = json;
        with[at] = value;
        EXPECT_EQ(solved(with), solved(without)) << pointer;
    }
    EXPECT_NEAR(empty.at("counterweight_weight_N").get<double>(), by_10, 1e-9 * by_10);
}

}  // namespace
}  // namespace ravnoves::elastic_hinge

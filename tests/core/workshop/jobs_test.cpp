// Jobs give the numbers of the scenes that they join.

#include "support.h"
#include "workshop/results.h"
#include "workshop/solver.h"

namespace ravnoves::workshop {
namespace {

using test::at;
using test::card;
using test::difference;
using test::error_of;
using test::number;
using test::plugs_card;
using test::solved;

TEST(Job, KeepsTheHolesThatTheOldFormatPlannedOfItself) {
    Json input = card();
    Json& readings = input["correction"]["readings"];
    readings = parse_json(R"([
        {"unbalance_g_mm": 4000, "angle_deg": 30}, {"unbalance_g_mm": 3000, "angle_deg": 200}])");
    const Json planned = test::solved_bob_weights_case(input).at("correction").at("planes");
    // The drilling did what it was to.
    input["correction"]["earlier_runs"] = {{{"readings", readings}}};
    for (std::size_t i = 0; i < 2; ++i) {
        readings[i] = {{"unbalance_g_mm", planned[i].at("remaining_g_mm")},
                       {"angle_deg", planned[i].at("remaining_angle_deg")}};
    }
    const Json was = test::solved_bob_weights_case(input).at("correction");
    const Json job = write_input(read_as_job("bob-weights", input).value());
    const Json is = solved(job).at("correction");
    EXPECT_EQ(job.at("correction").at("earlier_runs")[0].at("drilled").size(),
              was.at("runs")[0].at("planes")[0].at("drilled_holes").size() +
                  was.at("runs")[0].at("planes")[1].at("drilled_holes").size());
    EXPECT_EQ(difference(was.at("runs"), is.at("runs")), "");
    for (const char* key : {"unbalance_g_mm", "angle_deg", "grams_at_radius"}) {
        EXPECT_NEAR(was.at("planes")[0].at(key), is.at("planes")[0].at(key), 1e-9);
    }
    // A job that does not say what was drilled knows of no hole.
    Json bare = job;
    bare["correction"]["earlier_runs"][0].erase("drilled");
    EXPECT_TRUE(
        solved(bare).at("correction").at("runs")[0].at("planes")[0].at("drilled_holes").empty());
    EXPECT_FALSE(read_as_job("elastic-hinge", Json::object()));
}

TEST(Job, GivesAVerdictForReadingsWithoutAngleOrPlanes) {
    Json input = card();
    Json& correction = input["correction"];
    correction.erase("planes");
    correction["readings"] = parse_json(R"([{"unbalance_g_mm": 300}, {"unbalance_g_mm": 500}])");
    Json result = solved(input);
    EXPECT_NEAR(number(result, "/permissible_g_mm/0"), 416.7, 0.1);
    const Json planes = result.at("correction").at("planes");
    EXPECT_TRUE(planes[0].at("within_tolerance_as_measured").get<bool>());
    EXPECT_FALSE(planes[1].at("within_tolerance_as_measured").get<bool>());
    EXPECT_TRUE(planes[0].at("holes").is_null());
    EXPECT_EQ(result.at("verdict").at("severity"), "error");
    correction["readings"][1]["unbalance_g_mm"] = 400;
    EXPECT_EQ(solved(input).at("verdict").at("severity"), "good");
    // With an angle it is a plan, and that needs planes.
    correction["readings"][0]["angle_deg"] = 30;
    EXPECT_TRUE(solved(input).at("correction").at("planes")[0].at("holes").is_null());
    correction["readings"][1]["angle_deg"] = 90;
    EXPECT_EQ(error_of(input), "/input/correction/planes: must be a list of two, got 0");
    // Before any reading the bob weight is what there is to say.
    input.erase("correction");
    result = solved(input);
    EXPECT_EQ(result.at("verdict").at("severity"), "note");
    const std::string text = result.at("verdict").at("text");
    const std::size_t weight = text.find(" of ");
    ASSERT_NE(weight, std::string::npos) << text;
    EXPECT_NEAR(std::stod(text.substr(weight + 4)), number(result, "/bobweight_g"), 0.06) << text;
    EXPECT_FALSE(result.contains("correction"));
}

TEST(Job, JudgesReadingsBesideThePlanesWithAnglesAlone) {
    Json input = plugs_card();
    input["correction"]["readings"] =
        parse_json(R"([{"unbalance_g_mm": 300, "position_mm": -1000}, {"unbalance_g_mm": 400}])");
    const auto front = [](const Json& result) { return at(result, "/plugs/balancing/front"); };
    Json result = solved(input);
    EXPECT_TRUE(result.at("correction").at("runs")[0].at("within_tolerance").is_null());
    EXPECT_EQ(result.at("verdict").at("severity"), "error");
    EXPECT_FALSE(front(result).contains("passes"));
    // With angles it is known what they are in the planes: far beyond their limits.
    for (Json& reading : input["correction"]["readings"]) {
        reading["angle_deg"] = reading.contains("position_mm") ? 0 : 180;
    }
    result = solved(input);
    const Json& plane = at(result, "/correction/planes/0");
    EXPECT_NEAR(number(plane, "/unbalance_g_mm"), 300.0 * 1480.0 / 420.0, 1e-6);
    EXPECT_FALSE(plane.at("within_tolerance_as_measured").get<bool>());
    EXPECT_FALSE(front(result).contains("passes"));
    // In the planes the plugs' limits judge them, too.
    input["correction"]["readings"][0]["position_mm"] = 60;
    EXPECT_TRUE(front(solved(input)).at("passes").get<bool>());
}

TEST(Job, OfPlugsWithReadingsIsJudgedAsByTheirFormat) {
    Json input = plugs_card().at("plugs");
    input.erase("mass_changes_g");
    input["balancing"] = parse_json(R"({
        "grade_mm_s": 16, "rotor_mass_kg": 30, "service_speed_rpm": 5500,
        "front_reading_g_mm": 300, "rear_reading_g_mm": 400})");
    const Json was = test::solved_plugs_case(input);
    const Input job = read_as_job("v8-plugs", input, Completeness::as_is).value();
    EXPECT_EQ(verdict(job, solve(job, false)).text.english(), was.at("verdict").at("text"));
    // Of an engine without nominal masses neither says anything.
    input["engine"].erase("rotating_mass_g");
    EXPECT_NE(error_of(input, test::solved_plugs_case), "no error");
    const Input half = read_as_job("v8-plugs", input, Completeness::as_is).value();
    EXPECT_EQ(solve(half, false).doubts.at(0).rule->word, "unknown-bob-weight");
}

TEST(Job, AsksForTheReadingOfTheOtherPlane) {
    Json input = card();
    input["correction"]["readings"] = parse_json(R"([{"unbalance_g_mm": 300}, {}])");
    const auto said = [&] { return solved(input).at("verdict").at("text"); };
    EXPECT_EQ(said(), "Enter the reading of the other plane.");
    input.erase("tolerance");
    EXPECT_EQ(said(), "Enter the permissible residual for a verdict.");
}

TEST(Job, OfASheetHalfFilledHangsNothingWithoutThePlugs) {
    Json input = plugs_card();
    input["plugs"]["engine"].erase("plug_radius_mm");
    input.erase("correction");
    for (const char* part : {"piston", "rod_big_end"}) {
        input["weigh_in"][part] = {{"nominal_g", 560}, {"mass_g", std::vector<double>(8, 562.0)}};
    }
    const Input half = read_input(input, Completeness::as_is);
    const Result result = solve(half);
    EXPECT_FALSE(result.shaft.bob_weight);
    EXPECT_TRUE(result.shaft.lines.empty());
    EXPECT_EQ(verdict(half, result).text.english(),
              "Enter the missing values of engine and parts.");
}

TEST(Job, OfASheetHalfFilledHasAsManyRowsAsThePlugsNeed) {
    Json input = plugs_card();
    input["plugs"].erase("mass_changes_g");
    input["plugs"]["mass_changes_from"] = "weigh-in";
    for (const int cylinders : {6, 8, 10}) {
        Json other = input;
        other["engine"]["cylinders"] = cylinders;
        other["weigh_in"]["piston"] = {
            {"nominal_g", 560},
            {"mass_g", std::vector<double>(static_cast<std::size_t>(cylinders), 562.0)}};
        const Input half = read_input(other, Completeness::as_is);
        const auto whole = whole_plugs(half);
        EXPECT_EQ(whole->weigh_in->columns[0].mass.size(), 8U);
        EXPECT_EQ(solve(half).shaft.placing.has_value(), cylinders == 8) << cylinders;
    }
}

TEST(Job, SkipsADeepeningToLessAndStops) {
    Json input = card();
    input["correction"]["earlier_runs"] = parse_json(R"([{
        "drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 10, "from_depth_mm": 12,
                     "angle_deg": 40}]}])");
    const Json result = solved(input);
    EXPECT_EQ(at(result, "/doubts/0/kind"), "shallower-hole");
    EXPECT_TRUE(at(result, "/verdict/text").get<std::string>().starts_with("STOP. "));
    EXPECT_FALSE(solve(read_input(input)).shaft.runs[0].is_drilled());
    // By the record, which was corrected: deepened from 9, whatever was planned.
    auto& runs = input["correction"]["earlier_runs"];
    runs.insert(runs.begin(), runs[0]);
    runs[0]["drilled"][0].update({{"depth_mm", 9}, {"from_depth_mm", 0}});
    EXPECT_TRUE(solve(read_input(input)).shaft.runs[1].is_drilled());
    Json newest = card();
    newest["correction"]["drilled"] = runs[1]["drilled"];
    EXPECT_EQ(error_of(newest), "no error");
    // The older format has no doubts.
    input["tolerance"] = {{"g_mm", 300}};
    EXPECT_EQ(error_of(input, test::solved_bob_weights_case),
              "/input/correction/earlier_runs/1/drilled/0/from_depth_mm: must be less than the "
              "depth, 10, got 12");
}

TEST(Job, OfASheetHalfFilledSaysWhatIsMissing) {
    for (Json input : {card(), plugs_card()}) {
        input.erase("parts_g");
        input.erase("correction");
        if (input.contains("plugs")) {
            input["plugs"]["engine"] = "14.86 l";
        }
        const Input half = read_input(input, Completeness::as_is);
        const Result result = solve(half, false);
        EXPECT_FALSE(result.shaft.bob_weight);
        EXPECT_EQ(verdict(half, result).severity, Severity::note);
        EXPECT_EQ(read_input(write_input(half), Completeness::as_is), half);
    }
}

TEST(Job, RejectsWhatDoesNotGoTogether) {
    EXPECT_EQ(error_of(plugs_card()), "no error");
    test::expect_rejected(
        plugs_card(),
        {{"/parts_g", {{"piston", 500}}, "/input/parts_g: must be left out with plugs"},
         {"/factor", {{"reciprocating_percent", 40}}, "/input/factor: must be left out with plugs"},
         {"/engine/bank_angle_deg", 60, "/input/plugs: is allowed only"},
         {"/engine/cylinders", 6, "/input/plugs: is allowed only"},
         {"/engine/pin_split_deg", 5, "/input/plugs: is allowed only"},
         {"/weigh_in/piston/mass_g", std::vector<double>(8, 560.0),
          "/input/weigh_in/piston/nominal_g: is required and missing"},
         {"/plugs/engine/max_steel_reduction_g", 40,
          "/input/plugs/engine/max_steel_reduction_g: must be less than"},
         {"/plugs/plug/bore_depth_mm", 14, "/input/plugs/plug: must be a possible plug"},
         {"/plugs/balancing", Json::object(), "/input/plugs/balancing: is not a known key"},
         {"/plugs/weigh_in", Json::object(), "/input/plugs/weigh_in: "},
         {"/machine/planes", {"left"}, "/input/machine/planes: must be"},
         {"/correction/earlier_runs", Json::array({{{"readings", {{{"angle_deg", 1}}}}}}),
          "/input/correction/earlier_runs/0/readings"}});
    Json unweighed = plugs_card();
    unweighed["plugs"].erase("mass_changes_g");
    unweighed["plugs"]["mass_changes_from"] = "weigh-in";
    EXPECT_EQ(error_of(unweighed),
              "/input/weigh_in: is required where mass_changes_from is \"weigh-in\"");
}

}  // namespace
}  // namespace ravnoves::workshop

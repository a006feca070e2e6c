// What is doubted is not answered: no hole, no bold weight and no pass is in the result.

#include <set>
#include <tuple>
#include <utility>

#include "case-file/result_json.h"
#include "doubted_jobs.h"
#include "workshop/doubts.h"
#include "workshop/results.h"
#include "workshop/solver.h"

namespace ravnoves::workshop {
namespace {

using test::at;
using test::card;
using test::changed;
using test::difference;
using test::doubted;
using test::eight;
using test::plugs_card;
using test::solved;
using test::twice_drilled;
using test::weighed_card;

bool has(const Json& blocks, const char* word) {
    return std::find(blocks.begin(), blocks.end(), word) != blocks.end();
}

/// Every pass that a result says, but in what is doubtful.
void expect_no_pass(const Json& value, const std::string& where) {
    if (value.is_structured()) {
        for (const auto& item : value.items()) {
            if (item.key() != "doubtful" && item.key() != "within_permitted_spread") {
                expect_no_pass(item.value(), where + "/" + item.key());
            }
        }
    } else if (where.ends_with("/passes") || where.find("/within_tolerance") != std::string::npos) {
        EXPECT_NE(value, true) << where;
    }
}

/// Nothing that would have a plug machined or left.
void expect_no_plug(const Json& plugs) {
    for (const char* key : {"recommended", "reason", "state", "warning"}) {
        EXPECT_TRUE(plugs.at(key).is_null()) << key;
    }
    EXPECT_FALSE(plugs.contains("bobweight"));
    for (const Json& option : plugs.at("options")) {
        for (const char* key : {"reduction_g", "required_reduction_g", "feasible", "bobweight_g",
                                "residual_mass_g", "residual_unbalance_g_mm"}) {
            EXPECT_TRUE(option.at(key).is_null()) << key;
        }
        for (const char* key : {"bobweight", "boring", "shift_effect", "plug_mass_g", "reason"}) {
            EXPECT_FALSE(option.contains(key)) << key;
        }
    }
}

class EveryDoubt : public testing::TestWithParam<DoubtRule> {};

TEST_P(EveryDoubt, BlocksWhatItNames) {
    const DoubtRule& rule = GetParam();
    const auto job = doubted().find(rule.word);
    ASSERT_NE(job, doubted().end()) << "a doubt needs a job that has it: " << rule.word;
    // As the form has it: a column of the weigh-in may be half filled.
    const Input input = read_input(job->second(), Completeness::as_is);
    if (const Result half = solve(input, false); !half.shaft.bob_weight) {
        // No result is written, and nothing is left of the answer.
        ASSERT_EQ(half.doubts.size(), 1U);
        EXPECT_EQ(half.doubts[0].rule->word, rule.word);
        EXPECT_TRUE(verdict(input, half).text.english().starts_with("STOP. "));
        ASSERT_TRUE(half.shaft.correction && !half.shaft.correction->at(0).holes.empty());
        const Result left = allowed(half);
        EXPECT_FALSE(left.shaft.correction || left.shaft.newest()->passes());
        return;
    }
    const Json result = result_json({}, input);
    const Json& doubts = result.at("doubts");
    const auto found = std::find_if(doubts.begin(), doubts.end(),
                                    [&](const Json& each) { return each.at("kind") == rule.word; });
    ASSERT_NE(found, doubts.end()) << doubts.dump(1);
    const Json& blocks = found->at("blocks");
    EXPECT_EQ(found->at("severity"), severity_word(rule.severity));
    EXPECT_EQ(has(blocks, "bobweight"), rule.blocks.bob_weight);
    EXPECT_EQ(has(blocks, "holes"), rule.blocks.holes);
    EXPECT_EQ(has(blocks, "verdict"), rule.blocks.verdict);
    EXPECT_FALSE(found->at("text").get<std::string>().empty());
    const Json& planes = result.at("correction").at("planes");
    if (!rule.blocks.any()) {
        EXPECT_TRUE(result.at("doubtful").is_null()) << doubts.dump(1);
        EXPECT_TRUE(result.at("bobweight_g").is_number());
        EXPECT_EQ(planes[0].at("holes").is_array(), rule.word != "missing-angle");
        if (result.contains("plugs")) {
            EXPECT_TRUE(result.at("plugs").at("state").is_string());
        }
        if (rule.severity == Severity::warning) {
            EXPECT_NE(result.at("verdict").at("text").get<std::string>().find(
                          found->at("text").get<std::string>()),
                      std::string::npos);
        }
        return;
    }
    EXPECT_EQ(rule.severity, Severity::error);
    EXPECT_EQ(result.at("verdict").at("severity"), "error");
    EXPECT_TRUE(result.at("verdict").at("text").get<std::string>().starts_with("STOP. "));
    const Json& doubtful = result.at("doubtful");
    if (rule.blocks.bob_weight) {
        EXPECT_TRUE(result.at("bobweight_g").is_null());
        EXPECT_TRUE(result.at("lines").is_null());
        EXPECT_TRUE(doubtful.at("bobweight_g").is_number());
        if (result.contains("plugs")) {
            expect_no_plug(result.at("plugs"));
            EXPECT_TRUE(doubtful.at("plugs").at("state").is_string());
        }
    }
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_TRUE(planes[i].at("holes").is_null());
        EXPECT_TRUE(planes[i].at("slugs").is_null());
        EXPECT_TRUE(planes[i].at("remaining_g_mm").is_null());
        EXPECT_TRUE(planes[i].at("within_tolerance").is_null());
        EXPECT_EQ(doubtful.at("correction").at("planes")[i].at("holes").is_array(),
                  rule.blocks.holes);
    }
    if (rule.blocks.verdict) {
        EXPECT_TRUE(planes[0].at("within_tolerance_as_measured").is_null());
        EXPECT_FALSE(doubtful.at("verdict").at("text").get<std::string>().empty());
    }
    expect_no_pass(result, "");
}

INSTANTIATE_TEST_SUITE_P(Of, EveryDoubt,
                         testing::ValuesIn(doubt_rules().begin(), doubt_rules().end()),
                         [](const auto& info) {
                             std::string name(info.param.word);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(Doubts, OfADiameterNeedNoCrankRadius) {
    Json input = card();
    for (Json& plane : input["correction"]["planes"]) {
        plane["radius_mm"] = 156;
    }
    const Json doubts = solved(input).at("doubts");
    ASSERT_EQ(doubts.size(), 2U) << doubts.dump(1);
    EXPECT_EQ(doubts[0].at("kind"), "far-radius");
    EXPECT_NE(doubts[1].at("text").get<std::string>().find("not the diameter"), std::string::npos);
}

TEST(Doubts, OfAHeavyCrankshaftAreNoneOfRealOnes) {
    struct Case {
        const char* engine;
        double of_card;  ///< the masses of card(), times
        double mass_kg;
        bool is_doubted;
    };
    const char* const eight = R"({"type": "v", "cylinders": 8, "bank_angle_deg": 90})";
    const char* const six =
        R"({"type": "v", "cylinders": 6, "bank_angle_deg": 90, "pin_split_deg": 30})";
    const Case cases[] = {
        {eight, 1.0, 32, false},               // of a passenger car
        {eight, 1.0, 33 + 10 + 8 + 4, false},  // with flywheel, clutch and damper
        {eight, 4.5, 180, false},              // of a lorry
        {eight, 4.5, 180 + 45 + 45 + 15, false},
        {R"({"type": "v", "cylinders": 6, "bank_angle_deg": 90})", 4.5, 160 + 45 + 40 + 15, false},
        {six, 0.7, 22, false},
        {six, 0.7, 22 + 10 + 6, false},
        {R"({"type": "v", "cylinders": 4, "bank_angle_deg": 60, "pin_split_deg": 60})", 0.7,
         14 + 9 + 6 + 2, false},
        {R"({"type": "v", "cylinders": 12, "bank_angle_deg": 60})", 1.0, 45, false},
        {R"({"type": "v", "cylinders": 2, "bank_angle_deg": 45})", 1.0, 40, false},
        {R"({"type": "inline", "cylinders": 3, "rods_per_pin": 1})", 0.7, 13 + 8 + 5 + 2, false},
        {R"({"type": "inline", "cylinders": 5, "rods_per_pin": 1})", 0.7, 24 + 12 + 6 + 3, false},
        {R"({"type": "inline", "cylinders": 6})", 0.6, 90, false},  // nothing hangs on it
        {eight, 1.0, 120, true},
        {eight, 1.0, 320, true},
        {six, 0.7, 82, true},
        {R"({"type": "inline", "cylinders": 3, "rods_per_pin": 1})", 0.7, 90, true},
    };
    for (const Case& each : cases) {
        SCOPED_TRACE(std::to_string(each.mass_kg) + " " + each.engine);
        Json input = card();
        input["engine"] = parse_json(each.engine);
        for (Json& mass : input["parts_g"]) {
            mass = each.of_card * mass.get<double>();
        }
        input["tolerance"]["rotor_mass_kg"] = each.mass_kg;
        const Json doubts = solved(input).at("doubts");
        const bool is_doubted = std::any_of(doubts.begin(), doubts.end(), [](const Json& doubt) {
            return doubt.at("kind") == "rotor-mass";
        });
        EXPECT_EQ(is_doubted, each.is_doubted) << doubts.dump(1);
    }
}

TEST(Doubts, OfAnUnknownBobWeightAreNoneWhereNoneHangs) {
    const auto kinds = [](const char* engine, const Json& readings) {
        Json json = card();
        json["engine"] = parse_json(engine);
        json.erase("parts_g");
        json["correction"]["readings"] = readings;
        std::vector<std::string_view> list;
        for (const Doubt& doubt : solve(read_input(json, Completeness::as_is)).doubts) {
            list.push_back(doubt.rule->word);
        }
        return list;
    };
    const Json both = card().at("correction").at("readings");
    const Json one = parse_json(R"([{"unbalance_g_mm": 25, "angle_deg": 40}, {}])");
    const char* const eight = R"({"type": "v", "cylinders": 8, "bank_angle_deg": 90})";
    const std::vector<std::string_view> unknown{"unknown-bob-weight"};
    EXPECT_EQ(kinds(eight, both), unknown);
    EXPECT_EQ(kinds(eight, one), unknown) << "half a run is read with them, too";
    EXPECT_TRUE(kinds(eight, parse_json("[{}, {}]")).empty());
    EXPECT_TRUE(kinds(R"({"type": "inline", "cylinders": 6})", both).empty());
}

TEST(Doubts, OfThePapersPlugStopUntilItIsWeighed) {
    const auto engine = [](const Json& weighed) {
        Json values{{"oil_mass_g", 20},
                    {"oil_coefficient", 1},
                    {"reciprocating_mass_g", 1000},
                    {"rotating_mass_g", 650}};
        values.update(weighed);
        return values;
    };
    Json input = doubted().at("paper-plug")();
    input["plugs"]["engine"] = "4.25 l";
    // Aluminium plugs of the paper matter where they are to be fitted.
    for (const auto& [weighed, piston_g, is_stopped] :
         {std::tuple{Json::object(), 0.0, true},
          {Json{{"steel_plug_mass_g", 28.5}, {"max_steel_reduction_g", 6}}, 0.0, false},
          {Json{{"steel_plug_mass_g", 28.5}, {"max_steel_reduction_g", 6}}, 65.0, true}}) {
        input["plugs"]["engine_overrides"] = engine(weighed);
        input["plugs"]["mass_changes_g"]["repair_piston_and_rings"] = piston_g;
        const Json result = solved(input);
        EXPECT_EQ(result.at("bobweight_g").is_null(), is_stopped) << result.at("doubts").dump(1);
        EXPECT_EQ(result.at("verdict").at("text") ==
                      "STOP. The plug mass is from the paper: weigh the plugs.",
                  is_stopped);
    }
}

TEST(Doubts, OfAPistonLeaveNoPlugToBore) {
    Json input = plugs_card();
    input["plugs"]["plug"]["cutter_diameter_mm"] = 14;
    input["plugs"].erase("mass_changes_g");
    input["plugs"]["mass_changes_from"] = "weigh-in";
    input["weigh_in"]["piston"] = {{"nominal_g", 560}, {"mass_g", eight(562)}};
    const Json sound = solved(input).at("plugs");
    EXPECT_EQ(sound.at("state"), "works");
    input["weigh_in"]["piston"]["mass_g"][3] = 650;
    const Json result = solved(input);
    expect_no_plug(result.at("plugs"));
    const Json& doubtful = result.at("doubtful").at("plugs");
    EXPECT_TRUE(doubtful.at("state").is_string());
    EXPECT_EQ(doubtful.at("options").size(), sound.at("options").size());
}

TEST(Doubts, OfTheDirectionOfDegreesFollowTheMachine) {
    Json json = test::doubted().at("drilled-counting-otherwise")();
    json["correction"]["earlier_runs"][0].erase("drilled_counting_otherwise");
    json["correction"]["earlier_runs"].push_back({{"drilled", Json::array()}});
    Input input = read_input(json);
    const auto is_doubted = [&](const Input& job) { return !solve(job).doubts.empty(); };
    EXPECT_FALSE(is_doubted(input));
    note_counts_changed(*input.correction);
    EXPECT_TRUE(is_doubted(input));
    EXPECT_TRUE(input.correction->earlier_runs[0].counted_otherwise);
    EXPECT_FALSE(input.correction->earlier_runs[1].counted_otherwise) << "nothing was drilled";
    // What was measured is where it was found, and the old direction is the one of the holes.
    Input measured = input;
    measured.correction->earlier_runs[0].drilled->at(0).state = bob_weights::HoleState::measured;
    EXPECT_FALSE(is_doubted(measured));
    // The first of those that were not is named.
    const bob_weights::DrilledHole planned = input.correction->earlier_runs[0].drilled->front();
    measured.correction->earlier_runs[0].drilled->push_back(planned);
    EXPECT_EQ(solve(measured).doubts.at(0).hole, (bob_weights::Hole::Place{0, 1}));
    note_counts_changed(*input.correction);
    EXPECT_FALSE(is_doubted(input));
    EXPECT_EQ(input, read_input(json));
}

TEST(Doubts, OfAPlannedHoleFollowRadiusAndDrill) {
    Input input = read_input(card());
    bob_weights::Correction& correction = *input.correction;
    bob_weights::EarlierRun run;
    run.drilled = bob_weights::planned_holes(solve(input).shaft);
    run.readings = std::exchange(correction.readings, std::vector<bob_weights::Reading>(2));
    correction.earlier_runs = {run};
    EXPECT_TRUE(solve(input).doubts.empty());
    const auto doubts = [](Input job, const auto& change) {
        change(*job.correction);
        const auto found = solve(job).doubts;
        EXPECT_TRUE(std::ranges::all_of(found, [](const Doubt& doubt) {
            return doubt.rule->word == "drilled-by-other-values" && !doubt.rule->blocks.any();
        }));
        return found;
    };
    const auto of_radius =
        doubts(input, [](auto& changed) { changed.planes[1].radius = 77 * units::mm; });
    ASSERT_EQ(of_radius.size(), 1U);
    ASSERT_TRUE(of_radius[0].hole);
    EXPECT_EQ(run.drilled->at(of_radius[0].hole->hole).plane, bob_weights::PlaneName::rear);
    EXPECT_TRUE(of_radius[0].text.english().starts_with("Before, Rear plane: the hole at 290.0°"))
        << of_radius[0].text.english();
    EXPECT_EQ(doubts(input, [](auto& changed) { changed.drill.density = 7250; }).size(), 2U);
    EXPECT_EQ(doubts(input, [](auto& changed) { changed.drill.point_angle = pi; }).size(), 2U);
    // What was measured is what it is.
    EXPECT_TRUE(doubts(input, [](auto& changed) {
                    changed.drill.density = 7250;
                    for (bob_weights::DrilledHole& hole : *changed.earlier_runs[0].drilled) {
                        hole.state = bob_weights::HoleState::measured;
                    }
                }).empty());
}

TEST(Doubts, OfADrillingFindHolesInTheOtherPlane) {
    // Front 1250 at 40°: the hole takes off about 1100; it was drilled in the rear plane.
    Json input = card();
    Json& correction = input["correction"];
    correction["earlier_runs"] = parse_json(R"([{
        "readings": [{"unbalance_g_mm": 1250, "angle_deg": 40}, {"unbalance_g_mm": 0}],
        "drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 9, "angle_deg": 40}]}])");
    correction["readings"] = parse_json(R"([{"unbalance_g_mm": 1250, "angle_deg": 40},
                                            {"unbalance_g_mm": 1100, "angle_deg": 220}])");
    const auto expected = [&] {
        return test::at(solved(input), "/correction/runs/1/planes/0").value("expected", Json());
    };
    EXPECT_TRUE(expected().at("drilling_acted_in_other_plane").get<bool>());
    EXPECT_NE(solved(input).at("verdict").at("text").get<std::string>().find("other plane"),
              std::string::npos);
    // The record says where the hole is, and all is as expected.
    Json& hole = correction["earlier_runs"][0]["drilled"][0];
    hole.update({{"plane", "rear"}, {"state", "measured"}});
    EXPECT_TRUE(expected().is_null());
    EXPECT_TRUE(solved(input).at("doubts").empty()) << solved(input).at("doubts").dump(1);
    // A hole that is in neither plane is in no other one.
    hole["plane"] = "front";
    correction["readings"][1]["unbalance_g_mm"] = 0;
    EXPECT_FALSE(expected().at("drilling_acted_in_other_plane").get<bool>());
}

TEST(Doubts, StopWhereUnbalanceVanishesWithoutAHole) {
    Json input = card();
    Json& correction = input["correction"];
    correction["earlier_runs"] =
        Json::array({{{"readings", Json::parse(R"([{"unbalance_g_mm": 4630, "angle_deg": 116},
                                                   {"unbalance_g_mm": 90, "angle_deg": 200}])")},
                      {"drilled", Json::array()}}});
    correction["readings"] = Json::parse(R"([{"unbalance_g_mm": 77, "angle_deg": 33},
                                             {"unbalance_g_mm": 80, "angle_deg": 190}])");
    const Json doubts = solved(input).at("doubts");
    ASSERT_EQ(doubts.size(), 1U) << doubts.dump(1);
    EXPECT_EQ(doubts[0].at("kind"), "drilled-otherwise");
    // Measured once more, it is what it was.
    correction["readings"][0] = {{"unbalance_g_mm", 4500}, {"angle_deg", 117}};
    EXPECT_TRUE(solved(input).at("doubts").empty()) << solved(input).at("doubts").dump(1);
}

TEST(Doubts, StopWhereTheRecordedHoleDoesNotExplainThePass) {
    // The limit is 417 g·mm in each plane; 16 mm, 30 mm deep take off about 3450.
    Json input = card();
    Json& correction = input["correction"];
    correction["readings"] = Json::parse(R"([{"unbalance_g_mm": 77, "angle_deg": 33},
                                             {"unbalance_g_mm": 80, "angle_deg": 190}])");
    double was_g_mm = 3500;
    const auto doubts = [&](const char* plane, double depth_mm, double angle_deg) {
        const Json front{{"unbalance_g_mm", was_g_mm}, {"angle_deg", 116}};
        const Json hole{{"plane", plane},
                        {"diameter_mm", 16},
                        {"depth_mm", depth_mm},
                        {"angle_deg", angle_deg},
                        {"state", "measured"}};
        correction["earlier_runs"] = Json::array(
            {{{"readings", {front, correction["readings"][1]}}, {"drilled", Json::array({hole})}}});
        const Json found = solved(input).at("doubts");
        EXPECT_TRUE(found.empty() || found[0].at("kind") == "drilled-otherwise") << found.dump(1);
        return found.size();
    };
    EXPECT_EQ(doubts("front", 30, 116), 0U);
    EXPECT_EQ(doubts("front", 28, 120), 0U) << "nearly there";
    EXPECT_EQ(doubts("front", 30, 170), 1U) << "another angle";
    EXPECT_EQ(doubts("front", 1, 116), 1U) << "another depth";
    EXPECT_EQ(doubts("rear", 30, 116), 2U) << "another plane";
    // It was to pass, and passes.
    was_g_mm = 600;
    correction["readings"][0] = {{"unbalance_g_mm", 410}, {"angle_deg", 296}};
    EXPECT_EQ(doubts("front", 3, 116), 0U);
}

/// Kinds and texts of the doubts of a job as the form has it.
std::vector<std::pair<std::string_view, std::string>> doubts_of(const Json& input) {
    std::vector<std::pair<std::string_view, std::string>> list;
    for (const Doubt& doubt : solve(read_input(input, Completeness::as_is)).doubts) {
        list.emplace_back(doubt.rule->word, doubt.text.english());
    }
    return list;
}

TEST(Doubts, CompareEveryRunWithTheOneBeforeIt) {
    EXPECT_TRUE(doubts_of(twice_drilled()).empty());
    const auto expect = [](const test::Changes& changes, std::string_view kind,
                           std::string_view beginning) {
        const auto doubts = doubts_of(changed(twice_drilled(), changes));
        ASSERT_FALSE(doubts.empty()) << beginning;
        EXPECT_EQ(doubts[0].first, kind) << doubts[0].second;
        EXPECT_TRUE(doubts[0].second.starts_with(beginning)) << doubts[0].second;
    };
    const char* const runs = "/correction/earlier_runs/";
    const auto of_run = [&](const std::string& place) { return runs + place; };
    const std::string rear = of_run("0/drilled/1/");
    expect({{"/machine/shows", "light"}}, "drilled-at-light-spot",
           "Before, Front plane: the holes drilled after 2600.0 g·mm ∠ 75.0° are opposite");
    expect({{(rear + "angle_deg").c_str(), 30}}, "drilled-at-light-spot",
           "Before, Rear plane: the holes drilled after 1450.0 g·mm ∠ 210.0° are opposite");
    expect({{(rear + "depth_mm").c_str(), 0}}, "drilled-otherwise",
           "Run 1, Rear plane: residual 95.0 g·mm ∠ 70.0° after drilling instead of");
    expect({{(rear + "state").c_str(), "not-drilled"}}, "drilled-otherwise",
           "Run 1, Rear plane: 95.0 g·mm ∠ 70.0° instead of 1450.0 g·mm ∠ 210.0°, but no hole");
    // What is missing is asked for, and a run without readings is none to compare with.
    const std::string read = of_run("1/readings");
    expect({{(read + "/0/angle_deg").c_str(), nullptr}}, "incomplete-run",
           "Run 1, Front plane: enter the angle.");
    expect({{read.c_str(), {Json::object(), Json::object()}}}, "incomplete-run",
           "Run 1, Front plane: enter the unbalance.");
    EXPECT_TRUE(doubts_of(changed(twice_drilled(), {{read.c_str(), nullptr}})).empty());
    expect({{read.c_str(), nullptr}, {(rear + "angle_deg").c_str(), 30}}, "drilled-at-light-spot",
           "Before, Rear plane");
    // Readings without an angle have a verdict where nothing is planned.
    EXPECT_TRUE(doubts_of(changed(twice_drilled(), {{(read + "/0/angle_deg").c_str(), nullptr},
                                                    {"/correction/readings/0/angle_deg", nullptr}}))
                    .empty());
    // A deepened hole is deeper than before.
    expect({{of_run("1/drilled/0/depth_mm").c_str(), 14}}, "shallower-hole",
           "Run 1, Front plane: the hole of ⌀ 16.0 mm at 75.0° is 14.0 mm deep");
}

TEST(Doubts, AskForTheOneAngleThatAPassLacks) {
    const auto front = [](const Json& angle_deg) {
        Json reading{{"unbalance_g_mm", 60}, {"angle_deg", angle_deg}};
        return angle_deg.is_null() ? Json{{"unbalance_g_mm", 60}} : reading;
    };
    const Json rear{{"unbalance_g_mm", 150}};
    const test::Changes read{{"/correction/readings", {front(100), rear}}};
    const Input input = read_input(changed(twice_drilled(), read), Completeness::as_is);
    const Result result = solve(input);
    ASSERT_EQ(result.doubts.size(), 1U);
    EXPECT_EQ(result.doubts[0].rule->word, "missing-angle");
    EXPECT_EQ(result.doubts[0].text.english(), "Run 2, Rear plane: enter the angle.");
    EXPECT_EQ(result.shaft.newest()->passes(), true);
    EXPECT_EQ(verdict(input, result).severity, Severity::warning);
    EXPECT_EQ(short_verdict(input, result).severity, Severity::warning);
    // Amounts alone have a verdict, and a first run is compared with none.
    Json alone = changed(twice_drilled(), {{"/correction/readings", {front(nullptr), rear}}});
    EXPECT_TRUE(doubts_of(alone).empty());
    alone["correction"].erase("earlier_runs");
    alone["correction"]["readings"] = {front(100), rear};
    EXPECT_TRUE(doubts_of(alone).empty());
}

TEST(Doubts, EndWhereARunIsExplained) {
    const auto front = [](double unbalance_g_mm) {
        return Json{{"unbalance_g_mm", unbalance_g_mm}, {"angle_deg", 75}};
    };
    for (const auto& [state, between] : {std::pair("wrong-side", 4500), {"not-drilled", 2590}}) {
        Json input = twice_drilled();
        Json& correction = input["correction"];
        Json& runs = correction["earlier_runs"];
        runs[1]["drilled"][0] = runs[0]["drilled"][0];
        runs[1]["readings"][0] = front(between);
        correction["readings"][0] = front(between - 1950);
        EXPECT_FALSE(doubts_of(input).empty()) << state;
        runs[0]["drilled"][0]["state"] = state;
        EXPECT_TRUE(doubts_of(input).empty()) << state << doubts_of(input)[0].second;
    }
}

TEST(Doubts, StopBeforeAHoleOfUnknownDepthIsDeepened) {
    Json input = twice_drilled();
    Json& correction = input["correction"];
    correction["readings"] = correction["earlier_runs"][1]["readings"];
    correction["earlier_runs"].erase(1);
    Json& hole = correction["earlier_runs"][0]["drilled"][0];
    hole["depth_mm"] = 20.7;
    hole["state"] = "as-planned";
    auto doubts = doubts_of(input);
    ASSERT_FALSE(doubts.empty());
    EXPECT_EQ(doubts[0].first, "deepens-unmeasured");
    EXPECT_TRUE(doubts[0].second.starts_with("Run 1, Front plane: residual 610.0 g·mm ∠ 75.0°"));
    EXPECT_NE(doubts[0].second.find("the hole at 75.0°"), std::string::npos) << doubts[0].second;
    // It is that deep, whatever the machine reads.
    hole["state"] = "measured";
    doubts = doubts_of(input);
    ASSERT_EQ(doubts.size(), 1U);
    EXPECT_EQ(doubts[0].first, "drilled-beside-plan");
    hole["depth_mm"] = 15;
    EXPECT_TRUE(doubts_of(input).empty());
}

/// The hole at 55° is really 20.7 mm deep.
Json shallow_record() {
    Json input = card();
    input["tolerance"] = {{"g_mm", 150}};
    Json& correction = input["correction"];
    for (Json& plane : correction["planes"]) {
        plane["radius_mm"] = 75;
    }
    correction["drill"] = {{"diameters_mm", {8, 10, 12}}, {"maximum_depth_mm", 25}};
    correction["earlier_runs"] = parse_json(R"([
        {"readings": [{"unbalance_g_mm": 4500, "angle_deg": 42},
                      {"unbalance_g_mm": 15, "angle_deg": 190}],
         "drilled": [{"plane": "front", "diameter_mm": 12, "depth_mm": 19.3, "angle_deg": 19},
                     {"plane": "front", "diameter_mm": 12, "depth_mm": 21.5, "angle_deg": 34.3},
                     {"plane": "front", "diameter_mm": 12, "depth_mm": 15, "angle_deg": 55,
                      "state": "measured"}]},
        {"readings": [{"unbalance_g_mm": 996, "angle_deg": 62.7},
                      {"unbalance_g_mm": 15, "angle_deg": 190}],
         "drilled": [{"plane": "front", "diameter_mm": 12, "depth_mm": 25, "from_depth_mm": 15,
                      "angle_deg": 55, "state": "not-drilled"},
                     {"plane": "front", "diameter_mm": 12, "depth_mm": 12, "angle_deg": 70.6,
                      "state": "measured"}]}])");
    correction["readings"] = parse_json(R"([{"unbalance_g_mm": 226, "angle_deg": 36},
                                            {"unbalance_g_mm": 14, "angle_deg": 190}])");
    return input;
}

TEST(Doubts, OfAHoleAreKeptUntilItIsDeepened) {
    const Json input = shallow_record();
    const auto expect = [](const Json& job, const char* beginning) {
        const Result result = solve(read_input(job));
        EXPECT_TRUE(std::ranges::any_of((*result.shaft.correction)[0].holes, [](const auto& hole) {
            return hole.deepens == bob_weights::Hole::Place{0, 2};
        }));
        const auto doubts = doubts_of(job);
        ASSERT_EQ(doubts.size(), 1U);
        EXPECT_EQ(doubts[0].first, "drilled-beside-plan");
        EXPECT_TRUE(doubts[0].second.starts_with(beginning)) << doubts[0].second;
    };
    expect(input, "Run 1, Front plane: residual 996.0 g·mm ∠ 62.7°");
    // Also where that run was within its limit, but not by the record.
    expect(changed(input, {{"/correction/earlier_runs/0/readings/0/unbalance_g_mm", 3600},
                           {"/correction/earlier_runs/1/readings/0",
                            {{"unbalance_g_mm", 140}, {"angle_deg", 50}}},
                           {"/correction/earlier_runs/1/drilled", Json::array()},
                           {"/correction/readings/0/angle_deg", 45}}),
           "Run 1, Front plane: residual 140.0 g·mm ∠ 50.0°");
    // Nothing is deepened within the limit: it passes, and the record is contradicted all the same.
    const Json passed = changed(input, {{"/correction/readings/0/unbalance_g_mm", 84}});
    const auto doubts = doubts_of(passed);
    ASSERT_FALSE(doubts.empty());
    for (const auto& [kind, text] : doubts) {
        EXPECT_EQ(kind, "drilled-unlike-record") << text;
    }
    EXPECT_EQ(at(solved(passed), "/verdict/severity"), "good");
    // The real depth explains the run.
    EXPECT_TRUE(doubts_of(changed(input, {{"/correction/earlier_runs/0/drilled/2/depth_mm", 20.7}}))
                    .empty());
}

TEST(Doubts, OfHolesThatNoRunHasRead) {
    Json input = twice_drilled();
    Json& correction = input["correction"];
    EXPECT_TRUE(doubts_of(input).empty());
    const Json planned = at(solved(input), "/correction/planes/0/holes");
    const Json hole{{"plane", "front"}, {"diameter_mm", 16}, {"depth_mm", 3}, {"angle_deg", 120}};
    correction["drilled"] = Json::array({changed(hole, {{"/state", "not-drilled"}}), hole});
    const Result result = solve(read_input(input));
    ASSERT_EQ(result.doubts.size(), 1U);
    EXPECT_EQ(result.doubts[0].text.english(),
              "Holes are recorded after Run 2: enter the readings of Run 3, or mark the holes as "
              "not drilled.");
    EXPECT_EQ(result.doubts[0].hole, (bob_weights::Hole::Place{2, 1}));
    EXPECT_EQ(at(solved(input), "/correction/runs/2/planes/0/drilled_holes").size(), 1U);
    // None of them is there: the plan is that of the readings.
    correction["drilled"][1]["state"] = "not-drilled";
    EXPECT_TRUE(doubts_of(input).empty());
    EXPECT_EQ(difference(planned, at(solved(input), "/correction/planes/0/holes")), "");
    // Drilled before any further run.
    correction["drilled"][1]["state"] = "wrong-side";
    correction.erase("earlier_runs");
    const auto doubts = doubts_of(input);
    ASSERT_EQ(doubts.size(), 1U);
    EXPECT_TRUE(
        doubts[0].second.starts_with("Holes are recorded after “Before”: enter the "
                                     "readings of Run 1"));
}

TEST(Doubts, OfHalfASectorNameTheOtherEnd) {
    for (const auto& [missing, name] :
         {std::pair("from_deg", "“Drill from”"), {"to_deg", "“Drill to”"}}) {
        Json input = card();
        input["correction"]["planes"][1].erase(missing);
        const auto doubts = doubts_of(input);
        ASSERT_EQ(doubts.size(), 1U);
        EXPECT_EQ(doubts[0].first, "half-sector");
        EXPECT_TRUE(doubts[0].second.starts_with("Rear plane: enter " + std::string(name)));
    }
}

TEST(Doubts, NoneOfAHoleAsDeepAsIsPermitted) {
    Json input = card();
    input["correction"]["earlier_runs"] = Json::parse(
        R"([{"drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 30, "angle_deg": 40}]}])");
    EXPECT_TRUE(solved(input).at("doubts").empty()) << solved(input).at("doubts").dump(1);
}

TEST(Doubts, NamesOfOneLetterAreExchangedToo) {
    Json input = card();
    for (const auto& [front, rear, count] :
         {std::tuple("r", "l", 1U), std::tuple("L", "R", 0U), std::tuple("Rim", "Lug", 0U)}) {
        input["machine"]["planes"] = {front, rear};
        EXPECT_EQ(solved(input).at("doubts").size(), count) << front;
    }
}

// One wrong digit or field each, of jobs that nobody doubts, beside those of the table of doubts.
TEST(Doubts, StopAtSlipsOfTheKeyboard) {
    struct Slip {
        Json (*base)();
        const char* pointer;
        Json value;
    };
    const Slip slips[] = {{card, "/parts_g/big_end", 4298},
                          {card, "/parts_g/pin", 1736},
                          {card, "/parts_g/rings", 695},
                          {card, "/parts_g/locks", 200},
                          {card, "/parts_g/small_end", 17},
                          {card, "/tolerance/grade_mm_s", 160},
                          {card, "/tolerance/grade_mm_s", 630},
                          {card, "/tolerance/service_speed_rpm", 55},
                          {card, "/tolerance/service_speed_rpm", 320},
                          {card, "/tolerance/service_speed_rpm", 55000},
                          {card, "/correction/planes/0/radius_mm", 850},
                          {card, "/correction/planes/0/radius_mm", 8.5},
                          {card, "/correction/planes/0/position_mm", 600},
                          {card,
                           "/correction/readings",
                           {{{"unbalance_g_mm", 6000}, {"angle_deg", 45}, {"position_mm", 500}},
                            {{"unbalance_g_mm", 800}, {"angle_deg", 210}, {"position_mm", 100}}}},
                          {card,
                           "/correction/readings",
                           {{{"unbalance_g_mm", 6000}, {"angle_deg", 45}, {"position_mm", 300}},
                            {{"unbalance_g_mm", 800}, {"angle_deg", 210}, {"position_mm", 310}}}},
                          {card, "/correction/drill/maximum_depth_mm", 300},
                          {card,
                           "/tolerance",
                           {{"grade_mm_s", 16},
                            {"rotor_mass_kg", 30},
                            {"service_speed_rpm", 5500},
                            {"centre_of_mass_mm", 100},
                            {"front_bearing_mm", 120},
                            {"rear_bearing_mm", 420}}},
                          {plugs_card, "/plugs/engine/reciprocating_mass_g", 10000},
                          {plugs_card, "/plugs/engine/rotating_mass_g", 6500},
                          {plugs_card, "/plugs/engine/oil_mass_g", 300},
                          {plugs_card, "/plugs/engine/new_plug_radius_mm", 493},
                          {plugs_card, "/plugs/engine/crank_radius_mm", 400},
                          {card, "/machine/planes", {"rear", ""}},
                          {card, "/machine/planes", {"Left", "left"}},
                          {card, "/machine/planes", {"задняя", "передняя"}},
                          {plugs_card, "/plugs/engine/oil_coefficient", 10},
                          {plugs_card, "/tolerance/service_speed_rpm", 320},
                          {plugs_card, "/correction/planes/0/radius_mm", 156}};
    for (const auto& [base, pointer, value] : slips) {
        const Json doubts = solved(changed(base(), {{pointer, value}})).at("doubts");
        EXPECT_TRUE(std::any_of(doubts.begin(), doubts.end(),
                                [](const Json& doubt) { return has(doubt.at("blocks"), "holes"); }))
            << pointer << " " << value << ": " << doubts.dump();
    }
    Json large = card();
    large["tolerance"]["grade_mm_s"] = 40;
    EXPECT_TRUE(solved(large).at("doubts").empty());
}

TEST(Doubts, NameThePlanesAsTheMachineDoes) {
    Json input = card();
    Json& plane = input["correction"]["planes"][0];
    plane.erase("from_deg");
    plane.erase("to_deg");
    const auto text = [&] { return solved(input).at("doubts")[0].at("text").get<std::string>(); };
    EXPECT_TRUE(text().starts_with("Front plane: enter the drilling sector"));
    for (const auto& [name, shown] :
         {std::pair("left", "Left"), {"pulley", "Pulley"}, {"левая", "Левая"}, {"шкив", "Шкив"}}) {
        input["machine"]["planes"] = {name, "right"};
        EXPECT_TRUE(text().starts_with(std::string(shown) + ": enter the drilling sector"));
    }
}

TEST(Doubts, OfAnOddPartNameThePermittedRangeWhereItHelps) {
    Json input = weighed_card();
    Json& rings = input["weigh_in"]["rings"];
    const auto said = [&](double mass) {
        rings["mass_g"] = {70, 70, 70, mass, 70, 70, 70, 70};
        const Json doubts = solved(input).at("doubts");
        return doubts.empty() ? "" : doubts[0].at("text").get<std::string>();
    };
    constexpr std::string_view remedy =
        "If the difference is permitted, enter the “permitted range” of the column.";
    EXPECT_TRUE(said(71).ends_with(remedy)) << said(71);
    EXPECT_FALSE(said(80).ends_with(remedy)) << said(80);
    rings["permitted_spread_g"] = 1;
    EXPECT_EQ(said(71), "");
    EXPECT_NE(said(80), "");
}

TEST(Doubts, OfTheSpreadOfAPartNameItsCylinders) {
    Json input = doubted().at("spread")();
    Json& piston = input["weigh_in"]["piston"];
    piston["mass_g"] = {582, 581, 580, 583, 587, 584, 585, 586};
    for (int time = 0; time < 2; ++time) {
        const auto doubts = doubts_of(input);
        ASSERT_EQ(doubts.size(), 1U);
        EXPECT_EQ(doubts[0].first, "spread");
        EXPECT_NE(doubts[0].second.find("(heaviest: cylinder 5, lightest: 3)"), std::string::npos)
            << doubts[0].second;
        piston.erase("permitted_spread_g");
    }
}

TEST(Doubts, AreNoneWhereNothingIsOdd) {
    Json slow = card();
    slow["tolerance"]["service_speed_rpm"] = 1500;
    for (const Json& input : {card(), weighed_card(), plugs_card(), slow}) {
        const Json result = solved(input);
        EXPECT_TRUE(result.at("doubts").empty()) << result.at("doubts").dump(1);
        EXPECT_TRUE(result.at("doubtful").is_null());
    }
    std::set<std::string_view> words;
    for (const DoubtRule& rule : doubt_rules()) {
        EXPECT_TRUE(words.insert(rule.word).second) << rule.word;
    }
    EXPECT_EQ(words.size(), doubted().size());
}

}  // namespace
}  // namespace ravnoves::workshop

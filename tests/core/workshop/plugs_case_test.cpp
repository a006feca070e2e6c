// Cases of v8-plugs: the contract's examples, reading and writing, bad input.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "case-file/field_index.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "examples.h"
#include "support.h"
#include "v8-plugs/presets.h"
#include "workshop/solver.h"

namespace ravnoves::v8_plugs {
namespace {

using workshop::PlugsCase;
using workshop::read_plugs_case;
using workshop::write_input;
using workshop::test::at;
using workshop::test::number;

constexpr double gram = 1e-3;
constexpr double millimetre = 1e-3;

Json example() {
    return parse_json(R"({
        "engine": {
            "crank_radius_mm": 40, "plug_radius_mm": 47.2, "new_plug_radius_mm": 49.3,
            "steel_plug_mass_g": 2.79, "aluminium_plug_mass_g": 0.954,
            "new_steel_plug_mass_g": 3.45, "new_aluminium_plug_mass_g": 1.179,
            "max_steel_reduction_g": 1.951, "max_aluminium_reduction_g": 0.684,
            "rod_coefficient": 0.445, "oil_mass_g": 20, "oil_coefficient": 1.0,
            "reciprocating_mass_g": 1000, "rotating_mass_g": 650},
        "process": "repair",
        "mass_changes_g": {"piston": 0, "rod_big_end": 0.5, "repair_piston_and_rings": 2.0,
                           "repair_bearing": 1.1}})");
}

Json full_example() {
    Json input = example();
    input["crankshaft"] = "standard";
    input["tolerance_g_mm"] = 4.5;
    input["weigh_in"] = parse_json(R"({
        "cylinder_numbering": "alternating",
        "piston": {"nominal_g": 600, "permitted_spread_g": 2,
                   "mass_g": [600, 601, 602, 603, 604, 605, 606, 607]},
        "rod_big_end": {"nominal_g": 700, "mass_g": [700, 700, 700, 701, 700, 700, 700, 700]}})");
    input["mass_changes_from"] = "typed";
    input["plug"] = parse_json(R"({"thread": "M30x1.5", "height_mm": 14, "bore_diameter_mm": 20,
        "bore_depth_mm": 8, "cutter_diameter_mm": 20, "minimum_wall_mm": 1,
        "minimum_bottom_mm": 2, "steel_density_kg_m3": 7800})");
    input["balancing"] = parse_json(R"({"grade_mm_s": 16, "rotor_mass_kg": 30,
        "service_speed_rpm": 3200, "front_reading_g_mm": 700, "rear_reading_g_mm": 800})");
    input["job"] = parse_json(R"({"engine_number": "ЗМЗ-53 №123", "customer": "A", "date":
        "2024-05-31", "technician": "B", "notes": "C"})");
    return input;
}

Json solved(const Json& input) {
    return workshop::test::solved_plugs_case(input);
}

std::string error_of(const Json& input) {
    return workshop::test::error_of(input, solved);
}

TEST(Weights, ActWhateverTheProcess) {
    Json input = example();
    input["mass_changes_g"] = {{"repair_bearing", 3.0}};
    input["process"] = "manufacture";
    EXPECT_EQ(solved(input).at("recommended"), "none-needed");
    EXPECT_EQ(solved(input).at("not_counted")[0],
              "Repair shells of one crankpin Δmₛₕ: the typed 3.00 g is not used in manufacture.");
    input.erase("mass_changes_g");
    input["weigh_in"]["shells"] = {{"nominal_g", 24}, {"mass_g", std::vector<double>(8, 25.1)}};
    const Json result = solved(input);
    EXPECT_NEAR(number(result, "/unbalanced_mass_g"), 2.2, 1e-9);
    EXPECT_NEAR(number(result, "/mass_changes_g/repair_bearing"), 2.2, 1e-9);
    EXPECT_EQ(result.at("recommended"), "steel-machined");
    EXPECT_TRUE(result.at("not_counted").empty());
    input["process"] = "repair";
    EXPECT_EQ(solved(input).at("options"), result.at("options"));
}

TEST(ShiftEffect, IsCorrectedInTheOrderOfItsShiftsAndSaysWhatIsBeyond) {
    Json input = example();
    input["mass_changes_g"] = {{"repair_piston_and_rings", 4.0}};
    input["crankshaft"] = "new-plugs";
    const Json options = solved(input).at("options");
    for (const auto& [name, option] : options.items()) {
        if (!option.contains("shift_effect")) {
            continue;
        }
        const Json& effect = option.at("shift_effect");
        const double mass = number(option, "/plug_mass_g") + number(option, "/reduction_g");
        const double radius = name == "new-steel-machined" ? 49.3 : 47.2;
        const double wanted = mass - number(option, "/required_reduction_g");
        for (std::size_t i = 0; i < 2; ++i) {
            const double off = effect.at("corrected_reduction_g")[i].get<double>();
            const double shift = effect.at("shift_mm")[i].get<double>();
            if (off < 0.99 * number(option, "/reduction_g")) {  // no limit
                EXPECT_NEAR((mass - off) * (radius - shift), wanted * radius, 1e-9) << name;
            }
        }
        EXPECT_GE(effect.at("corrected_reduction_g")[0], effect.at("corrected_reduction_g")[1]);
        EXPECT_EQ(effect.at("beyond_tolerance"),
                  std::abs(number(effect, "/residual_unbalance_g_mm")) > 5.0)
            << name << option;
    }
    input["mass_changes_g"] = {{"repair_piston_and_rings", 20.0}};
    const Json far = at(solved(input), "/options/new-steel-machined/shift_effect");
    EXPECT_GT(far.at("residual_unbalance_g_mm"), 100.0);
    EXPECT_TRUE(far.at("beyond_tolerance").get<bool>());
}

// The same big ends count with kᵣ where nobody has weighed the small ends, and the result says so.
TEST(RodCoefficient, IsNamedWithItsEffect) {
    Json input = example();
    input["mass_changes_g"] = {{"rod_big_end", 1.3}};
    const auto notes = [&] { return solved(input).at("notes")[0].get<std::string>(); };
    const double typed = number(solved(input), "/unbalanced_mass_g");
    EXPECT_EQ(notes(),
              "Big end × 2.445: 2 for two rods, kᵣ = 0.445 by the method for the small ends, which "
              "are not weighed; effect here: 0.58 g, 23.1 g·mm.");
    input["mass_changes_from"] = "weigh-in";
    input["weigh_in"]["rod_big_end"] = {{"nominal_g", 600}, {"mass_g", std::vector(8, 601.3)}};
    EXPECT_NEAR(number(solved(input), "/unbalanced_mass_g"), typed, 1e-9);
    EXPECT_NE(notes().find("23.1 g·mm"), std::string::npos);
    input["weigh_in"]["rod_small_end"] = {{"nominal_g", 230}, {"mass_g", std::vector(8, 230.0)}};
    EXPECT_NEAR(typed - number(solved(input), "/unbalanced_mass_g"), 0.445 * 1.3, 1e-9);
    EXPECT_EQ(notes(), "Big end × 2: the small ends are weighed, kᵣ is not used.");
}

TEST(Example, IsAnswered) {
    const Json repair = solved(ravnoves::test::example("v8-4.25-repair").input);
    EXPECT_EQ(repair.at("recommended"), "steel-machined");
    EXPECT_EQ(repair.at("reason"), "Take 1.83 g off each of the 8 steel plugs.");
    const Json manufacture = solved(ravnoves::test::example("v8-6-manufacture").input);
    EXPECT_EQ(manufacture.at("recommended"), "steel-to-aluminium");
}

TEST(Result, PresetWithOverridesIsTheSameEngine) {
    Json by_name = example();
    by_name["engine"] = "4.25 l";
    by_name["engine_overrides"] = {{"oil_mass_g", 20},
                                   {"oil_coefficient", 1.0},
                                   {"reciprocating_mass_g", 1000},
                                   {"rotating_mass_g", 650}};
    EXPECT_EQ(solved(by_name), solved(example()));
    const auto fields = describe_fields<PlugsCase>("/engine_overrides/oil_mass_g");
    ASSERT_EQ(fields.size(), 1U) << "as a field, for its name and its unit";
    EXPECT_EQ(fields[0].field.unit.name, "g");
    by_name["engine_overrides"]["crank_radius_mm"] = 41;
    EXPECT_NE(solved(by_name).at("k_p"), solved(example()).at("k_p"));
}

TEST(Result, SheetsAddTheirParts) {
    const Json result = solved(full_example());
    EXPECT_EQ(result.at("recommended"), "steel-machined");
    EXPECT_NE(
        result.at("reason").get<std::string>().find("Bore 0.75 mm deeper with a cutter of 20 mm"),
        std::string::npos)
        << result.at("reason");
    EXPECT_FALSE(result.at("plug").at("steel").at("fits").get<bool>());
    EXPECT_FALSE(result.at("weigh_in").at("piston").at("within_permitted_spread").get<bool>());
    EXPECT_EQ(at(result, "/weigh_in/piston/heaviest_cylinder"), 8);
    const Json& before = result.at("weigh_in").at("crankpins");
    const Json& after = at(result, "/weigh_in/assignment/crankpins");
    // Pistons 0…7 g over nominal, in pairs of equal sum; the heavy rod is worth 1.2225 g.
    EXPECT_NEAR(number(before, "/spread_g"), 6.0, 1e-9);
    EXPECT_LE(number(after, "/spread_g"), 1.2225);
    // ISO 21940-11 by hand: 1000 · 30 · 16 / (3200 π/30) = 1432.4 g·mm, half in each plane.
    EXPECT_NEAR(number(result, "/balancing/permissible_g_mm"), 1432.394, 1e-3);
    EXPECT_NEAR(number(result, "/balancing/front/permissible_g_mm"), 716.197, 1e-3);
    EXPECT_TRUE(result.at("balancing").at("front").at("passes").get<bool>());
    EXPECT_FALSE(result.at("balancing").at("rear").at("passes").get<bool>());
}

TEST(Result, ABoreDeeperThanThePlugIsNotRecommended) {
    Json input = example();
    EXPECT_EQ(solved(input)["recommended"], "steel-machined");
    input["plug"] = parse_json(R"({"thread": "M22x1.5", "height_mm": 2.5, "bore_diameter_mm": 14,
        "bore_depth_mm": 2, "cutter_diameter_mm": 14, "minimum_bottom_mm": 0})");
    Json result = solved(input);
    EXPECT_EQ(result["options"]["steel-machined"]["boring"]["possible"], false);
    EXPECT_EQ(result["recommended"], "steel-to-aluminium") << "the next, as they are";
    input["mass_changes_g"]["rod_big_end"] = 0.8;  // then they would be bored, too
    result = solved(input);
    EXPECT_TRUE(result["recommended"].is_null()) << result["recommended"];
    EXPECT_EQ(result["state"], "fails");
    const std::string reason = result["reason"];
    EXPECT_TRUE(reason.starts_with("“Aluminium plugs” would be suitable with ")) << reason;
    EXPECT_NE(reason.find("such a plug cannot be made. A cutter of"), std::string::npos) << reason;
    input["plug"]["bore_depth_mm"] = 2.5;
    EXPECT_NE(error_of(input).find("no bottom remains"), std::string::npos) << error_of(input);
}

TEST(Result, HasTheMachineWhereItsLimitsAreGiven) {
    Json input = full_example();
    for (const char* key : {"front_reading_g_mm", "rear_reading_g_mm"}) {
        input["balancing"].erase(key);
    }
    const Json balancing = solved(input).at("balancing");
    EXPECT_EQ(balancing.at("limit"), "iso-21940-11");
    EXPECT_FALSE(balancing.at("front").contains("passes"));
    EXPECT_FALSE(read_plugs_case(input).correction);
    input.erase("balancing");
    EXPECT_FALSE(solved(input).contains("balancing"));
}

TEST(Result, SetsKeepTheNumbersTheyWereWeighedUnder) {
    Json input = full_example();
    input["weigh_in"]["piston_sets"] = {3, 1, 2, 4, 5, 6, 7, 8};
    const PlugsCase read = read_plugs_case(input);
    EXPECT_EQ(read.weigh_in->piston_sets[0], 3);
    EXPECT_EQ(write_input(read).at("weigh_in").at("piston_sets"), input["weigh_in"]["piston_sets"]);
    EXPECT_FALSE(write_input(read).at("weigh_in").contains("rod_sets"));
    const Json sheet = solved(input).at("weigh_in");
    EXPECT_EQ(sheet.at("piston").at("part_numbers"), input["weigh_in"]["piston_sets"]);
    EXPECT_EQ(sheet.at("rod_big_end").at("part_numbers"), (Json{1, 2, 3, 4, 5, 6, 7, 8}));
    input["weigh_in"]["piston_sets"] = {3, 3, 2, 4, 5, 6, 7, 8};
    EXPECT_THROW(read_plugs_case(input), InputError);
    // Moving the parts moves their numbers, from wherever they are.
    shop::WeighIn moved = *read.weigh_in;
    move_sets(moved, {1, 0, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 7, 6});
    EXPECT_EQ(moved.piston_sets, (shop::SetNumbers{1, 3, 2, 4, 5, 6, 7, 8}));
    EXPECT_EQ(moved.rod_sets, (shop::SetNumbers{1, 2, 3, 4, 5, 6, 8, 7}));
}

TEST(Result, ChangesFromTheWeighInSheet) {
    Json input = full_example();
    input["mass_changes_from"] = "weigh-in";
    const Json result = solved(input);
    EXPECT_NEAR(number(result, "/mass_changes_g/repair_piston_and_rings"), 3.5, 1e-9);
    EXPECT_NEAR(number(result, "/mass_changes_g/rod_big_end"), 0.125, 1e-9);
    // Shells that nobody weighed are as heavy as was typed; on each crankpin alike.
    EXPECT_NEAR(number(result, "/mass_changes_g/repair_bearing"), 1.1, 1e-9);
    const double excess = number(result, "/unbalanced_mass_g");
    EXPECT_NEAR(excess, 3.5 + 2.445 * 0.125 + 1.1, 1e-9);
    double mean = 0.0;
    for (const Json& mass : at(result, "/weigh_in/crankpins/unbalanced_mass_g")) {
        mean += mass.get<double>() / 4;
    }
    EXPECT_NEAR(mean, excess, 1e-9);
    // The sheet alone is meant to be used.
    input["mass_changes_g"].erase("repair_bearing");
    Json weighed = solved(input);
    EXPECT_NEAR(number(weighed, "/unbalanced_mass_g"), excess - 1.1, 1e-9);
    EXPECT_EQ(weighed.at("not_counted").size(), 2U) << "typed, and replaced by the weights";
    input.erase("mass_changes_from");
    input.erase("mass_changes_g");
    weighed["not_counted"] = Json::array();
    EXPECT_EQ(solved(input), weighed);
}

TEST(Result, NullMeansThatThereIsNoSuchPlug) {
    Json input = example();
    for (const char* key :
         {"new_plug_radius_mm", "new_steel_plug_mass_g", "new_aluminium_plug_mass_g"}) {
        input["engine"][key] = nullptr;
    }
    const Json result = solved(input);
    EXPECT_TRUE(result.at("options").at("new-steel-to-steel").at("maximum_g").is_null());
    EXPECT_TRUE(result.at("k_y_new").is_null());
    input["crankshaft"] = "new-plugs";
    EXPECT_NE(error_of(input).find("/input/crankshaft"), std::string::npos);
    input["crankshaft"] = "standard";
    input["engine"]["new_plug_radius_mm"] = 49.3;
    EXPECT_EQ(error_of(input),
              "/input/engine/new_plug_radius_mm: must be null or left out where "
              "new_aluminium_plug_mass_g is null, got 49.3");
}

TEST(RoundTrip, WrittenInputReadsBackTheSame) {
    const PlugsCase read = read_plugs_case(full_example());
    const Json written = write_input(read);
    EXPECT_EQ(read_plugs_case(written), read) << written.dump(2);
}

TEST(RoundTrip, HalfFilledFormsKeepWhatIsThere) {
    PlugsCase input;
    Input& plugs = *input.plugs;
    plugs.preset = "8.32 l";
    plugs.engine = *find_preset("8.32 l");
    plugs.engine.oil_mass = 20.5 * gram;
    input.weigh_in.emplace().fit(8);
    (*input.weigh_in)[Part::pin].mass[3] = 151.25 * gram;
    plugs.plug.emplace();
    plugs.plug->height = 12 * millimetre;
    input.tolerance.emplace().rotor_mass = 31.0;
    const Json written = write_input(input);
    EXPECT_EQ(written.at("engine"), "8.32 l");
    EXPECT_EQ(read_plugs_case(written, Completeness::as_is), input);
    EXPECT_THROW(read_plugs_case(written), InputError);
    // So is a sheet on which two values do not go together yet.
    plugs.plug->thread = Thread{22 * millimetre, 1.5 * millimetre};
    plugs.plug->bore_diameter = 30 * millimetre;
    plugs.plug->bore_depth = 5 * millimetre;
    plugs.engine.steel_plug_mass = 3 * gram;
    plugs.engine.max_steel_reduction = 4 * gram;
    EXPECT_EQ(read_plugs_case(write_input(input), Completeness::as_is), input);
    // A preset value that was emptied cannot be an override: the engine is written out.
    plugs.engine.crank_radius.reset();
    EXPECT_FALSE(
        read_plugs_case(write_input(input), Completeness::as_is).plugs->engine.crank_radius);
    const Result partial = workshop::solve(input).plugs.value();
    EXPECT_FALSE(partial.advice);
    EXPECT_FALSE(partial.nominal);
}

TEST(BadInput, EveryEngineValueMissingNegativeOrAbsurd) {
    for (const EngineField& field : engine_fields()) {
        const std::string key(field.field.key);
        const std::string pointer = "/input/engine/" + key + ": ";
        Json input = example();
        input["engine"].erase(key);
        EXPECT_EQ(error_of(input), pointer + "is required and missing");
        for (const double value :
             {-1.0, -1e-300, 1e300, -1e300, std::numeric_limits<double>::max()}) {
            input["engine"][key] = value;
            EXPECT_EQ(error_of(input).substr(0, pointer.size()), pointer) << value;
        }
        for (const Json& value : {Json("x"), Json(true), Json::array(), Json::object()}) {
            input["engine"][key] = value;
            EXPECT_EQ(error_of(input).substr(0, pointer.size()), pointer) << value;
        }
        if (field.group == EngineGroup::basic || field.group == EngineGroup::bob_weight) {
            input["engine"][key] = nullptr;
            EXPECT_EQ(error_of(input).substr(0, pointer.size()), pointer);
        }
    }
}

TEST(BadInput, NamesTheField) {
    workshop::test::expect_rejected(
        full_example(),
        {{"/process", "overhaul",
          "/input/process: must be one of \"manufacture\", \"repair\", got \"overhaul\""},
         {"/engine", "5 l",
          "/input/engine: must be an engine object or one of \"4.25 l\", \"6 l\", \"7 l\", "
          "\"8.32 l\", \"8.74 l\", \"10.85 l\", \"14.86 l\", got \"5 l\""},
         {"/engine", "6 l",
          "/input/engine_overrides/oil_mass_g: is required and missing: the preset \"6 l\" does "
          "not give it"},
         {"/engine_overrides", Json::object(), "/input/engine_overrides: is allowed"},
         {"/engine/max_steel_reduction_g", 2.8,
          "/input/engine/max_steel_reduction_g: must be less than the plug's mass 2.79, got 2.8"},
         {"/tolerance_g_mm", -1, "/input/tolerance_g_mm: must be from 0 to 1000000, got -1"},
         {"/weigh_in/piston/mass_g/3", -600,
          "/input/weigh_in/piston/mass_g/3: must be from 0.001 to 100000, got -600"},
         {"/weigh_in/pin",
          {{"nominal_g", 3}, {"mass_g", {1, 2}}},
          "/input/weigh_in/pin/mass_g: must be a list of 8 masses"},
         {"/weigh_in/pin",
          {{"mass_g", {1, 1, 1, 1, 1, 1, 1, 1}}},
          "/input/weigh_in/pin/nominal_g: is required"},
         {"/plug/thread", "22", "/input/plug/thread: must be a metric thread"},
         {"/plug/bore_depth_mm", 14, "/input/plug: must be a possible plug"},
         {"/balancing/service_speed_rpm", 0, "/input/balancing/service_speed_rpm"},
         {"/job/engine_number", 5, "/input/job/engine_number: must be a text"},
         {"/process", nullptr, "/input/process: is required and missing"}},
        solved);
    Json input = full_example();
    input["weigh_in"]["piston"]["mass_g"][3] = nullptr;
    EXPECT_EQ(error_of(input), "/input/weigh_in/piston/mass_g/3: must be a number, got null");
    input = example();
    input["mass_changes_from"] = "weigh-in";
    EXPECT_NE(error_of(input).find("/input/weigh_in: is required"), std::string::npos);
    EXPECT_EQ(error_of(Json::object()), "/input/engine: is required and missing");
}

Json six_litres(double repair_piston_g) {
    return {{"engine", "6 l"},
            {"engine_overrides",
             {{"oil_mass_g", 20},
              {"oil_coefficient", 1},
              {"reciprocating_mass_g", 1000},
              {"rotating_mass_g", 650}}},
            {"process", "repair"},
            {"mass_changes_g", {{"repair_piston_and_rings", repair_piston_g}}}};
}

TEST(Shift, MakesTheAnswerAmber) {
    Json json = six_litres(3.0);
    Json result = solved(json);
    EXPECT_EQ(result.at("recommended"), "steel-machined");
    EXPECT_EQ(result.at("state"), "warning");
    EXPECT_NE(result.at("warning").get<std::string>().find("take off 1.11 g each"),
              std::string::npos);
    // One number wherever it is said; the method's own is beside it.
    EXPECT_EQ(result.at("reason"), "Take 1.11 g off each of the 8 steel plugs.");
    const auto off = [&](const char* key) {
        return number(result.at("options").at("steel-machined"), key);
    };
    EXPECT_NEAR(off("/take_off_g"), 1.111, 1e-3);
    EXPECT_NEAR(off("/reduction_g"), 1.159, 1e-3);
    const Json& effect = at(result, "/options/steel-machined/shift_effect");
    EXPECT_TRUE(effect.at("beyond_tolerance").get<bool>());
    EXPECT_EQ(effect.at("from"), "range");
    // With the plug's sizes and a cutter the depth is given.
    json["plug"] = {{"thread", "M30x1.5"}, {"height_mm", 11}, {"cutter_diameter_mm", 10}};
    result = solved(json);
    const Json& bored = result.at("options").at("steel-machined");
    EXPECT_EQ(bored.at("shift_effect").at("from"), "bore");
    EXPECT_EQ(result.at("state"), "warning");
    EXPECT_LT(number(bored, "/shift_effect/corrected_depth_mm"), number(bored, "/boring/depth_mm"));
    EXPECT_NE(result.at("warning").get<std::string>().find(" from the face, "), std::string::npos);
    // A tolerance that covers it.
    json["tolerance_g_mm"] = 50;
    result = solved(json);
    EXPECT_EQ(result.at("state"), "works");
    EXPECT_FALSE(result.contains("warning"));
    EXPECT_EQ(off("/take_off_g"), off("/reduction_g"));
    json["tolerance_g_mm"] = 5;
    json["mass_changes_g"]["repair_piston_and_rings"] = 100.0;
    EXPECT_EQ(solved(json).at("state"), "fails");
}

}  // namespace
}  // namespace ravnoves::v8_plugs

// What is skipped when little is asked for changes no number of what is asked for.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/sha256.h"
#include "case-file/text_file.h"
#include "examples.h"
#include "scenes/scenes.h"
#include "support.h"
#include "temporary_folder.h"

namespace ravnoves::studies {
namespace {

using test::example;

TEST(Wanted, EachPartAloneIsThatOfTheWhole) {
    for (const auto& path : ravnoves::test::example_files()) {
        const CaseFile file = parse_case(read_text_file(path));
        const Json whole = solve_case(file, {}).at("result");
        for (const auto& item : whole.items()) {
            const Json alone = solve_case(file, {}, Wanted({"/" + item.key()})).at("result");
            EXPECT_TRUE(alone == (Json{{item.key(), item.value()}})) << path << ' ' << item.key();
        }
    }
}

TEST(Wanted, EachNumberAloneIsThatOfTheWhole) {
    CaseFile too_weak = example("zotov-softer-spring");
    too_weak.input["spring"]["guide_radius_at_zero_mm"] = 99.0;
    int tried = 0;
    for (const auto& [file, begins] :
         {std::pair(example("tmz-650d"), std::vector{"/metrics/", "/optimum/", "/change"}),
          std::pair(example("zotov-softer-spring"), std::vector{"/guide/"}),
          std::pair(example("zotov-counterweight"), std::vector{"/guide/"}),
          std::pair(too_weak, std::vector{"/guide/"})}) {
        const Json flat = solve_case(file, {}).at("result").flatten();
        for (const auto& item : flat.items()) {
            if (std::ranges::any_of(begins,
                                    [&](auto each) { return item.key().starts_with(each); })) {
                const Json alone = solve_case(file, {}, Wanted({item.key()})).at("result");
                EXPECT_EQ(alone.at(Json::json_pointer(item.key())), item.value()) << item.key();
                ++tried;
            }
        }
    }
    EXPECT_GT(tried, 100);
}

TEST(TypedResponse, GivesTheNumbersOfTheWholeSolution) {
    const struct {
        const char* file;
        std::vector<std::string> varied;
    } cases[] = {{"tmz-650d", {"/crank_radius_mm", "/reciprocating_masses_kg/piston"}},
                 {"tmz-650d", {"/shaft_angle_deg", "/torque/torque_Nm/26"}},
                 {"with-shaft-88x75", {"/crank_radius_mm", "/shaft_angle_deg"}},
                 {"with-shaft-88x75", {"/speed_rpm", "/centre_distance_mm"}},
                 {"with-shaft-88x75", {"/cylinder/bore_mm", "/cylinder/rod_length_mm"}},
                 {"with-shaft-88x75",
                  {"/reciprocating_masses_kg/piston", "/torque/cycle/compression_ratio"}},
                 {"zotov-energy", {"/lambda"}},
                 {"vr5-volkswagen", {"/crank_radius_mm"}},
                 {"v8-6-manufacture", {"/engine/plug_radius_mm"}},
                 {"bob-weights-v8", {"/parts_g/piston"}}};
    for (const auto& [name, varied] : cases) {
        SCOPED_TRACE(name + varied[0]);
        const CaseFile file = example(name);
        const Json flat = solve_case(file, {}).at("result").flatten();
        std::vector<std::string> watched;
        for (const auto& item : flat.items()) {
            // Of a balance shaft those that rest on the moments alone; a solver gives the others.
            const bool is_watched =
                file.scene != "balance-shaft"
                    ? item.value().is_number_float() && watched.size() < 12
                    : item.value().is_number() && (item.key().starts_with("/metrics/") ||
                                                   item.key().starts_with("/optimum/") ||
                                                   item.key() == "/moment_amplitude_Nm" ||
                                                   item.key() == "/counterweight_mass_kg");
            if (is_watched) {
                watched.push_back(item.key());
            }
        }
        ASSERT_GT(watched.size(), file.scene == "balance-shaft" ? 25U : 0U);
        const auto quick = scene_solver(file.scene).respond(file.input, {}, varied, watched);
        std::vector<double> x(varied.size());
        std::vector<double> y(watched.size());
        for (std::size_t i = 0; i < 6; ++i) {
            CaseFile moved = file;
            // Together, then one alone: what the one that stays leaves as it was is kept.
            for (std::size_t j = 0; j < varied.size(); ++j) {
                Json& value = moved.input.at(Json::json_pointer(varied[j]));
                const std::size_t step = i < 3 ? i : j == i % 2 ? i : 2;
                x[j] = value.get<double>() * (1.0 + 0.001 * static_cast<double>(step));
                value = x[j];
            }
            ASSERT_TRUE(quick->evaluate(x, y));
            const Json result = solve_case(moved, {}).at("result");
            for (std::size_t w = 0; w < watched.size(); ++w) {
                EXPECT_EQ(y[w], result.at(Json::json_pointer(watched[w])).get<double>())
                    << watched[w];
            }
        }
        std::fill(x.begin(), x.end(), -1e13);
        EXPECT_FALSE(quick->evaluate(x, y));
        const std::string reason = quick->reason().message().english();
        EXPECT_TRUE(std::ranges::any_of(varied, [&](const auto& each) {
            return reason.starts_with("/input" + each + ": ");
        })) << reason;
    }
}

TEST(TypedResponse, KnowsThePeriodsOfAngles) {
    const CaseFile four = example("tmz-650d");
    CaseFile two = example("vr5-volkswagen");
    two.input["strokes"] = 2;
    CaseFile motion = example("zotov-softer-spring");
    motion.input["motion"] = {{"turns", 5}};
    const struct {
        CaseFile file;
        const char* watched;
        double period;
    } cases[] = {{four, "/metrics/M_up/max_crank_angle_deg", 720.0},
                 {example("vr5-volkswagen"), "/firing/1/crank_angle_deg", 720.0},
                 {two, "/firing/1/crank_angle_deg", 360.0},
                 {four, "/optimum/range/shaft_angle_deg", 360.0},
                 {four, "/metrics/M_up/range_Nm", 0.0},
                 {motion, "/guide/worst_crank_angle_deg", 360.0},
                 {motion, "/motion/without_hinge/crank_angle_deg", 0.0}};
    for (const auto& [file, watched, period] : cases) {
        const std::array<std::string, 1> pointers{watched};
        const auto response = scene_solver(file.scene).respond(file.input, {}, {}, pointers);
        double y = 0.0;
        ASSERT_TRUE(response->evaluate({}, std::span(&y, 1))) << watched;
        EXPECT_EQ(response->period(0), period) << watched;
        for (const ResultEntry& entry : scene_solver(file.scene).results(file.input, {})) {
            EXPECT_TRUE(entry.pointer != watched || entry.period == period) << watched;
        }
    }
}

TEST(TypedResponse, RejectsAsTheWholeSolutionDoes) {
    CaseFile file = example("tmz-650d");
    const std::array<std::string, 1> varied{"/crank_radius_mm"};
    const std::array<std::string, 1> watched{"/metrics/M_ups/range_Nm"};
    const auto quick = scene_solver(file.scene).respond(file.input, {}, varied, watched);
    double y = 0.0;
    for (const double x : {-46.0, 0.0, 1e-9, 1e120}) {
        file.input["crank_radius_mm"] = x;
        std::string reason;
        try {
            solve_case(file, {});
        } catch (const InputError& error) {
            reason = error.where() + ": " + error.allowed();
        }
        EXPECT_FALSE(quick->evaluate(std::span(&x, 1), std::span(&y, 1)));
        EXPECT_EQ(quick->reason().message().english(), reason);
    }
}

TEST(CaseResponse, SaysThatAFileHasChanged) {
    const test::TemporaryFolder folder;
    const CaseContext context{folder.path()};
    const std::string table = "0;0\n180;300\n360;0\n540;-100\n720;0\n";
    write_text_file(context.directory / "torque.csv", table);
    CaseFile file = example("tmz-650d");
    file.input["torque"] = {{"csv", "torque.csv"}, {"csv_sha256", sha256(table)}};
    file.study = {{"vary", {{"/shaft_angle_deg", {{"plus_minus", 1}}}}},
                  {"watch", {{"/metrics/M_ups/range_Nm", Json::object()}}},
                  {"samples", 16}};
    EXPECT_TRUE(problem_of(file, context).file_notes.empty());
    file.input["torque"]["csv_sha256"] = sha256("");
    const Json notes = write_results(whole(problem_of(file, context))).at("notes");
    ASSERT_FALSE(notes.empty());
    EXPECT_TRUE(notes[0].get<std::string>().starts_with("torque.csv has changed since")) << notes;
}

TEST(CaseResponse, DerivativesAreThoseOfFiftyDigits) {
    CaseFile file = example("tmz-650d");
    file.study = {{"vary",
                   {{"/crank_radius_mm", {{"plus_minus", 0.02}}},
                    {"/reciprocating_masses_kg/piston", {{"normal_sd", 0.002}}},
                    {"/centre_distance_mm", {{"plus_minus", 0.1}}},
                    {"/shaft_angle_deg", {{"plus_minus", 0.5}}}}},
                  {"watch",
                   {{"/metrics/M_ups/range_Nm", Json::object()},
                    {"/optimum/rms/rms_Nm", Json::object()},
                    {"/moment_amplitude_Nm", Json::object()}}},
                  {"method", "linear"}};
    const Part part = *run_study(problem_of(file, {}), 1, 1, 1);
    // Of the closed forms, by mpmath with 50 digits.
    constexpr std::array<std::array<double, 4>, 3> known{{
        {1.2165693976016577, 42.524462226197761, 0.55878374727584876, -3.0891452805202856},
        {4.8205131278706674, 168.49817924167986, 2.2141148665207259, 0.0},
        {9.356181444288, 327.039776928, 4.29739736832, 0.0},
    }};
    for (std::size_t w = 0; w < known.size(); ++w) {
        for (std::size_t j = 0; j < known[w].size(); ++j) {
            const auto& slope = part.basis.expansions[w].slopes[j];
            ASSERT_TRUE(slope);
            const double scale = std::abs(known[w][j]);
            EXPECT_NEAR(slope->value, known[w][j], 1e-9 * scale + 1e-11) << w << ' ' << j;
            EXPECT_LE(std::abs(slope->value - known[w][j]), slope->error + 1e-12 * scale);
            EXPECT_LE(slope->error, 1e-8 * scale + 1e-9);
        }
    }
}

}  // namespace
}  // namespace ravnoves::studies

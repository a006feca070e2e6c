#include "inertia-moments/input.h"

#include <gtest/gtest.h>

#include "case-file/case_file.h"
#include "case-file/field_index.h"
#include "case-file/json.h"
#include "case-file/result_json.h"
#include "engines.h"

namespace ravnoves::inertia_moments {
namespace {

Json vr5_json() {
    return parse_json(R"({"crank_radius_mm": 45, "lambda": 0.265, "speed_rpm": 6200,
        "reciprocating_mass_kg": 0.622, "rotating_mass_kg": 0.8, "reference_position_mm": 0,
        "layout": {"type": "vr", "cylinders": 5, "bank_angle_deg": 15, "offset_mm": 12.51,
                   "spacing_mm": 63, "firing_order": [1, 2, 4, 5, 3], "first_position_mm": 204.8}
        })");
}

Json table_json() {
    return parse_json(R"({"crank_radius_mm": 40, "lambda": 0.3, "speed_rpm": 3000,
        "reciprocating_mass_kg": 0.5, "cylinders": [
        {"axial_position_mm": 40, "bank_angle_deg": 0, "offset_mm": 0, "crankpin_angle_deg": 0},
        {"axial_position_mm": -40, "bank_angle_deg": 0, "offset_mm": 0, "crankpin_angle_deg": 180}
        ]})");
}

TEST(CaseIo, KeysHaveTheContractsNamesAndNullRules) {
    const Json twin = result_json({}, read_input(table_json()));
    // Two pistons in antiphase: no first-order force, so it has no direction.
    const Json& force_1 = twin["exact"]["order_1"]["force_N"];
    EXPECT_TRUE(force_1["forward"]["angle_deg"].is_null());
    EXPECT_TRUE(force_1["backward"]["angle_deg"].is_null());
    EXPECT_LT(force_1["forward"]["amplitude"].get<double>(), 1e-9);
    EXPECT_TRUE(twin["exact"]["order_2"]["force_N"]["forward"]["angle_deg"].is_number());
    EXPECT_TRUE(twin["rotating"]["force_angle_deg"].is_null());
    EXPECT_TRUE(twin["rotating"]["counterweight_force_lag_deg"].is_null());
    EXPECT_NEAR(twin["rotating"]["moment_factor_m"].get<double>(), 0.08, 1e-15);
    EXPECT_EQ(twin["rotating"]["force_N"].get<double>(), 0.0);
    EXPECT_FALSE(twin.contains("tdc_angle_deg"));
    EXPECT_FALSE(result_json({}, read_input(vr5_json())).contains("curves"));
}

TEST(CaseIo, RejectsWithPointerRuleAndFinding) {
    const Json rod{{"mass_kg", 0.5}, {"centre_from_big_end_mm", -2000}, {"inertia_kg_m2", 0.001}};
    const struct {
        const char* pointer;
        Json value;
        const char* error;  // its beginning
    } rows[] = {{"/crank_radius_mm", -46, "/crank_radius_mm: must be greater than 0, got -46"},
                {"/layout/firing_order",
                 {1, 2, 4, 5, 5},
                 "/layout/firing_order: must name each cylinder from 1 to 5 once, got 1-2-4-5-5"},
                {"/balance_shafts", Json::array({{{"order", 13}}}), "/balance_shafts/0/order"},
                {"/rod", rod, "/rod/centre_from_big_end_mm"}};
    for (const auto& [pointer, value, error] : rows) {
        Json json = vr5_json();
        json[Json::json_pointer(pointer)] = value;
        EXPECT_TRUE(test::rejection_of(json).starts_with(std::string("/input") + error)) << error;
    }
    Json json = vr5_json();
    json["layout"]["type"] = "library";
    json["layout"].erase("cylinders");
    json["layout"]["name"] = "vr66";
    EXPECT_NE(test::rejection_of(json).find("(the nearest is \"vr"), std::string::npos);
    json.erase("layout");
    EXPECT_NE(test::rejection_of(json).find("/input/cylinders: is required"), std::string::npos);
    json["cylinders"] = Json::array();
    EXPECT_NE(test::rejection_of(json).find("/input/cylinders: must list from 1"),
              std::string::npos);
}

TEST(CaseIo, TheRodsLengthStandsForLambda) {
    const Input by_ratio = read_input(vr5_json());
    Json json = vr5_json();
    json.erase("lambda");
    json["rod_length_mm"] = 45.0 / 0.265;
    const Input by_length = read_input(json);
    EXPECT_NEAR(by_length.ratio(), 0.265, 1e-15);
    EXPECT_NEAR(by_length.rod_length(), by_ratio.rod_length(), 1e-15);
    const EngineOrder& first = solve(by_ratio).exact.order(2);
    const EngineOrder& second = solve(by_length).exact.order(2);
    EXPECT_NEAR(std::abs(first.moment.forward - second.moment.forward), 0.0,
                1e-12 * first.moment_scale);
    // It is written as it was given, and stays where the crank radius changes.
    const Json written = write_input(by_length);
    EXPECT_FALSE(written.contains("lambda"));
    EXPECT_NEAR(written.at("rod_length_mm").get<double>(), 45.0 / 0.265, 1e-12);
    EXPECT_EQ(read_input(written), by_length);
    Input longer = by_length;
    EXPECT_TRUE(set_field(longer, "/crank_radius_mm", 50.0));
    EXPECT_NEAR(longer.rod_length(), by_length.rod_length(), 1e-15);
    EXPECT_NEAR(longer.ratio(), 50.0 / (45.0 / 0.265), 1e-12);
    EXPECT_TRUE(set_field(longer, "/rod_length_mm", 160.0));
    EXPECT_NEAR(longer.rod_length(), 0.16, 1e-15);
    // Exactly one of the two.
    json["lambda"] = 0.265;
    EXPECT_EQ(test::rejection_of(json),
              "/input/rod_length_mm: must be left out if lambda is given");
    json.erase("lambda");
    json.erase("rod_length_mm");
    EXPECT_NE(test::rejection_of(json), "no error");
    json["rod_length_mm"] = 40;
    json["layout"]["offset_mm"] = 0;
    EXPECT_EQ(test::rejection_of(json).rfind(
                  "/input/rod_length_mm: must be greater than the crank radius, 45 mm;", 0),
              0U)
        << test::rejection_of(json);
    json["rod_length_mm"] = 46e9;
    EXPECT_EQ(
        test::rejection_of(json).rfind("/input/rod_length_mm: must be at most 45000000000", 0), 0U)
        << test::rejection_of(json);
}

TEST(CaseIo, LockingMechanismsAreRejectedWithTheAngle) {
    Json json = vr5_json();
    json["lambda"] = 0.9;
    json["layout"]["offset_mm"] = 10;
    // L − R = 5 mm; turning forward the rod lies across at 180° + arcsin((L − e)/R).
    const double forward = 180.0 + std::asin((50.0 - 10.0) / 45.0) / degree;
    const std::string text = test::rejection_of(json);
    EXPECT_NE(text.find("/input/layout/offset_mm: must be less than 5 mm in magnitude"),
              std::string::npos)
        << text;
    std::array<char, 16> angle{};
    std::snprintf(angle.data(), angle.size(), "%.1f°", forward);
    EXPECT_NE(text.find(angle.data()), std::string::npos) << text;
    EXPECT_NE(text.find(", got 10"), std::string::npos) << text;

    json["lambda"] = 1.25;
    json["layout"]["offset_mm"] = 0;
    EXPECT_NE(test::rejection_of(json).find(
                  "/input/lambda: must be at most 0.999999996; the mechanism of "
                  "cylinder 1 locks with the crank at 53.13°"),
              std::string::npos)
        << test::rejection_of(json);

    json = table_json();
    json["cylinders"][1]["offset_mm"] = -93.4;
    EXPECT_NE(test::rejection_of(json).find("/input/cylinders/1/offset_mm"), std::string::npos);
    json["cylinders"][1]["offset_mm"] = -500;
    EXPECT_NE(test::rejection_of(json).find("is not possible"), std::string::npos)
        << test::rejection_of(json);
    // Just inside the limit it turns.
    json["cylinders"][1]["offset_mm"] = -93.3;
    EXPECT_EQ(test::rejection_of(json), "no error");
}

/// A layout of the library stays centred whatever its spacing: an even in-line engine or V-8 has no
/// second-order moment that its lever alone would make.
TEST(CaseIo, ALayoutOfTheLibraryStaysCentred) {
    Json json = vr5_json();
    json["layout"] = {{"type", "library"}};
    for (const LayoutSpec& spec : layout_library()) {
        json["layout"]["name"] = std::string(spec.name);
        for (const double spacing : {80.0, 137.5}) {
            json["layout"]["spacing_mm"] = spacing;
            const Result result = solve(read_input(json));
            double low = 0.0;
            double high = 0.0;
            for (const Cylinder& cylinder : result.engine.cylinders) {
                low = std::min(low, cylinder.axial_position);
                high = std::max(high, cylinder.axial_position);
            }
            EXPECT_NEAR(low + high, 0.0, 1e-12) << spec.name;
            if (spec.name == "i4" || spec.name == "v8-flat-plane") {
                EXPECT_LT(result.exact.order(2).moment.max(),
                          1e-9 * result.exact.order(2).moment_scale)
                    << spec.name;
            }
        }
    }
    // One bank has no stagger: what is given has no effect, and a note says so.
    json["layout"] = {{"type", "library"}, {"name", "i4"}, {"spacing_mm", 80}};
    const Result plain = solve(read_input(json));
    json["layout"]["stagger_mm"] = 20;
    const Result staggered = solve(read_input(json));
    EXPECT_EQ(staggered.engine.cylinders, plain.engine.cylinders);
    ASSERT_EQ(staggered.notes.size(), plain.notes.size() + 1);
    EXPECT_EQ(staggered.notes.back().english().find("The stagger of 20"), 0U)
        << staggered.notes.back().english();
    // A position that is given stays, and one that only repeats the middle does not.
    json["layout"] = {{"type", "library"}, {"name", "i4"}, {"spacing_mm", 80}};
    json["layout"]["first_position_mm"] = 150;
    EXPECT_EQ(read_input(json).layout->first_position, 150 * units::mm);
    json["layout"]["first_position_mm"] = 120;
    EXPECT_FALSE(read_input(json).layout->first_position);
}

/// Before and after balancing are of the same parts: without weights and shafts nothing differs.
TEST(CaseIo, BeforeAndAfterHaveTheRotatingMasses) {
    const Json result = result_json({}, read_input(vr5_json()));
    EXPECT_EQ(result.at("unbalanced"), result.at("remaining"));
    EXPECT_NE(result.at("unbalanced").at("order_1"), result.at("exact").at("order_1"));
    EXPECT_EQ(result.at("unbalanced").at("order_2"), result.at("exact").at("order_2"));
}

/// What the help says of an empty field is what the program takes for it.
TEST(CaseIo, AnEmptyFieldStandsForWhatTheHelpSays) {
    Json json = table_json();
    json["reference_position_mm"] = 12.0;
    json["rotating_mass_kg"] = 0.5;
    json["cylinders"].push_back(json["cylinders"][0]);
    json["cylinders"][2]["bank_angle_deg"] = 60;
    json["cylinders"][2]["articulated"] = {{"knuckle_radius_mm", 30}};
    json["balance_shafts"] = {{{"order", 1}, {"direction", "forward"}, {"balances", "force"}}};
    const std::pair<const char*, Json> defaults[] = {
        {"/cylinders/2/articulated/knuckle_angle_deg", 60},
        {"/cylinders/2/articulated/rod_length_mm", 40 / 0.3 - 30},
        {"/cylinders/2/articulated/master", 1},
        {"/balance_shafts/0/axial_position_mm", 12},
    };
    const Result empty = solve(read_input(json));
    for (const auto& [pointer, value] : defaults) {
        Json with = json;
        with[Json::json_pointer(pointer)] = value;
        const Result given = solve(read_input(with));
        for (const int order : {1, 2}) {
            EXPECT_NEAR(std::abs(given.remaining.order(order).moment.forward -
                                 empty.remaining.order(order).moment.forward),
                        0.0, 1e-9 * empty.remaining.order(order).moment_scale)
                << pointer;
        }
    }
}

TEST(InertiaMomentsVerdict, DoubtsWhatNoEngineIsLike) {
    const auto rod = [](double centre_mm, double inertia) {
        return Json{
            {"mass_kg", 1}, {"centre_from_big_end_mm", centre_mm}, {"inertia_kg_m2", inertia}};
    };
    const auto webs = [](double front_mm, double radius_mm) {
        return Json{{"front_position_mm", front_mm},
                    {"rear_position_mm", -90},
                    {"front_radius_mm", radius_mm},
                    {"rear_radius_mm", 45},
                    {"first_order_share", 1}};
    };
    const struct {
        const char* pointer;
        Json value;
        const char* doubt;
    } rows[] = {{"/rod", rod(50, 0.004), ""},
                {"/rod", rod(200, 0), "200 mm from the big end"},
                {"/rod", rod(50, 1000), "inertia is implausible"},
                {"/layout/spacing_mm", 6.3, "Cylinder spacing 12.6 mm is implausible"},
                {"/layout/spacing_mm", 40, ""},
                {"/layout/spacing_mm", 200, ""},
                {"/layout/spacing_mm", 630, "Cylinder spacing 630 mm is implausible"},
                {"/reference_position_mm", 400, ""},
                {"/reference_position_mm", -2048, "is 2001 mm outside the cylinders"},
                {"/counterweights", webs(240, 45), ""},
                {"/counterweights", webs(150, 45), "not beyond the outer cylinders"},
                {"/counterweights", webs(240, 0.1), "is heavier than all throws and pistons"},
                {"/counterweights", webs(-88, 45), "is heavier than all throws and pistons"}};
    for (const auto& [pointer, value, doubt] : rows) {
        Json json = vr5_json();
        json[Json::json_pointer(pointer)] = value;
        const Input input = read_input(json);
        const Verdict said = verdict(input, solve(input));
        EXPECT_EQ(said.severity, *doubt == 0 ? Severity::note : Severity::warning) << value;
        EXPECT_NE(said.text.english().find(doubt), std::string::npos) << said.text.english();
    }
    // Whatever the layout, its usual sizes are none.
    for (const LayoutSpec& spec : layout_library()) {
        EXPECT_TRUE(solve(test::engine_of(spec.name)).notes.empty()) << spec.name;
    }
}

}  // namespace
}  // namespace ravnoves::inertia_moments

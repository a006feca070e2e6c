// Cases of bob-weights: the shop card, the result's keys, bad input, limits of planes.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "bob-weights/solver.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "shop/results.h"
#include "shop/weighing.h"
#include "support.h"

namespace ravnoves::bob_weights {
namespace {

using workshop::BobWeightsCase;
using workshop::write_input;
using workshop::test::at;
using workshop::test::changed;
using workshop::test::Changes;
using workshop::test::difference;
using workshop::test::number;

BobWeightsCase read_input(const Json& input, Completeness completeness = Completeness::required) {
    return workshop::read_bob_weights_case(input, completeness);
}

Json shop_card() {
    return parse_json(R"({
        "engine": {"type": "v", "cylinders": 8, "bank_angle_deg": 90, "rods_per_pin": 2},
        "parts_g": {"rings": 69.5, "piston": 583.9, "pin": 173.6, "locks": 4.8, "small_end": 162.4,
                    "big_end": 229.8, "shells": 23.7, "oil": 4}})");
}

Json with_correction() {
    Json input = shop_card();
    input["correction"] = parse_json(R"({
        "planes": [{"position_mm": 60, "radius_mm": 85}, {"position_mm": 480, "radius_mm": 80}],
        "readings": [{"unbalance_g_mm": 2500, "angle_deg": 40},
                     {"unbalance_g_mm": 1200, "angle_deg": -70}],
        "drill": {"diameters_mm": [10, 16], "maximum_depth_mm": 30}})");
    return input;
}

Json solved(const Json& input) {
    return workshop::test::solved_bob_weights_case(input);
}

Json front_of(const Json& input) {
    return at(solved(input), "/correction/planes/0");
}

std::string error_of(const Json& input) {
    return workshop::test::error_of(input, solved);
}

TEST(BobWeight, OfSplitCrankpinsHangsOnEachOfThem) {
    Json card = shop_card();
    card["parts_g"]["oil"] = 4;
    card["engine"] = {{"type", "v"},
                      {"cylinders", 6},
                      {"bank_angle_deg", 60},
                      {"pin_split_deg", 60},
                      {"rods_per_pin", 2}};
    const Json two = solved(card);
    card["engine"]["rods_per_pin"] = 1;
    const Json one = solved(card);
    EXPECT_EQ(two.at("bobweights"), 6);
    EXPECT_EQ(two.at("bobweight_g"), one.at("bobweight_g"));
    // The oil of one crankpin, one rod, half of one piston.
    EXPECT_NEAR(number(two, "/bobweight_g"),
                4 + 229.8 + 23.7 + 0.5 * (69.5 + 583.9 + 173.6 + 4.8 + 162.4), 1e-9);
    // Of weighed parts each crankpin has its own cylinder.
    card["engine"]["rods_per_pin"] = 2;
    card["weigh_in"] = parse_json(R"({"piston": {"mass_g": [580, 581, 582, 583, 584, 585]}})");
    const Json pins = solved(card).at("weigh_in").at("crankpins_g");
    ASSERT_EQ(pins.size(), 6U);
    EXPECT_NEAR(pins[5].get<double>() - pins[0].get<double>(), 2.5, 1e-9);
}

TEST(Weights, ThatDoNotCountOrReplaceWhatIsTypedAreSaid) {
    Json card = shop_card();
    EXPECT_TRUE(solved(card).at("not_counted").empty());
    card["weigh_in"] =
        parse_json(R"({"piston": {"mass_g": [580, 581, 582, 583, 584, 585, 586, 587]}})");
    const Json said = solved(card).at("not_counted");
    ASSERT_EQ(said.size(), 1U) << said;
    EXPECT_EQ(said[0], "Piston: the weighed masses replace the typed 583.90 g.");
    // Of a sheet that is half filled.
    BobWeightsCase input = read_input(card);
    input.weigh_in->columns[1].mass[2] = 0.17;
    EXPECT_EQ(replaced(input).size(), 1U);
    EXPECT_EQ(not_counted(input).at(0).english(),
              "Pin: 1 of 8 weighed; the typed mass is used until all are weighed.");
}

TEST(Weighing, AddsTheRoundingOfEachPartBySquares) {
    // Five parts count once (twice 50 %), two twice, and the bob weight is weighed itself.
    constexpr double d = 1e-4;
    Json card = with_correction();
    const Input input = read_input(card);
    const auto found = shop::weighing(d, rounding_squares(input, solve(input)), 30e-6);
    EXPECT_NEAR(found.bob_weight, 2.0 * d * std::sqrt((1.0 + 5.0 + 2.0 * 4.0) / 12.0), 1e-15);
    EXPECT_NEAR(found.bob_weight * *found.largest_radius, 30e-6 / 3.0, 1e-15);
    // Of eight weighed pistons the mean counts.
    card["weigh_in"]["piston"]["mass_g"] = Json::array({584, 583, 584, 583, 584, 583, 584, 583});
    const Input sheet = read_input(card);
    EXPECT_NEAR(rounding_squares(sheet, solve(sheet)), 4.0 + 1.0 / 8.0 + 8.0, 1e-12);
}

TEST(BobWeight, IsTheSumOfItsLines) {
    const auto factor = [](double percent, double overbalance) {
        return Json{{"reciprocating_percent", percent}, {"overbalance_percent", overbalance}};
    };
    const Json two{{"piston", 600}, {"big_end", 500}};  // what is not given weighs nothing
    const Json one = {{"type", "inline"}, {"cylinders", 1}, {"rods_per_pin", 1}};
    const std::pair<Changes, double> rows[] = {
        {{}, 1505.2},
        {{{"/factor", factor(46, 2)}}, 4 + 2 * (253.5 + 0.48 * 994.2)},
        {{{"/factor", factor(2, 5)}}, 4 + 2 * (253.5 + 0.07 * 994.2)},
        {{{"/factor", factor(2, -2)}}, 4 + 2 * 253.5},
        {{{"/parts_g", two}}, 1600},
        {{{"/parts_g", two}, {"/engine", one}}, 800}};
    for (const auto& [changes, grams] : rows) {
        const Json result = solved(changed(shop_card(), changes));
        EXPECT_NEAR(number(result, "/bobweight_g"), grams, 1e-9);
        double sum = 0.0;
        for (const Json& line : result.at("lines")) {
            sum += number(line, "/product_g");
        }
        EXPECT_NEAR(sum, grams, 1e-9);
    }
    EXPECT_THROW(solved(changed(shop_card(), {{"/factor", factor(2, -2.5)}})), InputError);
}

TEST(BobWeight, OfWeighedPartsTakesTheirMeans) {
    Json input = shop_card();
    input["engine"]["cylinders"] = 4;
    input["weigh_in"] = parse_json(R"({"cylinder_numbering": "alternating",
        "piston": {"permitted_spread_g": 2, "mass_g": [580, 582, 584, 590]},
        "rod_big_end": {"nominal_g": 230, "mass_g": [230, 231, 232, 233]}})");
    Json result = solved(input);
    EXPECT_NEAR(number(result, "/bobweight_g"), 1505.2 + (584 - 583.9) + 2 * (231.5 - 229.8), 1e-9);
    const Json& piston = result.at("weigh_in").at("piston");
    EXPECT_FALSE(piston.at("within_permitted_spread").get<bool>());
    const double more[] = {0, 2, 4, 10};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(piston.at("take_off_g")[i].get<double>(), more[i], 1e-9);
    }
    // Each crankpin with its own two cylinders; their mean is the bob weight.
    const Json& pins = result.at("weigh_in").at("crankpins_g");
    ASSERT_EQ(pins.size(), 2u);
    EXPECT_NEAR(pins[0].get<double>(), 1505.2 - 583.9 - 459.6 + 0.5 * (580 + 582) + 230 + 231,
                1e-9);
    EXPECT_NEAR(0.5 * (pins[0].get<double>() + pins[1].get<double>()),
                number(result, "/bobweight_g"), 1e-9);
    input["weigh_in"]["cylinder_numbering"] = "bank-by-bank";
    result = solved(input);
    EXPECT_NEAR(number(result, "/weigh_in/crankpins_g/0"),
                1505.2 - 583.9 - 459.6 + 0.5 * (580 + 584) + 230 + 232, 1e-9);
    // The sheet may stand for the parts that it weighs.
    input["parts_g"].erase("piston");
    input["parts_g"].erase("big_end");
    EXPECT_EQ(solved(input).at("bobweight_g"), result.at("bobweight_g"));
    // An engine of more cylinders keeps what was weighed, and what counts follows it.
    BobWeightsCase larger = read_input(input);
    larger.engine.cylinders = 6;
    EXPECT_FALSE(solve(larger).bob_weight);
    EXPECT_EQ(write_input(larger).at("weigh_in").at("piston").at("mass_g").size(), 6u);
    larger.engine.cylinders = 4;
    EXPECT_NEAR(*solve(larger).bob_weight, number(result, "/bobweight_g") * 1e-3, 1e-12);
    input["weigh_in"]["piston"]["mass_g"].push_back(590);
    EXPECT_NE(error_of(input).find("must be a list of 4 masses"), std::string::npos);
}

TEST(BobWeight, SaysWhatWasNotGivenOrLooksLikeKilograms) {
    Json input = shop_card();
    EXPECT_TRUE(solved(input).at("not_given").empty());
    EXPECT_TRUE(solved(input).at("looks_like_kilograms").empty());
    input["parts_g"] = {{"piston", 0.584}, {"big_end", 229.8}, {"locks", 0.0048}, {"pin", 0}};
    const Json result = solved(input);
    EXPECT_EQ(result.at("not_given"), Json({"rings", "small_end", "shells", "oil"}));
    EXPECT_EQ(result.at("looks_like_kilograms"), Json({"piston", "locks"}));
    input = shop_card();
    input["weigh_in"] = {{"pin", {{"mass_g", Json(std::vector<double>(8, 0.17))}}}};
    EXPECT_EQ(solved(input).at("looks_like_kilograms"), Json({"pin"}));
}

TEST(Matching, OfABoxerKnowsThatOppositePistonsCancel) {
    Json input = shop_card();
    input["engine"] = {{"type", "boxer"}, {"cylinders", 4}, {"rods_per_pin", 1}};
    input["weigh_in"] = parse_json(R"({"cylinder_numbering": "alternating",
        "piston": {"mass_g": [602, 602, 600, 600]},
        "matching": {"goal": "least-shaking", "pistons": "within-bank", "crank_radius_mm": 40}})");
    Json placed = solved(input).at("weigh_in").at("assignment");
    EXPECT_EQ(placed.at("goal"), "least-shaking");
    EXPECT_NEAR(number(placed, "/shaking_before/force_g"), 0, 1e-12);
    EXPECT_FALSE(placed.at("shaking").contains("couple_g_mm"));
    EXPECT_EQ(placed.at("sets_moved"), 0);
    // One heavy piston alone: 1.5 − (−0.5) of the pair, to and fro, with 40 mm and 3000 rpm.
    input["weigh_in"]["piston"]["mass_g"] = {602, 600, 600, 600};
    input["weigh_in"]["matching"]["cylinder_spacing_mm"] = 90;
    input["tolerance"] = {{"grade_mm_s", 16}, {"rotor_mass_kg", 20}, {"service_speed_rpm", 3000}};
    placed = solved(input).at("weigh_in").at("assignment");
    const Json& before = placed.at("shaking_before");
    EXPECT_NEAR(number(before, "/force_g"), 2, 1e-9);
    EXPECT_NEAR(number(before, "/force_g_mm"), 80, 1e-9);
    EXPECT_NEAR(number(before, "/force_N"), 80e-6 * std::pow(3000 * units::rpm, 2), 1e-9);
    EXPECT_NEAR(number(before, "/couple_g_mm"), 2 * 45, 1e-9);
    EXPECT_NEAR(number(before, "/couple_g_mm2"), 2 * 45 * 40, 1e-7);
    // The numbers of the sets are read and written.
    input["weigh_in"]["rod_sets"] = {2, 1, 3, 4};
    const BobWeightsCase read = read_input(input);
    EXPECT_EQ(read_input(write_input(read)), read);
    EXPECT_EQ(write_input(read).at("weigh_in").at("matching").size(), 4u);
}

/// What holes and slugs leave, added up from the result alone.
double left_of(const Json& plane) {
    const auto at = [](const Json& json, const char* size) {
        return std::polar(json.at(size).get<double>(), number(json, "/angle_deg") * degree);
    };
    std::complex<double> left = at(plane, "unbalance_g_mm");
    for (const char* list : {"holes", "slugs"}) {
        for (const Json& hole : plane.at(list)) {
            left -= at(hole, "removed_g_mm");
        }
    }
    return std::abs(left);
}

void expect_reason(const Json& plane, std::string_view beginning) {
    EXPECT_TRUE(plane.at("reason").get<std::string>().starts_with(beginning)) << plane.dump(1);
}

TEST(Correction, LeavesWhatItSays) {
    Json input = with_correction();
    for (const double unbalance : {150.0, 900.0, 4000.0, 20'000.0}) {
        input["correction"]["readings"][0]["unbalance_g_mm"] = unbalance;
        for (const bool slugs : {false, true}) {
            input["correction"].erase("slug");
            if (slugs) {
                input["correction"]["slug"] = {{"diameter_mm", 20}, {"density_kg_m3", 17'500}};
            }
            const Json planes = solved(input).at("correction").at("planes");
            for (const Json& plane : planes) {
                EXPECT_NEAR(left_of(plane), number(plane, "/remaining_g_mm"), 1e-6);
                EXPECT_TRUE(plane.at("within_tolerance").is_null());
            }
        }
    }
}

TEST(Correction, PressesInSlugsWhereHolesHaveNoRoom) {
    Json input = with_correction();
    input["tolerance"] = {{"g_mm", 100}};
    input["correction"]["readings"][0]["unbalance_g_mm"] = 20'000;
    EXPECT_FALSE(front_of(input).at("within_tolerance").get<bool>());
    input["correction"]["slug"] = {{"diameter_mm", 25}, {"density_kg_m3", 18'000}};
    Json plane = front_of(input);
    EXPECT_TRUE(plane.at("within_tolerance").get<bool>()) << plane.dump(1);
    EXPECT_FALSE(plane.contains("reason"));
    ASSERT_FALSE(plane.at("slugs").empty());
    EXPECT_FALSE(plane.at("holes").front().contains("slug_g"));
    EXPECT_EQ(number(plane, "/slugs/0/removed_g_mm"), -number(plane, "/slugs/0/added_g_mm"));
    // Half a turn from the heavy spot, and outside the sector that may be drilled slugs alone.
    input["correction"]["readings"][0]["unbalance_g_mm"] = 2000;
    input["correction"]["planes"][0]["from_deg"] = 150;
    input["correction"]["planes"][0]["to_deg"] = 290;
    plane = front_of(input);
    EXPECT_TRUE(plane.at("holes").empty());
    ASSERT_EQ(plane.at("slugs").size(), 1u);
    EXPECT_NEAR(number(plane, "/slugs/0/angle_deg"), 220, 1e-9);
    // There, too, is too little room: the reason is the sector.
    input["correction"]["planes"][0].update({{"from_deg", 131}, {"to_deg", 221}});
    input["correction"]["readings"][0]["unbalance_g_mm"] = 20'000;
    plane = front_of(input);
    expect_reason(plane, "The heavy spot is outside the drilling sector. ");
}

TEST(Correction, DrillsTheEdgeOfTheSectorBesideTheHeavySpot) {
    Json input = with_correction();
    input["tolerance"] = {{"g_mm", 407}};
    const auto front = [&](double unbalance, double angle, double from, double to) {
        input["correction"]["readings"][0] = {{"unbalance_g_mm", unbalance}, {"angle_deg", angle}};
        input["correction"]["planes"][0]["from_deg"] = from;
        input["correction"]["planes"][0]["to_deg"] = to;
        const Json plane = front_of(input);
        EXPECT_NEAR(left_of(plane), number(plane, "/remaining_g_mm"), 1e-6);
        return plane;
    };
    const Json one = front(1013, 69.5, 70, 200);
    // Half its diameter inside, and as little beside the heavy spot as that takes.
    EXPECT_NEAR(one.at("holes").at(0).at("angle_deg").get<double>(), 74, 1);
    EXPECT_TRUE(one.at("feasible").get<bool>());
    EXPECT_FALSE(one.contains("edge_beyond_sector_mm"));
    // A row has its middle further inside.
    const Json row = front(2885, 73.1, 74, 120);
    EXPECT_LT(number(row, "/remaining_g_mm"), 0.35 * 2885) << row.dump(1);
    EXPECT_FALSE(row.contains("edge_beyond_sector_mm"));
    EXPECT_TRUE(front(1013, 200.5, 70, 200).at("within_tolerance").get<bool>());
    EXPECT_TRUE(front(1013, 0.5, 280, 0).at("within_tolerance").get<bool>());
    // Farther off it lowers what is to be welded on, or a slug takes the rest.
    const Json half = front(2000, 40, 80, 170);
    EXPECT_NEAR(number(half, "/remaining_g_mm"), 2000 * std::sin(45.4 * degree), 10);
    expect_reason(half, "The heavy spot is outside the drilling sector; holes at its edge ");
    EXPECT_TRUE(front(2000, 40, 110, 150).at("holes").empty()) << "hardly lowers it";
    input["correction"]["slug"] = {{"diameter_mm", 25}, {"density_kg_m3", 18'000}};
    const Json both = front(2000, 40, 80, 200);
    EXPECT_FALSE(both.at("holes").empty() || both.at("slugs").empty());
    EXPECT_TRUE(both.at("within_tolerance").get<bool>()) << both.dump(1);
    // Where slugs alone are enough, they are what is planned.
    EXPECT_TRUE(front(1013, 69.5, 70, 280).at("holes").empty());
}

TEST(Correction, SaysWhyMoreRemainsThanMay) {
    struct Row {
        double unbalance;  // heavy at 40°, so that a slug would be at 220°
        Json sector;
        Json slug;
        Changes more;
        const char* said;
    };
    const auto slug = [](double diameter, double density) {
        return Json{{"diameter_mm", diameter}, {"density_kg_m3", density}};
    };
    const Json earlier = parse_json(
        R"([{"drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 20, "angle_deg": 222}]}])");
    const Json light = slug(16, 7900);
    const Json heavy = slug(20, 17'500);
    const Json axial{{"diameter_mm", 20}, {"density_kg_m3", 17'500}, {"direction", "axial"}};
    const char* const outside = "The opposite side is outside the sector too";
    const Changes deep{{"/correction/smallest_depth_mm", 40}};
    const Row rows[] = {
        {2000, {131, 200}, {}, {}, "The opposite side is outside the sector too: widen the sector"},
        {2000, {131, 200}, light, {}, outside},
        {2000, {80, 120}, {}, {}, outside},
        {2000, {80, 120}, light, {}, outside},
        {20'000, {0, 80}, {}, {}, "There is too little room for the holes. "},
        {20'000, {0, 80}, light, {}, "There is too little room for the holes. "},
        {20'000, {0, 80}, light, {}, "is outside the sector too: drill deeper or wider"},
        {2000, {131, 250}, light, {}, "Slugs of 7900 kg/m³ are hardly"},
        {2000, {131, 250}, {}, {}, "Press in heavy metal opposite. As"},
        {20'000, {}, {}, {}, "Press in heavy metal opposite, or drill deeper or wider"},
        {20'000, {}, {}, {}, "As a last resort weld an equal mass at 220.0°."},
        {20'000, {}, {}, {}, "at the drilling radius at 40.0°"},
        {2000, {131, 219}, slug(25, 18'000), {}, "The heavy spot is outside the drilling sector. "},
        {20'000,
         {},
         slug(25, 7900),
         {},
         "Slugs of 7900 kg/m³ are hardly heavier than the crankshaft metal (7850 kg/m³)"},
        {20'000,
         {},
         slug(25, 11'340),
         {{"/correction/drill/maximum_depth_mm", 4}},
         "A slug of 11340 kg/m³ of maximum depth is lighter than the crankshaft metal (7850 "
         "kg/m³)"},
        {20'000,
         {20, 300},
         heavy,
         deep,
         "fits at 220.0°. Too deep: the maximum depth is 30.00 mm."},
        {20'000,
         {20, 300},
         axial,
         deep,
         "fits at 220.0°. Too deep: the maximum depth is 30.00 mm."},
        {20'000,
         {20, 300},
         axial,
         {{"/correction/drill/minimum_wall_mm", 75}},
         "fits at 220.0°. Too deep: no wall remains to the other holes."},
        {20'000, {216, 224}, heavy, {}, "fits at 220.0°. The hole is outside the drilling sector."},
        // A pair at its sides would be beyond the sector.
        {20'000,
         {205, 235},
         heavy,
         {{"/correction/earlier_runs", earlier}},
         "fits at 220.0°. Another hole is too near."},
    };
    for (const auto& [unbalance, sector, slug, more, said] : rows) {
        Json input = with_correction();
        input["tolerance"] = {{"g_mm", 100}};
        Json& correction = input["correction"];
        correction["readings"][0]["unbalance_g_mm"] = unbalance;
        if (!sector.empty()) {
            correction["planes"][0].update({{"from_deg", sector[0]}, {"to_deg", sector[1]}});
        }
        if (!slug.empty()) {
            correction["slug"] = slug;
        }
        const Json plane = front_of(changed(input, more));
        EXPECT_TRUE(plane.at("slugs").empty()) << said;
        EXPECT_FALSE(plane.at("feasible").get<bool>()) << said;
        EXPECT_NE(plane.at("reason").get<std::string>().find(said), std::string::npos)
            << plane.at("reason");
    }
}

TEST(Tolerance, IsSharedByTheDistances) {
    Tolerance tolerance;
    tolerance.grade = 16e-3;
    tolerance.rotor_mass = 30.0;
    tolerance.service_speed = 3200 * units::rpm;
    const double whole = 30.0 * 16e-3 / (3200 * units::rpm);
    EXPECT_NEAR(whole / 1e-6, 1432.394, 1e-3);  // by hand, g·mm
    const std::array<double, 2> planes{0.1, 0.5};
    const auto limits = [&] { return plane_limits(tolerance, planes).value(); };
    EXPECT_NEAR(limits()[0], 0.5 * whole, 1e-15);
    tolerance.front_share = 0.4;
    EXPECT_NEAR(limits()[0], 0.4 * whole, 1e-15);
    EXPECT_NEAR(limits()[1], 0.6 * whole, 1e-15);
    tolerance.front_share = 0.5;
    tolerance.centre_of_mass = 0.2;  // 3/4 of it towards the first plane; the standard stops at 0.7
    EXPECT_NEAR(limits()[0], 0.7 * whole, 1e-15);
    tolerance.centre_of_mass = 0.28;
    EXPECT_NEAR(limits()[0], 0.55 * whole, 1e-15);
    // Bearings in the planes change nothing; planes outboard may keep less.
    tolerance.front_bearing = 0.1;
    tolerance.rear_bearing = 0.5;
    EXPECT_NEAR(limits()[0], 0.55 * whole, 1e-15);
    tolerance.front_bearing = 0.2;
    tolerance.rear_bearing = 0.4;
    const auto outboard = limits();
    EXPECT_LT(outboard[0] + outboard[1], whole);
    // By brute force over phases no bearing gets more than its share, and one gets all of it.
    double maximum = 0.0;
    const double share = (0.4 - 0.28) / 0.2;
    for (int i = 0; i < 360; ++i) {
        const std::array<std::complex<double>, 2> left{outboard[0],
                                                       std::polar(outboard[1], i * degree)};
        const auto there = carried_over(left, planes, {0.2, 0.4});
        maximum = std::max({maximum, std::abs(there[0]) / (share * whole),
                            std::abs(there[1]) / ((1 - share) * whole)});
    }
    EXPECT_NEAR(maximum, 1.0, 1e-12);
}

TEST(BadInput, IsNamed) {
    Json input = with_correction();
    input["correction"]["slug"] = {{"diameter_mm", 25}, {"density_kg_m3", 18'000}};
    input["tolerance"] = {{"g_mm", 2}};
    input["weigh_in"] = {{"piston", {{"mass_g", {1, 2, 3, 4, 5, 6, 7, 8}}}}};
    const Json third{{"position_mm", 1}, {"radius_mm", 2}};
    workshop::test::expect_rejected(
        input,
        {{"/engine/type", "w",
          "/input/engine/type: must be one of \"v\", \"inline\", \"boxer\", got \"w\""},
         {"/engine/rods_per_pin", 3, "/input/engine/rods_per_pin: must be 1 or 2, got 3"},
         {"/parts_g/piston", -1, "/input/parts_g/piston: must be from 0 to 1000000, got -1"},
         {"/correction/planes/1/position_mm", 60,
          "/input/correction/planes/1/position_mm: must differ from the first, got 60"},
         {"/correction/drill/diameters_mm", Json::array(),
          "/input/correction/drill/diameters_mm: is required and missing"},
         {"/correction/slug/density_kg_m3", 7000,
          "/input/correction/slug/density_kg_m3: must be greater than the crankshaft's 7850, got "
          "7000"},
         {"/tolerance/rotor_mass_kg", 30, "/input/tolerance/rotor_mass_kg: is not a known key"},
         {"/machine", Json::object(), "/input/machine: is not a known key"},
         {"/weigh_in/matching/goal", "best",
          "/input/weigh_in/matching/goal: must be one of \"least-spread\", \"fewest-moves\", "
          "\"least-shaking\", got \"best\""},
         {"/weigh_in/matching/shells", "anywhere",
          "/input/weigh_in/matching/shells: must be one of \"with-set\", \"stay\", got "
          "\"anywhere\""},
         {"/weigh_in/matching/crankpin_angles_deg",
          {0, 90},
          "/input/weigh_in/matching/crankpin_angles_deg: must be a list of 4 angles, got 2"},
         {"/weigh_in/matching/permitted_spread_g", -1,
          "/input/weigh_in/matching/permitted_spread_g: must be from 0 to 100000, got -1"},
         {"/weigh_in/matching/stay", true, "/input/weigh_in/matching/stay: is not a known key"},
         {"/weigh_in/matching/bank_offset_mm", 20,
          "/input/weigh_in/matching/cylinder_spacing_mm: is required with the bank offset"},
         {"/engine/type", "inline",
          "/input/engine/rods_per_pin: must be 1 for cylinders in line, got 2"},
         {"/correction/planes/-", third, "/input/correction/planes: must be a list of two, got 3"},
         {"/engine/bank_angle_deg", nullptr,
          "/input/engine/bank_angle_deg: is required and missing"},
         {"/parts_g/big_end", nullptr, "/input/parts_g/big_end: is required and missing"}},
        solved);
    input.erase("weigh_in");
    EXPECT_EQ(error_of(changed(input, {{"/engine/cylinders", 7}})),
              "/input/engine/cylinders: must be even if two rods share a bob weight, got 7");
}

TEST(HalfFilled, FormsKeepWhatIsThere) {
    BobWeightsCase input;
    input.engine.cylinders = 6;
    input.weigh_in.emplace();
    fit_weigh_in(input);
    (*input.weigh_in)[shop::Part::pin].mass[3] = 0.15125;
    Correction& correction = input.correction.emplace();
    correction.planes[1].radius = 0.08;
    correction.aim = Aim::tolerance;
    correction.smallest_depth = 0.0;
    correction.deepens = false;
    input.tolerance.emplace();
    input.tolerance->grade = 0.016;
    const Json written = write_input(input);
    EXPECT_EQ(read_input(written, Completeness::as_is), input);
    EXPECT_THROW(read_input(written), InputError);
    const Result result = solve(input);
    EXPECT_FALSE(result.bob_weight);
    EXPECT_EQ(missing_for_bob_weight(input).size(), 3u);
    EXPECT_FALSE(result.correction);
}

TEST(Correction, AReadingOfNothingNeedsNoAngle) {
    Json input = with_correction();
    Json& correction = input["correction"];
    const Json nothing{{"unbalance_g_mm", 0}};
    correction["earlier_runs"] = Json::array({{{"readings", correction["readings"]}}});
    for (const char* pointer : {"/readings/0", "/readings/1", "/earlier_runs/0/readings/0",
                                "/earlier_runs/0/readings/1"}) {
        correction[Json::json_pointer(pointer)] = nothing;
        EXPECT_EQ(error_of(input), "no error") << pointer;
    }
    const Json written = write_input(read_input(input)).at("correction");
    EXPECT_EQ(written.at("readings"), Json::array({nothing, nothing}));
    EXPECT_EQ(at(written, "/earlier_runs/0/readings"), written.at("readings"));
    correction["readings"][1]["unbalance_g_mm"] = 1;
    EXPECT_NE(error_of(input).find("/readings/1/angle_deg: is required and missing"),
              std::string::npos);
}

TEST(Correction, RunsHaveVerdictsAndTheNewestIsCorrected) {
    Json input = with_correction();
    input["tolerance"] = {{"g_mm", 400}};
    const Json before = solved(input).at("correction");
    ASSERT_EQ(before.at("runs").size(), 1u);
    EXPECT_FALSE(before.at("runs")[0].at("within_tolerance").get<bool>());
    EXPECT_EQ(at(before, "/planes/0/within_tolerance_as_measured"), false);
    EXPECT_NEAR(number(before, "/amplification"), 1, 1e-12);
    // What the holes leave is what the next run reads.
    Json& correction = input["correction"];
    Json run{{"readings", correction["readings"]}};
    correction["earlier_runs"] = Json::array({run});
    for (std::size_t i = 0; i < 2; ++i) {
        correction["readings"][i] = {
            {"unbalance_g_mm", before.at("planes")[i].at("remaining_g_mm")},
            {"angle_deg", before.at("planes")[i].at("remaining_angle_deg")}};
    }
    const Json after = solved(input).at("correction");
    ASSERT_EQ(after.at("runs").size(), 2u);
    for (const auto& [key, value] : before.at("runs")[0].at("planes")[0].items()) {
        EXPECT_EQ(after.at("runs")[0].at("planes")[0].at(key), value);
    }
    EXPECT_TRUE(after.at("runs")[1].at("within_tolerance").get<bool>());
    EXPECT_TRUE(after.at("planes")[0].at("holes").empty());
    const Json written = write_input(read_input(input)).at("correction").at("earlier_runs");
    EXPECT_EQ(written[0].at("readings"), correction["earlier_runs"][0]["readings"]);
    EXPECT_FALSE(written[0].at("drilled").empty()) << "what the readings asked for";
    correction["earlier_runs"][0]["readings"][1].erase("angle_deg");
    EXPECT_NE(error_of(input).find("/input/correction/earlier_runs/0/readings/1/angle_deg"),
              std::string::npos)
        << error_of(input);
    // Both read beyond the rear plane: errors of the two, at the worst phases, are carried over.
    input = with_correction();
    input["correction"]["readings"][0]["position_mm"] = 500;
    input["correction"]["readings"][1]["position_mm"] = 600;
    EXPECT_NEAR(number(solved(input), "/correction/amplification"), 980.0 / 420.0, 1e-12);
}

TEST(Correction, OlderCasesHaveNoHoleThatIsDeepenedToLess) {
    Json input = with_correction();
    input["correction"]["drilled"] = Json::parse(
        R"([{"plane": "front", "diameter_mm": 10, "depth_mm": 9, "angle_deg": 40,
             "from_depth_mm": 9.4}])");
    EXPECT_NE(error_of(input).find("/correction/drilled/0/from_depth_mm: must be less than"),
              std::string::npos);
}

TEST(Correction, DrillingThatActedOtherwiseIsFound) {
    Json input = with_correction();
    input["tolerance"] = {{"g_mm", 50}};
    Json& correction = input["correction"];
    const Json first = correction["readings"];
    correction["earlier_runs"] = Json::array({{{"readings", first}}});
    const Json planned = [&] {
        Json alone = with_correction();
        alone["tolerance"] = {{"g_mm", 50}};
        return solved(alone).at("correction").at("planes");
    }();
    // What is left where each hole takes off `acted` times what it was to.
    const auto after = [&](double acted) {
        for (std::size_t i = 0; i < 2; ++i) {
            const double read = first[i].at("unbalance_g_mm").get<double>();
            const double left = planned[i].at("remaining_g_mm").get<double>();
            const std::complex<double> before =
                std::polar(read, first[i].at("angle_deg").get<double>() * degree);
            const std::complex<double> meant =
                std::polar(left, planned[i].at("remaining_angle_deg").get<double>() * degree) -
                before;
            const std::complex<double> now = before + acted * meant;
            correction["readings"][i] = {{"unbalance_g_mm", std::abs(now)},
                                         {"angle_deg", std::arg(now) / degree}};
        }
        return at(solved(input), "/correction/runs/1/planes");
    };
    for (const double well : {0.7, 1.0, 1.3}) {
        EXPECT_FALSE(after(well)[0].contains("expected")) << well;
    }
    for (const double badly : {-1.0, 0.0, 2.0}) {
        for (std::size_t i = 0; i < 2; ++i) {
            const Json found = after(badly)[i].at("expected");
            EXPECT_NEAR(number(found, "/unbalance_g_mm"),
                        planned[i].at("remaining_g_mm").get<double>(), 1e-6);
            EXPECT_EQ(found.at("drilling_acted_opposite"), badly < 0.0);
        }
    }
}

TEST(Correction, OneHoleBesideAnOldOneIsEnoughWhereTwoTakeOffTooMuch) {
    Json input = with_correction();
    input["tolerance"] = {{"g_mm", 60}};
    Json& correction = input["correction"];
    correction["planes"][0]["radius_mm"] = 80;
    correction["drill"] = {{"diameters_mm", {10}}, {"maximum_depth_mm", 25}};
    correction["smallest_depth_mm"] = 1.5;
    correction["earlier_runs"] = parse_json(R"([{
        "readings": [{"unbalance_g_mm": 3000, "angle_deg": 255}, {"unbalance_g_mm": 5, "angle_deg": 200}],
        "drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 25, "angle_deg": 255}]}])");
    for (const double reading : {70.0, 100.0, 130.0}) {
        correction["readings"] = {{{"unbalance_g_mm", reading}, {"angle_deg", 255}},
                                  {{"unbalance_g_mm", 5}, {"angle_deg", 200}}};
        const Json front = front_of(input);
        EXPECT_EQ(front.at("holes").size(), 1U) << front.dump(1);
        EXPECT_TRUE(front.at("within_tolerance").get<bool>());
        EXPECT_NEAR(left_of(front), number(front, "/remaining_g_mm"), 1e-6);
    }
}

TEST(Correction, EarlierHolesStayAndLaterOnesKeepClearOfThem) {
    Json input = with_correction();
    input["job"] = {{"engine_number", "2"}};
    input["tolerance"] = {{"g_mm", 200}};
    const Json first = solved(input).at("correction").at("planes");
    Json& correction = input["correction"];
    correction["earlier_runs"] = Json::array({{{"readings", correction["readings"]}}});
    correction["readings"] = parse_json(R"([{"unbalance_g_mm": 900, "angle_deg": 39},
                                            {"unbalance_g_mm": 100, "angle_deg": 20}])");
    const auto drilled = [&](std::size_t run, std::size_t plane) {
        const Json runs = at(solved(input), "/correction/runs");
        return runs[run].at("planes")[plane].at("drilled_holes");
    };
    Json after = solved(input).at("correction");
    for (std::size_t plane = 0; plane < 2; ++plane) {
        EXPECT_EQ(difference(first[plane].at("holes"), drilled(0, plane)), "");
        EXPECT_FALSE(after.at("runs")[1].at("planes")[plane].contains("drilled_holes"));
    }
    const Cut rim{85e-3, 7850, 118 * degree};
    const auto half = [&](const Json& hole) {
        return *half_width(rim, number(hole, "/diameter_mm") * 1e-3,
                           number(hole, "/depth_mm") * 1e-3, 3e-3);
    };
    const Json& front = after.at("planes")[0];
    ASSERT_EQ(front.at("holes").size(), 2u) << "to both sides of the first";
    for (const Json& hole : front.at("holes")) {
        const double apart = std::abs(number(hole, "/angle_deg") - 40) * degree;
        EXPECT_GE(apart, half(hole) + half(at(first, "/0/holes/0")) - 1e-12);
    }
    EXPECT_NEAR(left_of(front), number(front, "/remaining_g_mm"), 1e-6);
    EXPECT_TRUE(front.at("within_tolerance").get<bool>());
    EXPECT_TRUE(after.at("planes")[1].at("holes").empty()) << "within its limit";

    // A third run keeps clear of both; one that passed has drilled nothing.
    correction["earlier_runs"].push_back({{"readings", correction["readings"]}});
    EXPECT_EQ(difference(front.at("holes"), drilled(1, 0)), "");
    EXPECT_TRUE(drilled(1, 1).empty());
    const Json third = front_of(input);
    ASSERT_FALSE(third.at("holes").empty());
    for (const Json& hole : third.at("holes")) {
        for (const Json& old : front.at("holes")) {
            EXPECT_GE(std::abs(number(hole, "/angle_deg") - number(old, "/angle_deg")) * degree,
                      half(hole) + half(old) - 1e-12);
        }
    }
    // One alone goes to one side and takes off what it can.
    correction["drill"]["maximum_holes"] = 1;
    const Json one = front_of(input);
    EXPECT_EQ(one.at("holes").size(), 1U);
    EXPECT_NEAR(number(one, "/remaining_g_mm"), 900 * std::sin(15 * degree), 1);
    expect_reason(one,
                  "There is too little room next to the holes of earlier runs. Residual: 2.74 g");
    // Without room it says why.
    correction["planes"][0]["from_deg"] = 30;
    correction["planes"][0]["to_deg"] = 48;
    const Json stuck = front_of(input);
    EXPECT_TRUE(stuck.at("holes").empty());
    expect_reason(stuck,
                  "There is too little room next to the holes of earlier runs. Residual: 10.59 g");
    correction["planes"][0].erase("from_deg");
    correction["planes"][0].erase("to_deg");
    // Of another crankshaft, or planned by readings of another bob weight, is nothing.
    correction["earlier_runs"][1]["readings"][0]["bobweight_g"] = 1400;
    EXPECT_TRUE(drilled(1, 0).empty());
    EXPECT_FALSE(drilled(0, 0).empty());
    correction["earlier_runs"][0]["readings"][0]["read_of"] = {{"engine_number", "1"}};
    EXPECT_TRUE(drilled(0, 0).empty());
}

TEST(Correction, EarlierSlugsAreTakenToo) {
    Json input = with_correction();
    input["correction"]["slug"] = {{"diameter_mm", 25}, {"density_kg_m3", 18'000}};
    input["correction"]["readings"][0]["unbalance_g_mm"] = 20'000;
    const Json first = front_of(input);
    ASSERT_FALSE(first.at("slugs").empty());
    Json& correction = input["correction"];
    correction["earlier_runs"] = Json::array({{{"readings", correction["readings"]}}});
    correction["readings"][0] = {{"unbalance_g_mm", 500}, {"angle_deg", 220}};
    const Json after = solved(input).at("correction");
    EXPECT_EQ(difference(first.at("slugs"), at(after, "/runs/0/planes/0/drilled_slugs")), "");
    for (const Json& hole : at(after, "/planes/0/holes")) {
        for (const Json& slug : first.at("slugs")) {
            EXPECT_GT(std::abs(number(hole, "/angle_deg") - number(slug, "/angle_deg")), 10);
        }
    }
}

TEST(Correction, ReadingsWithAnotherBobWeightNameBothInGrams) {
    EXPECT_EQ(shop::other_readings(1.4, std::nullopt, 2.1052).english(),
              "The readings were taken with another bob weight: 1400.0 g then, 2105.2 g now. "
              "Measure again.");
}

TEST(BearingPlaces, AreJudgedOnlyWhereBothPlanesAreKnown) {
    Input input;
    input.tolerance.emplace();
    input.tolerance->front_bearing = 0.4;
    input.tolerance->rear_bearing = 0.1;
    for (const std::size_t planes : {0U, 1U, 2U}) {
        input.correction.emplace().planes.resize(planes);
        EXPECT_EQ(places_of_bearings(input), BearingPlaces::plausible) << planes;
    }
    input.correction->planes[0].position = 0.06;
    input.correction->planes[1].position = 0.48;
    EXPECT_EQ(places_of_bearings(input), BearingPlaces::reversed);
    // From the other end, with zero between the planes: the order is the same in both.
    input.correction->planes[0].position = 0.5;
    input.correction->planes[1].position = -0.1;
    EXPECT_EQ(places_of_bearings(input), BearingPlaces::plausible);
}

}  // namespace
}  // namespace ravnoves::bob_weights

// The plan of a job: holes that are there are deepened first, and the record is what is there.

#include <complex>
#include <random>

#include "bob-weights/drilling.h"
#include "bob-weights/solver.h"
#include "core/bob-weights/quadrature.h"
#include "doubted_jobs.h"
#include "numerics/constants.h"
#include "workshop/solver.h"

namespace ravnoves::workshop {
namespace {

using bob_weights::Cut;
using bob_weights::Hole;
using bob_weights::HoleLimits;
using bob_weights::HolePlan;
using bob_weights::Shortfall;
using test::at;
using test::card;
using test::number;
using test::solved;
using Vector = std::complex<double>;

constexpr double density = 7850.0;

/// ρ ∫ A(x) (R − x) dx from one depth to another, the cone of the point with it, by quadrature.
double removed_between(const Cut& cut, double diameter, double from, double to) {
    using bob_weights::test::by_quadrature;
    return by_quadrature(cut, diameter, to).unbalance -
           by_quadrature(cut, diameter, from).unbalance;
}

struct State {
    Vector unbalance;
    std::vector<Hole> holes;
    Cut cut{0.08, density, 118.0 * degree};
    HoleLimits limits{0.02, 1e-3, 3e-3, 5, 60.0 * degree, std::nullopt};
};

/// Holes of a millimetre's step, so that all depths can be tried.
State random_state(std::mt19937& generator) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator);
    };
    State state;
    state.cut.radius = between(0.06, 0.1);
    const double heavy = between(0.0, 2.0 * pi);
    const int count = static_cast<int>(between(1.0, 3.99));
    for (int i = 0; i < count; ++i) {
        const double diameter = between(0.0, 1.0) < 0.5 ? 0.010 : 0.014;
        const double depth = 1e-3 * std::floor(between(2.0, 15.0));
        const double angle = heavy + (i - 0.5 * (count - 1)) * 0.6 + between(-0.15, 0.15);
        state.holes.push_back({diameter, depth, bob_weights::turn_of(angle), 0.0, 0.0});
        state.holes.back().deepens = Hole::Place{0, static_cast<std::size_t>(i)};
    }
    state.unbalance = std::polar(1e-6 * between(50.0, 3000.0), heavy + between(-0.3, 0.3));
    return state;
}

double left_by(const State& state, const std::vector<double>& depths) {
    Vector sum = state.unbalance;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const Hole& hole = state.holes[i];
        sum -= std::polar(state.cut.removed(hole.diameter, depths[i]).unbalance -
                              state.cut.removed(hole.diameter, hole.depth).unbalance,
                          hole.angle);
    }
    return std::abs(sum);
}

bool keeps_walls(const State& state, const std::vector<double>& depths) {
    for (std::size_t i = 0; i < depths.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (depths[i] == state.holes[i].depth && depths[k] == state.holes[k].depth) {
                continue;
            }
            const auto one = half_width(state.cut, state.holes[i].diameter, depths[i],
                                        state.limits.minimum_wall);
            const auto other = half_width(state.cut, state.holes[k].diameter, depths[k],
                                          state.limits.minimum_wall);
            const double apart =
                std::abs(std::remainder(state.holes[i].angle - state.holes[k].angle, 2.0 * pi));
            if (!one || !other || apart < *one + *other - 1e-12) {
                return false;
            }
        }
    }
    return true;
}

/// The smallest that any depths leave.
double min_left(const State& state, std::vector<double>& depths) {
    const std::size_t i = depths.size();
    if (i == state.holes.size()) {
        return keeps_walls(state, depths) ? left_by(state, depths) : INFINITY;
    }
    double minimum = INFINITY;
    const Hole& hole = state.holes[i];
    const double away = std::abs(std::remainder(hole.angle - std::arg(state.unbalance), 2.0 * pi));
    const double maximum =
        away <= state.limits.maximum_angle
            ? std::min(state.limits.maximum_depth, state.cut.radius - state.cut.cone(hole.diameter))
            : hole.depth;
    for (double depth = hole.depth; depth <= maximum + 1e-9; depth += state.limits.depth_step) {
        depths.push_back(depth);
        minimum = std::min(minimum, min_left(state, depths));
        depths.pop_back();
    }
    return minimum;
}

Json front_of(const Json& input) {
    return at(solved(input), "/correction/planes/0");
}

TEST(Deepening, RemovesTheDifferenceAndNoDepthsLeaveLess) {
    std::mt19937 generator(11);
    int deepened = 0;
    for (int i = 0; i < 200; ++i) {
        const State state = random_state(generator);
        const HolePlan plan =
            plan_deepening(state.unbalance, state.holes, state.cut, state.limits, -1.0, INFINITY);
        std::vector<double> depths;
        for (const Hole& hole : state.holes) {
            depths.push_back(hole.depth);
        }
        double steps = 1e-9;
        for (const Hole& hole : plan.holes) {
            ++deepened;
            depths[hole.deepens->hole] = hole.depth;
            EXPECT_GT(hole.depth, hole.from_depth);
            EXPECT_LE(hole.depth, state.limits.maximum_depth + 1e-12);
            EXPECT_NEAR(hole.unbalance,
                        removed_between(state.cut, hole.diameter, hole.from_depth, hole.depth),
                        1e-6 * hole.unbalance);
            steps += state.cut.removed(hole.diameter, hole.depth).unbalance -
                     state.cut.removed(hole.diameter, hole.depth - 1e-3).unbalance;
        }
        EXPECT_TRUE(keeps_walls(state, depths)) << i;
        std::vector<double> tried;
        const double minimum = min_left(state, tried);
        const double left = left_by(state, depths);
        // What is enough is within the steps; what is not is the smallest.
        EXPECT_LE(left,
                  plan.shortfall == Shortfall::none ? std::max(steps, minimum) : minimum + 1e-9)
            << i;
        EXPECT_LE(left, std::abs(state.unbalance)) << i;
    }
    EXPECT_GT(deepened, 100);
}

TEST(Deepening, TakesOneHoleWhereThatIsEnough) {
    State state;
    state.unbalance = std::polar(600e-6, 0.02);
    for (const double angle : {0.0, 0.6, -0.6}) {
        state.holes.push_back({0.014, 0.008, angle, 0.0, 0.0});
    }
    const HolePlan plan =
        plan_deepening(state.unbalance, state.holes, state.cut, state.limits, 50e-6, 50e-6);
    ASSERT_EQ(plan.holes.size(), 1U);
    EXPECT_EQ(plan.shortfall, Shortfall::none);
    EXPECT_EQ(plan.holes[0].angle, 0.0);
    // A hole a quarter turn away is none that helps.
    state.holes = {{0.014, 0.008, 0.5 * pi, 0.0, 0.0}};
    EXPECT_TRUE(plan_deepening(state.unbalance, state.holes, state.cut, state.limits, 50e-6, 50e-6)
                    .holes.empty());
}

/// A second run whose heavy spot is at the hole that was drilled after the first.
Json second_run() {
    Json input = card();
    Json& correction = input["correction"];
    correction["readings"] = parse_json(R"([{"unbalance_g_mm": 450, "angle_deg": 40},
                                            {"unbalance_g_mm": 10, "angle_deg": 90}])");
    correction["earlier_runs"] = parse_json(R"([{
        "readings": [{"unbalance_g_mm": 2000, "angle_deg": 40},
                     {"unbalance_g_mm": 10, "angle_deg": 90}],
        "drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 10, "angle_deg": 40}]}])");
    return input;
}

TEST(Plan, DeepensTheHoleThatIsThere) {
    const Json plane = front_of(second_run());
    ASSERT_EQ(plane.at("holes").size(), 1U) << plane.dump(1);
    const Json& hole = plane.at("holes")[0];
    EXPECT_EQ(hole.at("deepens"), "/correction/earlier_runs/0/drilled/0");
    EXPECT_EQ(hole.at("from_depth_mm"), 10);
    EXPECT_GT(number(hole, "/depth_mm"), 10.0);
    EXPECT_NEAR(number(hole, "/removed_g_mm"),
                1e6 * removed_between({0.085, density, 118 * degree}, 0.016, 0.010,
                                      1e-3 * number(hole, "/depth_mm")),
                1e-3);
    EXPECT_NEAR(number(plane, "/remaining_g_mm"), std::abs(450.0 - number(hole, "/removed_g_mm")),
                1e-6);
    // Once it is recorded as deepened it is one hole, to be deepened further.
    Json third = second_run();
    Json& runs = third["correction"]["earlier_runs"];
    runs.push_back({{"readings", third["correction"]["readings"]},
                    {"drilled",
                     {{{"plane", "front"},
                       {"diameter_mm", 16},
                       {"angle_deg", 40},
                       {"depth_mm", hole.at("depth_mm")},
                       {"from_depth_mm", 10}}}}});
    third["tolerance"] = {{"g_mm", 50}};
    // The second reading fits the third: what the deepening took off is gone.
    runs[1]["readings"][0]["unbalance_g_mm"] = 450.0 + number(hole, "/removed_g_mm");
    const Json again = solved(third);
    EXPECT_TRUE(again.at("doubtful").is_null()) << again.at("doubts").dump(1);
    const Json& recorded = at(again, "/correction/runs/1/planes/0/drilled_holes/0");
    EXPECT_NEAR(number(recorded, "/removed_g_mm"), number(hole, "/removed_g_mm"), 1e-6);
    EXPECT_EQ(recorded.at("from_depth_mm"), 10);
    EXPECT_TRUE(recorded.at("deepens").is_null());
    const Json& holes = at(again, "/correction/planes/0/holes");
    ASSERT_EQ(holes.size(), 1U) << holes.dump(1);
    EXPECT_EQ(holes[0].at("deepens"), "/correction/earlier_runs/1/drilled/0");
    EXPECT_EQ(holes[0].at("from_depth_mm"), hole.at("depth_mm"));
}

TEST(Plan, DeepensNoHoleWithoutItsDrill) {
    Json input = second_run();
    input["correction"]["drill"]["diameters_mm"] = {8, 10};
    const Json plane = front_of(input);
    ASSERT_FALSE(plane.at("holes").empty()) << plane.dump(1);
    for (const Json& hole : plane.at("holes")) {
        EXPECT_TRUE(hole.at("deepens").is_null());
        EXPECT_LE(number(hole, "/diameter_mm"), 10);
        // Beside the one that is there, by its drill and the wall.
        EXPECT_GT(std::abs(number(hole, "/angle_deg") - 40), 10);
    }
}

TEST(Plan, KeepsToTheSmallestDepthAndAims) {
    Json input = card();
    input["tolerance"] = {{"g_mm", 100}};
    Json& correction = input["correction"];
    const auto depths = [&] {
        std::vector<double> list;
        const Json plane = front_of(input);
        for (const Json& hole : plane.at("holes")) {
            list.push_back(hole.at("depth_mm"));
        }
        return list;
    };
    std::mt19937 generator(3);
    for (int i = 0; i < 150; ++i) {
        const double steps[] = {0.1, 0.5, 1.0};
        correction["drill"]["depth_step_mm"] = steps[i % 3];
        correction["readings"][0]["unbalance_g_mm"] =
            std::uniform_real_distribution<double>(101, 4000)(generator);
        for (const double depth : depths()) {
            EXPECT_GE(depth, 1.5 - 1e-9);
        }
        const double zero = front_of(input).at("remaining_g_mm");
        correction["aim"] = "tolerance";
        EXPECT_LE(zero, number(front_of(input), "/remaining_g_mm") + 1e-6);
        correction.erase("aim");
    }
    // Within the limit nothing is drilled, whatever the aim.
    correction["readings"][0]["unbalance_g_mm"] = 99;
    EXPECT_TRUE(depths().empty());
    correction["readings"][0]["unbalance_g_mm"] = 130;
    correction["smallest_depth_mm"] = 5;
    for (const double depth : depths()) {
        EXPECT_GE(depth, 5.0 - 1e-9);
    }
}

/// Every plan that leaves more than the limit says why.
void expect_within_or_reason(const Json& plane, double limit, const std::string& of) {
    if (number(plane, "/remaining_g_mm") > limit) {
        EXPECT_FALSE(plane.at("feasible").get<bool>()) << of << plane.dump(1);
        EXPECT_TRUE(plane.contains("reason")) << of << plane.dump(1);
    }
}

TEST(Plan, LooksFurtherWhereTheStepOfTheDepthsLeavesMoreThanTheLimit) {
    Json input = card();
    input["tolerance"] = {{"g_mm", 20}};
    Json& correction = input["correction"];
    correction["drill"]["depth_step_mm"] = 1;
    correction["readings"][0]["unbalance_g_mm"] = 1005;
    // A hole of 16 mm is nearest by its steps and leaves 31.7; one of 10 mm leaves 1.4.
    const Json plane = front_of(input);
    ASSERT_EQ(plane.at("holes").size(), 1U);
    EXPECT_EQ(at(plane, "/holes/0/diameter_mm"), 10);
    EXPECT_NEAR(number(plane, "/remaining_g_mm"), 1.376, 1e-3);
    EXPECT_TRUE(plane.at("within_tolerance").get<bool>());
    // A deepening alone leaves 49.2.
    correction["earlier_runs"] = second_run().at("correction").at("earlier_runs");
    correction["earlier_runs"][0].erase("readings");
    correction["readings"][0]["unbalance_g_mm"] = 500;
    for (const char* aim : {"zero", "tolerance"}) {
        correction["aim"] = aim;
        const Json deepened = front_of(input);
        EXPECT_LE(number(deepened, "/remaining_g_mm"), 20.0) << deepened.dump(1);
    }
    std::mt19937 generator(5);
    for (int i = 0; i < 200; ++i) {
        const double unbalance = std::uniform_real_distribution<double>(21, 3000)(generator);
        const double step = std::uniform_real_distribution<double>(0.2, 3)(generator);
        correction["readings"][0]["unbalance_g_mm"] = unbalance;
        correction["drill"]["depth_step_mm"] = step;
        for (const char* aim : {"zero", "tolerance"}) {
            correction["aim"] = aim;
            expect_within_or_reason(front_of(input), 20.0,
                                    std::string(aim) + " " + std::to_string(step));
        }
    }
}

TEST(Plan, PutsNoHoleFartherFromTheHeavySpotThanTheLimit) {
    // Older holes push the new ones aside: the limit is not about the middle of those.
    Json input = card();
    input["tolerance"] = {{"g_mm", 0}};
    Json& correction = input["correction"];
    correction["planes"][1] = {{"position_mm", 480}, {"radius_mm", 65}};
    correction["drill"] = {{"diameters_mm", {8, 12}},
                           {"maximum_depth_mm", 15},
                           {"maximum_holes", 5},
                           {"maximum_angle_deg", 60}};
    Json& reading = correction["readings"][1];
    correction["earlier_runs"] = parse_json(R"([{"drilled": [
        {"plane": "rear", "diameter_mm": 12, "depth_mm": 15, "angle_deg": 11.1},
        {"plane": "rear", "diameter_mm": 12, "depth_mm": 15, "angle_deg": 207.0},
        {"plane": "rear", "diameter_mm": 12, "depth_mm": 15, "angle_deg": 223.0},
        {"plane": "rear", "diameter_mm": 10, "depth_mm": 15, "angle_deg": 238.9}]}])");
    const auto holes = [&] {
        const Json plane = at(solved(input), "/correction/planes/1");
        EXPECT_LE(number(plane, "/remaining_g_mm"), number(reading, "/unbalance_g_mm"));
        for (const Json& hole : plane.at("holes")) {
            const double apart =
                std::remainder(number(hole, "/angle_deg") - number(reading, "/angle_deg"), 360.0);
            const double most = number(correction, "/drill/maximum_angle_deg");
            EXPECT_LE(std::abs(apart), most + 1e-9) << input.dump() << plane.dump(1);
        }
        return plane.at("holes").size();
    };
    reading = {{"unbalance_g_mm", 1459.7}, {"angle_deg", 197.1}};
    EXPECT_GT(holes(), 0U);
    std::mt19937 generator(3);
    const auto any = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator);
    };
    std::size_t drilled = 0;
    for (int i = 0; i < 200; ++i) {
        reading = {{"unbalance_g_mm", any(50, 3000)}, {"angle_deg", any(90, 270)}};
        correction["drill"]["maximum_angle_deg"] = any(10, 85);
        for (Json& hole : correction["earlier_runs"][0]["drilled"]) {
            hole["angle_deg"] = number(reading, "/angle_deg") + any(-90, 90);
            hole["depth_mm"] = any(5, 15);
        }
        drilled += holes();
    }
    EXPECT_GT(drilled, 300U);
}

TEST(Plan, CountsWhatWasReallyDrilled) {
    Json input = second_run();
    Json& hole = input["correction"]["earlier_runs"][0]["drilled"][0];
    const auto drilled = [&] {
        return at(solved(input), "/correction/runs/0/planes/0/drilled_holes");
    };
    const double planned = number(drilled(), "/0/removed_g");
    EXPECT_NEAR(planned, 1e3 * Cut({0.085, density, 118 * degree}).removed(0.016, 0.010).mass,
                1e-9);
    // As planned its mass is the one planned; measured it is that of its sizes.
    hole["removed_g"] = 12;
    EXPECT_NEAR(number(drilled(), "/0/removed_g"), 12, 1e-12);
    hole["state"] = "measured";
    EXPECT_NEAR(number(drilled(), "/0/removed_g"), planned, 1e-9);
    hole["state"] = "wrong-side";
    EXPECT_NEAR(number(drilled(), "/0/angle_deg"), 220, 1e-9);
    hole["state"] = "not-drilled";
    EXPECT_TRUE(drilled().empty());
    hole.erase("removed_g");
    // Holes that were there before the first run have no readings, and new ones keep clear of them.
    hole["state"] = "as-planned";
    input["correction"]["earlier_runs"][0].erase("readings");
    const Json correction = solved(input).at("correction");
    EXPECT_TRUE(correction.at("runs")[0].at("within_tolerance").is_null());
    EXPECT_EQ(at(correction, "/planes/0/holes/0/deepens"), "/correction/earlier_runs/0/drilled/0");
}

/// A third run, after one that was to deepen the hole of the first from 10 to 13 mm.
Json third_run() {
    Json input = second_run();
    Json& runs = input["correction"]["earlier_runs"];
    runs.push_back(runs[0]);
    runs[1]["drilled"][0].update({{"depth_mm", 13}, {"from_depth_mm", 10}});
    for (Json& run : runs) {
        run.erase("readings");
    }
    return input;
}

TEST(Plan, CountsADeepeningWhereItWasDrilled) {
    Json input = third_run();
    Json& deepening = input["correction"]["earlier_runs"][1]["drilled"][0];
    const Cut cut{0.085, density, 118 * degree};
    const double whole = 1e6 * cut.removed(0.016, 0.013).unbalance;
    const double difference = whole - 1e6 * cut.removed(0.016, 0.010).unbalance;
    const auto expect = [&](double angle, double from_depth, double removed, std::size_t there) {
        const Json correction = solved(input).at("correction");
        const Json& holes = at(correction, "/runs/1/planes/0/drilled_holes");
        ASSERT_EQ(holes.size(), 1U);
        EXPECT_NEAR(number(holes, "/0/angle_deg"), angle, 1e-9);
        EXPECT_EQ(holes[0].at("from_depth_mm"), from_depth > 0.0 ? Json(from_depth) : Json());
        EXPECT_NEAR(number(holes, "/0/removed_g_mm"), removed, 1e-6);
        EXPECT_EQ(at(correction, "/planes/0/holes/0/deepens"),
                  "/correction/earlier_runs/" + std::to_string(there) + "/drilled/0");
    };
    expect(40, 10, difference, 1);
    // The hole that is deepened was found to be deeper than planned.
    Json& deepened = input["correction"]["earlier_runs"][0]["drilled"][0];
    deepened["depth_mm"] = 11;
    expect(40, 11, whole - 1e6 * cut.removed(0.016, 0.011).unbalance, 1);
    deepened["depth_mm"] = 10;
    // An angle that was measured is not quite the one planned.
    deepening["state"] = "measured";
    deepening["angle_deg"] = 40.04;
    expect(40.04, 10, difference, 1);
    // Where no hole was all of it is gone, whatever was planned, and the first is as deep as it
    // was.
    deepening["removed_g"] = 5;
    deepening["angle_deg"] = 62;
    expect(62, 0, whole, 0);
    deepening["state"] = "wrong-side";
    deepening["angle_deg"] = 40;
    expect(220, 0, whole, 0);
    // So it is in the other plane, where no hole was.
    deepening.update({{"state", "measured"}, {"plane", "rear"}});
    const Json other = at(solved(input), "/correction/runs/1/planes/1");
    const Cut there{input["correction"]["planes"][1]["radius_mm"].get<double>() * 1e-3, density,
                    118 * degree};
    EXPECT_NEAR(number(other, "/drilled_holes/0/removed_g_mm"),
                1e6 * there.removed(0.016, 0.013).unbalance, 1e-6);
    deepening["plane"] = "front";
    // A hole that no record tells of was there all the same.
    deepening["state"] = "measured";
    input["correction"]["earlier_runs"][0]["drilled"] = Json::array();
    expect(40, 10, difference, 1);
}

TEST(Plan, CountsTheSlugThatIsThere) {
    Json input = third_run();
    input["correction"]["earlier_runs"].erase(1);
    Json& slug = input["correction"]["earlier_runs"][0]["drilled"][0];
    slug = {{"plane", "front"}, {"diameter_mm", 20}, {"depth_mm", 20},      {"angle_deg", 220},
            {"slug_g", 110},    {"removed_g", -70},  {"direction", "axial"}};
    const auto pressed = [&] {
        return at(solved(input), "/correction/runs/0/planes/0/drilled_slugs");
    };
    EXPECT_NEAR(number(pressed(), "/0/added_g"), 70, 1e-9);
    EXPECT_GT(number(pressed(), "/0/centrifugal_force_N"), 0.0);
    slug["state"] = "wrong-side";
    EXPECT_NEAR(number(pressed(), "/0/angle_deg"), 40, 1e-9);
    EXPECT_NEAR(number(pressed(), "/0/added_g"), 70, 1e-9);
    slug["state"] = "measured";
    slug["depth_mm"] = 18;
    EXPECT_NEAR(number(pressed(), "/0/added_g"),
                110 - 1e3 * Cut({0.085, density, 118 * degree}).removed(0.020, 0.018).mass, 1e-9);
    slug["state"] = "not-drilled";
    EXPECT_TRUE(pressed().empty());
    // A slug that was not weighed has no force that is known.
    slug["state"] = "as-planned";
    slug.erase("slug_g");
    EXPECT_NEAR(number(pressed(), "/0/added_g"), 70, 1e-9);
    EXPECT_TRUE(pressed()[0].at("centrifugal_force_N").is_null());
}

TEST(Plan, JudgesAHoleThatIsTriedByItsOwnRules) {
    using bob_weights::NoRoom;
    Json input = card();
    input["correction"]["earlier_runs"] = parse_json(R"([{"drilled": [
        {"plane": "front", "diameter_mm": 16, "depth_mm": 28, "angle_deg": 100},
        {"plane": "front", "diameter_mm": 20, "depth_mm": 20, "angle_deg": 220,
         "slug_g": 110, "removed_g": -70, "direction": "axial"}]}])");
    const Input job = read_input(input);
    const Result result = solve(job);
    const auto room = [&](double diameter, double depth, double angle) {
        return what_if(job, result.shaft, bob_weights::PlaneName::front, diameter, depth, angle)
            ->room;
    };
    const auto missing = [&](double angle_deg, double depth_mm) {
        return room(0.016, 1e-3 * depth_mm, angle_deg * degree).missing;
    };
    // Apart at the rim, deep holes meet further in.
    EXPECT_EQ(missing(117, 5), NoRoom::none);
    EXPECT_EQ(missing(117, 28), NoRoom::beside_hole);
    EXPECT_EQ(missing(220, 5), NoRoom::beside_hole) << "a slug is there";
    EXPECT_EQ(missing(359.5, 5), NoRoom::in_sector);
    EXPECT_EQ(missing(300, 30.1), NoRoom::too_deep);
    EXPECT_NEAR(room(0.016, 0.005, 5.0).maximum_depth, 0.03, 1e-15);
    for (const Hole& hole : result.shaft.correction->at(0).holes) {
        EXPECT_EQ(room(hole.diameter, hole.depth, hole.angle).missing, NoRoom::none);
    }
    // One that is there may be deepened, by another drill not.
    EXPECT_EQ(missing(101, 29), NoRoom::none);
    EXPECT_EQ(room(0.016, 0.029, 101 * degree).from_depth, 0.028);
    EXPECT_NEAR(room(0.016, 0.029, 101 * degree).angle, 100 * degree, 1e-12) << "of the hole there";
    EXPECT_EQ(missing(104, 29), NoRoom::beside_hole) << "5.9 mm away";
    EXPECT_EQ(missing(100, 28), NoRoom::beside_hole);
    EXPECT_EQ(room(0.010, 0.029, 100 * degree).missing, NoRoom::beside_hole);
    const auto left = [&](double angle) {
        const auto tried =
            what_if(job, result.shaft, bob_weights::PlaneName::front, 0.016, 0.03, angle);
        return std::polar(tried->unbalance, tried->angle);
    };
    const Cut cut{0.085, job.correction->drill.density, job.correction->drill.point_angle};
    EXPECT_NEAR(std::abs(left(300 * degree) - left(100 * degree) +
                         std::polar(cut.removed(0.016, 0.03).unbalance, 300 * degree) -
                         std::polar(cut.removed(0.016, 0.03).unbalance -
                                        cut.removed(0.016, 0.028).unbalance,
                                    100 * degree)),
                0.0, 1e-12);
}

TEST(Plan, CountsAHoleThatWasDeepenedAfterOneRunOnce) {
    Json input = card();
    input["correction"]["earlier_runs"] = parse_json(R"([
        {"drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 9, "angle_deg": 300}]},
        {"drilled": [
            {"plane": "front", "diameter_mm": 16, "depth_mm": 9, "angle_deg": 40},
            {"plane": "front", "diameter_mm": 16, "depth_mm": 12, "from_depth_mm": 9,
             "angle_deg": 40, "state": "measured"}]}])");
    const Json holes = at(solved(input), "/correction/runs/1/planes/0/drilled_holes");
    const Cut cut{0.085, bob_weights::Drill().density, bob_weights::Drill().point_angle};
    EXPECT_NEAR(number(holes, "/1/removed_g"),
                1e3 * (cut.removed(0.016, 0.012).mass - cut.removed(0.016, 0.009).mass), 1e-9);
}

TEST(Plan, PutsHolesAtTheHeavySpotWhateverTheMachineShows) {
    Json input = card();
    Json& correction = input["correction"];
    correction["earlier_runs"] = parse_json(R"([{
        "readings": [{"unbalance_g_mm": 3900, "angle_deg": 40},
                     {"unbalance_g_mm": 1200, "angle_deg": 290}],
        "drilled": [{"plane": "front", "diameter_mm": 16, "depth_mm": 10, "angle_deg": 40}]}])");
    const Json heavy = solved(input).at("correction");
    EXPECT_FALSE(heavy.at("planes")[0].at("holes").empty());
    for (Json* readings : {&correction["readings"], &correction["earlier_runs"][0]["readings"]}) {
        for (Json& reading : *readings) {
            reading["angle_deg"] = reading["angle_deg"].get<double>() - 180.0;
        }
    }
    input["machine"]["shows"] = "light";
    EXPECT_EQ(test::difference(heavy, solved(input).at("correction")), "");
}

TEST(Plan, PressesNothingIntoAPlaneThatHolesBringWithinItsLimit) {
    Json input = card();
    input["tolerance"] = {{"g_mm", 200}};
    Json& correction = input["correction"];
    correction["readings"][0]["unbalance_g_mm"] = 500;
    // Holes at the edge of the sector leave 500 sin 10° and more, opposite of which a slug may lie.
    correction["planes"][0].update({{"from_deg", 50}, {"to_deg", 200}});
    correction["slug"] = {{"diameter_mm", 10}, {"density_kg_m3", 18'000}};
    for (const char* aim : {"zero", "tolerance"}) {
        correction["aim"] = aim;
        const Json plane = front_of(input);
        EXPECT_TRUE(plane.at("within_tolerance").get<bool>()) << plane.dump(1);
        EXPECT_FALSE(plane.at("holes").empty()) << plane.dump(1);
        EXPECT_TRUE(plane.at("slugs").empty()) << plane.dump(1);
    }
}

TEST(Plan, SaysHowFarADeepenedHoleReachesBeyondTheSector) {
    Json input = test::doubted().at("beyond-sector")();
    const Json plane = front_of(input);
    ASSERT_EQ(plane.at("holes").size(), 1U) << plane.dump(1);
    EXPECT_EQ(at(plane, "/holes/0/from_depth_mm"), 9);
    EXPECT_NEAR(number(plane, "/edge_beyond_sector_mm"), 8, 1e-9);
    input["correction"]["planes"][0]["from_deg"] = 20;
    EXPECT_FALSE(front_of(input).contains("edge_beyond_sector_mm"));
}

TEST(Plan, PressesSlugsInParallelToTheCrankshaft) {
    Json input = card();
    input["tolerance"]["grade_mm_s"] = 6.3;
    Json& correction = input["correction"];
    correction["readings"][0]["unbalance_g_mm"] = 30'000;
    correction["planes"][0] = {{"position_mm", 60}, {"radius_mm", 85}};
    correction["slug"] = {{"diameter_mm", 20}, {"density_kg_m3", 18'000}};
    const auto slug = [&] {
        const Json slugs = front_of(input).at("slugs");
        EXPECT_FALSE(slugs.empty());
        return slugs.at(0);
    };
    const Json axial = slug();
    EXPECT_EQ(axial.at("direction"), "axial");
    EXPECT_NEAR(number(axial, "/angle_deg"), 220, 70);
    // Its middle lies the wall and half its diameter below the rim; what is under it stays empty.
    const double area = 0.25 * pi * 20 * 20;
    const double depth = axial.at("depth_mm");
    const double radius = 85.0 - 3.0 - 10.0;
    const double cone = area * 10.0 / std::tan(59 * degree) / 3.0;
    EXPECT_NEAR(number(axial, "/slug_g"), 18e-3 * area * depth, 1e-6);
    EXPECT_NEAR(number(axial, "/added_g_mm"),
                radius * (18e-3 * area * depth - 7.85e-3 * (area * depth + cone)), 1e-3);
    EXPECT_NEAR(number(axial, "/radius_mm"), radius, 1e-9);
    const double speed = 5500 * 2.0 * pi / 60.0;
    EXPECT_NEAR(number(axial, "/centrifugal_force_N"),
                1e-6 * number(axial, "/slug_g") * radius * speed * speed, 1e-6);
    correction["slug"]["direction"] = "radial";
    const Json radial = slug();
    EXPECT_EQ(radial.at("direction"), "radial");
    EXPECT_NEAR(number(radial, "/centrifugal_force_N"),
                1e-6 * number(radial, "/slug_g") * (85.0 - 0.5 * number(radial, "/depth_mm")) *
                    speed * speed,
                1e-6);
    input["tolerance"] = {{"g_mm", 200}};
    EXPECT_TRUE(slug().at("centrifugal_force_N").is_null());
}

}  // namespace
}  // namespace ravnoves::workshop

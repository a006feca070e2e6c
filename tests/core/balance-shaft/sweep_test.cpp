// Many angles at once, the extrema of splines, and the processor's vector units: other ways to the
// same numbers.

#include <gtest/gtest.h>

#include <random>

#include "balance-shaft/moment_plane.h"
#include "balance-shaft/rod_sweep.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "numerics/vector_lanes.h"
#include "scenes/scenes.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

std::vector<Input> engines() {
    std::vector<Input> inputs{preset_tmz_650d(), test::diesel(), test::two_stroke()};
    for (const std::size_t rows : {3, 5, 12, 49, 200, 2600}) {
        inputs.push_back(preset_tmz_650d());
        inputs.back().torque.table = test::random_table(static_cast<unsigned>(rows), rows);
    }
    const std::size_t count = inputs.size();
    for (std::size_t i = 0; i < count; ++i) {
        inputs.push_back(inputs[i]);
        inputs.back().interpolation = Interpolation::periodic_cubic;
    }
    return inputs;
}

std::vector<double> some_angles(int count, double from, double to) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> angle(from, to);
    std::vector<double> angles;
    for (int i = 0; i < count; ++i) {
        angles.push_back(angle(generator));
    }
    return angles;
}

TEST(BalanceShaftSweep, ManyAnglesAtOnceHaveTheDigitsOfEach) {
    std::vector<double> degrees;
    for (int i = 0; i <= 360; ++i) {
        degrees.push_back(i * degree);
    }
    for (const Input& input : engines()) {
        const Solver solver(input);
        for (const auto& alpha :
             {degrees, some_angles(60, -10.0, 10.0), std::vector<double>{1.0}, {}}) {
            std::vector<double> range(alpha.size());
            std::vector<double> rms(alpha.size());
            solver.sweep(alpha, range, rms);
            for (std::size_t i = 0; i < alpha.size(); ++i) {
                EXPECT_EQ(range[i], solver.range(alpha[i])) << alpha[i];
                EXPECT_EQ(rms[i], solver.rms(alpha[i]));
            }
        }
    }
}

TEST(BalanceShaftSweep, ExtremaAreThoseOfThePlaneAndStandAtTheirAngles) {
    for (const Input& input : engines()) {
        const Solver solver(input);
        const PeriodicPiecewise& moment = solver.tipping_moment();
        const MomentPlane plane(moment);
        for (const double amplitude : {0.0, 1.0, 50.0, 430.0, 3000.0}) {
            const CycleExtrema extrema(moment, amplitude);
            for (const double alpha : some_angles(40, 0.0, two_pi)) {
                const double x = amplitude * std::sin(alpha);
                const double y = amplitude * std::cos(alpha);
                const auto found = extrema(alpha);
                const auto other = plane(x, y);
                const double rounding = 4e-14 * (1000.0 + amplitude);
                EXPECT_NEAR(found.max.value, other.max.value, rounding) << amplitude;
                EXPECT_NEAR(found.min.value, other.min.value, rounding) << amplitude;
                for (const Extremum& at : {found.max, found.min}) {
                    EXPECT_NEAR(
                        moment(at.angle_deg) + amplitude * std::sin(at.angle_deg * degree + alpha),
                        at.value, 10.0 * rounding);
                }
            }
        }
    }
}

/// Where stretches of knots are passed over, none that holds an extremum is.
TEST(BalanceShaftSweep, ThousandsOfRowsHaveTheExtremaOfAllTheirKnots) {
    TorqueTable even;
    constexpr int rows = 9000;
    for (int i = 0; i <= rows; ++i) {
        even.crank_angle_deg.push_back(720.0 * i / rows);
        even.torque.push_back(300.0 * std::cos(2.0 * two_pi * i / rows) + i % 7);
    }
    even.torque.back() = even.torque.front();
    TorqueTable uneven = test::random_table(3, 5000);
    for (std::size_t i = 1; i + 1 < uneven.size(); ++i) {
        // Nearly all of them within one turn, so that one stretch is wide.
        uneven.crank_angle_deg[i] = 0.01 * uneven.crank_angle_deg[i] + (i > 4900 ? 400.0 : 0.0);
    }
    for (const TorqueTable& table : {even, uneven}) {
        const auto moment = PeriodicPiecewise::linear(table.crank_angle_deg, table.torque);
        const MomentPlane plane(moment);
        for (const double amplitude : {0.0, 1.0, 300.0, 3000.0}) {
            const CycleExtrema extrema(moment, amplitude);
            for (const double alpha : some_angles(12, 0.0, two_pi)) {
                double highest = -1e9;
                double lowest = 1e9;
                for (std::size_t i = 0; i < table.size(); ++i) {
                    const double value =
                        table.torque[i] +
                        amplitude * std::sin(table.crank_angle_deg[i] * degree + alpha);
                    highest = std::max(highest, value);
                    lowest = std::min(lowest, value);
                }
                const Extrema found = extrema(alpha);
                const auto other = plane(amplitude * std::sin(alpha), amplitude * std::cos(alpha));
                const double rounding = 4e-14 * (1000.0 + amplitude);
                EXPECT_GE(found.max.value, highest - rounding);
                EXPECT_LE(found.min.value, lowest + rounding);
                EXPECT_NEAR(found.max.value, other.max.value, rounding);
                EXPECT_NEAR(found.min.value, other.min.value, rounding);
            }
        }
    }
}

TEST(BalanceShaftSweep, RodIsNearestWhereNoOtherPlaceOfItIsNearer) {
    const FrontView view = front_view(preset_tmz_650d());
    const RodSweep rods(view);
    const SliderCrank<double> crank = view.crank();
    const std::vector<double> place = some_angles(120, -0.3, 0.4);
    for (std::size_t k = 0; k + 1 < place.size(); k += 2) {
        const double x = place[k];
        const double y = place[k + 1];
        double least = 1.0;
        for (int i = 0; i < 40'000; ++i) {
            const double theta = two_pi * i / 40'000;
            const double from_x = crank.crank_radius * std::sin(theta);
            const double from_y = crank.crank_radius * std::cos(theta);
            const double along_x = crank.offset - from_x;
            const double along_y = crank.at(theta).s - from_y;
            const double t = std::clamp(((x - from_x) * along_x + (y - from_y) * along_y) /
                                            (crank.rod_length * crank.rod_length),
                                        0.0, 1.0);
            least = std::min(least, std::hypot(x - from_x - t * along_x, y - from_y - t * along_y));
        }
        const RodSweep::Nearest found = rods.nearest(x, y);
        EXPECT_LE(found.distance, least + 1e-15);
        EXPECT_NEAR(found.distance, least, least > 1e-4 ? 1e-8 : 1e-5) << x << ' ' << y;
        EXPECT_NEAR(std::hypot(x - found.x, y - found.y), found.distance, 1e-12);
        EXPECT_TRUE(rods.is_clear(x, y, found.distance));
        EXPECT_FALSE(rods.nearer_than(x, y, found.distance));
        EXPECT_EQ(rods.nearer_than(x, y, found.distance * 1.01 + 1e-12)->distance, found.distance);
    }
}

/// With vector units and without: on any processor a user sees the same digits.
TEST(VectorUnits, ChangeNoDigitOfAResult) {
    Json json = Json::parse(read_text_file(std::string(RAVNOVES_EXAMPLES) + "/tmz-650d.case.json"));
    for (const char* interpolation : {"linear", "periodic-cubic"}) {
        json["input"]["interpolation"] = interpolation;
        const CaseFile file = read_case(json);
        const std::string with = solve_case(file, {}).dump();
        want_avx2(false);
        EXPECT_FALSE(has_avx2());
        EXPECT_EQ(solve_case(file, {}).dump(), with);
        want_avx2(true);
    }
    EXPECT_EQ(has_avx2(), processor_has_avx2());
}

}  // namespace
}  // namespace ravnoves::balance_shaft

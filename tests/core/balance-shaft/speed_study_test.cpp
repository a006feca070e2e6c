#include "balance-shaft/speed_study.h"
#include "balance-shaft/position_study.h"

#include <gtest/gtest.h>

#include <cmath>

#include "balance-shaft/angle_search.h"
#include "balance-shaft/input.h"
#include "balance-shaft/presets.h"
#include "case-file/json.h"

#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::diesel;
using test::written;
using Criterion = SpeedStudy::Criterion;
using Measure = SpeedStudy::Measure;

SpeedBand band(double from_rpm, double to_rpm, int speeds) {
    return {from_rpm * units::rpm, to_rpm * units::rpm, speeds, false};
}

TEST(SpeedStudy, EverySpeedIsTheEngineSolvedAtThatSpeed) {
    std::vector<Input> engines{diesel(), diesel(), diesel(), test::two_stroke()};
    engines[1].interpolation = Interpolation::periodic_cubic;
    engines[2].cylinder.offset = 8e-3;
    for (Input& input : engines) {
        const SpeedStudy study(input, band(1500, 4000, 5));
        ASSERT_TRUE(study.is_complete());
        EXPECT_TRUE(study.reason().empty());
        const auto map = study.map(24);
        ASSERT_TRUE(map);
        for (std::size_t k = 0; k < 5; ++k) {
            const SpeedStudy::Point& point = study.points()[k];
            EXPECT_NEAR(point.angular_speed / units::rpm, 1500.0 + 625.0 * static_cast<double>(k),
                        1e-9);
            input.angular_speed = point.angular_speed;
            const Solver solver(input);
            const Result result = solver.result();
            const double size = result.M_up.range;
            EXPECT_NEAR(point.range_without, result.M_up.range, 1e-11 * size);
            EXPECT_NEAR(point.rms_without, result.M_up.rms, 1e-11 * size);
            EXPECT_NEAR(point.best_range, result.best_range.value, 1e-11 * size);
            EXPECT_NEAR(point.best_range_angle, *result.best_range.shaft_angle, 1e-6);
            EXPECT_NEAR(*point.buildable_range_angle, *result.best_range_buildable.shaft_angle,
                        1e-6);
            EXPECT_NEAR(point.best_rms, result.best_rms.value, 1e-11 * size);
            EXPECT_NEAR(point.best_rms_angle, *result.best_rms.shaft_angle, 1e-9);
            EXPECT_NEAR(*point.buildable_rms_angle, *result.best_rms_buildable.shaft_angle, 1e-9);
            for (std::size_t i = 0; i < 24; ++i) {
                const double alpha = map->shaft_angle_deg[i] * degree;
                EXPECT_NEAR(map->range[k * 24 + i], solver.range(alpha), 1e-11 * size);
                EXPECT_NEAR(map->rms[k * 24 + i], solver.rms(alpha), 1e-11 * size);
            }
        }
    }
}

TEST(SpeedStudy, TheBestCompromiseAngleIsTheMinimaxOfADenseMap) {
    const Input input = diesel();
    const SpeedStudy study(input, band(1500, 4200, 12));
    ASSERT_FALSE(study.buildable().stretches.empty());
    constexpr std::size_t angles = 1800;
    const auto map = study.map(angles);
    for (const bool built : {false, true}) {
        const auto& within = built ? study.buildable().stretches : whole_turn();
        for (const auto& [criterion, measure] : {std::pair(Criterion::range, Measure::absolute),
                                                 std::pair(Criterion::range, Measure::relative),
                                                 std::pair(Criterion::rms, Measure::absolute),
                                                 std::pair(Criterion::rms, Measure::relative)}) {
            const bool by_range = criterion == Criterion::range;
            double minimum = 1e300;
            for (std::size_t i = 0; i < angles; ++i) {
                if (built && !study.buildable().contains(map->shaft_angle_deg[i] * degree)) {
                    continue;
                }
                double worst = 0.0;
                for (std::size_t k = 0; k < study.points().size(); ++k) {
                    const auto& point = study.points()[k];
                    const double value = (by_range ? map->range : map->rms)[k * angles + i];
                    const double without = by_range ? point.range_without : point.rms_without;
                    worst = std::max(worst, measure == Measure::absolute ? value : value / without);
                }
                minimum = std::min(minimum, worst);
            }
            const auto found = study.best_compromise_angle(criterion, measure, within);
            EXPECT_TRUE(!built || study.buildable().contains(found.shaft_angle));
            EXPECT_LE(found.value, minimum * (1.0 + 1e-9));
            EXPECT_GE(found.value, minimum * 0.99);
            EXPECT_LE(found.gap, 1e-9 * found.value);
            // The worst speed is one at which the value is reached.
            Input at_worst = input;
            at_worst.angular_speed = found.worst_speed;
            const Solver solver(at_worst);
            const double value =
                by_range ? solver.range(found.shaft_angle) : solver.rms(found.shaft_angle);
            const MomentMetrics& without = solver.result().M_up;
            EXPECT_NEAR(measure == Measure::absolute
                            ? value
                            : value / (by_range ? without.range : without.rms),
                        found.value, 1e-9 * found.value);
        }
    }
}

TEST(SpeedStudy, TheBestCompromiseAngleCoversTheBandAndNotOnlyItsPoints) {
    const Input input = diesel();
    // Few points: the worst speed of the relative measures may lie between them.
    const SpeedStudy coarse(input, band(1200, 4500, 2));
    const SpeedStudy fine(input, band(1200, 4500, 41));
    // A scan of the band, and a finer one about the worst of it.
    const auto worst_ratio = [&](Criterion criterion, double alpha) {
        double worst = 0.0;
        double worst_rpm = 0.0;
        const auto look = [&](double n) {
            if (n < 1200.0 || n > 4500.0) {
                return;
            }
            Input at = input;
            at.angular_speed = n * units::rpm;
            const Solver solver(at);
            const MomentMetrics& without = solver.result().M_up;
            const double value = criterion == Criterion::range ? solver.range(alpha) / without.range
                                                               : solver.rms(alpha) / without.rms;
            if (value > worst) {
                worst = value;
                worst_rpm = n;
            }
        };
        for (int k = 0; k <= 150; ++k) {
            look(1200.0 + 22.0 * k);
        }
        const double centre = worst_rpm;
        for (int k = -40; k <= 40; ++k) {
            look(centre + 0.55 * k);
        }
        return worst;
    };
    for (const Criterion criterion : {Criterion::range, Criterion::rms}) {
        for (const Measure measure : {Measure::absolute, Measure::relative}) {
            const auto found = coarse.best_compromise_angle(criterion, measure);
            EXPECT_LE(found.gap, 1e-9 * found.value);
            EXPECT_NEAR(fine.best_compromise_angle(criterion, measure).value, found.value,
                        1e-8 * found.value);
        }
    }
    for (const Criterion criterion : {Criterion::range, Criterion::rms}) {
        const auto found = coarse.best_compromise_angle(criterion, Measure::relative);
        const double brute = worst_ratio(criterion, found.shaft_angle);
        EXPECT_LE(brute, found.value * (1.0 + 1e-9));
        EXPECT_GE(brute, found.value * (1.0 - 1e-5));
    }
}

TEST(SpeedStudy, ABandOfOneSpeedHasThatSpeedsBestAngle) {
    Input input = diesel();
    input.angular_speed = 3000.0 * units::rpm;
    const SpeedStudy study(input, band(3000, 3000, 2));
    const Result result = solve(input);
    EXPECT_NEAR(study.best_compromise_angle(Criterion::range, Measure::absolute).value,
                result.best_range.value, 1e-9);
    EXPECT_NEAR(study.best_compromise_angle(Criterion::rms, Measure::relative).shaft_angle,
                *result.best_rms.shaft_angle, 1e-5);
}

TEST(AngleMinimum, OfEndsThatMirrorEachOtherTheFirstIsChosenWhateverRoundingSays) {
    const auto evaluate = [](double alpha) { return Cut{alpha, std::cos(alpha), {0.0, 1.0, 0.0}}; };
    for (int i = 1; i < 200; ++i) {
        const double end = 0.3 + 0.01 * i;
        const auto best =
            minimise_over_angle(evaluate, 1.0, {{0.1, end}, {two_pi - end, two_pi - 0.1}});
        EXPECT_NEAR(best.alpha, end, 1e-12);
    }
}

TEST(SpeedStudy, CanBeCancelledAndReportsItsProgress) {
    const Input input = diesel();
    int calls = 0;
    const SpeedStudy cancelled(input, band(1000, 4000, 10), [&](double) { return ++calls < 4; });
    EXPECT_FALSE(cancelled.is_complete());
    EXPECT_EQ(cancelled.points().size(), 3U);
    double last = -1.0;
    const auto rising = [&](double part) {
        EXPECT_GT(part, last);
        last = part;
        return true;
    };
    const SpeedStudy study(input, band(1000, 4000, 10), rising);
    EXPECT_EQ(last, 1.0);
    last = -1.0;
    EXPECT_TRUE(study.map(10, rising));
    EXPECT_EQ(last, 1.0);
    EXPECT_FALSE(study.map(10, [](double part) { return part < 0.5; }));
}

TEST(SpeedStudy, ATableIsTakenToOtherSpeedsOnlyWhereItBelongsToItsMasses) {
    const Input paper = preset_tmz_650d();
    const SpeedStudy rejected(paper, band(2000, 4000, 5));
    EXPECT_FALSE(rejected.is_complete());
    EXPECT_EQ(rejected.reason().english().rfind("The torque does not match masses and speed", 0),
              0U);
    Input with_band = paper;
    with_band.speed_band = band(2000, 4000, 5);
    EXPECT_EQ(written(with_band).at("speed_band").at("feasible"), false);

    Input slower = paper;
    slower.angular_speed = solve(paper).inertia_check.matching_speed;
    const SpeedStudy study(slower, {slower.angular_speed, 1.2 * slower.angular_speed, 3, false});
    ASSERT_TRUE(study.is_complete());
    const Result result = solve(slower);
    EXPECT_NEAR(study.points()[0].best_range, result.best_range.value, 1e-9);
    EXPECT_NEAR(study.points()[0].range_without, result.M_up.range, 1e-9);
    EXPECT_GT(study.points()[2].moment_amplitude, study.points()[0].moment_amplitude);
}

}  // namespace
}  // namespace ravnoves::balance_shaft

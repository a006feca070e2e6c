#include "shop/weighing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support.h"

namespace ravnoves::v8_plugs {
namespace {

using test::gram;

Input job(Process process) {
    Input input;
    input.process = process;
    input.engine.rod_coefficient = 0.4;
    input.tolerance = 40 * units::gram_mm;
    input.changes_from_weigh_in = true;
    input.weigh_in.emplace();
    for (PartColumn& column : input.weigh_in->columns) {
        column.nominal = 500 * gram;
        column.mass.assign(8, 501 * gram);
    }
    return input;
}

shop::Weighing weighing(const Input& input, double resolution) {
    return shop::weighing(resolution, rounding_squares(input), input.tolerance);
}

TEST(Weighing, OfEveryPartIsTheSquareRootOfItsSquares) {
    const double d = 0.1 * gram;
    // Repair: piston, pin, rings and small end count once, big end and shell twice. Without small
    // ends the big end stands for them: 2 + k.
    Input input = job(Process::repair);
    const auto expected = [&](double squares) {
        return 2.0 * d * std::sqrt((1.0 + squares / 8.0) / 12.0);
    };
    EXPECT_NEAR(weighing(input, d).bob_weight, expected(4.0 + 4.0 + 4.0), 1e-15);
    (*input.weigh_in)[Part::rod_small_end].mass.front().reset();
    EXPECT_NEAR(weighing(input, d).bob_weight, expected(3.0 + 2.4 * 2.4 + 4.0), 1e-15);

    Input nothing = job(Process::repair);
    nothing.weigh_in.reset();
    EXPECT_NEAR(weighing(nothing, d).bob_weight, 2.0 * d / std::sqrt(12.0), 1e-18);
}

// The readings themselves, rounded as a scale does it.
TEST(Weighing, IsWhatRoundedReadingsScatterBy) {
    test::Workshop random(7);
    for (const Process process : {Process::manufacture, Process::repair}) {
        Input input = job(process);
        const double d = 0.5 * gram;
        const double k = input.rod_coefficient().value();
        constexpr int runs = 4000;
        double squares = 0.0;
        for (int run = 0; run < runs; ++run) {
            WeighIn exact = *input.weigh_in;
            WeighIn read = exact;
            for (std::size_t part = 0; part < exact.columns.size(); ++part) {
                for (std::size_t i = 0; i < cylinder_count; ++i) {
                    const double mass = random.between(480, 520) * gram;
                    exact.columns[part].mass[i] = mass;
                    read.columns[part].mass[i] = d * std::round(mass / d);
                }
            }
            const auto excess = [&](const WeighIn& sheet) {
                return unbalanced_mass(mass_changes(sheet, process), k);
            };
            const double bob_weight = random.between(1900, 2100) * gram;
            const double hung = d * std::round(bob_weight / d) - bob_weight;
            squares += std::pow(excess(read) - excess(exact) + hung, 2);
        }
        const double u = 0.5 * weighing(input, d).bob_weight;
        // A variance of n samples is known to √(2/n) of itself.
        EXPECT_NEAR(squares / runs / (u * u), 1.0, 3.0 * std::sqrt(2.0 / runs));
    }
}

TEST(Weighing, NamesTheCoarsestScaleThatIsEnough) {
    test::Workshop random(11);
    for (int i = 0; i < 200; ++i) {
        Input input = job(random.process());
        const double radius = random.between(30, 100) * 1e-3;
        input.tolerance = random.between(1, 2000) * units::gram_mm;
        const double d = weighing(input, gram).coarsest(radius);
        EXPECT_TRUE(weighing(input, d).is_enough(radius));
        EXPECT_LE(weighing(input, d).bob_weight * radius, input.tolerance / 3.0 * (1.0 + 1e-9));
        EXPECT_FALSE(weighing(input, 2.5 * d).is_enough(radius));
        const double digits = std::log10(d / gram);
        const double lead = std::pow(10.0, digits - std::floor(digits + 1e-9));
        EXPECT_TRUE(std::abs(lead - 1.0) < 1e-6 || std::abs(lead - 2.0) < 1e-6 ||
                    std::abs(lead - 5.0) < 1e-6)
            << d;
    }
    // A step that is just enough is named as it is, not the next finer one.
    for (const double grams : {0.02, 0.05, 0.1, 0.2, 0.5, 2.0, 5.0}) {
        Input input = job(Process::repair);
        input.tolerance = 3.0 * weighing(input, grams * gram).bob_weight * 60e-3;
        EXPECT_NEAR(weighing(input, gram).coarsest(60e-3) / gram, grams, 1e-9 * grams);
    }
}

}  // namespace
}  // namespace ravnoves::v8_plugs

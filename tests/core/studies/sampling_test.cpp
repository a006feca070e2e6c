// Points and sums: what makes shards print the same digits.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "case-file/sha256.h"
#include "studies/sampler.h"
#include "studies/study.h"
#include "studies/tally.h"
#include "studies/taylor.h"

namespace ravnoves::studies {
namespace {

constexpr std::array sampled{Method::monte_carlo, Method::sobol};

TEST(Law, HasTheMomentsOfItsSamples) {
    constexpr int steps = 200'000;
    for (const Varied::Spread spread : {Varied::Spread::normal, Varied::Spread::plus_minus}) {
        const Law law = law_of({.pointer = "/x", .spread = spread, .size = 0.5}, 3.0);
        double mean = 0.0;
        for (int i = 0; i < steps; ++i) {
            mean += law.at((i + 0.5) / steps) / steps;
        }
        double squares = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double away = law.at((i + 0.5) / steps) - mean;
            squares += away * away / steps;
        }
        EXPECT_NEAR(mean, law.mean, 1e-9);
        EXPECT_NEAR(squares, law.deviation * law.deviation, 1e-4 * squares);
    }
}

TEST(CountingPlan, OneLimitOfAnAngleHoldsForTheHalfTurnFromThere) {
    const auto within = [](std::optional<double> min, std::optional<double> max, double value) {
        return CountingPlan{.period = 360.0, .min = min, .max = max}.within(value);
    };
    EXPECT_TRUE(within(60, {}, 60.1));
    EXPECT_FALSE(within(60, {}, 59.9));
    EXPECT_FALSE(within({}, 60, 67));
    EXPECT_TRUE(within({}, 60, 359));
    EXPECT_TRUE(within(350, {}, 3));
    EXPECT_FALSE(within(355, 363, 350));
    EXPECT_TRUE(within(355, 363, 2));
}

TEST(RandomBits, GivesThePublishedNumbers) {
    // The first known answer of philox4x32-10 in Random123.
    EXPECT_EQ(random_bits(0, 0, 0, 0), 0x6627e8d5e169c58dU);
    EXPECT_EQ(random_bits(0, 0, 0, 1), 0xbc57ac4c9b00dbd8U);
}

TEST(Sampler, GivesASampleTheSameWhereverItIsAskedFor) {
    for (const Method method : sampled) {
        constexpr std::uint64_t samples = 1000;
        Sampler running(method, 7, 5);
        Sampler jumping(method, 7, 5);
        std::array<double, 5> one{};
        std::array<double, 5> other{};
        for (std::uint64_t i = 0; i < samples; ++i) {
            running.point(i, one);
            for (const double u : one) {
                EXPECT_TRUE(u > 0.0 && u < 1.0);
            }
            if (i % 37 < 2) {
                jumping.point(samples - 1 - i, other);
                jumping.point(i, other);
                EXPECT_EQ(one, other) << i;
            }
        }
        Sampler seeded(method, 8, 5);
        seeded.point(samples - 1, other);
        EXPECT_NE(one, other);
    }
}

TEST(Sampler, SobolPointsOfAReplicateFillEveryElementaryBox) {
    // The first two coordinates are a (0, 8, 2)-net, scrambled or not.
    for (const std::uint64_t seed : {0U, 1U, 99U}) {
        for (int bits = 0; bits <= 8; ++bits) {
            Sampler sampler(Method::sobol, seed, 2);
            std::array<std::vector<int>, replicates> met;
            met.fill(std::vector<int>(256));
            std::array<double, 2> u{};
            for (std::uint64_t i = 0; i < 256 * replicates; ++i) {
                sampler.point(i, u);
                const auto x = static_cast<std::size_t>(u[0] * (1 << bits));
                const auto y = static_cast<std::size_t>(u[1] * (256 >> bits));
                ++met[i % replicates][x * static_cast<std::size_t>(256 >> bits) + y];
            }
            for (const auto& counts : met) {
                EXPECT_TRUE(std::all_of(counts.begin(), counts.end(), [](int n) { return n == 1; }))
                    << seed << ' ' << bits;
            }
        }
    }
}

/// Of a list with its next neighbours.
double neighbours_correlation(const std::vector<double>& list) {
    double mean = 0.0;
    for (const double each : list) {
        mean += each / static_cast<double>(list.size());
    }
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        squares += (list[i] - mean) * (list[i] - mean);
        products += i == 0 ? 0.0 : (list[i] - mean) * (list[i - 1] - mean);
    }
    return products / squares;
}

TEST(Sampler, NeighbouringSeedsAndReplicatesAreIndependent) {
    // Means of a smooth value and of a corner over few samples, which are the errors of a study.
    constexpr int seeds = 4096;
    constexpr std::uint64_t samples = 64;
    for (const Method method : sampled) {
        std::array<std::vector<double>, 2> by_seed;
        std::array<std::vector<double>, 2> by_replicate;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            Sampler sampler(method, seed, 3);
            std::array<double, 3> u{};
            std::array<std::array<double, replicates>, 2> sums{};
            for (std::uint64_t i = 0; i < samples; ++i) {
                sampler.point(i, u);
                sums[0][i % replicates] += u[0] + u[1] * u[2];
                sums[1][i % replicates] += std::max(u[0] + u[1] + u[2], 1.7);
            }
            for (std::size_t k = 0; k < 2; ++k) {
                by_seed[k].push_back(std::accumulate(sums[k].begin(), sums[k].end(), 0.0));
                by_replicate[k].insert(by_replicate[k].end(), sums[k].begin(), sums[k].end());
            }
        }
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_NEAR(neighbours_correlation(by_seed[k]), 0.0, 3.5 / std::sqrt(seeds));
            EXPECT_NEAR(neighbours_correlation(by_replicate[k]), 0.0,
                        3.5 / std::sqrt(seeds * replicates));
        }
    }
}

TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Difference, OfAnglesIsTheShorterWay) {
    EXPECT_EQ(difference(1.0, -1.0, 0.0), 2.0);
    EXPECT_EQ(difference(1.0, 359.0, 360.0), 2.0);
    EXPECT_EQ(difference(359.0, 1.0, 360.0), -2.0);
    EXPECT_EQ(difference(-179.0, 179.0, 360.0), 2.0);
    EXPECT_EQ(difference(-179.0, 179.0, 0.0), -358.0);
}

TEST(Tally, BarsHoldAllSamples) {
    // A seventh of the samples is one value, the smallest of all; a thousandth lies far off.
    const auto bars_of = [](double offset, double period) {
        Tally tally({{.low = offset - 2.0, .width = 0.0078125, .centre = offset, .period = period}},
                    1);
        Block block{.from = 0, .to = 7000, .sums = std::vector<Sums>(replicates)};
        const double u = 0.5;
        for (std::uint64_t i = 0; i < block.to; ++i) {
            const double y = offset + (i % 7 == 0      ? 0.003
                                       : i % 1000 == 1 ? 1000.0 * (period == 0.0 ? 1.0 : 0.1)
                                                       : 0.003 + static_cast<double>(i) / 7000.0);
            tally.add(block, i, std::span(&u, 1), std::span(&y, 1));
        }
        const auto percentiles = tally.statistics(0, std::span(&block, 1)).percentiles;
        return tally.histogram(0, percentiles.front(), percentiles.back(), 48);
    };
    for (const auto& bars :
         {bars_of(0.0, 0.0), bars_of(1.0, 360.0), bars_of(361.0, 360.0), bars_of(721.0, 360.0)}) {
        EXPECT_EQ(std::accumulate(bars.begin(), bars.end(), std::uint64_t{0}), 7000U);
        EXPECT_GE(bars.front(), 1000U);
        EXPECT_GE(std::count_if(bars.begin(), bars.end(), [](auto n) { return n > 0; }), 40);
    }
}

}  // namespace
}  // namespace ravnoves::studies

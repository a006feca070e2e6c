// Points and sums: what makes shards print the same digits.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "case-file/json.h"
#include "case-file/sha256.h"
#include "studies/exact_sum.h"
#include "studies/law.h"
#include "studies/sampler.h"
#include "studies/tally.h"

namespace ravnoves::studies {
namespace {

constexpr std::array sampled{Method::monte_carlo, Method::latin_hypercube, Method::sobol};

TEST(Law, HasTheMomentsOfItsSamples) {
    constexpr int steps = 200'000;
    for (const Varied::Spread spread : {Varied::Spread::normal, Varied::Spread::plus_minus}) {
        const Law law = law_of({.pointer = "/x", .spread = spread, .size = 0.5}, 3.0);
        double mean = 0.0;
        for (int i = 0; i < steps; ++i) {
            mean += law.at((i + 0.5) / steps) / steps;
        }
        double squares = 0.0;
        double fourths = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double away = law.at((i + 0.5) / steps) - mean;
            squares += away * away / steps;
            fourths += away * away * away * away / steps;
        }
        EXPECT_NEAR(mean, law.mean, 1e-9);
        EXPECT_NEAR(squares, law.deviation * law.deviation, 1e-4 * squares);
        EXPECT_NEAR(fourths, law.fourth_moment, 1e-3 * fourths);
    }
}

TEST(CounterRandom, GivesThePublishedNumbers) {
    // The first known answer of philox4x32-10 in Random123.
    const CounterRandom random(0);
    EXPECT_EQ(random.bits(0, 0, 0), 0x6627e8d5e169c58dU);
    EXPECT_EQ(random.bits(0, 0, 1), 0xbc57ac4c9b00dbd8U);
}

TEST(Sampler, GivesASampleTheSameWhereverItIsAskedFor) {
    for (const Method method : sampled) {
        constexpr std::uint64_t samples = 1000;
        Sampler running(method, samples, 7, 5);
        Sampler jumping(method, samples, 7, 5);
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
        Sampler seeded(method, samples, 8, 5);
        seeded.point(samples - 1, other);
        EXPECT_NE(one, other);
    }
}

TEST(Sampler, LatinHypercubeMeetsEveryStratumOnce) {
    for (const std::uint64_t samples : {1U, 2U, 3U, 37U, 1000U}) {
        Sampler sampler(Method::latin_hypercube, samples, 3, 2);
        std::array<std::vector<int>, 2> met{std::vector<int>(samples), std::vector<int>(samples)};
        std::array<double, 2> u{};
        for (std::uint64_t i = 0; i < samples; ++i) {
            sampler.point(i, u);
            for (std::size_t j = 0; j < 2; ++j) {
                ++met[j][static_cast<std::size_t>(u[j] * static_cast<double>(samples))];
            }
        }
        for (const auto& counts : met) {
            EXPECT_TRUE(std::all_of(counts.begin(), counts.end(), [](int n) { return n == 1; }));
        }
    }
}

TEST(Sampler, SobolPointsFillEveryElementaryBox) {
    // The first two coordinates are a (0, 8, 2)-net, scrambled or not.
    for (const std::uint64_t seed : {0U, 1U, 99U}) {
        for (int bits = 0; bits <= 8; ++bits) {
            Sampler sampler(Method::sobol, 256, seed, 2);
            std::vector<int> met(256);
            std::array<double, 2> u{};
            for (std::uint64_t i = 0; i < 256; ++i) {
                sampler.point(i, u);
                const auto x = static_cast<std::size_t>(u[0] * (1 << bits));
                const auto y = static_cast<std::size_t>(u[1] * (256 >> bits));
                ++met[x * static_cast<std::size_t>(256 >> bits) + y];
            }
            EXPECT_TRUE(std::all_of(met.begin(), met.end(), [](int n) { return n == 1; }))
                << seed << ' ' << bits;
        }
    }
}

TEST(ExactSum, IsExactInAnyOrderAndAnyShares) {
    std::vector<double> values{1e308, 1.0, -1e308, 0x1p-1074, 3e-300, -2.5, 1e308, -1e308, 1e16};
    std::vector<ExactSum> sums;
    for (int turn = 0; turn < 6; ++turn) {
        std::array<ExactSum, 2> shares;
        for (std::size_t i = 0; i < values.size(); ++i) {
            shares[(i * 7 + static_cast<std::size_t>(turn)) % 2].add(values[i]);
        }
        shares[0].add(shares[1]);
        sums.push_back(shares[0]);
        std::next_permutation(values.begin(), values.end());
    }
    for (const ExactSum& sum : sums) {
        EXPECT_EQ(sum, sums.front());
        EXPECT_EQ(sum.value(), 1e16 - 1.5);
        EXPECT_EQ(ExactSum::read(sum.write(), ""), sum);
    }
    ExactSum small;
    small.add(-0x1p-1074);
    EXPECT_EQ(small.value(), -0x1p-1074);
    small.add(0x1p-1074);
    EXPECT_EQ(small.value(), 0.0);
    EXPECT_EQ(ExactSum().value(), 0.0);
    ExactSum tenths;
    for (int i = 0; i < 1000; ++i) {
        tenths.add(0.1);
        tenths.add(-0.3);
    }
    EXPECT_DOUBLE_EQ(tenths.value(), -200.0);
}

TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Tally, TakesAPairOfAnglesByTheShorterWay) {
    const auto pairs = [](double period, double one, double two) {
        Tally tally({{.low = -256.0, .width = 0.0078125, .centre = 0.0, .period = period}}, 1);
        tally.add_pair(0, std::span(&one, 1), std::span(&two, 1));
        return tally.write().at("values").at(0).at("pairs").dump();
    };
    const std::string two_degrees = pairs(0.0, -1.0, 1.0);
    EXPECT_EQ(two_degrees, "[65536]");  // (2/2⁻⁷)²
    EXPECT_EQ(pairs(360.0, 359.0, 1.0), two_degrees);
    EXPECT_EQ(pairs(360.0, 1.0, 359.0), two_degrees);
    EXPECT_EQ(pairs(360.0, 179.0, -179.0), two_degrees);
    EXPECT_NE(pairs(0.0, 179.0, -179.0), two_degrees);
}

TEST(Tally, BarsHoldAllSamples) {
    // A seventh of the samples is one value, the least of all; a thousandth lies far off.
    const auto bars_of = [](double offset, double period) {
        Tally tally({{.low = offset - 2.0, .width = 0.0078125, .centre = offset, .period = period}},
                    1);
        constexpr int count = 7000;
        const double u = 0.5;
        for (int i = 0; i < count; ++i) {
            const double y = offset + (i % 7 == 0      ? 0.003
                                       : i % 1000 == 1 ? 1000.0 * (period == 0.0 ? 1.0 : 0.1)
                                                       : 0.003 + i / 7000.0);
            tally.add(std::span(&u, 1), std::span(&y, 1));
        }
        const auto percentiles = tally.statistics(0).percentiles;
        return tally.histogram(0, percentiles.front(), percentiles.back(), 48);
    };
    for (const auto& bars : {bars_of(0.0, 0.0), bars_of(361.0, 360.0)}) {
        EXPECT_EQ(std::accumulate(bars.begin(), bars.end(), std::uint64_t{0}), 7000U);
        EXPECT_GE(bars.front(), 1000U);
        EXPECT_GE(std::count_if(bars.begin(), bars.end(), [](auto n) { return n > 0; }), 2);
    }
}

}  // namespace
}  // namespace ravnoves::studies

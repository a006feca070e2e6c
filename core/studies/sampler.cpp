#include "studies/sampler.h"

#include <array>
#include <bit>
#include <boost/random/sobol.hpp>
#include <vector>

namespace ravnoves::studies {

namespace {

/// In (0, 1), never an end.
double to_unit(std::uint64_t bits) {
    return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

std::uint64_t mix(std::uint64_t x) {  // the finaliser of SplitMix64
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> c, std::uint32_t k0,
                                    std::uint32_t k1) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t a = std::uint64_t{0xD2511F53U} * c[0];
        const std::uint64_t b = std::uint64_t{0xCD9E8D57U} * c[2];
        c = {static_cast<std::uint32_t>(b >> 32) ^ c[1] ^ k0, static_cast<std::uint32_t>(b),
             static_cast<std::uint32_t>(a >> 32) ^ c[3] ^ k1, static_cast<std::uint32_t>(a)};
        k0 += 0x9E3779B9U;
        k1 += 0xBB67AE85U;
    }
    return c;
}

std::uint64_t reversed(std::uint64_t x) {
    x = __builtin_bswap64(x);
    x = ((x >> 4) & 0x0f0f0f0f0f0f0f0fU) | ((x & 0x0f0f0f0f0f0f0f0fU) << 4);
    x = ((x >> 2) & 0x3333333333333333U) | ((x & 0x3333333333333333U) << 2);
    return ((x >> 1) & 0x5555555555555555U) | ((x & 0x5555555555555555U) << 1);
}

/// A permutation in which each bit depends on the bits above it alone, as nested scrambling wants.
std::uint64_t scrambled(std::uint64_t x, std::uint64_t key) {
    x = reversed(x);
    x ^= x * 0x6c50b47cd8b6a9ecU;
    x += key;
    x *= mix(key) | 1;
    x ^= x * 0xb82f1e52a1c8f3baU;
    x *= mix(~key) | 1;
    x ^= x * 0xc7afe638ea4f4d86U;
    return reversed(x);
}

}  // namespace

std::uint64_t CounterRandom::bits(std::uint64_t sample, std::uint32_t stream,
                                  std::uint32_t place) const {
    const auto out =
        philox({static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(sample >> 32),
                place / 2, stream},
               static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32));
    const std::size_t half = place % 2 == 0 ? 0 : 2;
    return (std::uint64_t{out[half]} << 32) | out[half + 1];
}

double CounterRandom::uniform(std::uint64_t sample, std::uint32_t stream,
                              std::uint32_t place) const {
    return to_unit(bits(sample, stream, place));
}

struct Sampler::Points {
    Points() = default;
    Points(const Points&) = delete;
    Points& operator=(const Points&) = delete;
    virtual ~Points() = default;
    virtual void point(std::uint64_t sample, std::span<double> u) = 0;
};

namespace {

struct MonteCarloPoints final : Sampler::Points {
    explicit MonteCarloPoints(std::uint64_t seed) : random(seed) {}
    void point(std::uint64_t sample, std::span<double> u) override {
        for (std::size_t j = 0; j < u.size(); ++j) {
            u[j] = random.uniform(sample, 0, static_cast<std::uint32_t>(j));
        }
    }
    CounterRandom random;
};

struct LatinPoints final : Sampler::Points {
    LatinPoints(std::uint64_t samples, std::uint64_t seed)
        : count(samples),
          low_bits(static_cast<int>(std::bit_width(samples - 1)) / 2),
          high_bits(static_cast<int>(std::bit_width(samples - 1)) - low_bits),
          key(seed),
          random(seed) {}

    /// The place of a sample in the order of one input: a Feistel network over the next power of
    /// two, walked until it meets the samples again.
    std::uint64_t place(std::uint64_t sample, std::uint64_t input) const {
        const std::uint64_t low_mask = (std::uint64_t{1} << low_bits) - 1;
        const std::uint64_t high_mask = (std::uint64_t{1} << high_bits) - 1;
        std::uint64_t x = sample;
        do {
            std::uint64_t low = x & low_mask;
            std::uint64_t high = x >> low_bits;
            for (std::uint64_t round = 0; round < 4; ++round) {
                const std::uint64_t round_key = key ^ mix(8 * input + 2 * round);
                high ^= mix(low ^ round_key) & high_mask;
                low ^= mix(high ^ ~round_key) & low_mask;
            }
            x = (high << low_bits) | low;
        } while (x >= count);
        return x;
    }
    void point(std::uint64_t sample, std::span<double> u) override {
        for (std::size_t j = 0; j < u.size(); ++j) {
            const double within = random.uniform(sample, 0, static_cast<std::uint32_t>(j));
            u[j] = (static_cast<double>(place(sample, j)) + within) / static_cast<double>(count);
        }
    }

    std::uint64_t count;
    int low_bits;
    int high_bits;
    std::uint64_t key;
    CounterRandom random;
};

struct SobolPoints final : Sampler::Points {
    SobolPoints(std::uint64_t seed, std::size_t inputs) : engine(inputs) {
        for (std::size_t j = 0; j < inputs; ++j) {
            keys.push_back(mix(mix(seed) + j));
        }
    }
    void point(std::uint64_t sample, std::span<double> u) override {
        // The library leaves out the first point, 0.
        if (sample != 0 && (sample != next || next == 1)) {
            engine.seed(sample - 1);
        }
        for (std::size_t j = 0; j < u.size(); ++j) {
            u[j] = to_unit(scrambled(sample == 0 ? 0 : engine(), keys[j]));
        }
        next = sample + 1;
    }

    boost::random::sobol engine;
    std::vector<std::uint64_t> keys;
    std::uint64_t next = 1;  ///< sample that the engine gives without a jump
};

}  // namespace

Sampler::Sampler(Method method, std::uint64_t samples, std::uint64_t seed, std::size_t inputs) {
    if (method == Method::monte_carlo) {
        points_ = std::make_unique<MonteCarloPoints>(seed);
    } else if (method == Method::latin_hypercube) {
        points_ = std::make_unique<LatinPoints>(samples, seed);
    } else {
        points_ = std::make_unique<SobolPoints>(seed, inputs);
    }
}
Sampler::~Sampler() = default;
Sampler::Sampler(Sampler&&) noexcept = default;
Sampler& Sampler::operator=(Sampler&&) noexcept = default;

void Sampler::point(std::uint64_t sample, std::span<double> u) {
    points_->point(sample, u);
}

}  // namespace ravnoves::studies

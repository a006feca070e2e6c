#include "studies/sampler.h"

#include <array>

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

std::uint64_t random_bits(std::uint64_t seed, std::uint64_t sample, std::uint32_t stream,
                          std::uint32_t place) {
    const auto out =
        philox({static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(sample >> 32),
                place / 2, stream},
               static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32));
    const std::size_t half = place % 2 == 0 ? 0 : 2;
    return (std::uint64_t{out[half]} << 32) | out[half + 1];
}

double random_uniform(std::uint64_t seed, std::uint64_t sample, std::uint32_t stream,
                      std::uint32_t place) {
    return to_unit(random_bits(seed, sample, stream, place));
}

Sampler::Sampler(Method method, std::uint64_t seed, std::size_t inputs) : seed_(seed) {
    if (method == Method::monte_carlo) {
        return;
    }
    sobol_.emplace(inputs);
    point_.resize(inputs);
    for (std::size_t i = 0; i < replicates * inputs; ++i) {
        keys_.push_back(mix(mix(seed) + i));
    }
}

void Sampler::point(std::uint64_t sample, std::span<double> u) {
    if (!sobol_) {
        for (std::size_t j = 0; j < u.size(); ++j) {
            u[j] = random_uniform(seed_, sample, 0, static_cast<std::uint32_t>(j));
        }
        return;
    }
    const std::uint64_t number = sample / replicates;
    if (number != at_) {
        if (number != at_ + 1) {
            sobol_->seed(number == 0 ? 0 : number - 1);  // the library leaves out the first point
        }
        for (std::uint64_t& each : point_) {
            each = number == 0 ? 0 : (*sobol_)();
        }
        at_ = number;
    }
    const std::uint64_t* key = keys_.data() + (sample % replicates) * u.size();
    for (std::size_t j = 0; j < u.size(); ++j) {
        u[j] = to_unit(scrambled(point_[j], key[j]));
    }
}

}  // namespace ravnoves::studies

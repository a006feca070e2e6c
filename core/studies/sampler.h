#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "studies/study.h"

namespace ravnoves::studies {

/// Uniform numbers in (0, 1) that depend on seed, sample, stream and place alone: Philox4x32-10
/// [salmon].
class CounterRandom {
  public:
    explicit CounterRandom(std::uint64_t seed) : seed_(seed) {}
    double uniform(std::uint64_t sample, std::uint32_t stream, std::uint32_t place) const;
    std::uint64_t bits(std::uint64_t sample, std::uint32_t stream, std::uint32_t place) const;

  private:
    std::uint64_t seed_;
};

/// The points of a sampled study in the unit cube, any of them at once: sample i depends on the
/// seed and on i alone (for a Latin hypercube on the number of samples too).
///
/// Monte Carlo: CounterRandom. Latin hypercube: for each input a permutation of the samples by a
/// Feistel network, so nothing is stored. Sobol: Boost.Random's points, each coordinate scrambled
/// by a hash that approximates Owen's [burley]: without bias, for smooth functions with an
/// error near N^−1.5.
class Sampler {
  public:
    Sampler(Method method, std::uint64_t samples, std::uint64_t seed, std::size_t inputs);
    ~Sampler();
    Sampler(Sampler&&) noexcept;
    Sampler& operator=(Sampler&&) noexcept;

    /// Fast where the samples are asked for one after the other.
    void point(std::uint64_t sample, std::span<double> u);

    struct Points;

  private:
    std::unique_ptr<Points> points_;
};

}  // namespace ravnoves::studies

#pragma once

#include <boost/random/sobol.hpp>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "studies/study.h"

namespace ravnoves::studies {

/// Numbers that depend on seed, sample, stream and place alone: Philox4x32-10 [salmon].
std::uint64_t random_bits(std::uint64_t seed, std::uint64_t sample, std::uint32_t stream,
                          std::uint32_t place);
double random_uniform(std::uint64_t seed, std::uint64_t sample, std::uint32_t stream,
                      std::uint32_t place);  ///< in (0, 1)

/// Sample i belongs to replicate i mod 8, whose samples are independent of the others', also Sobol
/// points. So the differences of replicates are the error of their mean.
inline constexpr std::size_t replicates = 8;

/// The points of a sampled study in the unit cube, any of them at once: sample i depends on the
/// seed and on i alone.
///
/// Monte Carlo: random_uniform(). Sobol: Boost.Random's points, scrambled for each replicate by
/// keys of its own by a hash that approximates Owen's [burley]: without bias, for smooth functions
/// with an error near N^−1.5.
class Sampler {
  public:
    Sampler(Method method, std::uint64_t seed, std::size_t inputs);

    /// Fast where the samples are asked for one after the other.
    void point(std::uint64_t sample, std::span<double> u);

  private:
    std::uint64_t seed_;
    std::optional<boost::random::sobol> sobol_;
    std::vector<std::uint64_t> keys_;   ///< by replicate, then input
    std::vector<std::uint64_t> point_;  ///< of all replicates, before it is scrambled
    std::uint64_t at_ = 0;              ///< its number
};

}  // namespace ravnoves::studies

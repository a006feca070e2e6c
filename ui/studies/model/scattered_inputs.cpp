#include "studies/model/scattered_inputs.h"

#include <algorithm>
#include <cmath>

#include "studies/sampler.h"

namespace ravnoves {

double percentileOf(const std::vector<double>& ascending, double share) {
    const double rank = share * static_cast<double>(ascending.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    return std::lerp(ascending[below], ascending[std::min(below + 1, ascending.size() - 1)],
                     rank - std::floor(rank));
}

std::vector<std::vector<double>> samplesOf(const std::vector<studies::Law>& laws,
                                           studies::Method method, std::uint64_t seed) {
    studies::Sampler sampler(method, seed, laws.size());
    std::vector<std::vector<double>> samples(scatteredSamples, std::vector<double>(laws.size()));
    for (std::uint64_t i = 0; i < samples.size(); ++i) {
        sampler.point(studies::replicates * i, samples[i]);  // of one replicate
        for (std::size_t j = 0; j < laws.size(); ++j) {
            samples[i][j] = laws[j].at(samples[i][j]);
        }
    }
    return samples;
}

}  // namespace ravnoves

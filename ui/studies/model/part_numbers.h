#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/part.h"
#include "studies/study.h"

namespace ravnoves {

class SceneModel;

inline constexpr int scatteredSamples = 128;
/// 128 samples of inputs that scatter by these laws, evenly also by themselves; Sobol points but
/// for Monte Carlo.
std::vector<std::vector<double>> samplesOf(const std::vector<studies::Law>& laws,
                                           studies::Method method, std::uint64_t seed);
/// Between order statistics.
double percentileOf(const std::vector<double>& ascending, double share);

/// A number with its samples.
struct ScatteredNumber {
    double nominal = 0.0;         ///< NaN for a missing one
    double period = 0.0;          ///< of an angle
    std::vector<float> off = {};  ///< of the samples that have it

    void add(double value);
    /// From the 5 % point to the number, and from it to the 95 % point; nothing where fewer than
    /// nine samples of ten have it.
    std::optional<std::pair<double, double>> sides(std::size_t samples) const;
};

/// The numbers of some parts of a case, points of curves and cells of tables, and what samples of
/// the case make of them.
class PartNumbers {
  public:
    PartNumbers(const SceneModel& model, const std::vector<std::string_view>& ids);

    /// Adds a sample: the same numbers of another input.
    void add(const SceneModel& sample);
    std::size_t samples() const { return samples_; }
    /// Part by part.
    std::map<std::string, PartSpread, std::less<>> spreads(const QString& how) const;

  private:
    struct Part {
        std::string_view id;
        Content ofCase;
        std::vector<ScatteredNumber> numbers;  ///< in its order
    };

    std::vector<Part> parts_;
    std::size_t samples_ = 0;
};

}  // namespace ravnoves

#pragma once

#include <optional>
#include <vector>

#include "case-file/json.h"
#include "studies/sampler.h"
#include "studies/study.h"

namespace ravnoves {

/// Between order statistics.
double percentileOf(const std::vector<double>& ascending, double share);

/// Inputs of a case whose tolerances scatter, one sample after the other.
class ScatteredInputs {
  public:
    static constexpr int count = 128;

    /// Tolerances of numbers that the input has not are left out.
    ScatteredInputs(Json input, const studies::Study& study);

    bool isEmpty() const { return sources_.empty(); }
    Json next();

  private:
    struct Source {
        Json::json_pointer place;
        studies::Law law;
    };
    Json input_;
    std::vector<Source> sources_;
    std::optional<studies::Sampler> sampler_;
    std::vector<double> point_;
    std::uint64_t next_ = 0;
};

/// Numbers that a page shows, and what samples of its case make of them.
class BandSamples {
  public:
    /// From the 5 % point to the number, and from it to the 95 % point; not a number where fewer
    /// than nine samples of ten have one.
    struct Sides {
        std::vector<double> below;
        std::vector<double> above;
    };

    /// @param nominal  NaN for a missing one
    /// @param periods  of angles; else 0
    BandSamples(std::vector<double> nominal, std::vector<double> periods)
        : nominal_(std::move(nominal)), periods_(std::move(periods)) {}

    void add(const std::vector<double>& numbers);
    std::size_t size() const { return samples_.size(); }
    Sides sides() const;

  private:
    std::vector<double> nominal_;
    std::vector<double> periods_;
    std::vector<std::vector<float>> samples_;  ///< off the nominal numbers
};

}  // namespace ravnoves

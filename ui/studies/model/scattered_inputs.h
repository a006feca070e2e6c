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

}  // namespace ravnoves

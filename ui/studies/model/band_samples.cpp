#include "studies/model/band_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/demand.h"

namespace ravnoves {

double percentileOf(const std::vector<double>& ascending, double share) {
    const double rank = share * static_cast<double>(ascending.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    return std::lerp(ascending[below], ascending[std::min(below + 1, ascending.size() - 1)],
                     rank - std::floor(rank));
}

ScatteredInputs::ScatteredInputs(Json input, const studies::Study& study)
    : input_(std::move(input)) {
    for (const studies::Varied& varied : study.vary) {
        const Json::json_pointer place(varied.pointer);
        if (varied.spread == studies::Varied::Spread::grid || !input_.contains(place) ||
            !input_.at(place).is_number()) {
            continue;
        }
        const studies::Law law = studies::law_of(varied, input_.at(place).get<double>());
        if (law.deviation > 0.0) {
            sources_.push_back({place, law});
        }
    }
    if (sources_.empty()) {
        return;
    }
    const bool isRandom = study.method == studies::Method::monte_carlo;
    sampler_.emplace(isRandom ? studies::Method::monte_carlo : studies::Method::sobol, study.seed,
                     sources_.size());
    point_.resize(sources_.size());
}

Json ScatteredInputs::next() {
    sampler_->point(studies::replicates * next_++, point_);  // one replicate: even by itself
    Json changed = input_;
    for (std::size_t j = 0; j < sources_.size(); ++j) {
        changed[sources_[j].place] = sources_[j].law.at(point_[j]);
    }
    return changed;
}

void BandSamples::add(const std::vector<double>& numbers) {
    RAVNOVES_DEMAND(numbers.size() == nominal_.size(), "a sample has the numbers of the case");
    std::vector<float>& sample = samples_.emplace_back();
    for (std::size_t i = 0; i < nominal_.size(); ++i) {
        const double off = numbers[i] - nominal_[i];
        sample.push_back(
            static_cast<float>(periods_[i] > 0.0 ? std::remainder(off, periods_[i]) : off));
    }
}

BandSamples::Sides BandSamples::sides() const {
    constexpr double enough = 0.9;
    Sides sides;
    std::vector<double> column;
    for (std::size_t i = 0; i < nominal_.size(); ++i) {
        column.clear();
        for (const std::vector<float>& sample : samples_) {
            if (std::isfinite(sample[i])) {
                column.push_back(sample[i]);
            }
        }
        const bool isKnown = !column.empty() && static_cast<double>(column.size()) >=
                                                    enough * static_cast<double>(samples_.size());
        std::sort(column.begin(), column.end());
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        sides.below.push_back(isKnown ? -percentileOf(column, 0.05) : none);
        sides.above.push_back(isKnown ? percentileOf(column, 0.95) : none);
    }
    return sides;
}

}  // namespace ravnoves

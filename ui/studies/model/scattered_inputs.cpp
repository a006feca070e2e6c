#include "studies/model/scattered_inputs.h"

#include <algorithm>
#include <cmath>

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

}  // namespace ravnoves

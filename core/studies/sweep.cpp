#include "studies/sweep.h"

#include <limits>

#include "studies/study_run.h"

namespace ravnoves::studies {

Study sweep_study(const std::vector<SweptInput>& inputs, std::vector<Watched> watch) {
    Study study{.vary = {}, .watch = std::move(watch), .method = Method::grid};
    for (const SweptInput& input : inputs) {
        study.vary.push_back({.pointer = input.pointer,
                              .spread = Varied::Spread::grid,
                              .from = input.from,
                              .to = input.to,
                              .values = spaced(input.from, input.to, input.steps),
                              .steps = input.steps});
    }
    return study;
}

std::pair<double, double> swept_range(const Varied& varied, double nominal) {
    if (varied.spread == Varied::Spread::grid) {
        return {varied.values.front(), varied.values.back()};
    }
    const Law law = law_of(varied, nominal);
    return {law.low, law.high};
}

SweepTable sweep_table(const Part& part) {
    const Study& study = part.study;
    SweepTable table;
    for (const Varied& varied : study.vary) {
        table.axes.push_back(varied.values);
    }
    table.values.assign(
        study.watch.size(),
        std::vector<double>(study.points(), std::numeric_limits<double>::quiet_NaN()));
    for (std::size_t w = 0; w < study.watch.size(); ++w) {
        for (std::size_t i = 0; i < part.rows.size() && i < part.done - part.from; ++i) {
            if (const auto& value = part.rows[i][study.vary.size() + w]) {
                table.values[w][part.from + i] = *value;
            }
        }
    }
    return table;
}

}  // namespace ravnoves::studies

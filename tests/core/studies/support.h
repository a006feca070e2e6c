#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "case-file/json.h"
#include "studies/study_run.h"

namespace ravnoves::studies {

using Function = std::function<bool(std::span<const double> x, std::span<double> y)>;

/// Of one value, which exists for any inputs.
template <typename Value>
Function always(Value value) {
    return [value](auto x, auto y) {
        y[0] = value(x);
        return true;
    };
}

/// A function in the place of a scene.
class FunctionResponse final : public Response {
  public:
    /// @param period  of its values
    FunctionResponse(Function function, double period)
        : function_(std::move(function)), period_(period) {}
    double period(std::size_t /*watched*/) const override { return period_; }
    bool evaluate(std::span<const double> x, std::span<double> y) override {
        reason_ = {"/x", {Text{"must be less than %1"}, x[0]}};
        return function_(x, y);
    }

  private:
    Function function_;
    double period_;
};

/// A study of a function; the nominal inputs are those given.
inline Problem problem(const Json& study, std::vector<double> nominal, Function function,
                       double period = 0.0) {
    Problem made{.origin = {.scene = "test", .title = "", .case_sha256 = "0"},
                 .study = read_study(study),
                 .nominal = std::move(nominal),
                 .nominal_result = {},
                 .make = [=] { return std::make_unique<FunctionResponse>(function, period); }};
    std::vector<double> y(made.study.watch.size());
    const bool there = function(made.nominal, y);
    for (const double value : y) {
        made.nominal_result.push_back(there ? std::optional(value) : std::nullopt);
    }
    return made;
}

inline Part whole(const Problem& problem, int threads = 1) {
    return *run_study(problem, 1, 1, threads);
}

/// Of a part's only value, or of another.
inline Statistics statistics(const Part& part, std::size_t watched = 0) {
    return part.tally.statistics(watched, part.blocks);
}

inline std::string notes_text(const Part& part) {
    std::string text;
    for (const Note& note : noted(part)) {
        text += note.text.english() + '\n';
    }
    return text;
}

/// So many inputs of mean 0 and deviation 1, one value.
inline Json normal_study(int inputs, const char* method, std::uint64_t samples, std::uint64_t seed,
                         const char* watched = "/y") {
    Json study = {{"method", method}, {"samples", samples}, {"seed", seed}};
    for (int j = 0; j < inputs; ++j) {
        study["vary"]["/x" + std::to_string(j)] = {{"normal_sd", 1}};
    }
    study["watch"][watched] = Json::object();
    return study;
}

}  // namespace ravnoves::studies

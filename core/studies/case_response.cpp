// A case as a response: its scene solves one input after the other.

#include <algorithm>
#include <cmath>
#include <limits>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "case-file/said_messages.h"
#include "case-file/sha256.h"
#include "case-file/text_file.h"
#include "case-file/wanted.h"
#include "scenes/responses.h"
#include "scenes/scenes.h"
#include "studies/law.h"
#include "studies/study_run.h"

namespace ravnoves::studies {

namespace {

using Pointer = Json::json_pointer;

const SceneSolver& solver_of(const CaseFile& file) {
    const auto scenes = scene_solvers();
    const auto found = std::find_if(scenes.begin(), scenes.end(), [&](const SceneSolver& each) {
        return each.name == file.scene;
    });
    if (found == scenes.end()) {
        throw InputError("/scene", CORE_TEXT("core", "must be a known scene"), file.scene);
    }
    return *found;
}

/// The number that a result holds at a place; yes and no are 1 and 0.
std::optional<double> number_at(const Json& result, const Pointer& place) {
    const Json* value = result.contains(place) ? &result.at(place) : nullptr;
    if (value == nullptr || !(value->is_number() || value->is_boolean())) {
        return std::nullopt;
    }
    const double number =
        value->is_boolean() ? (value->get<bool>() ? 1.0 : 0.0) : value->get<double>();
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// Why there is no number: the reason that the objects around it give, the nearest first.
Message why_missing(const Json& result, const Pointer& place, const SaidMessages& said) {
    for (Pointer around = place; !around.empty();) {
        around = around.parent_pointer();
        if (!result.contains(around)) {
            continue;
        }
        const Json& object = result.at(around);
        for (const char* key : {"reason", "note"}) {
            if (object.is_object() && object.contains(key) && object[key].is_string() &&
                !object[key].get_ref<const std::string&>().empty()) {
                return said.of(object[key].get<std::string>());
            }
        }
    }
    return no_value;
}

template <typename Named>
std::vector<std::string> pointers_of(const std::vector<Named>& named) {
    std::vector<std::string> pointers;
    for (const Named& each : named) {
        pointers.push_back(each.pointer);
    }
    return pointers;
}

class CaseResponse final : public Response {
  public:
    CaseResponse(const SceneSolver& solver, Json input, CaseContext context, const Study& study)
        : solver_(solver), input_(std::move(input)), context_(std::move(context)) {
        for (const Varied& varied : study.vary) {
            slots_.push_back(&input_.at(Pointer(varied.pointer)));
        }
        for (const Watched& watched : study.watch) {
            places_.emplace_back(watched.pointer);
        }
        wanted_ = Wanted(pointers_of(study.watch));
    }

    bool evaluate(std::span<const double> x, std::span<double> y) override {
        for (std::size_t j = 0; j < x.size(); ++j) {
            *slots_[j] = x[j];
        }
        std::fill(y.begin(), y.end(), std::numeric_limits<double>::quiet_NaN());
        const SaidMessages said;
        Json result;
        try {
            result = solver_.solve(input_, context_, wanted_);
        } catch (const InputError& error) {
            reason_ = {error.where_message(), error.allowed_message()};
            return false;
        }
        bool whole = true;
        for (std::size_t w = 0; w < y.size(); ++w) {
            if (const auto number = number_at(result, places_[w])) {
                y[w] = *number;
            } else if (whole) {
                whole = false;
                reason_ = {places_[w].to_string(), why_missing(result, places_[w], said)};
            }
        }
        return whole;
    }

  private:
    const SceneSolver& solver_;
    Json input_;
    CaseContext context_;
    std::vector<Json*> slots_;
    std::vector<Pointer> places_;
    Wanted wanted_;
};

std::vector<double> nominal_inputs(const Json& input, const Study& study) {
    std::vector<double> nominal;
    for (const Varied& varied : study.vary) {
        const Pointer place(varied.pointer);
        const bool there = input.contains(place);
        if (!there || !input.at(place).is_number()) {
            throw InputError(vary_place(varied.pointer),
                             CORE_TEXT("studies", "must lead to a number of the input"),
                             there ? show(input.at(place)) : Message());
        }
        nominal.push_back(input.at(place).get<double>());
        const Law law = law_of(varied, nominal.back());
        if (varied.spread != Varied::Spread::grid &&
            !std::isfinite(law.deviation * law.deviation)) {
            throw InputError(vary_place(varied.pointer),
                             CORE_TEXT("studies",
                                       "must scatter less: its moments are no numbers "
                                       "any more"));
        }
    }
    return nominal;
}

/// @throws InputError where the case cannot be solved, or the result has no such values
std::vector<std::optional<double>> nominal_result(const SceneSolver& solver, const CaseFile& file,
                                                  const CaseContext& context, const Study& study) {
    const Json result = solver.solve(file.input, context, Wanted(pointers_of(study.watch)));
    std::vector<std::optional<double>> values;
    for (const Watched& watched : study.watch) {
        const Pointer place(watched.pointer);
        if (!result.contains(place)) {
            throw InputError(watch_place(watched.pointer),
                             CORE_TEXT("core", "must be a value that the result has"));
        }
        const Json& value = result.at(place);
        if (value.is_structured() || value.is_string()) {
            throw InputError(watch_place(watched.pointer),
                             CORE_TEXT("studies", "must lead to a number of the result"),
                             show(value));
        }
        values.push_back(number_at(result, place));
    }
    return values;
}

}  // namespace

Problem problem_of(const CaseFile& file, const CaseContext& context, std::string_view text) {
    if (file.study.is_null()) {
        throw InputError("/study", CORE_TEXT("core", "is required and missing"));
    }
    const SceneSolver& solver = solver_of(file);
    Problem problem{.origin = {.scene = file.scene, .title = file.title, .case_sha256 = {}},
                    .study = read_study(file.study),
                    .nominal = {},
                    .nominal_result = {},
                    .make = {}};
    problem.nominal = nominal_inputs(file.input, problem.study);
    problem.nominal_result = nominal_result(solver, file, context, problem.study);
    problem.origin.case_sha256 = sha256(text.empty() ? write_case(file).dump() : std::string(text));
    for (const auto& path : files_named_by(file, context)) {
        problem.origin.files_sha256.emplace_back(path.filename().string(),
                                                 sha256(read_text_file(path)));
    }
    problem.make = [&solver, file, context, study = problem.study]() -> std::unique_ptr<Response> {
        if (auto typed =
                typed_response(file, context, pointers_of(study.vary), pointers_of(study.watch))) {
            return typed;
        }
        return std::make_unique<CaseResponse>(solver, file.input, context, study);
    };
    problem.file_notes = file_notes(file, context);
    return problem;
}

}  // namespace ravnoves::studies

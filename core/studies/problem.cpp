// The study of a case.

#include <algorithm>
#include <cmath>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "case-file/sha256.h"
#include "case-file/text_file.h"
#include "scenes/case_sources.h"
#include "scenes/scenes.h"
#include "studies/study_run.h"

namespace ravnoves::studies {

namespace {

using Pointer = Json::json_pointer;

template <typename Named>
std::vector<std::string> pointers_of(const std::vector<Named>& named) {
    std::vector<std::string> pointers;
    for (const Named& each : named) {
        pointers.push_back(each.pointer);
    }
    return pointers;
}

std::vector<double> nominal_inputs(const Json& input, const Study& study) {
    std::vector<double> nominal;
    for (const Varied& varied : study.vary) {
        const Pointer place(varied.pointer);
        const bool there = input.contains(place);
        if (!there || !input.at(place).is_number()) {
            throw InputError(vary_place(varied.pointer),
                             Text::tr("must point to a number of the input"),
                             there ? show(input.at(place)) : Message());
        }
        nominal.push_back(input.at(place).get<double>());
        const Law law = law_of(varied, nominal.back());
        if (varied.spread != Varied::Spread::grid &&
            !std::isfinite(law.deviation * law.deviation)) {
            throw InputError(
                vary_place(varied.pointer),
                Text::tr("must scatter less: its moments exceed the range of numbers"));
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
                             Text::tr("must be a value that the result has"));
        }
        const Json& value = result.at(place);
        if (value.is_structured() || value.is_string()) {
            throw InputError(watch_place(watched.pointer),
                             Text::tr("must point to a number of the result"), show(value));
        }
        const double number = value.is_boolean()  ? (value.get<bool>() ? 1.0 : 0.0)
                              : value.is_number() ? value.get<double>()
                                                  : std::nan("");
        values.push_back(std::isfinite(number) ? std::optional(number) : std::nullopt);
    }
    return values;
}

}  // namespace

std::optional<Varied> open_input(const CaseFile& file, const CaseContext& context,
                                 const std::vector<Varied>& typed) {
    using ravnoves::open_input;
    const auto ends = open_ends(file, context);
    return ends && std::ranges::find(typed, open_input, &Varied::pointer) == typed.end()
               ? std::optional(Varied{.pointer = open_input,
                                      .spread = Varied::Spread::uniform,
                                      .from = ends->first,
                                      .to = ends->second})
               : std::nullopt;
}

Problem problem_of(const CaseFile& file, const CaseContext& context, std::string_view text) {
    if (file.study.is_null()) {
        throw InputError("/study", Text::tr("is required and missing"));
    }
    const SceneSolver& solver = scene_solver(file.scene);
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
    problem.make = [&solver, file, context, vary = pointers_of(problem.study.vary),
                    watch = pointers_of(problem.study.watch)] {
        return solver.respond(file.input, context, vary, watch);
    };
    for (const std::string& changed : changed_files(file.input, context)) {
        problem.file_notes.push_back(changed_note(changed));
    }
    const auto open = problem.study.method == Method::grid
                          ? std::nullopt
                          : open_input(file, context, problem.study.vary);
    if (open) {
        problem.file_notes.push_back(
            {Text::tr("The uncertain dead centre of the trace is not included: give %1 a tolerance "
                      "of ± %2."),
             open->pointer, Number{(open->to - open->from) / 2.0, units::degree, 2}});
    }
    return problem;
}

}  // namespace ravnoves::studies

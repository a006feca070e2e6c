#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bibliography/formula.h"
#include "case-file/case_context.h"
#include "case-file/case_file.h"
#include "case-file/field_index.h"
#include "case-file/json_fwd.h"
#include "case-file/preset.h"
#include "case-file/response.h"
#include "case-file/result_json.h"

namespace ravnoves {

inline constexpr std::string_view result_format = "ravnoves-result";

/// A scene as the case file sees it. What takes the case's "input" object (its pointer is "/input")
/// throws InputError for bad input. A design that cannot exist is a result with `"feasible": false`
/// and a reason.
struct SceneSolver {
    std::string_view name;  ///< the word in the case file, for example "balance-shaft"
    Text title;             ///< in the window; empty where it has no page
    Text summary;           ///< one line: what the page is for
    void (*visit)(ResultVisitor& visitor, const Json& input, const CaseContext& context);
    /// What its result rests on.
    std::vector<Formula> (*formulas)(const Json& input);
    std::span<const Text> (*left_out)();
    /// What an answer leads with, by pointers below "result".
    std::span<const std::string_view> leading;
    std::vector<Preset<Json>> (*presets)();  ///< "input" objects to begin with
    /// Values of its result as functions of numbers of its input, without a file in between; both
    /// by their pointers below "result" and "input".
    std::unique_ptr<Response> (*respond)(const Json& input, const CaseContext& context,
                                         std::span<const std::string> varied,
                                         std::span<const std::string> watched);
    /// The fields of an "input", for their names and words; their places are no longer valid.
    std::vector<FieldEntry> (*fields)(const Json& input);
    /// Pointer below "result" to whether a case is feasible, yes or no; empty without one.
    std::string_view buildable{};
    /// Below "input" the word that chooses a method rather than an engine; empty without one.
    std::string_view method{};

    /// The "result" object. Of unwanted values it computes only what the scene always computes.
    Json solve(const Json& input, const CaseContext& context, const Wanted& wanted) const;
    /// The single numbers of its result, with their names.
    std::vector<ResultEntry> results(const Json& input, const CaseContext& context) const;
};

/// The scenes that have a solver, in the order of the navigation.
std::span<const SceneSolver> scene_solvers();
/// The scene of that name.
/// @throws InputError without one
const SceneSolver& scene_solver(const std::string& name);

/// read_case() with the names of scene_solvers().
/// @throws InputError
CaseFile read_case(Json document);
/// Parses UTF-8 JSON text, then read_case(). Syntax errors name line and column.
/// @throws InputError
CaseFile parse_case(std::string_view text);

/// The same for a program that shows each case on a page: a case of v8-plugs or bob-weights becomes
/// a job of workshop.
/// @throws InputError
CaseFile parse_shown_case(std::string_view text);

/// Whether the data of a case leave an input open: the ends of the phase of a pressure trace, °, as
/// its compression line tells the dead centre.
inline constexpr const char* open_input = "/torque/pressure/crank_angle_shift_deg";
std::optional<std::pair<double, double>> open_ends(const CaseFile& file,
                                                   const CaseContext& context);

/// Solves a case and wraps the result, or its wanted part, in its envelope, without NaN or
/// infinity.
/// @throws InputError for bad input
Json solve_case(const CaseFile& file, const CaseContext& context, const Wanted& wanted = {});

}  // namespace ravnoves

#pragma once

#include <span>
#include <string>
#include <string_view>

#include "case-file/case_context.h"
#include "case-file/json.h"

namespace ravnoves {

inline constexpr std::string_view case_format = "ravnoves-case";
inline constexpr std::string_view result_format = "ravnoves-result";
inline constexpr int case_version = 1;  ///< the newest version this program reads and writes

/// A scene as the case file sees it. solve() takes the case's "input" object (its pointer is
/// "/input") and returns the "result" object; it throws InputError for bad input. A design that
/// cannot exist is a result with `"feasible": false` and a reason.
struct SceneSolver {
    std::string_view name;  ///< the word in the case file, for example "balance-shaft"
    Json (*solve)(const Json& input, const CaseContext& context);
};

/// The scenes that have a solver, in the order of the navigation.
std::span<const SceneSolver> scene_solvers();

/// One case: which scene, its title and its input, not yet checked by the scene.
struct CaseFile {
    std::string scene;
    std::string title;
    Json input;
};

/// Checks the envelope (format, version, scene, unknown keys). The scene name is checked against
/// scene_solvers().
/// @throws InputError
CaseFile read_case(const Json& document);
/// Parses UTF-8 JSON text, then read_case(). Syntax errors name line and column.
/// @throws InputError
CaseFile parse_case(std::string_view text);
Json write_case(const CaseFile& file);

/// Solves a case and wraps the result in its envelope. Never holds NaN or infinity.
/// @throws InputError for bad input, std::logic_error for a fault of ours
Json solve_case(const CaseFile& file, const CaseContext& context);

/// Parses JSON text; syntax errors, NaN and numbers beyond double name line and column. Nesting is
/// limited to 100 levels.
/// @throws InputError
Json parse_json(std::string_view text);

}  // namespace ravnoves

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/case_context.h"
#include "case-file/result_json.h"

namespace ravnoves {
struct CaseFile;
}

namespace ravnoves::methods {

/// How much a leading result changes where one thing alone is otherwise: the same solution of the
/// same case with this one change.
struct Contribution {
    enum class Kind {
        rounding,     ///< every operation rounded up, down or towards zero instead of to nearest
        choice,       ///< another word of a choice of method
        approximate,  ///< the approximate form that the scene prints beside the exact one
        tolerance,    ///< an input at either end of its ±; of a normal law one deviation away
    };
    Kind kind = Kind::rounding;
    /// Below "input", of an approximate form below "result"; empty of rounding.
    std::string pointer{};
    std::string word{};              ///< of another choice
    std::optional<double> change{};  ///< largest amount, SI; empty where it is not solved then

    /// As a line of the command line: "/interpolation: periodic-cubic".
    std::string english() const;
};

/// A leading result of a case, and what contributes to it, largest first.
struct CaseDoubt {
    ResultEntry result;  ///< with a value
    std::vector<Contribution> contributions{};
};

/// The leading results of a case and how sure each is. Changes within rounding are left out, and so
/// are results without a change.
/// @throws InputError as a solution of the case, and for an invalid "study"
std::vector<CaseDoubt> case_budget(const CaseFile& file, const CaseContext& context);

/// As aligned text (UTF-8), in the units of the case file.
std::string write_text(const std::vector<CaseDoubt>& budget);

}  // namespace ravnoves::methods

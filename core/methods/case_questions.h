#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "case-file/case_context.h"
#include "case-file/field_index.h"
#include "case-file/json_fwd.h"
#include "studies/study.h"

namespace ravnoves::methods {

/// What case_budget() asks of the cases of a scene.
struct CaseQuestions {
    std::string_view scene;
    std::span<const std::string_view> leading;  ///< what an answer leads with, below "result"
    /// The fields of an "input", for their names and words; their places are no longer valid.
    std::vector<FieldEntry> (*fields)(const Json& input);
    /// Below "input" the words that choose a method rather than an engine.
    std::span<const std::string_view> choices{};
    // Objects of the result with the same values by an exact and by an approximate form; or empty.
    std::string_view exact{};
    std::string_view approximate{};
    /// Inputs that are only as certain as a measurement, each from … to.
    std::vector<studies::Varied> (*measured)(const Json& input,
                                             const CaseContext& context) = nullptr;
};

/// Of a scene by its word in case files.
const CaseQuestions& questions_of(std::string_view scene);

}  // namespace ravnoves::methods

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/case_context.h"
#include "case-file/json_fwd.h"
#include "case-file/message.h"
#include "case-file/response.h"
#include "case-file/result_index.h"

namespace ravnoves {

struct CaseFile;

/// A case as a response: its values at these pointers as functions of the numbers at those, without
/// a file in between.
/// @return nothing where the scene does not describe its result by visit_results()
/// @throws InputError where the case is wrong
std::unique_ptr<Response> typed_response(const CaseFile& file, const CaseContext& context,
                                         std::span<const std::string> varied,
                                         std::span<const std::string> watched);

/// The single numbers of a case's result, with their names.
/// @return none where the scene does not describe its result by visit_results()
/// @throws InputError where the case is wrong
std::vector<ResultEntry> case_results(std::string_view scene, const Json& input,
                                      const CaseContext& context);

/// Pointer below "result" to whether a case can be built, yes or no.
/// @return nothing where the scene does not tell that
std::optional<std::string> buildable_value(const CaseFile& file);

/// What is to be known of the files that the case is solved from, whatever is asked of it.
/// @throws InputError where the case is wrong
std::vector<Message> file_notes(const CaseFile& file, const CaseContext& context);

}  // namespace ravnoves

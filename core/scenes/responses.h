#pragma once

#include <memory>
#include <span>
#include <string>

#include "case-file/case_context.h"
#include "case-file/response.h"

namespace ravnoves {

struct CaseFile;

/// A response of the case's scene that is faster than solving it as a whole, with the same numbers.
/// @return nothing where the scene has none for these pointers
/// @throws InputError where the case is wrong
std::unique_ptr<Response> quick_response(const CaseFile& file, const CaseContext& context,
                                         std::span<const std::string> varied,
                                         std::span<const std::string> watched);

}  // namespace ravnoves

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case-file/case_context.h"
#include "case-file/message.h"
#include "case-file/response.h"

namespace ravnoves {

struct CaseFile;

/// A response of the case's scene that is faster than solving it as a whole, with the same numbers.
/// @return nothing where the scene has none for these pointers
/// @throws InputError where the case is wrong
std::unique_ptr<Response> quick_response(const CaseFile& file, const CaseContext& context,
                                         std::span<const std::string> varied,
                                         std::span<const std::string> watched);

/// The angles of best_choice() that can be built as the inputs at these pointers vary.
/// @return nothing where the scene has none for these pointers
/// @throws InputError where the case is wrong
BuildableOf quick_buildable(const CaseFile& file, const CaseContext& context,
                            std::span<const std::string> varied);

/// Pointer below "result" to whether a case can be built, yes or no.
/// @return nothing where the scene does not tell that
std::optional<std::string> buildable_value(const CaseFile& file);

/// What is to be known of the files that the case is solved from, whatever is asked of it.
/// @throws InputError where the case is wrong
std::vector<Message> file_notes(const CaseFile& file, const CaseContext& context);

/// An angle of a scene's input that is there to make one of its results least.
struct BestChoice {
    std::string input;           ///< pointer to the angle, degrees, below "input"
    std::string value;           ///< to what it makes least, below "result"
    std::string best;            ///< to the angle that does so
    std::string best_buildable;  ///< to the one among those that can be built
    std::string amplitude;       ///< the value moves by no more than twice this per radian
    std::string buildable;       ///< to the stretches of angles that can be built, degrees
};
std::optional<BestChoice> best_choice(const CaseFile& file);

}  // namespace ravnoves

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "case-file/json.h"
#include "case-file/message.h"

namespace ravnoves {

inline constexpr std::string_view case_format = "ravnoves-case";
inline constexpr int case_version = 1;  ///< the newest version this program reads and writes

/// Another input of the same scene, kept under a name to be compared with the case's own.
struct CaseVariant {
    std::string name;  ///< not empty, of one variant alone
    Json input;        ///< checked by the scene when it is used
    friend bool operator==(const CaseVariant&, const CaseVariant&) = default;
};

/// One case: which scene, its title and its input, not yet checked by the scene.
struct CaseFile {
    std::string scene;
    std::string title;
    Json input;
    std::string notes{};  ///< the user's own words
    std::vector<CaseVariant> variants{};
    std::string reference{};  ///< name of the variant that results are seen against; empty: none
    Json study{};             ///< kept unchanged; null without one
    /// Unused parts of the input, under the keys that they would have there: kept unchanged; null
    /// without any.
    Json kept{};
    std::vector<Message> changes{};  ///< what reading did to a case of an older version
};

/// Checks the envelope: format, version, scene, unknown keys.
/// @param scenes  the names that a scene may have
/// @throws InputError
CaseFile read_case(Json document, const std::vector<std::string>& scenes);
/// Empty members beside title and input are left out.
Json write_case(const CaseFile& file);

/// Parses JSON text. Syntax errors, NaN and NUL name line and column; a key given twice, a text
/// with NUL and a number beyond double name the pointer. Nesting is limited to 100 levels.
/// @throws InputError
Json parse_json(std::string_view text);

/// Sets a value of a case's input at a JSON pointer below it ("/torque/torque_Nm/3"). Objects on
/// the way are made; a list grows by one element at most.
/// @throws InputError where the pointer leads nowhere
void set_input_value(Json& input, const std::string& pointer, Json value);

}  // namespace ravnoves

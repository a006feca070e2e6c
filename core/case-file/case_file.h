#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "case-file/json.h"

namespace ravnoves {

inline constexpr std::string_view case_format = "ravnoves-case";
inline constexpr int case_version = 1;  ///< the newest version this program reads and writes

/// One case: which scene, its title and its input, not yet checked by the scene.
struct CaseFile {
    std::string scene;
    std::string title;
    Json input;
};

/// Checks the envelope (format, version, scene, unknown keys).
/// @param scenes  the names that a scene may have
/// @throws InputError
CaseFile read_case(const Json& document, const std::vector<std::string>& scenes);
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

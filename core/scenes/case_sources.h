#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case-file/case_context.h"
#include "case-file/json_fwd.h"

namespace ravnoves {

struct CaseFile;

/// Whether both are one regular file, by whatever path, link or hard link.
bool is_same_file(const std::filesystem::path& file, const std::filesystem::path& other);

/// Whether the file is one that the case names; nothing may be written over it then.
bool is_named_by(const CaseFile& file, const CaseContext& context,
                 const std::filesystem::path& path);

/// The files that an input names together with their SHA-256 and that have changed, by their names
/// in the input. An unreadable one is not among them: the input is rejected then.
std::vector<std::string> changed_files(const Json& input, const CaseContext& context);

}  // namespace ravnoves

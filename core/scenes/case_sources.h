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

/// The files that the case names: each text under a key "csv", beside the case.
std::vector<std::filesystem::path> files_named_by(const CaseFile& file, const CaseContext& context);

/// Rewrites the names of these files for a case that moves, so that they are the same files from
/// there. A file below its folder is named by a short path; whole paths to elsewhere are unchanged.
void move_files(CaseFile& file, const CaseContext& from, const CaseContext& to);

/// Whether the file is one that the case names; nothing may be written over it then.
bool is_named_by(const CaseFile& file, const CaseContext& context,
                 const std::filesystem::path& path);

/// The files that an input names together with their SHA-256 and that have changed, by their names
/// in the input. An unreadable one is not among them: the input is rejected then.
std::vector<std::string> changed_files(const Json& input, const CaseContext& context);

}  // namespace ravnoves

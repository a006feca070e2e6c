#pragma once

#include <filesystem>

#include "case-file/case_context.h"

namespace ravnoves {

struct CaseFile;

/// Whether both are one regular file, by whatever path, link or hard link.
bool is_same_file(const std::filesystem::path& file, const std::filesystem::path& other);

/// Whether the file is one that the case names; nothing may be written over it then.
bool is_named_by(const CaseFile& file, const CaseContext& context,
                 const std::filesystem::path& path);

}  // namespace ravnoves

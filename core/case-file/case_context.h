#pragma once

#include <filesystem>

namespace ravnoves {

/// Where a case came from: files that it names are looked for beside it.
struct CaseContext {
    std::filesystem::path directory = ".";
};

}  // namespace ravnoves

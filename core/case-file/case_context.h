#pragma once

#include <filesystem>

namespace ravnoves {

/// Where a case came from: files that it names are looked for beside it.
struct CaseContext {
    std::filesystem::path directory = ".";
    /// A stranger's case reads only files in the directory, wherever links lead.
    bool stays_in_directory = false;

    bool may_read(const std::filesystem::path& name) const {
        if (!stays_in_directory) {
            return true;
        }
        std::error_code error;
        const auto folder = std::filesystem::weakly_canonical(directory, error);
        const auto file = std::filesystem::weakly_canonical(directory / name, error);
        const auto below = file.lexically_relative(folder);
        return !error && !below.empty() && *below.begin() != "..";
    }
};

}  // namespace ravnoves

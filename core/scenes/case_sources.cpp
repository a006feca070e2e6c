#include "scenes/case_sources.h"

#include <algorithm>
#include <system_error>

#include "scenes/scenes.h"

namespace ravnoves {

bool is_same_file(const std::filesystem::path& file, const std::filesystem::path& other) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(other, ignored) &&
           std::filesystem::equivalent(file, other, ignored);
}

bool is_named_by(const CaseFile& file, const CaseContext& context,
                 const std::filesystem::path& path) {
    const auto inputs = files_named_by(file, context);
    return std::any_of(inputs.begin(), inputs.end(),
                       [&](const auto& input) { return is_same_file(input, path); });
}

}  // namespace ravnoves

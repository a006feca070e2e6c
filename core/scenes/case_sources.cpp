#include "scenes/case_sources.h"

#include <algorithm>
#include <system_error>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/sha256.h"
#include "case-file/text_file.h"
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

std::vector<std::string> changed_files(const Json& input, const CaseContext& context) {
    std::vector<std::string> changed;
    const auto name = input.find("csv");
    const auto sum = input.find("csv_sha256");
    if (input.is_object() && name != input.end() && name->is_string() && sum != input.end() &&
        sum->is_string()) {
        const auto& file = name->get_ref<const std::string&>();
        try {
            if (context.may_read(file) &&
                is_other_sum(sum->get_ref<const std::string&>(),
                             sha256(read_text_file(context.directory / file)))) {
                changed.push_back(file);
            }
        } catch (const InputError&) {
        }
    }
    for (const Json& part : input) {
        if (part.is_structured()) {
            const auto below = changed_files(part, context);
            changed.insert(changed.end(), below.begin(), below.end());
        }
    }
    return changed;
}

}  // namespace ravnoves

#include "scenes/case_sources.h"

#include <algorithm>
#include <system_error>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/sha256.h"
#include "case-file/text_file.h"

namespace ravnoves {

namespace {

/// Calls `visit` with each text under a key "csv" and the object around it.
template <typename Value, typename Visit>
void visit_files(Value& value, const Visit& visit) {
    if (!value.is_structured()) {
        return;
    }
    for (auto& item : value.items()) {
        if (item.value().is_string() && value.is_object() && item.key() == "csv") {
            visit(item.value(), value);
        }
        visit_files(item.value(), visit);
    }
}

template <typename File, typename Visit>
void visit_files_of_case(File& file, const Visit& visit) {
    visit_files(file.input, visit);
    visit_files(file.kept, visit);
    for (auto& variant : file.variants) {
        visit_files(variant.input, visit);
    }
}

/// Without links and detours, as far as the path exists.
std::filesystem::path plain_path(const std::filesystem::path& path) {
    std::error_code fault;
    auto plain = std::filesystem::weakly_canonical(std::filesystem::absolute(path), fault);
    plain = fault ? std::filesystem::absolute(path).lexically_normal() : plain;
    return plain.has_filename() ? plain : plain.parent_path();
}

}  // namespace

bool is_same_file(const std::filesystem::path& file, const std::filesystem::path& other) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(other, ignored) &&
           std::filesystem::equivalent(file, other, ignored);
}

std::vector<std::filesystem::path> files_named_by(const CaseFile& file,
                                                  const CaseContext& context) {
    std::vector<std::filesystem::path> files;
    visit_files_of_case(file, [&](const Json& name, const Json&) {
        files.push_back(context.directory / name.get_ref<const std::string&>());
    });
    return files;
}

bool is_named_by(const CaseFile& file, const CaseContext& context,
                 const std::filesystem::path& path) {
    const auto inputs = files_named_by(file, context);
    return std::any_of(inputs.begin(), inputs.end(),
                       [&](const auto& input) { return is_same_file(input, path); });
}

void move_files(CaseFile& file, const CaseContext& from, const CaseContext& to) {
    const std::filesystem::path folder = plain_path(to.directory);
    const bool is_same = folder == plain_path(from.directory);
    visit_files_of_case(file, [&](Json& name, const Json&) {
        const std::filesystem::path given = name.get<std::string>();
        if (given.empty() || (is_same && given.is_relative())) {
            return;
        }
        const std::filesystem::path whole = plain_path(from.directory / given);
        const std::filesystem::path moved = whole.lexically_relative(folder);
        const bool is_below = !moved.empty() && *moved.begin() != "..";
        if (is_below || given.is_relative()) {
            name = (moved.empty() ? whole : moved).generic_string();
        }
    });
}

std::vector<std::string> changed_files(const Json& input, const CaseContext& context) {
    std::vector<std::string> changed;
    visit_files(input, [&](const Json& name, const Json& around) {
        const auto& file = name.get_ref<const std::string&>();
        const auto sum = around.find("csv_sha256");
        try {
            if (sum != around.end() && sum->is_string() && context.may_read(file) &&
                is_other_sum(sum->get_ref<const std::string&>(),
                             sha256(read_text_file(context.directory / file)))) {
                changed.push_back(file);
            }
        } catch (const InputError&) {
        }
    });
    return changed;
}

}  // namespace ravnoves

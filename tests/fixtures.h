#pragma once

#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "case-file/text_file.h"

/// Files of versions before this one, as those wrote them: tests/data/fixtures, a folder for each
/// month in which some were made. None is ever changed.
namespace ravnoves::test {

inline const std::filesystem::path& fixture_folder() {
    static const auto folder =
        std::filesystem::path(RAVNOVES_EXPECTED).parent_path() / "fixtures" / "2026-11";
    return folder;
}

inline Json fixture(const std::string& name) {
    return parse_json(read_text_file(fixture_folder() / name));
}

/// What stands before an ending, of all fixtures that have it: "v8-plugs" of "v8-plugs.case.json".
inline std::vector<std::string> fixtures_with(const std::string& ending) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(fixture_folder())) {
        std::string name = entry.path().filename().string();
        if (name.ends_with(ending)) {
            names.push_back(name.substr(0, name.size() - ending.size()));
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// A value that is not what it was, on purpose.
struct Difference {
    const char* where;  ///< fixture, variant and pointer: "two-stroke//sweep/*"; * is any text
    const char* why;
    /// Relative, for one that moved a little; without it the value may be gone or be anything.
    double within = std::numeric_limits<double>::infinity();
    double floor = 0.0;  ///< what rounding leaves, in the unit of the value
};

namespace detail {

inline bool is_index(const std::string& key) {
    return !key.empty() &&
           std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The unit at the end of a key; numbers of a list have all the same.
inline std::string unit_of(const std::string& key) {
    return is_index(key) ? "" : key.substr(std::min(key.rfind('_'), key.size()));
}

inline bool is_word(const Json& value) {
    return value.is_string() && value.get_ref<const std::string&>().find(' ') == std::string::npos;
}

inline void compare(const Json& expected, const Json& actual, const std::string& where,
                    std::span<const Difference> allowed, std::vector<std::string>& found) {
    for (const auto& item : expected.items()) {
        const std::string here = where + "/" + item.key();
        const Json& value = item.value();
        const Json* now = nullptr;
        if (actual.is_object() && actual.contains(item.key())) {
            now = &actual.at(item.key());
        } else if (actual.is_array() && is_index(item.key()) &&
                   std::stoul(item.key()) < actual.size()) {
            now = &actual.at(std::stoul(item.key()));
        }
        double within = 1e-9;
        double floor = 0.0;
        for (const Difference& each : allowed) {
            if (::fnmatch(each.where, here.c_str(), 0) == 0) {
                within = std::max(within, each.within);
                floor = std::max(floor, each.floor);
            }
        }
        if (std::isinf(within)) {
            continue;
        }
        if (now == nullptr) {
            found.push_back(here + " is gone");
        } else if (value.is_structured() && now->is_structured()) {
            compare(value, *now, here, allowed, found);
        } else if (value.is_number() && now->is_number()) {
            // Of a sum of large numbers rounding alone is left.
            double size = 0.0;
            for (const auto& other : expected.items()) {
                if (other.value().is_number() && unit_of(other.key()) == unit_of(item.key())) {
                    size = std::max(size, std::abs(other.value().get<double>()));
                }
            }
            const double was = value.get<double>();
            const double is = now->get<double>();
            if (!(std::abs(is - was) <= std::max({within * std::abs(was), 1e-12 * size, floor}))) {
                found.push_back(here + " was " + value.dump() + ", is " + now->dump());
            }
        } else if ((is_word(value) || !value.is_string() || !now->is_string()) && value != *now) {
            found.push_back(here + " was " + value.dump() + ", is " + now->dump());
        }
    }
}

}  // namespace detail

/// What has become another: every number to 1e-9, every word, yes, no and null; sentences may
/// change, and more may be there. A long list of the fixture is an object that holds some of its
/// values by their index.
/// @param name  of the fixture, which Difference::where begins with
inline std::vector<std::string> differences(const std::string& name, const Json& was,
                                            const Json& is, std::span<const Difference> allowed) {
    std::vector<std::string> found;
    detail::compare(was, is, name, allowed, found);
    return found;
}

/// The first of them as a test prints it.
inline std::string first_of(const std::vector<std::string>& found) {
    std::string text = std::to_string(found.size()) + " differences";
    for (std::size_t i = 0; i < std::min<std::size_t>(found.size(), 10); ++i) {
        text += "\n" + found[i];
    }
    return text;
}

}  // namespace ravnoves::test

// A part of a study: rejected in words, or it is put together and has finite results. Its sum is
// made to fit, or nothing but the sum would be tried.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json_text.h"
#include "case-file/sha256.h"
#include "studies/study_run.h"

namespace {

using namespace ravnoves;

bool has_only_finite_numbers(const Json& value) {
    return value.is_structured() ? std::all_of(value.begin(), value.end(), has_only_finite_numbers)
                                 : !value.is_number_float() || std::isfinite(value.get<double>());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        Json json = parse_json(std::string_view(reinterpret_cast<const char*>(data), size));
        if (!json.is_object()) {
            return 0;
        }
        json.erase("sha256");
        json["sha256"] = sha256(json_text(json, JsonLayout::one_line));
        const studies::Part part = studies::read_part(std::move(json));
        if (!has_only_finite_numbers(studies::write_results(part))) {
            std::abort();
        }
        studies::read_part(studies::write_part(part));  // so it is kept
        const auto whole = studies::merge_parts({"part"}, [&](const auto&) { return part; });
        if (!has_only_finite_numbers(studies::write_results(whole))) {
            std::abort();
        }
    } catch (const InputError&) {
        // rejected in words
    }
    return 0;
}

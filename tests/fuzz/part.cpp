// A part of a study: rejected in words, or it is put together and has finite results. Its sum is
// made to fit, or nothing but the sum would be tried.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json_text.h"
#include "case-file/sha256.h"
#include "finite.h"
#include "studies/study_run.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ravnoves;
    try {
        Json json = parse_json(std::string_view(reinterpret_cast<const char*>(data), size));
        if (!json.is_object()) {
            return 0;
        }
        json.erase("sha256");
        json["sha256"] = sha256(json_text(json, JsonLayout::one_line));
        studies::Part part = studies::read_part(std::move(json));
        if (not_finite(studies::write_results(part)) != nullptr) {
            std::abort();
        }
        studies::read_part(studies::write_part(part));  // so it is kept
        studies::PartMerger merger;
        merger.add(std::move(part), "part");
        if (not_finite(studies::write_results(merger.finish())) != nullptr) {
            std::abort();
        }
    } catch (const InputError&) {
        // rejected in words
    }
    return 0;
}

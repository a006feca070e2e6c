// A case file: solved, or refused in words; never another exception, NaN or infinity.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "scenes/scenes.h"
#include "studies/study_run.h"

namespace {

using namespace ravnoves;

bool is_finite(const Json& value) {
    if (value.is_structured()) {
        for (const auto& each : value) {
            if (!is_finite(each)) {
                return false;
            }
        }
    }
    return !value.is_number_float() || std::isfinite(value.get<double>());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    CaseContext context;
    context.stays_in_directory = true;
    try {
        const CaseFile file =
            parse_case(std::string_view(reinterpret_cast<const char*>(data), size));
        if (!is_finite(solve_case(file, context))) {
            std::abort();
        }
        studies::problem_of(file, context);
    } catch (const InputError&) {
        // refused in words
    }
    return 0;
}

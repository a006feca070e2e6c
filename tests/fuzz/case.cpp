// A case file: solved, or rejected in words; never another exception.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "case-file/input_error.h"
#include "scenes/scenes.h"
#include "studies/study_run.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ravnoves;
    CaseContext context;
    context.stays_in_directory = true;
    try {
        const CaseFile file =
            parse_case(std::string_view(reinterpret_cast<const char*>(data), size));
        solve_case(file, context);
        studies::problem_of(file, context);
    } catch (const InputError&) {
        // rejected in words
    }
    return 0;
}

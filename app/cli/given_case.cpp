#include "given_case.h"

#include <unistd.h>

#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "output.h"
#include "scenes/case_sources.h"
#include "scenes/scenes.h"

namespace ravnoves::cli {

int with_case(const std::string& path, const std::string& output, const std::string& what,
              const CaseWork& work) {
    if (is_same_file(path, output)) {
        return complain(output, "is the case itself; write the " + what + " to another file");
    }
    try {
        const bool is_input = path == "-" || path == "/dev/stdin";
        const std::string text = is_input ? read_text(STDIN_FILENO) : read_text_file(path);
        const CaseContext context =
            is_input ? CaseContext{} : CaseContext{std::filesystem::path(path).parent_path()};
        const CaseFile file = parse_case(text);
        if (is_named_by(file, context, output)) {
            return complain(
                output, "is a file that the case reads; write the " + what + " to another file");
        }
        return work(file, context, text);
    } catch (const InputError& error) {
        return complain(path, error.what());
    }
}

}  // namespace ravnoves::cli

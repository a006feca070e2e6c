#include "given_case.h"

#include <unistd.h>

#include <filesystem>

#include "case-file/text_file.h"

namespace ravnoves::cli {

GivenCase read_given_case(const std::string& path) {
    if (path != "-" && path != "/dev/stdin") {
        return {read_text_file(path), CaseContext{std::filesystem::path(path).parent_path()}};
    }
    return {read_text(STDIN_FILENO), CaseContext{}};
}

}  // namespace ravnoves::cli

#include "examples.h"

#include <algorithm>

#include "case-file/text_file.h"
#include "scenes/scenes.h"

namespace ravnoves::test {

CaseFile example(const std::string& name) {
    return parse_case(read_text_file(RAVNOVES_EXAMPLES "/" + name + ".case.json"));
}

std::vector<std::filesystem::path> example_files() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(RAVNOVES_EXAMPLES)) {
        if (entry.path().string().ends_with(".case.json")) {
            paths.push_back(entry.path());
        }
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace ravnoves::test

#include "given_case.h"

#include <array>
#include <filesystem>
#include <iostream>

#include "case-file/text_file.h"
#include "case-file/text_size.h"

namespace ravnoves::cli {

GivenCase read_given_case(const std::string& path) {
    if (path != "-" && path != "/dev/stdin") {
        return {read_text_file(path), CaseContext{std::filesystem::path(path).parent_path()}};
    }
    GivenCase given{{}, CaseContext{}};
    std::array<char, 65536> block{};
    while (std::cin.read(block.data(), block.size()) || std::cin.gcount() > 0) {
        const auto count = static_cast<std::size_t>(std::cin.gcount());
        check_text_size(given.text.size() + count);
        given.text.append(block.data(), count);
    }
    return given;
}

}  // namespace ravnoves::cli

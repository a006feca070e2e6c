#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case-file/case_file.h"

namespace ravnoves::test {

/// The case of an example, "tmz-650d", or of a file near them, "../templates/workshop".
CaseFile example(const std::string& name);
/// The files of all examples, in the order of their names.
std::vector<std::filesystem::path> example_files();

}  // namespace ravnoves::test

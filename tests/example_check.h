#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "case-file/case_file.h"
#include "case-file/json.h"

namespace ravnoves::test {

/// The case of an example, "tmz-650d", or of a file near them, "../templates/workshop".
CaseFile example(const std::string& name);
/// The files of all examples, in the order of their names.
std::vector<std::filesystem::path> example_files();

/// Solves resources/examples/NAME.case.json and compares with
/// tests/data/expected/NAME.expected.json by the contract's rules: 1e-6 relative, angles of an
/// optimum to 0.05°, curves at the sampled angles (`samples` against `curves`). The result's whole
/// document is returned for more checks.
Json check_example(const std::string& name);

/// Compares every number of `expected` with `found`; `scale` is the absolute size under which a
/// difference of 1e-9 of it does not count (for zeros).
void expect_matches(const Json& expected, const Json& found, const std::string& pointer,
                    double scale);

}  // namespace ravnoves::test

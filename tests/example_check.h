#pragma once

#include <gtest/gtest.h>

#include <string>

#include "case-file/json.h"

namespace ravnoves::test {

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

#pragma once

#include <string>

#include "case-file/case_context.h"

namespace ravnoves::cli {

/// A case as it was given: its text, and where the files that it names lie.
struct GivenCase {
    std::string text;
    CaseContext context;
};

/// Of "-" and /dev/stdin that is standard input, whatever it comes from; its files lie in the
/// working directory.
/// @throws InputError where it cannot be read or is larger than a file may be
GivenCase read_given_case(const std::string& path);

}  // namespace ravnoves::cli

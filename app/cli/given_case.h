#pragma once

#include <functional>
#include <string>

#include "case-file/case_context.h"
#include "case-file/case_file.h"

namespace ravnoves::cli {

/// What is done with a case. @return the exit status
using CaseWork =
    std::function<int(const CaseFile& file, const CaseContext& context, const std::string& text)>;

/// Reads a case and works on it. Of "-" and /dev/stdin that is standard input, whatever it comes
/// from; its files lie in the working directory.
/// @param output  a file for `what` follows from it; it may be neither the case nor what that reads
/// @return the exit status; where the case is bad, this has been said
int with_case(const std::string& path, const std::string& output, const std::string& what,
              const CaseWork& work);

}  // namespace ravnoves::cli

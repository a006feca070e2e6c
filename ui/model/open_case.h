#pragma once

#include "case-file/case_context.h"
#include "case-file/case_file.h"

namespace ravnoves {

/// The case that is open on a page, for other pages to refer to.
struct OpenCase {
    CaseFile file;
    CaseContext context;
    int shown = 0;  ///< the larger, the later it was in front
};

}  // namespace ravnoves

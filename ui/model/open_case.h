#pragma once

#include <QString>

#include "case-file/case_context.h"
#include "case-file/json.h"

namespace ravnoves {

/// The case that is open on a page, for other pages to refer to.
struct OpenCase {
    QString title;
    Json input;
    CaseContext context;
};

}  // namespace ravnoves

#pragma once

#include <optional>

#include "case-file/result_visitor.h"
#include "text/result_row.h"

namespace ravnoves {

/// shownRow() by what core says of the result; a dash where there is no number.
ResultRow shownRow(const ResultField& field, const std::optional<double>& si);

}  // namespace ravnoves

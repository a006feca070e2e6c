#pragma once

#include <vector>

#include "report/page_parts.h"

namespace ravnoves {

/// What a page shows, part by part, with its pictures: those beside the tabs first, then tab by
/// tab. Nothing of the page moves for it: plots and tables are made for the report alone.
std::vector<PageGroup> caseParts(ScenePage& page, const Patience& patience);

}  // namespace ravnoves

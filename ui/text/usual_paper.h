#pragma once

#include <QPageSize>

namespace ravnoves {

/// Letter where the desktop's country prints on it, else A4, as its locale has it (LC_PAPER): an
/// English program in Berlin prints on A4.
QPageSize::PageSizeId usualPaper();

}  // namespace ravnoves

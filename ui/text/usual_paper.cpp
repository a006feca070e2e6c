#include "text/usual_paper.h"

#include <langinfo.h>

#include <cstdint>

namespace ravnoves {

QPageSize::PageSizeId usualPaper() {
    constexpr int between = 288;  // mm, of 279 and 297
    const auto height = reinterpret_cast<std::intptr_t>(nl_langinfo(_NL_PAPER_HEIGHT));
    return static_cast<int>(height) < between ? QPageSize::Letter : QPageSize::A4;
}

}  // namespace ravnoves

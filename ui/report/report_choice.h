#pragma once

#include <QPageSize>

namespace ravnoves {

/// What a report has beside the answer, which is on its first page.
struct ReportChoice {
    bool inputs = true;
    bool plots = true;
    bool formulas = true;                         ///< and what the model leaves out
    bool validation = false;                      ///< of the paper that the scene is of
    QPageSize::PageSizeId paper = QPageSize::A4;  ///< of a PDF: A4 or Letter

    /// As the user chose last; the paper by the locale at first.
    static ReportChoice kept();
    void keep() const;
};

}  // namespace ravnoves

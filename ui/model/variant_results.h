#pragma once

#include <QStringList>

#include "text/result_row.h"

namespace ravnoves {

class SceneModel;

/// The present case and its variants beside one another.
struct VariantResults {
    QStringList verdicts;  ///< of each, with its name
    /// First the layout, or the inputs that differ; then the numbers beside the tabs of the page;
    /// last other differences of other layouts. Each with its difference from the reference (the
    /// present one by default).
    Results results;
    QStringList troubles;  ///< of variants: rejected, or of a file that has changed
};
VariantResults variantResults(const SceneModel& model);

}  // namespace ravnoves

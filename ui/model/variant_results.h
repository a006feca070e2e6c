#pragma once

#include <QStringList>

#include "text/result_row.h"

namespace ravnoves {

class SceneModel;

/// The present case and its variants beside one another: first the inputs that differ, then the
/// numbers that are beside the tabs of the page, each with its difference from the reference (the
/// present one, where there is none).
/// @param troubles  receives what is to be said of variants: refused, or of a file that has changed
Results variantResults(const SceneModel& model, QStringList& troubles);

}  // namespace ravnoves
